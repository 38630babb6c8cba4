#pragma once
// Finding what an edit names, and keeping seams where they are when edges change. Internal to the edits.

#include <cstddef>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/pattern/pattern.h"

namespace toile::edit {

/// An edge within its panel.
struct EdgePlace {
  std::size_t loop = 0;  ///< 0 the outline, then the holes
  std::size_t edge = 0;  ///< within the loop
  Index index = 0;       ///< as SeamEdge::edge counts
};

pattern::Loop& loop_at(pattern::Panel& panel, std::size_t loop);
const pattern::Loop& loop_at(const pattern::Panel& panel, std::size_t loop);

/// Errors: edit.unknown_piece, edit.unknown_edge, edit.unknown_seam.
Result<Index> find_piece(const pattern::Pattern& pattern, const std::string& id);
Result<EdgePlace> find_edge(const pattern::Panel& panel, const std::string& id);
Result<std::size_t> find_seam(const pattern::Pattern& pattern, const std::string& id);

/// "piece front" and "piece front, edge hem".
std::string piece_text(const std::string& piece);
std::string edge_text(const std::string& piece, const std::string& edge);

/// `wanted`, or `wanted` with the first number from 2 that no edge or line of the panel has.
std::string free_part_id(const pattern::Panel& panel, const std::string& wanted);

/// The part [from, to] of an edge that was, now [now_from, now_to] of another. Fractions of their lengths.
struct EdgeShare {
  double from = 0, to = 1;
  Index edge = kNone;
  double now_from = 0, now_to = 1;
};

/// Each edge of a panel that was → its shares, ascending, or none when it is gone.
using EdgeShares = std::vector<std::vector<EdgeShare>>;

/// The shares of a panel whose edges all stay; REQUIRES count >= 0.
EdgeShares same_edges(Index count);

/// Puts the seams of panel `panel` onto its edges of now. Seams without a side are removed. Neighbours in a
/// series that have become one stretch of an edge are made one.
void carry_seams(pattern::Pattern& pattern, Index panel, const EdgeShares& shares);

}  // namespace toile::edit
