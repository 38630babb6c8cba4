#pragma once
// Lines that are drawn across a piece.

#include <optional>
#include <vector>

#include "core/base/types.h"

namespace toile::create {

/// From a place on an outline straight to another, mm.
struct Chord {
  Vec2 from, to;
};

/// The drawn line where it is straight and leads from outline to outline: it may end `short_mm` before it, or
/// beyond it in the allowance. REQUIRES points.
std::optional<Chord> chord_across(const std::vector<Vec2>& line, const std::vector<Vec2>& outline,
                                  double short_mm = 3);

}  // namespace toile::create
