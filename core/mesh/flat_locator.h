#pragma once
// Which triangle of a flat mesh a point lies in.

#include <array>
#include <limits>
#include <span>
#include <vector>

#include "core/base/types.h"

namespace toile::mesh {

/// A point as weights of a triangle's corners.
struct FlatPlace {
  Index triangle = kNone;
  std::array<double, 3> share{};                             ///< of its corners; they sum up to 1
  double outside = std::numeric_limits<double>::infinity();  ///< the most negative share, 0 inside
};

class FlatLocator {
 public:
  /// `rest` (m) and `triangles`, counter-clockwise, must outlive it.
  FlatLocator(std::span<const Vec2> rest, std::span<const Tri> triangles);

  /// The first triangle that the point lies in; where there is none, the one that it is least outside of.
  /// No triangle where there are none.
  FlatPlace at(Vec2 p) const;

 private:
  struct Cells {
    int left, right, bottom, top;
  };
  void lay_grid(Vec2 size);
  Cells cells_of(const Tri& t) const;
  std::size_t entries() const;  ///< triangles in all cells together
  FlatPlace place_in(Index triangle, Vec2 p) const;
  int column(double x) const;
  int row(double y) const;
  std::size_t cell_at(int row, int column) const;

  std::span<const Vec2> rest_;
  std::span<const Tri> triangles_;
  Vec2 low_;
  double cell_ = 1;  ///< m
  int columns_ = 1, rows_ = 1;
  std::vector<std::vector<Index>> in_cell_;  ///< triangles that reach into each cell, rising
};

}  // namespace toile::mesh
