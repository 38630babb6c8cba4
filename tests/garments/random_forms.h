#pragma once
// What cloth falls on: one solid or two, standing around the y axis.

#include <string>
#include <vector>

#include "core/base/aabb.h"
#include "core/body/body.h"
#include "tests/garments/random_chance.h"

namespace toile::test {

struct Form {
  std::string kind;
  std::vector<body::Body> bodies;
  Aabb3 box;  ///< m, around all bodies; a point when there is none

  /// m, the farthest that a solid reaches sideways.
  double reach() const;
};

/// A form for cloth of about `size` m. A limb is as thick as a person's, whatever the cloth.
Form make_form(Chance& chance, double size);

/// An upright limb that a ring may be put around. `radius` m.
Form make_pole(Chance& chance, double radius, double height);

}  // namespace toile::test
