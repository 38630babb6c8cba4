#pragma once
// The exact count of crossings that every drape is reported with, by whatever method it runs.

#include <span>
#include <vector>

#include "core/collision/crossings.h"
#include "core/drape/drape_result.h"
#include "core/sewing/garment_mesh.h"

namespace toile {
class Crew;
}

namespace toile::drape {

class GarmentCrossings {
 public:
  explicit GarmentCrossings(const sewing::GarmentMesh& garment);

  void add_body(std::span<const Vec3> vertices, std::span<const Tri> triangles);
  /// One that was added, by its number, is elsewhere.
  void move_body(std::size_t body, std::span<const Vec3> vertices);
  const std::vector<collision::CrossingBody>& bodies() const { return bodies_; }
  /// `x`: m, of the garment's vertices.
  CrossingCount count(std::span<const Vec3> x, Crew& crew);

 private:
  collision::CrossingCounter counter_;
  std::vector<collision::CrossingBody> bodies_;
};

}  // namespace toile::drape
