#pragma once

#include <string>
#include <vector>

#include "core/base/types.h"

namespace toile::sewing {

/// Holds part of a panel during the drape, e.g. a waistband at its height until friction carries it, or leads
/// it to a place on the body.
struct Attachment {
  enum class Hold {
    kHeight,  ///< keeps its height; free to move sideways
    kPlace,   ///< keeps its place
    kGoal,    ///< is led to `goal` while the seams close, and stays there
  };
  std::string id;
  Index panel = kNone;
  std::vector<Index> edges;  ///< of the panel, as edges_of counts; no edges and no points: the whole panel
  Hold hold = Hold::kHeight;
  double release_after = 1.0;  ///< s after gravity is full; negative: never released
  std::vector<Vec2> points;    ///< m, flat, of the panel
  /// m. One point: each of `points` goes there, of edges the middle, of a whole panel what lies nearest its
  /// middle. Three or more: a closed line; points, and edges with all their length, come to lie on it and may
  /// slide along it.
  std::vector<Vec3> goal;
};

}  // namespace toile::sewing
