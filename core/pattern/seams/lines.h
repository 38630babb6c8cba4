#pragma once
// Pieces as they are sewn together once their darts are closed: what a dart parts is one line again.

#include <vector>

#include "core/pattern/pattern.h"

namespace toile::seams {

/// Two edges of a piece, one after the other, that close a dart, or stay open as a slit.
struct SeamDart {
  Index panel = kNone, first = kNone, second = kNone;
  bool slit = false;
};

struct SeamLines {
  /// The pieces with each line as one edge, and without the darts' legs: an edge may jump over a dart's
  /// mouth, so that this is no pattern to be cut. Seams name lines.
  pattern::Pattern pattern;
  std::vector<SeamDart> darts;                         ///< in the given pattern's edges
  std::vector<std::vector<std::vector<Index>>> edges;  ///< of each panel's lines, in the outline's order
};

/// A dart has legs of one length, a narrow tip, and a mouth across which the outline runs straight on. What
/// opens at the lower end of a skirt, a sleeve or a leg is a slit and not to be sewn. Edges that are sewn
/// already are lines of their own. REQUIRES a pattern that validate() accepts.
SeamLines lines_of(const pattern::Pattern& pattern);

/// A part of a line, as parts of the given pattern's edges, in the order and direction in which it runs.
std::vector<pattern::SeamEdge> edges_of_line(const SeamLines& lines, const pattern::Pattern& pattern,
                                             const pattern::SeamEdge& part);

}  // namespace toile::seams
