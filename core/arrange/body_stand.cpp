#include "core/arrange/body_stand.h"

#include <algorithm>
#include <cmath>

#include "core/body/measure/slices.h"
#include "core/geometry/polygon2.h"

namespace toile::arrange {

namespace {

/// The mean of a place and its image at x = middle.
void even(Vec3& left, Vec3& right, double middle) {
  const auto image = [&](Vec3 p) { return Vec3{2 * middle - p.x, p.y, p.z}; };
  left = (left + image(right)) * 0.5;
  right = image(left);
}

bool is_within(const std::vector<Vec2>& outline, const Aabb2& box, Vec2 p, double margin) {
  if (!box.contains(p)) return false;
  if (geometry::contains(outline, p)) return true;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    if (geometry::distance_to_segment(p, outline[i], outline[(i + 1) % outline.size()]) < margin) return true;
  }
  return false;
}

}  // namespace

measure::BodyFigure alike_on_both_sides(measure::BodyFigure f) {
  even(f.armpit[0], f.armpit[1], f.middle);
  even(f.shoulder[0], f.shoulder[1], f.middle);
  even(f.neck_side[0], f.neck_side[1], f.middle);
  even(f.bust_point[0], f.bust_point[1], f.middle);
  even(f.arm[0].root, f.arm[1].root, f.middle);
  even(f.arm[0].elbow, f.arm[1].elbow, f.middle);
  even(f.arm[0].wrist, f.arm[1].wrist, f.middle);
  even(f.arm[0].tip, f.arm[1].tip, f.middle);
  even(f.leg[0].top, f.leg[1].top, f.middle);
  even(f.leg[0].knee, f.leg[1].knee, f.middle);
  even(f.leg[0].ankle, f.leg[1].ankle, f.middle);
  f.arm[0].girth = f.arm[1].girth = std::max(f.arm[0].girth, f.arm[1].girth);
  return f;
}

double BodyStand::reach(const std::vector<Vec2>& outline, int face, double margin) const {
  const Aabb2 box = bounding_box(outline).grown(margin);
  double most = face * figure_.armpit[0].z;
  for (const Vec3& p : mesh_.vertices) {
    if (face * p.z <= most) continue;
    // Both sides are asked, so that left and right stand alike.
    const Vec2 here{p.x, p.y}, image{2 * figure_.middle - p.x, p.y};
    if (is_within(outline, box, here, margin) || is_within(outline, box, image, margin)) most = face * p.z;
  }
  return face * most;
}

double BodyStand::waist_girth() const { return measure::trunk_girth(cutter_, figure_, figure_.waist); }

double BodyStand::height_of_ring(double girth) const {
  constexpr double kStep = 0.005, kTight = 1.03;
  double loosest = figure_.waist, widest = 0;
  for (double y = figure_.waist; y > figure_.hip; y -= kStep) {
    const double g = measure::trunk_girth(cutter_, figure_, y);
    if (g * kTight >= girth) return y;
    if (g > widest) {
      widest = g;
      loosest = y;
    }
  }
  return loosest;
}

Vec2 BodyStand::middle_at(double height) const {
  const measure::BodyCut cut = measure::middle_cut(cutter_, height, figure_.middle);
  return {figure_.middle, cut.points.empty() ? figure_.armpit[0].z : cut.box.middle().z};
}

double BodyStand::half_breadth_above(double height) const {
  double half = 0;
  for (const Vec3& v : mesh_.vertices) {
    if (v.y > height) half = std::max(half, std::abs(v.x - figure_.middle));
  }
  return half;
}

double BodyStand::top_beside(double x) const {
  constexpr double kWithin = 0.015;
  double top = figure_.floor;
  for (const Vec3& v : mesh_.vertices) {
    if (std::abs(std::abs(v.x - figure_.middle) - x) < kWithin) top = std::max(top, v.y);
  }
  return top;
}

double BodyStand::radius_about(Vec2 axis, double low, double high, double breadth) const {
  double most = 0;
  for (const Vec3& p : mesh_.vertices) {
    if (p.y < low || p.y > high || std::abs(p.x - figure_.middle) > breadth) continue;
    most = std::max(most, std::hypot(p.x - axis.x, p.z - axis.y));
  }
  return most;
}

}  // namespace toile::arrange
