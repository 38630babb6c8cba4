#pragma once

#include <string>

#include "core/base/result.h"
#include "core/geometry/triangle_mesh.h"

namespace toile::measure {

/// How a body stood in its file.
struct BodyStance {
  double unit_in_m = 1;      ///< m per unit of the file
  char up = 'y';             ///< axis
  bool upside_down = false;  ///< head below
  int quarter_turns = 0;     ///< about the upright axis, to face +z
  double floor = 0;          ///< m; height of the soles before they were put on y = 0
};

struct StandingBody {
  geometry::TriangleMesh mesh;  ///< metres, y up, feet on y = 0, facing +z
  BodyStance stance;
};

/// Guesses unit and directions of a person's mesh by its shape and puts it upright: a stature lies between
/// 0.55 and 5.5 m (units of 1, 0.1, 0.01 or 0.001 m), y or z points up, legs are two and below, arms to the
/// sides, toes in front. Error: "body.not_a_body" where the shape says none of this.
Result<StandingBody> stand_body(geometry::TriangleMesh mesh);

}  // namespace toile::measure
