#pragma once
// What the layers of a pattern drawing stand for.

#include <string>

namespace toile::dxf {

/// By the numbers of ANSI/AAMA-292 and ASTM D6673, and by the names that people give.
enum class DxfRole {
  cut,       ///< 1
  turn,      ///< 2: points where the outline turns
  curve,     ///< 3: points on its curves
  notch,     ///< 4, and 80 to 83 for other shapes of notch
  grade,     ///< 5
  mirror,    ///< 6
  grain,     ///< 7
  internal,  ///< 8
  guide,     ///< 9, 10: stripes and plaids
  cutout,    ///< 11
  drill,     ///< 13
  sew,       ///< 14
  text,      ///< 15
  repeat,    ///< 84, 85, 86, 87: layers 1, 8, 11, 14 once more, more closely drawn
  other
};

DxfRole role_of_layer(const std::string& layer);

/// Of a layer that repeats another one at another density: the other one's role. Else its own.
DxfRole repeated_role(const std::string& layer);

}  // namespace toile::dxf
