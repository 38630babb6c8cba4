#pragma once
// Which closed lines of a place are pieces, which their sew lines, and which holes in them.

#include <cstddef>
#include <vector>

#include "core/base/result.h"
#include "core/pattern/dxf/found.h"
#include "core/pattern/dxf/roles.h"

namespace toile::dxf {

/// The closed lines of a place, in the order of its chains.
struct DxfLoops {
  std::vector<DxfLoop> outlines;  ///< that may be a piece's; nested
  std::vector<DxfLoop> inner;     ///< of layer 8
  std::vector<std::size_t> flat;  ///< chains that should be outlines, and enclose no area
};

/// The loops refer to the chains, which must outlive them. Error: dxf.too_large.
Result<DxfLoops> loops_of(const std::vector<DxfChain>& chains, const DxfRoles& roles, std::size_t most);

/// What loops are to each other as the two lines around a piece.
struct DxfSeamLines {
  std::vector<const DxfLoop*> sew_of;  ///< the sew line of each outline; null where it has none
  std::vector<int> around;             ///< number of sew lines around each outline

  bool is_sew_line(const DxfLoop& loop) const;
  /// Whether `loops.outlines[i]` has none or two loops around it. Sew lines do not count, since they part no
  /// cloth.
  bool is_outer(const DxfLoops& loops, std::size_t i) const {
    return (loops.outlines[i].depth - around[i]) % 2 == 0;
  }
};

/// Finds the sew line of each cut line: on layer 14 within it, on layer 8, or in drawings of free layers the
/// next loop inside, where those follow it at the width of an allowance. It refers to the loops, which must
/// outlive it.
DxfSeamLines seam_lines_of(const DxfLoops& loops, bool by_aama);

/// A piece for each loop that is one, numbered from `first_id`, by its sew line where it has one.
DxfPieces outlined(const std::vector<DxfChain>& chains, const DxfLoops& loops, const DxfSeamLines& seams,
                   bool by_aama, int first_id);

/// The pieces with the holes that lie in them, of all layers of outlines and of AAMA's layer 11.
DxfPieces with_holes(DxfPieces pieces, const std::vector<DxfChain>& chains, const DxfRoles& roles,
                     const DxfLoops& loops, const DxfSeamLines& seams);

}  // namespace toile::dxf
