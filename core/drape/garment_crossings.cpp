#include "core/drape/garment_crossings.h"

namespace toile::drape {

GarmentCrossings::GarmentCrossings(const sewing::GarmentMesh& garment)
    : counter_(collision::make_surface(garment.triangles, garment.vertex_count(), garment.weld)) {}

void GarmentCrossings::add_body(std::span<const Vec3> vertices, std::span<const Tri> triangles) {
  bodies_.push_back(collision::make_crossing_body(vertices, triangles));
}

void GarmentCrossings::move_body(std::size_t body, std::span<const Vec3> vertices) {
  bodies_[body] = collision::make_crossing_body(vertices, bodies_[body].triangles);
}

CrossingCount GarmentCrossings::count(std::span<const Vec3> x, Crew& crew) {
  CrossingCount count;
  counter_.place(x);
  for (const collision::CrossingBody& body : bodies_)
    count.cloth_body += static_cast<int>(counter_.with(body, crew).size());
  count.cloth_cloth = static_cast<int>(counter_.with_itself(crew).size());
  return count;
}

}  // namespace toile::drape
