#pragma once
// What a body measures where nobody says so.

#include <span>

#include "core/body/mannequin/figure.h"
#include "core/body/measure/measures.h"

namespace toile::mannequin {

/// A body of a size table. Lengths in metres.
struct BodyPreset {
  std::string_view name;  ///< "eu38", "m50", "child116"
  Sex sex;
  double height, bust, waist, hip;

  measure::MeasureSet measures() const;
};

/// EU 34 to 48 for women, 44 to 58 for men, children by height in cm.
///
/// Women's bust-waist-hip go in the steps of EN 13402-3's women's scale (80-64-88 to 104-88-112 by 4 cm, then
/// 110-94-117), as public summaries of the standard print it; its own text was not at hand. Men's chest is
/// twice the size, the waist 12 cm less, as that scale's men's rows are up to 112-100 (size 58, 116-104, lies
/// between its rows 112-100 and 118-106). Children's heights are its steps of 6 cm. The standard pairs no hip
/// with a man's chest, no height with a woman's bust, and no girths with a child's height: these are the
/// project's own.
std::span<const BodyPreset> body_presets();
const BodyPreset* find_preset(std::string_view name);  ///< null where there is none

/// `asked` with every gap filled.
///
/// Trunk girths: an asked one shifts the others by as much, as the columns of a size table do. Limbs and
/// lengths: ratios to the stature or to the trunk's girth near them, of the order of a survey of adults
/// (ANSUR II, 2012) but not computed from its data. Places and names after ISO 8559-1.
measure::MeasureSet with_proportions(Sex sex, const measure::MeasureSet& asked);

/// The head's size against an adult's of the same stature; 1 for adults.
double head_size(Sex sex, double height);

}  // namespace toile::mannequin
