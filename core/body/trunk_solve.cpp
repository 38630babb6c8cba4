#include "core/body/trunk_solve.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/body/tape.h"

namespace toile {
namespace {

constexpr int kDirections = 33;  // over the half circle; the other half mirrors it
constexpr int kHeights = 9;      // looked at in each range
constexpr int kRounds = 7;
constexpr double kAxisZ = -0.008;  // inside every trunk section
constexpr double kMarch = 0.012, kFarthest = 0.4;

// Half-circle directions (x >= 0) without trigonometry: even steps in the tangent of the half angle.
std::array<Vec2, kDirections> directions() {
  std::array<Vec2, kDirections> out;
  for (int i = 0; i < kDirections; ++i) {
    const double q = -1 + 2.0 * i / (kDirections - 1);
    out[i] = {(1 - q * q) / (1 + q * q), 2 * q / (1 + q * q)};
  }
  return out;
}

// Distance from the axis to the skin.
double skin_along(const BodyField& field, double y, Vec2 direction) {
  const auto value = [&](double r) {
    return field.trunk_at({direction.x * r, y, kAxisZ + direction.y * r}).value;
  };
  double in = 0, out = kMarch, f_in = value(0), f_out = value(out);
  while (f_out < 0 && out < kFarthest) in = out, f_in = f_out, out += kMarch, f_out = value(out);
  if (f_in >= 0) return 0;
  for (int i = 0; i < 4 && f_out > 0; ++i) {
    const double mid = in + (out - in) * std::clamp(f_in / (f_in - f_out), 0.02, 0.98);
    const double f = value(mid);
    if (f < 0) {
      in = mid, f_in = f;
    } else {
      out = mid, f_out = f;
    }
  }
  return in + (out - in) * f_in / (f_in - f_out);
}

double girth_at(const BodyField& field, double y) {
  static const std::array<Vec2, kDirections> kAround = directions();
  std::vector<Vec2> points;
  for (const Vec2& d : kAround) {
    const Vec2 p = d * skin_along(field, y, d);
    points.push_back(p);
    points.push_back({-p.x, p.y});
  }
  return hull_perimeter(std::move(points));
}

double extreme(const BodyField& field, double low, double high, bool widest) {
  double best = girth_at(field, low);
  for (int i = 1; i < kHeights; ++i) {
    const double g = girth_at(field, low + (high - low) * i / (kHeights - 1));
    best = widest ? std::max(best, g) : std::min(best, g);
  }
  return best;
}

}  // namespace

TrunkTargets trunk_girths(const BodyField& field) {
  return {extreme(field, 0.70, 0.72, true), extreme(field, 0.58, 0.68, false),
          extreme(field, 0.48, 0.56, true)};
}

BodyShape corrected(BodyShape shape, const TrunkTargets& asked, const TrunkTargets& got) {
  shape.bust = std::clamp(shape.bust * asked.bust / got.bust, 0.4, 2.5);
  shape.waist = std::clamp(shape.waist * asked.waist / got.waist, 0.4, 2.5);
  shape.hip = std::clamp(shape.hip * asked.hip / got.hip, 0.4, 2.5);
  return shape;
}

BodyShape solve_shape(const TrunkTargets& targets, BodyShape start) {
  BodyShape shape = start;
  for (int i = 0; i < kRounds; ++i) shape = corrected(shape, targets, trunk_girths(BodyField(shape)));
  return shape;
}

}  // namespace toile
