#include "core/dressing/axis_guard.h"

#include <algorithm>
#include <set>

namespace toile::dressing {

namespace {

constexpr double kBeyondHands = 0.12;  // m, so that cuffs stay on while they are pulled

/// Signed volume of the tetrahedron, times six.
double volume(Vec3 a, Vec3 b, Vec3 c, Vec3 d) { return dot(cross(b - a, c - a), d - a); }

bool goes_through(const Axis& axis, Vec3 a, Vec3 b, Vec3 c) {
  const double from = volume(a, b, c, axis[0]), to = volume(a, b, c, axis[1]);
  if ((from > 0) == (to > 0)) return false;
  const bool ab = volume(axis[0], axis[1], a, b) > 0, bc = volume(axis[0], axis[1], b, c) > 0;
  return ab == bc && bc == (volume(axis[0], axis[1], c, a) > 0);
}

bool apart(const Axis& axis, Vec3 low, Vec3 high) {
  const auto beside = [](double p, double q, double lo, double hi) {
    return std::max(p, q) < lo || std::min(p, q) > hi;
  };
  return beside(axis[0].x, axis[1].x, low.x, high.x) || beside(axis[0].y, axis[1].y, low.y, high.y) ||
         beside(axis[0].z, axis[1].z, low.z, high.z);
}

/// The straight pieces of a limb's line from corner `first` on.
void add_axes(const Skeleton& skeleton, std::size_t limb, std::size_t first, std::vector<Axis>& axes) {
  const std::vector<Vec3>& line = skeleton[limb];
  for (std::size_t i = first; i + 2 < line.size(); ++i) axes.push_back({line[i], line[i + 1]});
  if (limb != kLeftArm && limb != kRightArm) return;
  const Vec3 tip = line[line.size() - 2];
  axes.push_back({tip, tip + normalized(line.back() - tip) * kBeyondHands});
}

}  // namespace

std::vector<Axis> axes_of(const Skeleton& skeleton) {
  std::vector<Axis> axes;
  for (std::size_t limb = 0; limb < skeleton.size(); ++limb) add_axes(skeleton, limb, 0, axes);
  return axes;
}

Gaps gaps_of(const sewing::GarmentMesh& garment, std::span<const Covers> covers, const Skeleton& skeleton) {
  constexpr std::size_t kRoot = 2;  // of an arm's or a leg's line: what comes before is in the trunk
  Gaps gaps;
  for (const Limb limb : {kLeftArm, kRightArm, kLeftLeg, kRightLeg})
    add_axes(skeleton, limb, kRoot, gaps.axes);
  const auto edge = [](Index a, Index b) { return std::array{std::min(a, b), std::max(a, b)}; };
  std::set<std::array<Index, 2>> edges;
  for (const Tri& t : garment.triangles)
    for (std::size_t k = 0; k < 3; ++k) edges.insert(edge(t[k], t[(k + 1) % 3]));
  const auto meet = [&](Index a, Index b) { return a == b || edges.contains(edge(a, b)); };
  const auto on_limb = [&](Index v) {
    const Covers part = covers[static_cast<std::size_t>(garment.panel_of_vertex[v])];
    return part == Covers::kArm || part == Covers::kBelow;
  };
  for (std::size_t k = 0; k + 1 < garment.sewn.size(); ++k) {
    const auto [i, j] = garment.sewn[k];
    const auto [next_i, next_j] = garment.sewn[k + 1];
    const bool one_gap =
        garment.seam_of_sewn[k] == garment.seam_of_sewn[k + 1] && meet(i, next_i) && meet(j, next_j);
    if (!one_gap || !on_limb(i) || !on_limb(j)) continue;
    if (i != next_i) gaps.triangles.push_back({i, next_i, j});
    if (j != next_j) gaps.triangles.push_back({j, next_j, next_i});
  }
  return gaps;
}

AxisGuard::AxisGuard(std::vector<Axis> axes, std::span<const Tri> triangles, std::span<const Vec3> x,
                     Gaps gaps)
    : axes_(std::move(axes)), triangles_(triangles), gaps_(std::move(gaps)) {
  for (std::size_t t = 0; t < triangles_.size() + gaps_.triangles.size(); ++t)
    crossed_.push_back(is_crossed(t, x));
}

bool AxisGuard::is_crossed(std::size_t t, std::span<const Vec3> x) const {
  const Tri& corners = triangle(t);
  const Vec3 a = x[corners[0]], b = x[corners[1]], c = x[corners[2]];
  const Vec3 low{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::min({a.z, b.z, c.z})};
  const Vec3 high{std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}), std::max({a.z, b.z, c.z})};
  const std::vector<Axis>& axes = t < triangles_.size() ? axes_ : gaps_.axes;
  return std::any_of(axes.begin(), axes.end(), [&](const Axis& axis) {
    return !apart(axis, low, high) && goes_through(axis, a, b, c);
  });
}

void AxisGuard::keep(std::span<const Vec3> before, std::vector<Vec3>& x) {
  // Where untangling moves a few vertices of many, the others need no look; later only what went back does,
  // which may draw its neighbours in. What is back stays back, so that this ends.
  std::vector<bool> moved(x.size());
  for (std::size_t v = 0; v < x.size(); ++v) moved[v] = !(x[v] == before[v]);
  std::vector<bool> now = crossed_;
  for (bool taken_back = true; taken_back;) {
    taken_back = false;
    for (std::size_t t = 0; t < now.size(); ++t) {
      const Tri& corners = triangle(t);
      if (moved[corners[0]] || moved[corners[1]] || moved[corners[2]]) now[t] = is_crossed(t, x);
    }
    std::fill(moved.begin(), moved.end(), false);
    for (std::size_t t = 0; t < now.size(); ++t) {
      if (!now[t] || crossed_[t]) continue;
      for (const Index v : triangle(t)) {
        if (x[v] == before[static_cast<std::size_t>(v)]) continue;
        x[v] = before[static_cast<std::size_t>(v)];
        moved[v] = taken_back = true;
      }
    }
  }
  crossed_ = std::move(now);
}

}  // namespace toile::dressing
