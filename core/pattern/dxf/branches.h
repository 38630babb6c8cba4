#pragma once
// Open curves of a drawing that branch: drawings on one layer let outlines, darts, ticks and style lines
// meet.

#include <cstddef>
#include <vector>

#include "core/base/types.h"

namespace toile::dxf {

/// So many ends are looked through around a place where lines meet.
inline constexpr int kMostAtOnePlace = 64;

/// One drawn curve that is still open.
struct DxfStroke {
  std::vector<Vec2> points;  ///< mm, two or more
  int line = 0;
  std::size_t entity = 0;
  bool curved = false;
  bool is_run = false;  ///< a POLYLINE, not a LINE
  Vec2 end(bool last) const { return last ? points.back() : points.front(); }
};

/// A stroke as part of a line, run from its start or from its end.
struct DxfLink {
  std::size_t stroke = 0;
  bool reversed = false;
};

/// A closed line that has been found among strokes that branch.
struct DxfBranchLoop {
  std::vector<DxfLink> links;
  bool inner = false;  ///< hangs on the outer line of its strokes: no hole, no outline
};

struct DxfBranches {
  std::vector<DxfBranchLoop> loops;
  std::vector<std::size_t> repeated;  ///< strokes that are drawn a second time
  std::vector<std::size_t> inner;     ///< what is left of strokes that loops have been found among
  std::vector<std::size_t> plain;     ///< strokes that do not branch, or close nothing
  std::vector<std::size_t> parted;    ///< a stroke of each outline whose inside is parted by other lines
};

/// Sorts strokes by how they meet. Ends within `tolerance` (mm) are one place; where more than two meet, the
/// lines around the outside are outlines, and what runs between their places is a line within. Where no more
/// than two ends meet the strokes are left as they are (plain).
DxfBranches part_branches(const std::vector<DxfStroke>& strokes, double tolerance);

}  // namespace toile::dxf
