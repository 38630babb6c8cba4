#pragma once
// Plain garments as a pattern maker draws them, for the sample's mannequin. mm.

#include <string>
#include <vector>

#include "core/pattern/curve.h"
#include "core/pattern/pattern.h"

namespace toile::test {

/// Straight edges e0, e1, … from corner to corner, counter-clockwise.
inline pattern::Panel polygon(const std::string& id, const std::vector<Vec2>& corners) {
  pattern::Panel panel;
  panel.id = id;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    panel.outline.edges.push_back(
        {"e" + std::to_string(k), {pattern::line_segment(corners[k], corners[(k + 1) % corners.size()])}});
  }
  return panel;
}

/// The panel drawn over to the other side; edge k of the one is edge n - 1 - k of the other.
inline pattern::Panel turned_over(const std::string& id, const std::vector<Vec2>& corners) {
  std::vector<Vec2> mirrored;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec2 p = corners[(corners.size() - k) % corners.size()];
    mirrored.push_back({-p.x, p.y});
  }
  return polygon(id, mirrored);
}

inline pattern::Seam seam(const std::string& id, std::vector<pattern::SeamEdge> a,
                          std::vector<pattern::SeamEdge> b) {
  return {id, std::move(a), std::move(b), false};
}

inline pattern::Pattern skirt() {
  pattern::Pattern pattern;
  const std::vector<Vec2> panel{{-280, 0}, {280, 0}, {250, 500}, {-250, 500}};
  const std::vector<Vec2> band{{0, 0}, {375, 0}, {375, 40}, {0, 40}};
  pattern.panels = {polygon("skirt_front", panel), polygon("skirt_back", panel), polygon("wb_front", band),
                    polygon("wb_back", band)};
  pattern.seams = {seam("left", {{0, 1}}, {{1, 3}}),      seam("right", {{0, 3}}, {{1, 1}}),
                   seam("band_left", {{2, 1}}, {{3, 3}}), seam("band_right", {{2, 3}}, {{3, 1}}),
                   seam("front", {{2, 0}}, {{0, 2}}),     seam("back", {{3, 0}}, {{1, 2}})};
  return pattern;
}

/// Six equal gores that nothing names, each sewn to the next.
inline pattern::Pattern gored_skirt() {
  pattern::Pattern pattern;
  for (int k = 0; k < 6; ++k) {
    pattern.panels.push_back(
        polygon("piece" + std::to_string(k + 1), {{-110, 0}, {110, 0}, {70, 550}, {-70, 550}}));
    pattern.seams.push_back(seam("s" + std::to_string(k), {{k, 1}}, {{(k + 1) % 6, 3}}));
  }
  return pattern;
}

/// A bodice without sleeves, a skirt sewn to it, and a strip around the neck that closes at the back.
inline pattern::Pattern dress() {
  pattern::Pattern pattern;
  const std::vector<Vec2> bodice{{-215, 0},  {215, 0},    {250, 170},  {200, 380},
                                 {110, 405}, {-110, 405}, {-200, 380}, {-250, 170}};
  const std::vector<Vec2> skirt{{-330, 0}, {330, 0}, {215, 600}, {-215, 600}};
  pattern.panels = {polygon("bodice_front", bodice), polygon("bodice_back", bodice),
                    polygon("skirt_front", skirt), polygon("skirt_back", skirt),
                    polygon("collar", {{0, 0}, {220, 0}, {440, 0}, {440, 40}, {0, 40}})};
  pattern.seams = {seam("side_left", {{0, 1}}, {{1, 7}}),     seam("side_right", {{0, 7}}, {{1, 1}}),
                   seam("shoulder_left", {{0, 3}}, {{1, 5}}), seam("shoulder_right", {{0, 5}}, {{1, 3}}),
                   seam("skirt_left", {{2, 1}}, {{3, 3}}),    seam("skirt_right", {{2, 3}}, {{3, 1}}),
                   seam("waist_front", {{2, 2}}, {{0, 0}}),   seam("waist_back", {{3, 2}}, {{1, 0}}),
                   seam("neck_front", {{4, 0}}, {{0, 4}}),    seam("neck_back", {{4, 1}}, {{1, 4}}),
                   seam("collar_ends", {{4, 2}}, {{4, 4}})};
  return pattern;
}

/// A front, a back and two sleeves that close around the arms; e2 … e5 of the body are armhole, shoulder,
/// neck and shoulder.
inline pattern::Pattern shirt(const std::string& front = "front", const std::string& back = "back") {
  pattern::Pattern pattern;
  const std::vector<Vec2> body{{-260, 0}, {260, 0},   {260, 340},  {205, 560},
                               {80, 590}, {-80, 590}, {-205, 560}, {-260, 340}};
  const std::vector<Vec2> sleeve{{-165, 0}, {165, 0}, {175, 90}, {0, 235}, {-175, 90}};
  pattern.panels = {polygon(front, body), polygon(back, body), polygon("sleeve_a", sleeve),
                    polygon("sleeve_b", sleeve)};
  // Seen from its right side a front's right edges are the wearer's left, a back's the wearer's right.
  pattern.seams = {seam("side_left", {{0, 1}}, {{1, 7}}),       seam("side_right", {{0, 7}}, {{1, 1}}),
                   seam("shoulder_left", {{0, 3}}, {{1, 5}}),   seam("shoulder_right", {{0, 5}}, {{1, 3}}),
                   seam("under_left", {{2, 1}}, {{2, 4}}),      seam("under_right", {{3, 1}}, {{3, 4}}),
                   seam("cap_left_front", {{2, 3}}, {{0, 2}}),  seam("cap_left_back", {{2, 2}}, {{1, 6}}),
                   seam("cap_right_front", {{3, 2}}, {{0, 6}}), seam("cap_right_back", {{3, 3}}, {{1, 2}})};
  return pattern;
}

