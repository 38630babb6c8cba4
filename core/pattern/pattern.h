#pragma once
// The flat sewing pattern: pieces ("panels") with outlines of cubic Béziers, and seams that join series
// of their edges. Millimetres, as pattern makers count. y up, outlines counter-clockwise.

#include <string>
#include <vector>

#include "core/base/types.h"

namespace toile::pattern {

/// One cubic Bézier segment, mm. A straight line has its handles at the thirds.
struct CubicBezier {
  Vec2 p0, p1, p2, p3;
};

/// A run of the outline between two corners: what a seam, a pin or an edit names. Consecutive curves
/// share their end points exactly.
struct PanelEdge {
  std::string id;  ///< unique within its panel and stable over edits, e.g. "e3" or "hem"
  std::vector<CubicBezier> curves;
};

/// Id of the edge along which doubled cloth is folded, as the middle of a waistband: nothing is sewn there
/// but another fold.
inline constexpr char kFoldEdge[] = "fold";

/// A closed line: the end of each edge is the start of the next, exactly.
struct Loop {
  std::vector<PanelEdge> edges;
};

/// A line on a piece: where it is folded, or an elastic is sewn to it; the mesh follows it. Of a line that is
/// only drawn, a mark for people, the mesh takes no notice: it may leave the piece and cross others.
struct InnerLine {
  std::string id;            ///< unique within its panel, beside those of the edges
  std::vector<Vec2> points;  ///< mm; straight from each to the next, inside the outline; ends may lie on it
  bool drawn = false;        ///< only drawn
  friend bool operator==(const InnerLine&, const InnerLine&) = default;
};

/// A mark on the outline, where two pieces meet when they are sewn. Curves end there.
struct Notch {
  Vec2 at;           ///< mm
  double depth = 0;  ///< mm, of the cut into the allowance; 0 when it is not told
  Vec2 inwards;      ///< unit vector, null when it is not told
};

/// One piece of cloth as it is cut.
struct Panel {
  std::string id;           ///< unique within the pattern
  Loop outline;             ///< counter-clockwise
  std::vector<Loop> holes;  ///< clockwise, inside the outline, disjoint
  Vec2 grain{0, 1};         ///< unit vector of the warp in the panel's plane
  std::string fabric;       ///< id of a fabric of the project
  std::vector<InnerLine> lines = {};
  int layer = 0;  ///< order outwards: cloth of a higher layer is worn over that of a lower one
  std::vector<Notch> notches = {};
  double spacing = 0;  ///< m, wanted edge length of this panel's triangles; 0: as the whole pattern's
};

/// Wanted edge length of the panel's triangles, m, where the pattern's is `usual`.
inline double spacing_on(const Panel& panel, double usual) {
  return panel.spacing > 0 ? panel.spacing : usual;
}

/// One edge, or a part of one, in a seam's series. Traversed in the outline's own direction, or against it.
struct SeamEdge {
  Index panel = kNone;
  Index edge = kNone;  ///< index into the panel's outline, then into its holes' edges in order
  bool reversed = false;
  double from = 0,
         to = 1;  ///< the part of it that is sewn: fractions of its length, in the outline's direction
};

/// Joins the path that series `a` makes to the path that series `b` makes. Outlines wind the same way, so
/// that two pieces laid side by side meet with their edges running against each other: the start of `a`
/// meets the end of `b` unless `same_direction`.
struct Seam {
  std::string id;
  std::vector<SeamEdge> a, b;
  bool same_direction = false;
};

/// 1 where the seam lays its pieces side by side, so that both show the same side of the flat cloth; -1 where
/// the one is turned over.
inline int side_sign(const Seam& seam) {
  return (seam.same_direction != seam.a[0].reversed) != seam.b[0].reversed ? -1 : 1;
}

struct Pattern {
  std::vector<Panel> panels;
  std::vector<Seam> seams;
};

/// The panel's edges in the order that SeamEdge::edge counts: outline first, then each hole.
std::vector<const PanelEdge*> edges_of(const Panel& panel);

}  // namespace toile::pattern
