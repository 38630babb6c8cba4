#pragma once
// A small pattern that edits are tried on.

#include <string>
#include <utility>
#include <vector>

#include "core/pattern/curve.h"
#include "core/pattern/edit/edit.h"
#include "core/pattern/pattern.h"

namespace toile::test {

inline pattern::PanelEdge straight(std::string id, Vec2 a, Vec2 b) {
  return {std::move(id), {pattern::line_segment(a, b)}};
}

/// 100 × 200 mm at `corner`: bottom, right, top, left.
inline pattern::Panel sheet(std::string id, Vec2 corner = {}) {
  const Vec2 a = corner, b = a + Vec2{100, 0}, c = a + Vec2{100, 200}, d = a + Vec2{0, 200};
  pattern::Panel panel;
  panel.id = std::move(id);
  panel.fabric = "wool";
  panel.outline.edges = {straight("bottom", a, b), straight("right", b, c), straight("top", c, d),
                         straight("left", d, a)};
  return panel;
}

/// Two sheets sewn at two sides: front's right to back's left over the whole length, front's top to back's
/// top from a quarter to the end.
inline pattern::Pattern two_sheets() {
  pattern::Pattern pattern;
  pattern.panels = {sheet("front"), sheet("back", {300, 0})};
  pattern.panels[0].notches = {{{100, 100}, 5, {-1, 0}}};
  pattern.panels[0].outline.edges[1].curves = {pattern::line_segment({100, 0}, {100, 100}),
                                               pattern::line_segment({100, 100}, {100, 200})};
  pattern.panels[0].lines = {{"fold", {{20, 20}, {80, 20}}}};
  pattern.seams = {{"side", {{0, 1}}, {{1, 3}}, false},
                   {"shoulder", {{0, 2, false, 0.25, 1}}, {{1, 2, true, 0, 0.75}}, true}};
  return pattern;
}

}  // namespace toile::test
