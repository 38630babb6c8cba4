#include "core/dressing/wearer.h"

#include <algorithm>

namespace toile::dressing {

namespace {

constexpr double kCell = 0.01;     // m, of the distance field
constexpr double kOffSkin = 4e-3;  // m off the skin

}  // namespace

Wearer::Wearer(const Person& person)
    : figure_(person.figure),
      field_(person.body->mesh, kCell),
      mittens_(figure_),
      crossing_(collision::make_crossing_body(person.body->mesh.vertices, person.body->mesh.triangles)),
      obstacle_(collision::make_obstacle(person.body->mesh.vertices, person.body->mesh.triangles,
                                         person.body->friction, person.body->skin_offset)),
      skeleton_(skeleton_of(figure_)),
      margin_(std::max(kOffSkin, 2 * person.body->skin_offset)) {}

}  // namespace toile::dressing
