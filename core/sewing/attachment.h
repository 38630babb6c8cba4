#pragma once

#include <string>
#include <vector>

#include "core/base/types.h"

namespace toile {

/// Holds part of a panel during the drape, e.g. a waistband at its height until friction carries it.
struct Attachment {
  enum class Hold {
    kHeight,  ///< keeps its height; free to move sideways
    kPlace,   ///< keeps its place
  };
  std::string id;
  Index panel = kNone;
  std::vector<Index> edges;  ///< of the panel, as edges_of counts; empty: the whole panel
  Hold hold = Hold::kHeight;
  double release_after = 1.0;  ///< s after gravity is full; negative: never released
};

}  // namespace toile
