#include "core/project/create/pocket_corners.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/geometry/polygon2.h"
#include "core/pattern/curve.h"
#include "core/pattern/loop_part.h"
#include "core/pattern/seams/model.h"
#include "core/pattern/seams/roles.h"
#include "core/pattern/seams/shapes.h"
#include "core/project/create/front_sides.h"
#include "core/project/create/pocket_facings.h"

namespace toile::create {
namespace {

constexpr double kOnMouth = 1;  // mm, of a notch from the mouth

/// A front's side, the mouth after it or before it, and its waist, in edges of the panel.
struct Mouth {
  Index side = kNone, mouth = kNone, waist = kNone;  ///< of the side the edge at the mouth
  double side_length = 0;                            ///< mm, from the hem
  bool after = false;                                ///< the outline runs from the side to the waist
};

/// All that may be one; a crotch faces up a little, too, and is none.
std::vector<Mouth> mouths_of(const seams::SeamModel& m, Index panel) {
  std::vector<Mouth> mouths;
  for (const seams::SeamRun& lowest : m.runs) {
    if (lowest.panel != panel || !begins_side(m, lowest)) continue;
    for (const bool after : {true, false}) {
      std::vector<const seams::SeamRun*> side = side_from(m, lowest, after);
      if (side.size() < 2 || side.back()->up < kSideUp || seams::is_leg_crotch(m, *side.back())) continue;
      const seams::SeamRun& mouth = *side.back();
      side.pop_back();
      mouths.push_back({side.back()->edge, mouth.edge, beside(m, mouth, after).edge, length_of(side), after});
    }
  }
  return mouths;
}

/// Where both go on to, and how far each does; nothing where they do not meet there.
struct Meeting {
  Vec2 at;
  double side = 0, waist = 0;  ///< mm
};

std::optional<Meeting> meeting_of(const pattern::Panel& front, const Mouth& mouth) {
  const std::vector<pattern::PanelEdge>& edges = front.outline.edges;
  const pattern::PanelEdge &side = edges[mouth.side], &waist = edges[mouth.waist];
  const Vec2 from = mouth.after ? side.curves.back().p3 : side.curves.front().p0;
  const Vec2 to = mouth.after ? waist.curves.front().p0 : waist.curves.back().p3;
  const Vec2 up = way_on(side, mouth.after), out = way_on(waist, !mouth.after);
  const double sine = cross(up, out);
  if (std::abs(sine) < 0.5) return std::nullopt;
  const double s = cross(to - from, out) / sine, w = cross(to - from, up) / sine;
  if (std::min(s, w) < kLeastCut || std::max(s, w) > kMostCut) return std::nullopt;
  return Meeting{from + s * up, s, w};
}

/// As the line of the mouth on a facing tells, which knows how the hip is curved, or else where side and
/// waist meet that run on straight.
std::optional<PocketCorner> corner_at_mouth(std::span<const pattern::Panel> panels, const seams::SeamModel& m,
                                            Index panel, const std::vector<double>& behind) {
  const pattern::Panel& front = panels[panel];
  const std::vector<pattern::PanelEdge>& edges = front.outline.edges;
  const std::vector<Mouth> mouths = mouths_of(m, panel);
  const auto adds = [&](const Mouth& mouth, double side) {
    return !agrees(behind, mouth.side_length) && agrees(behind, mouth.side_length + side);
  };
  for (const Mouth& mouth : mouths) {
    const pattern::PanelEdge& side = edges[mouth.side];
    const Vec2 from = mouth.after ? side.curves.back().p3 : side.curves.front().p0;
    for (const Vec2 corner : facing_corners_at(panels, m, side, edges[mouth.waist], mouth.after))
      if (adds(mouth, length(corner - from))) return PocketCorner{panel, mouth.mouth, corner};
  }
  for (const Mouth& mouth : mouths) {
    const std::optional<Meeting> meeting = meeting_of(front, mouth);
    if (meeting && adds(mouth, meeting->side)) return PocketCorner{panel, mouth.mouth, meeting->at};
  }
  return std::nullopt;
}

}  // namespace

std::vector<PocketCorner> pocket_corners(std::span<const pattern::Panel> panels) {
  pattern::Pattern pattern;
  pattern.panels.assign(panels.begin(), panels.end());
  const seams::SeamModel m = seams::make_seam_model(pattern);
  if (std::none_of(m.words.begin(), m.words.end(), [](const auto& words) { return words.layer; })) return {};
  const std::vector<double> behind = sides_behind(m);
  std::vector<PocketCorner> corners;
  for (Index p = 0; p < static_cast<Index>(panels.size()); ++p) {
    if (m.words[p].face <= 0 || m.words[p].layer || !seams::has_leg_crotch(m, p)) continue;
    std::optional<PocketCorner> corner = corner_at_mouth(panels, m, p, behind);
    if (!corner) corner = corner_by_facing(panels, m, p, behind);
    if (corner) corners.push_back(*corner);
  }
  return corners;
}

pattern::Panel with_corner(const pattern::Panel& front, const PocketCorner& pocket) {
  pattern::Panel whole = front;
  std::vector<pattern::PanelEdge>& edges = whole.outline.edges;
  const std::size_t n = edges.size(), at = static_cast<std::size_t>(pocket.mouth);
  const pattern::PanelEdge cut = edges[at], mouth{"", pattern::curves_between(cut, pocket.from, pocket.to)};
  const pattern::CubicBezier on = pattern::line_segment(mouth.curves.front().p0, pocket.corner),
                             back = pattern::line_segment(pocket.corner, mouth.curves.back().p3);
  std::vector<pattern::CubicBezier>&before = edges[pocket.from > 0 ? at : (at + n - 1) % n].curves,
  &after = edges[pocket.to < 1 ? at : (at + 1) % n].curves;
  if (pocket.from > 0) before = pattern::curves_between(cut, 0, pocket.from);
  if (pocket.to < 1) after = pattern::curves_between(cut, pocket.to, 1);
  before.push_back(on);
  after.insert(after.begin(), back);
  if (pocket.from == 0 && pocket.to == 1) edges.erase(edges.begin() + pocket.mouth);
  const std::vector<Vec2> line = pattern::flatten(mouth, 0.1);
  std::erase_if(whole.notches, [&](const pattern::Notch& notch) {
    return length(geometry::nearest_on(line, notch.at) - notch.at) < kOnMouth;
  });
  return whole;
}

}  // namespace toile::create
