#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/geometry/triangle_mesh.h"

namespace toile::body {

/// A shape that a body comes to.
struct Keyframe {
  double at = 0;               ///< s after it begins to move, more than 0
  std::vector<Vec3> vertices;  ///< m, of its mesh, whose triangles stay
};

/// Something solid that cloth falls on: a person, a form, a table. Outward normals. Metres, y up.
struct Body {
  std::string id;
  geometry::TriangleMesh mesh;
  double friction = 0.4;      ///< Coulomb, cloth on this body
  double skin_offset = 1e-3;  ///< m, distance that cloth keeps from the skin
  /// Share of its speed towards the skin that cloth keeps, turned round, when it strikes: 0 stays, 1 leaves
  /// as fast as it came.
  double restitution = 0;
  /// In order of time; each vertex goes straight from one to the next. Empty: it stands still.
  std::vector<Keyframe> motion = {};
  std::vector<std::string> notes = {};  ///< what was mended when its file was read, in sentences
};

/// m, so many s into a motion: straight from one shape to the next, and the last from then on.
std::vector<Vec3> vertices_at(const std::vector<Vec3>& start, std::span<const Keyframe> motion, double time);

}  // namespace toile::body
