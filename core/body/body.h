#pragma once

#include <string>
#include <vector>

#include "core/geometry/triangle_mesh.h"

namespace toile::body {

/// Something solid that cloth falls on: a person, a form, a table. Outward normals. Metres, y up.
struct Body {
  std::string id;
  geometry::TriangleMesh mesh;
  double friction = 0.4;      ///< Coulomb, cloth on this body
  double skin_offset = 1e-3;  ///< m, distance that cloth keeps from the skin
  /// Share of its speed towards the skin that cloth keeps, turned round, when it strikes: 0 stays, 1 leaves
  /// as fast as it came.
  double restitution = 0;
  std::vector<std::string> notes = {};  ///< what was mended when its file was read, in sentences
};

}  // namespace toile::body
