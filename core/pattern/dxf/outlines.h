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
  std::vector<DxfLoop> inner;     ///< of other layers that may hold sew lines, of layer 8 above all
  std::vector<std::size_t> flat;  ///< chains that should be outlines, and enclose no area
};

/// The loops refer to the chains, which must outlive them. Error: dxf.too_large.
Result<DxfLoops> loops_of(const std::vector<DxfChain>& chains, const DxfRoles& roles, std::size_t most);

/// What loops are to each other as the two lines around a piece. Index i is that of `loops.outlines`.
struct DxfSeamLines {
  std::vector<const DxfLoop*> sew_of;               ///< the sew line of each outline; null where it has none
  std::vector<std::optional<std::size_t>> parents;  ///< as the loops', and of each sew line its cut line
  std::vector<int> depths;                          ///< number of loops around each but for sew lines

  bool is_sew_line(const DxfLoop& loop) const;
  /// Whether `loops.outlines[i]` has none or two loops around it. Sew lines do not count, since they part no
  /// cloth.
  bool is_outer(std::size_t i) const { return depths[i] % 2 == 0; }
};

/// How the sew lines of a place are looked for.
struct DxfSewSearch {
  bool by_aama = false;
  bool on_their_layer = false;  ///< the file holds lines on layer 14 or 87: no other layer has sew lines
};

/// Finds the sew line of each cut line: on layer 14 within it, on its own layer, on layer 8, or in drawings
/// of free layers on the only other layer that has one, where those follow it at the widths of allowances. It
/// refers to the loops, which must outlive it.
DxfSeamLines seam_lines_of(const DxfLoops& loops, const DxfSewSearch& search);

/// A piece for each loop that is one, numbered from `first_id`, by its sew line where it has one.
DxfPieces outlined(const std::vector<DxfChain>& chains, const DxfLoops& loops, const DxfSeamLines& seams,
                   bool by_aama, int first_id);

/// The pieces with the holes that lie in them, of all layers of outlines and of AAMA's layer 11.
DxfPieces with_holes(DxfPieces pieces, const std::vector<DxfChain>& chains, const DxfRoles& roles,
                     const DxfLoops& loops, const DxfSeamLines& seams);

}  // namespace toile::dxf
