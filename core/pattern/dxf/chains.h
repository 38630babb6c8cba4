#pragma once
// Curves of the drawing as polylines in millimetres, chained end to end.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/types.h"
#include "core/pattern/dxf/entities.h"

namespace toile {

/// What one reading of a file's pieces works with and leaves.
struct DxfContext {
  const DxfSettings& settings;
  double mm_per_unit;
  DxfLog& log;
  std::size_t drawn = 0;       ///< points so far, over the whole drawing
  std::optional<Error> fault;  ///< the first thing that could not be read; an error when nothing else could
  std::optional<Error> open;   ///< the first line that does not close, where it may have been meant to

  void fail(const Error& error) {
    if (!fault) fault = error;
  }
};

/// x·a + y·b + origin.
struct DxfTransform {
  Vec2 x{1, 0}, y{0, 1}, origin;
  Vec2 operator()(Vec2 p) const { return turned(p) + origin; }
  /// Without the shift.
  Vec2 turned(Vec2 p) const { return p.x * x + p.y * y; }
  /// First `inner`, then this.
  DxfTransform after(const DxfTransform& inner) const {
    return {turned(inner.x), turned(inner.y), (*this)(inner.origin)};
  }
};

/// From the coordinates of a block to those of the drawing that inserts it.
DxfTransform transform_of(const DxfInsert& insert, const DxfBlock& block);

/// A block as it stands in the drawing.
struct DxfPart {
  const DxfBlock* block = nullptr;
  DxfTransform transform;  ///< to the drawing's coordinates, in its own units
};

/// Joined curves of one layer. The first point of a closed chain is not repeated at its end.
struct DxfChain {
  std::vector<Vec2> points;  ///< mm
  bool closed = false;
  std::string layer;
  int line = 0;                   ///< of its earliest entity
  std::vector<Vec2> breaks;       ///< where entities meet, when there are several
  bool breaks_are_edges = false;  ///< the entities are runs that a pattern program drew, not single strokes
  std::vector<std::size_t> entities;  ///< their numbers in the log
  bool curved = false;                ///< arcs, bulges or splines have been drawn out
  bool inner = false;                 ///< branches off an outline: a line within it, no outline
};

/// The curves of the parts as chains, by line. Error: dxf.too_large.
Result<std::vector<DxfChain>> chains_of(const std::vector<DxfPart>& parts, DxfContext& context);

}  // namespace toile
