#pragma once
// What a person does to cloth while it drapes, as data: each touch with the step after which it came. The
// same input with the same touches gives the same bytes, whoever made them and whenever.

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/types.h"

namespace toile::drape {

enum class TouchKind : std::uint8_t {
  kPull,   ///< a hand takes hold of a point, or draws what it holds elsewhere
  kLetGo,  ///< a hand opens
  kPin,    ///< a point stays where it is, until it is unpinned
  kUnpin,
};

/// A point of the cloth: shares, summing to 1, of the corners of one of the garment's triangles.
struct TouchedPoint {
  Index triangle = kNone;
  std::array<double, 3> share{};
  friend bool operator==(const TouchedPoint&, const TouchedPoint&) = default;
};

struct Touch {
  int step = 0;  ///< substeps that the drape had made
  TouchKind kind = TouchKind::kPull;
  /// Which hand, or which pin. A pin that is set with 0 is given the next number, from 1.
  int id = 0;
  TouchedPoint at;  ///< of kPull, where its hand holds nothing yet, and of kPin
  Vec3 target;      ///< m, where to; of kPull
  friend bool operator==(const Touch&, const Touch&) = default;
};

/// What a hand or a pin holds.
struct Grip {
  int id = 0;
  TouchedPoint at;
  Vec3 wanted;  ///< m, where the hand is; of a pin, where it is
  Vec3 goal;    ///< m, to where it draws by now: it follows the hand at a limited speed
};

/// What the hands on a drape remember.
struct HandsState {
  std::vector<Grip> pulls, pins;  ///< in the order in which they came
  std::vector<Touch> log;         ///< all there were
};

}  // namespace toile::drape