/// A jacket without sleeves that is open in front, a stand all around its neck and a collar on that.
inline pattern::Pattern collared_vest() {
  pattern::Pattern pattern;
  const std::vector<Vec2> front{{10, 0}, {260, 0}, {260, 340}, {205, 560}, {80, 590}, {10, 530}};
  const std::vector<Vec2> back{{-260, 0}, {260, 0},   {260, 340},  {205, 560},
                               {80, 590}, {-80, 590}, {-205, 560}, {-260, 340}};
  pattern.panels = {polygon("left_front", front), turned_over("right_front", front), polygon("back", back),
                    polygon("collar_stand", {{0, 0}, {344, 0}, {344, 30}, {0, 30}}),
                    polygon("collar", {{0, 0}, {344, 0}, {350, 60}, {-6, 60}})};
  pattern.seams = {seam("side_left", {{0, 1}}, {{2, 7}}),
                   seam("side_right", {{1, 4}}, {{2, 1}}),
                   seam("shoulder_left", {{0, 3}}, {{2, 5}}),
                   seam("shoulder_right", {{1, 2}}, {{2, 3}}),
                   seam("neck", {{3, 0}}, {{1, 1}, {2, 4}, {0, 4}}),
                   seam("fold", {{4, 0}}, {{3, 2}})};
  return pattern;
}

/// Four legs: e1 inner leg, e2 crotch, e3 waist, e4 outer leg of the wearer's right front.
inline pattern::Pattern trousers() {
  pattern::Pattern pattern;
  const std::vector<Vec2> front{{0, 0}, {200, 0}, {290, 700}, {225, 960}, {-10, 960}};
  const std::vector<Vec2> back{{0, 0}, {230, 0}, {230, 960}, {-5, 960}, {-80, 700}};
  pattern.panels = {polygon("right_front_leg", front), turned_over("left_front_leg", front),
                    polygon("right_back_leg", back), turned_over("left_back_leg", back)};
  const auto over = [](Index edge) { return 4 - edge; };
  pattern.seams = {
      seam("inner_right", {{0, 1}}, {{2, 4}}),        seam("inner_left", {{1, over(1)}}, {{3, over(4)}}),
      seam("outer_right", {{0, 4}}, {{2, 1}}),        seam("outer_left", {{1, over(4)}}, {{3, over(1)}}),
      seam("crotch_front", {{0, 2}}, {{1, over(2)}}), seam("crotch_back", {{2, 3}}, {{3, over(3)}})};
  return pattern;
}

/// Fourteen wedges around a band: the skirt opens to a half circle.
inline pattern::Pattern wedge_skirt() {
  pattern::Pattern pattern;
  for (int k = 0; k < 14; ++k)
    pattern.panels.push_back(
        polygon("skirt_panel_" + std::to_string(k), {{-90, 0}, {90, 0}, {27, 500}, {-27, 500}}));
  const std::vector<Vec2> band{{0, 0}, {378, 0}, {378, 40}, {0, 40}};
  pattern.panels.push_back(polygon("wb_front", band));
  pattern.panels.push_back(polygon("wb_back", band));
  for (int k = 0; k < 14; ++k)
    pattern.seams.push_back(seam("side" + std::to_string(k), {{k, 1}}, {{(k + 1) % 14, 3}}));
  std::vector<pattern::SeamEdge> front, back;
  for (int k = 6; k >= 0; --k) front.push_back({k, 2});
  for (int k = 13; k >= 7; --k) back.push_back({k, 2});
  pattern.seams.push_back(seam("front", {{14, 0}}, front));
  pattern.seams.push_back(seam("back", {{15, 0}}, back));
  pattern.seams.push_back(seam("band_left", {{14, 1}}, {{15, 3}}));
  pattern.seams.push_back(seam("band_right", {{14, 3}}, {{15, 1}}));
  return pattern;
}

/// A top whose neckline is a V down to its lower edge, before and behind: only the shoulders hold its straps.
inline pattern::Pattern open_top() {
  pattern::Pattern p;
  const std::vector<Vec2> corners{{-220, 0}, {220, 0},    {240, 280},  {170, 420},  {170, 500}, {110, 500},
                                  {0, 60},   {-110, 500}, {-170, 500}, {-170, 420}, {-240, 280}};
  p.panels = {polygon("front", corners), turned_over("back", corners)};
  for (const Index e : {1, 4, 7, 10})
    p.seams.push_back(seam("s" + std::to_string(e), {{0, e}}, {{1, 10 - e}}));
  return p;
}

/// Two rectangles sewn at their sides, as a top without straps.
inline pattern::Pattern strapless() {
  pattern::Pattern pattern;
  const std::vector<Vec2> piece{{-240, 0}, {240, 0}, {240, 400}, {-240, 400}};
  pattern.panels = {polygon("bodice_front", piece), polygon("bodice_back", piece)};
  pattern.seams = {seam("left", {{0, 1}}, {{1, 3}}), seam("right", {{0, 3}}, {{1, 1}})};
  return pattern;
}

}  // namespace toile::test
