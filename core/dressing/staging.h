#pragma once
// Where the pieces begin before they are sewn around the slim figure: higher than they were placed, since
// shoulder seams close under the arms otherwise, and clear of the arms.

#include <span>
#include <vector>

#include "core/body/measure/figure.h"
#include "core/sewing/assembly.h"

namespace toile::dressing {

/// What of the body a piece is for, by where it is placed.
enum class Covers : std::uint8_t { kTrunk, kArm, kBelow, kNeck };

/// Where sleeves begin that are cut on, parts of the trunk's pieces that reach far beyond the armpits.
enum class CutOn : std::uint8_t {
  kAsPlaced,
  kAlongFreeArms,  ///< along the arms, unless the garment has sleeves of their own
  kAlongArms
};

/// One a panel. Where sleeves that are cut on begin along the arms, long pieces that have them are the
/// trunk's, however wide; else they hang from it, as wheels do.
std::vector<Covers> covers_of(const sewing::Assembly& assembly, const measure::BodyFigure& figure,
                              CutOn sleeves = CutOn::kAsPlaced);

/// Whether they do so in this garment.
bool are_along_arms(std::span<const Covers> covers, CutOn sleeves);

/// How what is wider below the waist than can pass the hands begins.
enum class Wide : std::uint8_t {
  kAsPlaced,
  kSmaller,  ///< as a whole
  kFolded,   ///< hung down at the sides, as long as it is
};

/// How far from where they were placed pieces begin.
struct Staging {
  double lift = 0;         ///< m, upwards, of garments that have something for the trunk
  double lift_others = 0;  ///< m, of skirts and trousers
  bool arms_centred =
      true;  ///< pieces for an arm have its line in their middle; else they go up as the trunk
  bool trunk_narrow = false;  ///< pieces of the trunk that reach beyond the armpits are drawn in between them
  Wide below = Wide::kSmaller;
  CutOn sleeves = CutOn::kAsPlaced;
};

/// The start of each garment vertex, m.
std::vector<Vec3> staged(const sewing::Assembly& assembly, std::span<const Covers> covers,
                         const measure::BodyFigure& figure, const Staging& staging);

}  // namespace toile::dressing
