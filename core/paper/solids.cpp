#include "core/paper/solids.h"

#include <algorithm>

#include "core/mesh/vertex_normals.h"

namespace toile::paper {

namespace {

/// A corner goes out by no more than so many times the clearance, however sharp it is.
constexpr double kMostMitre = 2;

Vec3 normal_of(const Tri& t, std::span<const Vec3> x) {
  return normalized(cross(x[t[1]] - x[t[0]], x[t[2]] - x[t[0]]));
}

/// The corners, moved out so that each triangle stands off by `clearance`.
std::vector<Vec3> moved_out(std::span<const Vec3> vertices, std::span<const Tri> triangles,
                            double clearance) {
  const std::vector<Vec3> outwards = mesh::vertex_normals(vertices, triangles);
  std::vector<double> steepest(vertices.size(), 1);
  for (const Tri& t : triangles) {
    const Vec3 n = normal_of(t, vertices);
    for (const Index v : t) steepest[v] = std::min(steepest[v], dot(n, outwards[v]));
  }
  std::vector<Vec3> moved;
  for (std::size_t v = 0; v < vertices.size(); ++v)
    moved.push_back(vertices[v] + outwards[v] * (clearance / std::max(steepest[v], 1 / kMostMitre)));
  return moved;
}

}  // namespace

void add_solid(std::span<const Vec3> vertices, std::span<const Tri> triangles, double clearance,
               Solids& solids) {
  const std::vector<Vec3> out = moved_out(vertices, triangles, clearance);
  for (const bool skin : {false, true}) {
    const std::span<const Vec3> x = skin ? vertices : out;
    for (const Tri& t : triangles) {
      solids.triangles.push_back({x[t[0]], x[t[1]], x[t[2]]});
      solids.normals.push_back(normal_of(t, x));
      solids.skin.push_back(skin);
    }
  }
}

}  // namespace toile::paper
