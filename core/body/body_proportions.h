#pragma once
// What a body measures where nobody says so.

#include <span>

#include "core/body/body_measures.h"
#include "core/body/figure.h"

namespace toile {

/// A body of a size table. Lengths in metres.
struct BodyPreset {
  std::string_view name;  ///< "eu38", "m50", "child116"
  Sex sex;
  double height, bust, waist, hip;

  MeasureSet measures() const;
};

/// EU 34 to 48 for women, 44 to 58 for men, children by height in cm.
std::span<const BodyPreset> body_presets();
const BodyPreset* find_preset(std::string_view name);  ///< null where there is none

/// `asked` with every gap filled.
///
/// Trunk girths: an asked one shifts the others by as much, as the columns of a size table do. The
/// tables go in steps as EN 13402-3 does (women 80-64-88 … 110-94-117, men's waist 12 cm below the chest up
/// to 100; children by heights 92 to 170); their figures are the project's own and were not compared with the
/// standard's text. Limbs and lengths: ratios to the stature or to the trunk's girth near them, of the order
/// of a survey of adults (ANSUR II, 2012) but not computed from its data. Places and names after ISO 8559-1.
MeasureSet with_proportions(Sex sex, const MeasureSet& asked);

/// The head's size against an adult's of the same stature; 1 for adults.
double head_size(Sex sex, double height);

}  // namespace toile
