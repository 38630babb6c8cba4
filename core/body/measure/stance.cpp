#include "core/body/measure/stance.h"

#include <algorithm>

#include "core/base/aabb.h"
#include "core/body/measure/cut_points.h"
#include "core/body/measure/mesh_cut.h"

namespace toile::measure {
namespace {

constexpr double kLeastStature = 0.55, kUnits[] = {1, 0.1, 0.01, 0.001};
constexpr double kShins = 0.15, kFace = 0.93, kAnkles = 0.075, kSoles = 0.045;  // shares of the stature

template <typename Turn>
void turn(geometry::TriangleMesh& mesh, Turn to) {
  for (Vec3& p : mesh.vertices) p = to(p);
}

bool two_legs_at(const geometry::TriangleMesh& mesh, double share) {
  const Aabb3 box = bounding_box(mesh.vertices);
  const MeshCut cut = MeshCutter(mesh, {0, 1, 0}).at(box.low.y + share * box.size().y);
  return cut.part_count >= 2;
}

// Toes reach farther from the ankles than heels do.
bool faces_back(const geometry::TriangleMesh& mesh, double stature) {
  const double ankle = middle_of(MeshCutter(mesh, {0, 1, 0}).at(kAnkles * stature).points).z;
  double toes = 0, heels = 0;
  for (const Vec3& p : mesh.vertices) {
    if (p.y > kSoles * stature) continue;
    toes = std::max(toes, p.z - ankle);
    heels = std::max(heels, ankle - p.z);
  }
  return heels > toes;
}

}  // namespace

Result<StandingBody> stand_body(geometry::TriangleMesh mesh) {
  const Error none{"body.not_a_body", "The mesh does not look like a standing person.", ""};
  if (mesh.triangles.empty()) return none;
  StandingBody out{std::move(mesh), {}};
  geometry::TriangleMesh& m = out.mesh;
  // Each question is put to the body as the answers before it have turned it: up, unit, head or feet, front.
  if (const Vec3 size = bounding_box(m.vertices).size(); size.z > size.y) {
    out.stance.up = 'z';
    turn(m, [](Vec3 p) { return Vec3{p.x, p.z, -p.y}; });
  }
  double stature = bounding_box(m.vertices).size().y;
  if (!(stature > 0)) return none;
  // The smallest unit of which the body is still as tall as a small child.
  for (double unit : kUnits)
    if (stature * unit >= kLeastStature) out.stance.unit_in_m = unit;
  turn(m, [&](Vec3 p) { return p * out.stance.unit_in_m; });
  stature *= out.stance.unit_in_m;
  if (!two_legs_at(m, kShins) && two_legs_at(m, 1 - kShins)) {
    out.stance.upside_down = true;
    turn(m, [](Vec3 p) { return Vec3{-p.x, -p.y, p.z}; });
  }
  // A head has one outline; what has two at both ends is no person, or holds its hands up.
  if (!two_legs_at(m, kShins) || two_legs_at(m, kFace + 0.05)) return none;
  // With arms off the trunk a person is broader than deep.
  if (const Vec3 size = bounding_box(m.vertices).size(); size.z > size.x) {
    out.stance.quarter_turns = 1;
    turn(m, [](Vec3 p) { return Vec3{p.z, p.y, -p.x}; });
  }
  out.stance.floor = bounding_box(m.vertices).low.y;
  turn(m, [&](Vec3 p) { return Vec3{p.x, p.y - out.stance.floor, p.z}; });
  if (faces_back(m, stature)) {
    out.stance.quarter_turns += 2;
    turn(m, [](Vec3 p) { return Vec3{-p.x, p.y, -p.z}; });
  }
  return out;
}

}  // namespace toile::measure
