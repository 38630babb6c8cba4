#pragma once
// Named places on a standing body, put on its skin.

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/body/measure/figure.h"

namespace toile::measure {

/// A point on a triangle of a mesh: it stays where it is on the skin when the mesh is reshaped.
struct SkinPoint {
  Index triangle = kNone;
  std::array<double, 3> share{1, 0, 0};  ///< weights of the triangle's corners, summing to 1
};

/// m. REQUIRES a triangle of the mesh.
Vec3 position_of(const SkinPoint& point, const geometry::TriangleMesh& mesh);

/// The point of the mesh's surface that is nearest to `p`. REQUIRES a mesh with triangles.
SkinPoint nearest_on_skin(const geometry::TriangleMesh& mesh, Vec3 p);

struct Landmark {
  std::string name;  ///< e.g. "waist_front", "elbow_left"; left and right are the wearer's
  SkinPoint at;
  Vec3 place;  ///< m
};

/// The landmarks of a figure, in a fixed order, each on the skin.
std::vector<Landmark> find_landmarks(const geometry::TriangleMesh& mesh, const BodyFigure& figure);

/// The landmark of that name, or nullptr.
const Landmark* landmark_named(std::span<const Landmark> landmarks, std::string_view name);

}  // namespace toile::measure
