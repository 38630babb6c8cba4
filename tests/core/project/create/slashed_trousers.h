#pragma once
// Trousers with pockets at the side.

#include "tests/core/pattern/garments.h"

namespace toile::garments {

/// Right half of trousers' front, cut away at a pocket between its side (so high, mm) and its waist.
inline pattern::Panel slashed_front(double side) {
  return piece(
      "Front",
      {{0, 0}, {220, 0}, {220, side}, {180, 1000}, {0, 1000, Vec2{0, 900}, Vec2{0, 775}}, {-60, 760}});
}

inline pattern::Panel back_of_trousers(double side) {
  return piece("Back", {{0, 0}, {240, 0}, {240, side}, {0, side, Vec2{0, 900}, Vec2{0, 775}}, {-110, 760}});
}

}  // namespace toile::garments
