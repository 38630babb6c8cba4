#include "core/arrange/flat_move.h"

namespace toile::arrange {

FlatMove after(const FlatMove& outer, const FlatMove& inner) {
  // A mirror before a turn turns the other way after it.
  const double sign = outer.mirrored ? -1 : 1;
  FlatMove both;
  both.c = outer.c * inner.c - outer.s * inner.s * sign;
  both.s = outer.s * inner.c + outer.c * inner.s * sign;
  both.mirrored = outer.mirrored != inner.mirrored;
  both.t = outer(inner.t);
  return both;
}

FlatFit fit_move(std::span<const Vec2> points, std::span<const Vec2> targets, bool mirrored) {
  const double count = static_cast<double>(points.size());
  const auto seen = [&](Vec2 p) { return mirrored ? Vec2{-p.x, p.y} : p; };
  Vec2 a, b;
  for (std::size_t i = 0; i < points.size(); ++i) {
    a = a + seen(points[i]);
    b = b + targets[i];
  }
  a = a * (1 / count);
  b = b * (1 / count);
  double along = 0, across = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    along += dot(seen(points[i]) - a, targets[i] - b);
    across += cross(seen(points[i]) - a, targets[i] - b);
  }
  FlatFit fit;
  fit.move.mirrored = mirrored;
  if (const double l = std::hypot(along, across); l > 1e-12) {
    fit.move.c = along / l;
    fit.move.s = across / l;
  }
  fit.move.t = b - Vec2{fit.move.c * a.x - fit.move.s * a.y, fit.move.s * a.x + fit.move.c * a.y};
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 d = fit.move(points[i]) - targets[i];
    sum += dot(d, d);
  }
  fit.rms = std::sqrt(sum / count);
  return fit;
}

FlatMove turn_by(double angle, bool mirrored) {
  FlatMove move;
  move.c = std::cos(angle);
  move.s = std::sin(angle);
  move.mirrored = mirrored;
  return move;
}

Vec2 mean_of(std::span<const Vec2> points) {
  Vec2 sum;
  for (const Vec2 p : points) sum = sum + p;
  return sum * (1.0 / static_cast<double>(points.size()));
}

PointAxes axes_of(std::span<const Vec2> points) {
  const Vec2 mean = mean_of(points);
  double xx = 0, xy = 0, yy = 0;
  for (const Vec2 p : points) {
    const Vec2 d = p - mean;
    xx += d.x * d.x;
    xy += d.x * d.y;
    yy += d.y * d.y;
  }
  const double angle = 0.5 * std::atan2(2 * xy, xx - yy);
  return {mean, {std::cos(angle), std::sin(angle)}, xx + yy > 1e-12};
}

}  // namespace toile::arrange
