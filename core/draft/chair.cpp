#include "core/draft/chair.h"

#include "core/base/units.h"
#include "core/draft/joined_boxes.h"

namespace toile::draft {

geometry::TriangleMesh chair_solid(const ChairSize& c) {
  constexpr double kStep = 0.04;
  const double half = c.width / 2, deep = c.depth / 2, under = c.seat - c.cushion;
  std::vector<Box> parts{{{-half, under, -deep}, {half, c.seat, deep}},
                         {{-half, c.seat, -deep}, {half, c.seat + c.back, c.back_thick - deep}}};
  for (const double x : {-half, half - c.leg})
    for (const double z : {-deep, deep - c.leg}) parts.push_back({{x, 0, z}, {x + c.leg, under, z + c.leg}});
  for (Box& part : parts) {
    part.low = part.low * 1e-3;
    part.high = part.high * 1e-3;
  }
  geometry::TriangleMesh mesh = joined_boxes(parts, kStep);
  const double seat = metres_from_mm(c.seat);
  for (Vec3& p : mesh.vertices)
    if (p.y > seat) p.z -= c.rake * (p.y - seat);
  return mesh;
}

}  // namespace toile::draft
