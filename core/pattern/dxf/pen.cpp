#include "core/pattern/dxf/pen.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "core/base/units.h"
#include "core/pattern/dxf/groups.h"

namespace toile::dxf {
namespace {

constexpr double kLongestChord = 5;                         // mm
constexpr double kWidestChord = radians_from_degrees(7.5);  // of an arc: 35° corners stay far off
constexpr double kFlatArc = 1e-4;                           // mm of height: drawn as its chord
constexpr double kSplineChord = 2;                          // mm of a spline's control polygon per chord
constexpr double kFewestSplineChords = 8, kMostSplineChords = 500;  // per knot span

/// Chords that draw an arc; at most a million, which any limit on vertices refuses.
std::size_t arc_steps(double radius, double sweep, double tolerance) {
  double step = kWidestChord;
  if (radius > tolerance) step = std::min(step, 2 * std::acos(1 - tolerance / radius));
  if (radius > 0) step = std::min(step, kLongestChord / radius);
  return static_cast<std::size_t>(std::clamp(std::ceil(std::abs(sweep) / step), 1.0, 1e6));
}

/// De Boor's algorithm in homogeneous coordinates, u in the given knot span.
Vec2 spline_point(const DxfCurve& c, std::size_t span, double u) {
  const auto p = std::size_t(c.degree);
  std::vector<Vec3> d(p + 1);
  for (std::size_t j = 0; j <= p; ++j) {
    const std::size_t i = span - p + j;
    const double w = c.weights.empty() ? 1 : c.weights[i];
    d[j] = {c.vertices[i].at.x * w, c.vertices[i].at.y * w, w};
  }
  for (std::size_t r = 1; r <= p; ++r) {
    for (std::size_t j = p; j >= r; --j) {
      const double low = c.knots[span - p + j], high = c.knots[span + 1 + j - r];
      const double t = high > low ? (u - low) / (high - low) : 0;
      d[j] = (1 - t) * d[j - 1] + t * d[j];
    }
  }
  return {d[p].x / d[p].z, d[p].y / d[p].z};
}

/// Draws one curve. Each kind takes its points' number from the room before it makes them, so that a file
/// cannot ask for more memory than the limit.
class Pen {
 public:
  Pen(const DxfSettings& settings, double mm_per_unit, std::size_t room)
      : settings_(settings), unit_(mm_per_unit), room_(room) {}

  /// Nothing when the room does not suffice.
  std::optional<DxfDrawn> draw(const DxfCurve& c) {
    std::vector<Vec2> points;
    if (!draw_kind(c, points)) return std::nullopt;
    return DxfDrawn{std::move(points), cost_};
  }

 private:
  bool draw_kind(const DxfCurve& c, std::vector<Vec2>& points) {
    switch (c.kind) {
      case DxfCurve::Kind::kPolyline:
        return polyline(c, points);
      case DxfCurve::Kind::kArc:
        return arc(c, points);
      case DxfCurve::Kind::kEllipse:
        return ellipse(c, points);
      case DxfCurve::Kind::kSpline:
        return spline(c, points);
      case DxfCurve::Kind::kThrough:
        return through(c, points);
    }
    return true;
  }
  bool take(std::size_t n) { return (cost_ += n) <= room_; }
  bool polyline(const DxfCurve& c, std::vector<Vec2>& points);
  bool bulge(Vec2 a, Vec2 b, double bulge, std::vector<Vec2>& points);
  bool arc(const DxfCurve& c, std::vector<Vec2>& points);
  bool ellipse(const DxfCurve& c, std::vector<Vec2>& points);
  bool spline(const DxfCurve& c, std::vector<Vec2>& points);
  bool through(const DxfCurve& c, std::vector<Vec2>& points);

