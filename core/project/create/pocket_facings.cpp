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

/// Whether one way is nearly the other.
bool goes_on(Vec2 way, Vec2 on) {
  constexpr double kGoesOn = 12;  // degrees
  return std::atan2(std::abs(cross(way, on)), dot(way, on)) * 180 / std::numbers::pi < kGoesOn;
}

/// Out of the front across its mouth, where that way leads down along it.
Vec2 out_of_mouth(Vec2 along, bool after) {
  return after ? Vec2{-along.y, along.x} : Vec2{along.y, -along.x};
}

/// Whether it adds as much to side and waist as a pocket may take, from the mouth's ends there.
bool adds_enough(Vec2 corner, Vec2 side, Vec2 waist) {
  const double up = length(corner - side), across = length(corner - waist);
  return std::min(up, across) >= kLeastCut && std::max(up, across) <= kMostCut;
}

/// The corner that the facing adds to such a side, if side and waist go on to it and backs' sides are as
/// long.
std::optional<PocketCorner> corner_of_facing(const pattern::Panel& front, Index panel, const SmoothSide& side,
                                             const FacingCorner& facing, const std::vector<double>& behind) {
  constexpr double kBelow = 20;  // mm of the side that tell where it goes on to
  const pattern::PanelEdge& edge = front.outline.edges[side.edge];
  const std::optional<double> mouth = mouth_on(edge, side.after, facing.line);
  if (!mouth) return std::nullopt;
  const double all = pattern::arc_length(edge);
  const auto at = [&](double s) { return pattern::point_at_length(edge, side.after ? all - s : s); };
  const Vec2 top = at(0), from = at(*mouth), along = normalized(from - top);
  const Vec2 corner = top + facing.along * along + facing.beyond * out_of_mouth(along, side.after);
  if (!adds_enough(corner, from, top)) return std::nullopt;
  const Vec2 up = from - at(*mouth + kBelow), on = way_on(front.outline.edges[side.waist], !side.after);
  if (!goes_on(corner - from, up) || !goes_on(corner - top, on) ||
      !agrees(behind, side.below + all - *mouth + length(corner - from)))
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

std::vector<Vec2> facing_corners_at(std::span<const pattern::Panel> panels, const seams::SeamModel& m,
                                    const pattern::PanelEdge& side, const pattern::PanelEdge& waist,
                                    bool after) {
  constexpr double kAsLong = 2;  // mm, that mouth and line may differ by
  const Vec2 from = after ? side.curves.back().p3 : side.curves.front().p0;
  const Vec2 top = after ? waist.curves.front().p0 : waist.curves.back().p3;
  const Vec2 along = normalized(from - top), out = out_of_mouth(along, after);
  std::vector<Vec2> corners;
  for (const FacingCorner& facing : facing_corners(panels, m)) {
    if (std::abs(facing.line - length(from - top)) > kAsLong) continue;
    const Vec2 corner = top + facing.along * along + facing.beyond * out;
    if (adds_enough(corner, from, top) && goes_on(corner - from, way_on(side, after)) &&
        goes_on(corner - top, way_on(waist, !after)))
      corners.push_back(corner);
  }
  return corners;
}

}  // namespace toile::create
