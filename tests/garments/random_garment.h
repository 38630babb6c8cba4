#pragma once
// Any garment at all: what a user, a careless one or a mad one, may ask the engine to drape.

#include <cstdint>
#include <string>

#include "core/drape/drape_input.h"

namespace toile::test {

struct RandomGarment {
  drape::DrapeInput input;
  std::string scene, form, shapes;  ///< in words, for the printed line
  int cancel_at_step = -1;          ///< -1: never; 0: before it begins
};

/// The garment of a seed: 1 to 6 pieces of any shape, placed, sewn and held by chance, on any form or none;
/// fabrics from a tenth to ten times of what there is in shops; particle distances of 3 to 40 mm, gravity 0
/// to 30 m/s². Sized so that a drape takes about a second.
RandomGarment random_garment(std::uint64_t seed);

}  // namespace toile::test
