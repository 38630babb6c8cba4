#include "core/draft/dart.h"

#include <array>

namespace toile::draft {

bool is_sewn(const Dart& dart) { return dart.width >= 6; }

void waist_with_dart(Outline& outline, Vec2 to, const Dart& dart, const std::string& before,
                     const std::string& after) {
  const Vec2 from = outline.at(), way = normalized(to - from);
  if (!is_sewn(dart)) {
    outline.line("waist_" + before, from + way * dart.at).line("waist_" + after, to);
    return;
  }
  // The piece lies to the left of a line that runs counter-clockwise around it.
  const Vec2 point = from + way * dart.at + perpendicular(way) * dart.length;
  outline.line("waist_" + before, from + way * (dart.at - dart.width / 2)).line("dart_" + before, point);
  outline.line("dart_" + after, from + way * (dart.at + dart.width / 2)).line("waist_" + after, to);
}

pattern::Panel strip(const std::string& id, const std::string& low, double length, double height) {
  Outline outline({0, 0});
  outline.line(low, {length, 0}).notch(length / 2);
  outline.line("end_b", {length, height}).line("top", {0, height}).line("end_a", {0, 0});
  return piece(id, outline);
}

}  // namespace toile::draft
