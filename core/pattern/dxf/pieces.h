#pragma once
// Which lines of a drawing are outlines, which belong to them, and which say nothing about the cloth's shape.

#include <vector>

#include "core/base/result.h"
#include "core/pattern/dxf/chains.h"
#include "core/pattern/dxf/read.h"

namespace toile {

/// A piece in the making.
struct DxfFound {
  DxfPiece piece;
  int id = 0;                         ///< its number in the log
  std::vector<std::size_t> entities;  ///< those of its outline
};

/// The pieces, without names, that the parts of one place make, by line; none when nothing there closes.
/// `next_id` counts them. Error: dxf.too_large; what else is wrong is told in the context.
Result<std::vector<DxfFound>> pieces_of(const std::vector<DxfPart>& parts, DxfContext& context, int& next_id);

}  // namespace toile
