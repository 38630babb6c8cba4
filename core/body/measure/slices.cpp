#include "core/body/measure/slices.h"

#include <array>
#include <cmath>

#include "core/geometry/convex_hull.h"

namespace toile::measure {

namespace {

void grow(BodyCut& cut, Vec3 p) {
  cut.box.add(p);
  cut.points.push_back(p);
}

/// Where the triangle meets the line along z through (x, y).
std::optional<double> depth_in(const std::array<Vec3, 3>& t, double x, double y) {
  const auto cross_at = [&](Vec3 a, Vec3 b) { return (a.x - x) * (b.y - y) - (a.y - y) * (b.x - x); };
  const double a = cross_at(t[1], t[2]), b = cross_at(t[2], t[0]), c = cross_at(t[0], t[1]);
  const double all = a + b + c;
  const bool inside = (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
  if (!inside || all == 0) return std::nullopt;
  return (a * t[0].z + b * t[1].z + c * t[2].z) / all;
}

}  // namespace

std::vector<BodyCut> cut_body(const PlaneCutter& cutter, Vec3 origin, Vec3 normal) {
  const MeshCut cut = cutter.cut(origin, normal);
  std::vector<BodyCut> parts(static_cast<std::size_t>(cut.part_count));
  for (std::size_t i = 0; i < cut.points.size(); ++i) grow(parts[cut.part[i]], cut.points[i]);
  return parts;
}

double tape_around(const BodyCut& cut, Vec3 normal) {
  const Vec3 n = normalized(normal);
  const Vec3 aside = std::abs(n.y) < 0.9 ? Vec3{0, 1, 0} : Vec3{1, 0, 0};
  const Vec3 u = normalized(cross(aside, n)), v = cross(n, u);
  std::vector<Vec2> flat;
  flat.reserve(cut.points.size());
  for (const Vec3& p : cut.points) flat.push_back({dot(p, u), dot(p, v)});
  return geometry::hull_perimeter(std::move(flat));
}

BodyCut middle_cut(const PlaneCutter& cutter, double height, double middle) {
  BodyCut out;
  for (const BodyCut& cut : cut_body(cutter, {0, height, 0}, {0, 1, 0})) {
    if (cut.box.low.x > middle || cut.box.high.x < middle) continue;
    for (const Vec3& p : cut.points) grow(out, p);
  }
  return out;
}

std::optional<Vec3> middle_skin(const geometry::TriangleMesh& mesh, const BodyCut& cut, double height,
                                double middle, double facing, double aside) {
  std::optional<Vec3> best;
  const auto take = [&](Vec3 p) {
    if (!best || facing * p.z > facing * best->z) best = p;
  };
  for (const Vec3& p : cut.points)
    if (std::abs(p.x - middle) <= aside) take(p);
  if (best && facing * (best->z - cut.box.middle().z) > 0) return best;
  for (const Tri& t : mesh.triangles) {
    const std::array<Vec3, 3> corners{mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
    if (const auto z = depth_in(corners, middle, height)) take({middle, height, *z});
  }
  return best;
}

}  // namespace toile::measure
