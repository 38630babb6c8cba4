#pragma once
// Curves of the drawing as polylines in millimetres, chained end to end.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/types.h"
#include "core/pattern/dxf/entities.h"

namespace toile::dxf {

/// In what way a drawing is read: the same for all of its places.
struct DxfReading {
  const DxfSettings& settings;
  double mm_per_unit;
  bool has_sew_layer = false;  ///< the file holds lines on the layers of sew lines, 14 or 87
};

/// x·a + y·b + origin.
struct DxfTransform {
  Vec2 x{1, 0}, y{0, 1}, origin;
  Vec2 operator()(Vec2 p) const { return turned(p) + origin; }
  /// Without the shift.
  Vec2 turned(Vec2 p) const { return p.x * x + p.y * y; }
  /// With everything drawn `s` times as large, as from the drawing's units to millimetres.
  DxfTransform scaled(double s) const { return {x * s, y * s, origin * s}; }
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
  /// Where an arc or a spline meets another entity at an angle: that is meant, and no sample of a curve.
  std::vector<Vec2> turns = {};
};

/// What the curves of one place chain up to.
struct DxfChains {
  std::vector<DxfChain> chains;  ///< by line
  std::size_t drawn = 0;         ///< points over the whole drawing so far
  DxfNotes notes;
};

/// The curves of the parts as chains. `drawn`: points over the drawing so far, which are limited as a whole.
/// Error: dxf.too_large.
Result<DxfChains> chains_of(const std::vector<DxfPart>& parts, const DxfReading& reading, std::size_t drawn);

}  // namespace toile::dxf
