#include "core/analysis/skin_distance.h"

#include <algorithm>

#include "core/geometry/bvh.h"
#include "core/geometry/distance.h"

namespace toile::analysis {
namespace {

class Skin {
 public:
  explicit Skin(const geometry::TriangleMesh& mesh) : mesh_(mesh) {
    std::vector<geometry::Box3> boxes;
    boxes.reserve(mesh.triangles.size());
    for (const Tri& t : mesh.triangles)
      boxes.push_back(
          geometry::box_around({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]}, 0));
    tree_ = geometry::Bvh(boxes);
  }

  /// Looks within a small distance first: most cloth lies near to who wears it.
  double distance(Vec3 p, double most) const {
    constexpr double kNearSkin = 0.01, kGrows = 4;
    for (double within = std::min(kNearSkin, most);; within = std::min(kGrows * within, most)) {
      const double found = nearest_within(p, within);
      if (found < within || within >= most) return found;
    }
  }

 private:
  double nearest_within(Vec3 p, double within) const {
    double least = within;
    tree_.query(geometry::box_around({p}, within), [&](Index t) {
      const Tri& tri = mesh_.triangles[t];
      const Vec3 a = mesh_.vertices[tri[0]], b = mesh_.vertices[tri[1]], c = mesh_.vertices[tri[2]];
      const geometry::TrianglePoint at = geometry::closest_on_triangle(p, a, b, c);
      least = std::min(least, length(p - (a * at.a + b * at.b + c * at.c)));
    });
    return least;
  }

  const geometry::TriangleMesh& mesh_;
  geometry::Bvh tree_;
};

}  // namespace

std::vector<double> skin_distances(std::span<const body::Body> bodies, std::span<const Vec3> positions,
                                   double most) {
  std::vector<double> out(positions.size(), most);
  for (const body::Body& body : bodies) {
    const Skin skin(body.mesh);
    for (std::size_t v = 0; v < out.size(); ++v)
      out[v] = std::min(out[v], skin.distance(positions[v], out[v]));
  }
  return out;
}

}  // namespace toile::analysis
