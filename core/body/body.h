#pragma once

#include <string>

#include "core/geometry/triangle_mesh.h"

namespace toile {

/// Something solid that cloth falls on: a person, a form, a table. Outward normals. Metres, y up.
struct Body {
  std::string id;
  TriangleMesh mesh;
  double friction = 0.4;      ///< Coulomb, cloth on this body
  double skin_offset = 1e-3;  ///< m, distance that cloth keeps from the skin
};

}  // namespace toile
