#include "core/pattern/edit/places.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace toile::edit {
namespace {

constexpr double kTouch = 1e-9;  // of an edge's length: as validate() counts

/// Where `x` of the old edge lies on the new one; exact at the share's ends.
double carried(const EdgeShare& share, double x) {
  if (x <= share.from) return share.now_from;
  if (x >= share.to) return share.now_to;
  return share.now_from + (share.now_to - share.now_from) * (x - share.from) / (share.to - share.from);
}

void append_carried(const pattern::SeamEdge& item, const std::vector<EdgeShare>& shares,
                    std::vector<pattern::SeamEdge>& series) {
  std::vector<pattern::SeamEdge> parts;
  for (const EdgeShare& share : shares) {
    const double from = std::max(item.from, share.from), to = std::min(item.to, share.to);
    if (to - from <= kTouch) continue;
    parts.push_back({item.panel, share.edge, item.reversed, carried(share, from), carried(share, to)});
  }
  if (item.reversed) std::reverse(parts.begin(), parts.end());
  series.insert(series.end(), parts.begin(), parts.end());
}

/// Whether `next` goes on where `item` ends on the same edge.
bool goes_on(const pattern::SeamEdge& item, const pattern::SeamEdge& next) {
  if (item.panel != next.panel || item.edge != next.edge || item.reversed != next.reversed) return false;
  return std::abs(item.reversed ? next.to - item.from : next.from - item.to) <= kTouch;
}

void carry_series(std::vector<pattern::SeamEdge>& series, Index panel, const EdgeShares& shares) {
  std::vector<pattern::SeamEdge> now;
  for (const pattern::SeamEdge& item : series) {
    if (item.panel == panel) {
      append_carried(item, shares[std::size_t(item.edge)], now);
    } else {
      now.push_back(item);
    }
  }
  series.clear();
  for (const pattern::SeamEdge& item : now) {
    const bool on = item.panel == panel && !series.empty() && goes_on(series.back(), item);
    if (!on) {
      series.push_back(item);
    } else if (item.reversed) {
      series.back().from = item.from;
    } else {
      series.back().to = item.to;
    }
  }
}

}  // namespace

pattern::Loop& loop_at(pattern::Panel& panel, std::size_t loop) {
  return loop == 0 ? panel.outline : panel.holes[loop - 1];
}
const pattern::Loop& loop_at(const pattern::Panel& panel, std::size_t loop) {
  return loop == 0 ? panel.outline : panel.holes[loop - 1];
}

std::string piece_text(const std::string& piece) { return "piece " + piece; }

std::string edge_text(const std::string& piece, const std::string& edge) {
  return piece_text(piece) + ", edge " + edge;
}

Result<Index> find_piece(const pattern::Pattern& pattern, const std::string& id) {
  for (std::size_t i = 0; i < pattern.panels.size(); ++i)
    if (pattern.panels[i].id == id) return Index(i);
  return Error{"edit.unknown_piece", "There is no piece of that name.", piece_text(id)};
}

Result<EdgePlace> find_edge(const pattern::Panel& panel, const std::string& id) {
  Index index = 0;
  for (std::size_t l = 0; l <= panel.holes.size(); ++l) {
    const pattern::Loop& loop = loop_at(panel, l);
    for (std::size_t e = 0; e < loop.edges.size(); ++e, ++index)
      if (loop.edges[e].id == id) return EdgePlace{l, e, index};
  }
  return Error{"edit.unknown_edge", "The piece has no edge of that name.", edge_text(panel.id, id)};
}

Result<std::size_t> find_seam(const pattern::Pattern& pattern, const std::string& id) {
  for (std::size_t s = 0; s < pattern.seams.size(); ++s)
    if (pattern.seams[s].id == id) return s;
  return Error{"edit.unknown_seam", "There is no seam of that name.", "seam " + id};
}

std::string free_part_id(const pattern::Panel& panel, const std::string& wanted) {
  std::set<std::string> taken;
  for (const pattern::PanelEdge* edge : pattern::edges_of(panel)) taken.insert(edge->id);
  for (const pattern::InnerLine& line : panel.lines) taken.insert(line.id);
  std::string id = wanted;
  for (int n = 2; taken.contains(id); ++n) id = wanted + "_" + std::to_string(n);
  return id;
}

EdgeShares same_edges(Index count) {
  EdgeShares shares;
  for (Index e = 0; e < count; ++e) shares.push_back({EdgeShare{0, 1, e, 0, 1}});
  return shares;
}

void carry_seams(pattern::Pattern& pattern, Index panel, const EdgeShares& shares) {
  for (pattern::Seam& seam : pattern.seams) {
    carry_series(seam.a, panel, shares);
    carry_series(seam.b, panel, shares);
  }
  std::erase_if(pattern.seams, [](const pattern::Seam& seam) { return seam.a.empty() || seam.b.empty(); });
}

}  // namespace toile::edit