  const DxfSettings& settings_;
  double unit_;
  std::size_t room_, cost_ = 0;
};

bool Pen::polyline(const DxfCurve& c, std::vector<Vec2>& points) {
  const std::size_t n = c.vertices.size();
  if (!take(n + 1)) return false;
  for (std::size_t i = 0; i < n; ++i) {
    points.push_back(c.vertices[i].at * unit_);
    const bool last = i + 1 == n;
    if (c.vertices[i].bulge == 0 || (last && !c.closed)) continue;
    if (!bulge(points.back(), c.vertices[(i + 1) % n].at * unit_, c.vertices[i].bulge, points)) return false;
  }
  return true;
}

/// The inner points of the arc from a to b. Its bulge is the tangent of a quarter of its angle.
bool Pen::bulge(Vec2 a, Vec2 b, double bulge, std::vector<Vec2>& points) {
  const double chord = length(b - a), sweep = 4 * std::atan(bulge);
  if (chord * std::abs(bulge) / 2 < kFlatArc) return true;
  const double radius = chord / (2 * std::abs(std::sin(sweep / 2)));
  const std::size_t steps = arc_steps(radius, sweep, settings_.arc_tolerance_mm);
  if (!take(steps)) return false;
  // The centre stands on the chord's bisector, to its left for an arc under a half turn that bulges right.
  const Vec2 centre = (a + b) * 0.5 + perpendicular(b - a) * ((1 - bulge * bulge) / (4 * bulge));
  const Vec2 from = a - centre;
  for (std::size_t i = 1; i < steps; ++i) {
    const double angle = sweep * double(i) / double(steps);
    points.push_back(centre + from * std::cos(angle) + perpendicular(from) * std::sin(angle));
  }
  return true;
}

bool Pen::arc(const DxfCurve& c, std::vector<Vec2>& points) {
  double degrees = c.closed ? 360 : std::fmod(c.end - c.start, 360.0);
  if (degrees <= 0) degrees += 360;
  const double sweep = radians_from_degrees(degrees), first = radians_from_degrees(std::fmod(c.start, 360.0));
  const double radius = c.radius * unit_;
  const std::size_t steps = arc_steps(radius, sweep, settings_.arc_tolerance_mm);
  if (!take(steps + 1)) return false;
  const Vec2 centre = c.vertices[0].at * unit_;
  for (std::size_t i = 0; i < steps + (c.closed ? 0 : 1); ++i) {
    const double angle = first + sweep * double(i) / double(steps);
    points.push_back(centre + radius * Vec2{std::cos(angle), std::sin(angle)});
  }
  return true;
}

bool Pen::ellipse(const DxfCurve& c, std::vector<Vec2>& points) {
  const Vec2 major = c.vertices[1].at * unit_, minor = perpendicular(major) * c.radius;
  const double whole = 2 * kPi;
  double sweep = c.closed ? whole : std::fmod(c.end - c.start, whole);
  if (sweep <= 0) sweep += whole;
  const double first = std::fmod(c.start, whole);
  const std::size_t steps =
      arc_steps(std::max(length(major), length(minor)), sweep, settings_.arc_tolerance_mm);
  if (!take(steps + 1)) return false;
  const Vec2 centre = c.vertices[0].at * unit_;
  for (std::size_t i = 0; i < steps + (c.closed ? 0 : 1); ++i) {
    const double angle = first + sweep * double(i) / double(steps);
    points.push_back(centre + major * std::cos(angle) + minor * std::sin(angle));
  }
  return true;
}

bool Pen::spline(const DxfCurve& c, std::vector<Vec2>& points) {
  const auto p = std::size_t(c.degree);
  for (std::size_t span = p; span < c.vertices.size(); ++span) {
    const double u0 = c.knots[span], u1 = c.knots[span + 1];
    if (!(u1 > u0)) continue;
    double control = 0;
    for (std::size_t i = span - p; i < span; ++i)
      control += length(c.vertices[i + 1].at - c.vertices[i].at) * unit_;
    const double steps =
        std::clamp(std::ceil(control / kSplineChord), kFewestSplineChords, kMostSplineChords);
    if (!take(std::size_t(steps) + 1)) return false;
    for (double i = points.empty() ? 0 : 1; i <= steps; ++i)
      points.push_back(spline_point(c, span, u0 + (u1 - u0) * (i / steps)) * unit_);
  }
  return true;
}

/// Each span as a cubic whose ends lean as the neighbouring points do, spaced by the chords' lengths.
bool Pen::through(const DxfCurve& c, std::vector<Vec2>& points) {
  const std::size_t n = c.vertices.size(), spans = c.closed ? n : n - 1;
  const auto at = [&](std::size_t i) { return c.vertices[i % n].at * unit_; };
  const auto slope = [&](std::size_t i) {  // per mm, of the parabola through the point and its neighbours
    const bool first = !c.closed && i == 0, last = !c.closed && i + 1 == n;
    const Vec2 before = at(i + n - 1), here = at(i), after = at(i + 1);
    const double h0 = length(here - before), h1 = length(after - here);
    if (first || !(h0 > 0)) return h1 > 0 ? (after - here) * (1 / h1) : Vec2{};
    if (last || !(h1 > 0)) return (here - before) * (1 / h0);
    return ((here - before) * (h1 / h0) + (after - here) * (h0 / h1)) * (1 / (h0 + h1));
  };
  for (std::size_t span = 0; span < spans; ++span) {
    const Vec2 a = at(span), b = at(span + 1);
    const double chord = length(b - a);
    const Vec2 ta = slope(span) * chord, tb = slope((span + 1) % n) * chord;
    const double steps = std::clamp(std::ceil(chord / kSplineChord), kFewestSplineChords, kMostSplineChords);
    if (!take(std::size_t(steps) + 1)) return false;
    for (double i = 0; i < steps; ++i) {
      const double t = i / steps, s = 1 - t;
      points.push_back(a * (s * s * (1 + 2 * t)) + ta * (s * s * t) + b * (t * t * (3 - 2 * t)) -
                       tb * (s * t * t));
    }
  }
  if (!c.closed) points.push_back(at(n - 1));
  return true;
}

}  // namespace

Result<DxfDrawn> drawn_out(const DxfCurve& curve, double mm_per_unit, const DxfSettings& settings,
                           std::size_t room) {
  std::optional<DxfDrawn> drawn = Pen(settings, mm_per_unit, room).draw(curve);
  if (drawn) return *std::move(drawn);
  return Error{"dxf.too_large",
               "With its arcs and splines drawn out the drawing has more than " +
                   std::to_string(settings.max_drawn_points) + " points, the limit.",
               line_text(curve.line), ErrorKind::kTooLarge};
}

}  // namespace toile::dxf
