#include "core/mesh/vertex_normals.h"

namespace toile::mesh {
namespace {

/// Cosine between the joint normal and a piece's own below which they count as different surfaces.
constexpr double kCreaseCosine = 0.2;

double angle_between(Vec3 a, Vec3 b) { return std::atan2(length(cross(a, b)), dot(a, b)); }

/// Sum over each vertex's triangles of unit normal times corner angle.
std::vector<Vec3> weighted_normals(std::span<const Vec3> positions, std::span<const Tri> triangles) {
  std::vector<Vec3> sums(positions.size());
  for (const Tri& t : triangles) {
    const Vec3 p[3] = {positions[t[0]], positions[t[1]], positions[t[2]]};
    const Vec3 normal = normalized(cross(p[1] - p[0], p[2] - p[0]));
    for (int i = 0; i < 3; ++i) {
      sums[t[i]] += normal * angle_between(p[(i + 1) % 3] - p[i], p[(i + 2) % 3] - p[i]);
    }
  }
  return sums;
}

Vec3 unit_or_up(Vec3 v) {
  const Vec3 unit = normalized(v);
  return dot(unit, unit) > 0.5 ? unit : Vec3{0, 0, 1};
}

}  // namespace

std::vector<Vec3> vertex_normals(std::span<const Vec3> positions, std::span<const Tri> triangles,
                                 std::span<const Index> weld) {
  const std::vector<Vec3> own = weighted_normals(positions, triangles);
  std::vector<Vec3> joint = own;
  if (!weld.empty()) {
    joint.assign(own.size(), Vec3{});
    for (std::size_t v = 0; v < own.size(); ++v) joint[weld[v]] += own[v];
  }
  std::vector<Vec3> normals(own.size());
  for (std::size_t v = 0; v < own.size(); ++v) {
    const Vec3 together = unit_or_up(weld.empty() ? joint[v] : joint[weld[v]]);
    const bool creased = dot(together, normalized(own[v])) < kCreaseCosine;
    normals[v] = creased ? unit_or_up(own[v]) : together;
  }
  return normals;
}

}  // namespace toile::mesh
