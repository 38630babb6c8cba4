#include "core/project/create/pocket_facings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/pattern/curve.h"
#include "core/project/create/drawn_lines.h"
#include "core/project/create/front_sides.h"

namespace toile::create {
namespace {

/// A corner of a facing, seen from the line of the mouth that is drawn on it, mm.
struct FacingCorner {
  double line = 0;               ///< length of the line
  double along = 0, beyond = 0;  ///< of the corner, from an end of the line and off it
};

/// All corners of facings that have such a line, seen from either of its ends.
std::vector<FacingCorner> facing_corners(std::span<const pattern::Panel> panels, const seams::SeamModel& m) {
  constexpr double kChords = 0.05, kOff = 10;  // mm
  std::vector<FacingCorner> found;
  for (std::size_t p = 0; p < panels.size(); ++p) {
    if (!m.words[p].layer) continue;
    const std::vector<Vec2> outline = pattern::flatten(panels[p].outline, kChords);
    for (const pattern::InnerLine& line : panels[p].lines) {
      const std::optional<Chord> mouth = line.drawn ? chord_across(line.points, outline) : std::nullopt;
      if (!mouth) continue;
      const double long_as = length(mouth->to - mouth->from);
      const Vec2 along = normalized(mouth->to - mouth->from);
      for (const pattern::PanelEdge& edge : panels[p].outline.edges) {
        const Vec2 off = edge.curves.front().p0 - mouth->from;
        const double beyond = std::abs(cross(along, off));
        if (beyond < kOff) continue;
        found.push_back({long_as, dot(off, along), beyond});
        found.push_back({long_as, long_as - dot(off, along), beyond});
      }
    }
  }
  return found;
}

/// The side of a front whose last edge runs into a mouth without a corner, up to its end at the waist.
struct SmoothSide {
  Index edge = kNone, waist = kNone;
  double below = 0;    ///< mm, of the side's edges before it
  bool after = false;  ///< as of Mouth
};

std::vector<SmoothSide> smooth_sides_of(const seams::SeamModel& m, Index panel) {
  std::vector<SmoothSide> sides;
  for (const seams::SeamRun& lowest : m.runs) {
    if (lowest.panel != panel || !begins_side(m, lowest)) continue;
    for (const bool after : {true, false}) {
      const std::vector<const seams::SeamRun*> side = side_from(m, lowest, after);
      if (side.empty() || std::abs(side.back()->up) > kSideUp) continue;
      const double below = length_of(side) - side.back()->length;
      sides.push_back({side.back()->edge, beside(m, *side.back(), after).edge, below, after});
    }
  }
  return sides;
}

/// The joint of two of the edge's curves that lies there, if one does: mm from its start.
double snapped(const pattern::PanelEdge& edge, double at) {
  constexpr double kAtJoint = 1;  // mm
  double joint = 0;
  for (const pattern::CubicBezier& curve : edge.curves) {
    joint += pattern::arc_length(curve);
    if (std::abs(joint - at) < kAtJoint) return joint;
  }
  return at;
}

/// Where on the side the mouth begins, mm along it from its end at the waist: as far off as the mouth is
/// long.
std::optional<double> mouth_on(const pattern::PanelEdge& side, bool after, double mouth) {
  constexpr double kStep = 0.25, kCurved = 1.1;  // mm; times the chord
  const double all = pattern::arc_length(side);
  const Vec2 end = after ? side.curves.back().p3 : side.curves.front().p0;
  for (double s = mouth; s < std::min(all, kCurved * mouth); s += kStep) {
    const double at = after ? all - s : s;
    if (length(pattern::point_at_length(side, at) - end) < mouth) continue;
    return after ? all - snapped(side, at) : snapped(side, at);
  }
  return std::nullopt;
}

double degrees_between(Vec2 a, Vec2 b) {
  return std::atan2(std::abs(cross(a, b)), dot(a, b)) * 180 / std::numbers::pi;
}

/// The corner that the facing adds to such a side, if side and waist go on to it and backs' sides are as
/// long.
std::optional<PocketCorner> corner_of_facing(const pattern::Panel& front, Index panel, const SmoothSide& side,
                                             const FacingCorner& facing, const std::vector<double>& behind) {
  constexpr double kGoesOn = 12;  // degrees
  constexpr double kBelow = 20;   // mm of the side that tell where it goes on to
  const pattern::PanelEdge& edge = front.outline.edges[side.edge];
  const std::optional<double> mouth = mouth_on(edge, side.after, facing.line);
  if (!mouth) return std::nullopt;
  const double all = pattern::arc_length(edge);
  const auto at = [&](double s) { return pattern::point_at_length(edge, side.after ? all - s : s); };
  const Vec2 top = at(0), from = at(*mouth), along = normalized(from - top);
  const Vec2 out = side.after ? Vec2{-along.y, along.x} : Vec2{along.y, -along.x};
  const Vec2 corner = top + facing.along * along + facing.beyond * out;
  const double waist = length(corner - top), rest = length(corner - from);
  if (std::min(waist, rest) < kLeastCut || std::max(waist, rest) > kMostCut) return std::nullopt;
  const Vec2 up = from - at(*mouth + kBelow), on = way_on(front.outline.edges[side.waist], !side.after);
  if (degrees_between(corner - from, up) > kGoesOn || degrees_between(corner - top, on) > kGoesOn ||
      !agrees(behind, side.below + all - *mouth + rest))
    return std::nullopt;
  const double share = *mouth / all;
  return side.after ? PocketCorner{panel, side.edge, corner, 1 - share, 1}
                    : PocketCorner{panel, side.edge, corner, 0, share};
}

}  // namespace

std::optional<PocketCorner> corner_by_facing(std::span<const pattern::Panel> panels,
                                             const seams::SeamModel& m, Index panel,
                                             const std::vector<double>& behind) {
  for (const SmoothSide& side : smooth_sides_of(m, panel))
    for (const FacingCorner& facing : facing_corners(panels, m))
      if (auto corner = corner_of_facing(panels[panel], panel, side, facing, behind)) return corner;
  return std::nullopt;
}

}  // namespace toile::create
