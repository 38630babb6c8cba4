#include "core/body/measure/slices.h"

#include "core/geometry/convex_hull.h"

namespace toile::measure {

namespace {

void grow(BodyCut& cut, Vec3 p) {
  cut.box.add(p);
  cut.points.push_back(p);
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

}  // namespace toile::measure
