#pragma once
// What the layers of a pattern drawing stand for.

#include <string>

namespace toile::dxf {

/// By the numbers of ANSI/AAMA-292 and ASTM D6673, and by the names that people give.
enum class DxfRole {
  kCut,       ///< 1
  kTurn,      ///< 2: points where the outline turns
  kCurve,     ///< 3: points on its curves
  kNotch,     ///< 4, and 80 to 83 for other shapes of notch
  kGrade,     ///< 5
  kMirror,    ///< 6
  kGrain,     ///< 7
  kInternal,  ///< 8
  kGuide,     ///< 9, 10: stripes and plaids
  kCutout,    ///< 11
  kDrill,     ///< 13
  kSew,       ///< 14
  kText,      ///< 15
  kRepeat,    ///< 84, 85, 86, 87: layers 1, 8, 11, 14 once more, more closely drawn
  kOther
};

DxfRole role_of_layer(const std::string& layer);

/// Of a layer that repeats another one at another density: the other one's role. Else its own.
DxfRole repeated_role(const std::string& layer);

}  // namespace toile::dxf
