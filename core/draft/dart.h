#pragma once
// Darts in waist lines, and the strips that go over them.

#include <string>

#include "core/draft/outline.h"

namespace toile::draft {

/// Millimetres.
struct Dart {
  double at = 0;      ///< its middle, from where the waist line begins
  double width = 0;   ///< less than 6: the line has no dart
  double length = 0;  ///< square to the waist line
};

/// Draws a straight waist line to `to` with a dart: edges "waist_A", "dart_A", "dart_B", "waist_B" with the
/// names `before` and `after` for A and B. Without a dart it is both waist edges, parted at the dart's place,
/// and no dart edges.
void waist_with_dart(Outline& outline, Vec2 to, const Dart& dart, const std::string& before,
                     const std::string& after);

bool is_sewn(const Dart& dart);

/// A straight strip: edges `low`, end_b, top, end_a, from its lower left corner.
pattern::Panel strip(const std::string& id, const std::string& low, double length, double height);

}  // namespace toile::draft
