#include "core/pattern/seams/accept.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/pattern/curve.h"
#include "core/pattern/seams/piece_words.h"
#include "core/pattern/seams/strangers.h"
#include "core/pattern/seams/taken_edges.h"

namespace toile::seams {
namespace {

/// One a panel: whether seams do not join it to the largest part of the garment, by area. All, where there is
/// no seam.
std::vector<char> loose_panels(const pattern::Pattern& pattern, std::span<const SeamProposal> proposals,
                               const std::vector<bool>& sewn) {
  DisjointSets parts(pattern.panels.size());
  bool any = false;
  const auto join = [&](const std::vector<pattern::SeamEdge>& edges) {
    for (const pattern::SeamEdge& e : edges) any |= parts.join(edges.front().panel, e.panel);
  };
  for (std::size_t i = 0; i < proposals.size(); ++i)
    if (sewn[i]) join(both_sides(proposals[i].seam));
  for (const pattern::Seam& seam : pattern.seams) join(both_sides(seam));
  std::vector<double> area(pattern.panels.size(), 0);
  for (Index p = 0; p < static_cast<Index>(area.size()); ++p)
    area[parts.root(p)] += std::abs(pattern::signed_area(pattern.panels[p].outline));
  const auto largest = static_cast<Index>(std::max_element(area.begin(), area.end()) - area.begin());
  std::vector<char> loose;
  loose.reserve(area.size());
  for (Index p = 0; p < static_cast<Index>(area.size()); ++p)
    loose.push_back(!any || parts.root(p) != largest);
  return loose;
}

/// Whether the seam closes a leg of one piece: open it would be half a skirt.
bool closes_leg(const pattern::Pattern& pattern, const std::vector<pattern::SeamEdge>& edges) {
  const Index panel = edges.front().panel;
  return words_of(pattern.panels[panel].id).leg &&
         std::all_of(edges.begin(), edges.end(),
                     [&](const pattern::SeamEdge& e) { return e.panel == panel; });
}

/// What each edge of a pattern's pieces is sewn to.
class SewnTo {
 public:
  void sew(const pattern::Seam& seam) {
    note(seam.a, seam.b);
    note(seam.b, seam.a);
  }

  /// Whether the seam closes a tube whose end is set in, as a sleeve's cap is: it joins two edges of one
  /// piece, and all between these, one way round, are sewn to other pieces, two at least. What goes around
  /// the neck is open in front as often as not.
  bool closes_tube(const pattern::Pattern& pattern, const pattern::Seam& seam) const {
    if (seam.a.size() != 1 || seam.b.size() != 1) return false;
    const pattern::SeamEdge &a = seam.a.front(), &b = seam.b.front();
    return a.panel == b.panel && a.edge != b.edge && !is_neck(words_of(pattern.panels[a.panel].id).kind) &&
           (set_in(pattern, a.panel, a.edge, b.edge) || set_in(pattern, a.panel, b.edge, a.edge));
  }

 private:
  void note(const std::vector<pattern::SeamEdge>& side, const std::vector<pattern::SeamEdge>& other) {
    for (const pattern::SeamEdge& e : side)
      for (const pattern::SeamEdge& o : other)
        if (o.panel != e.panel) others_[{e.panel, e.edge}].insert(o.panel);
  }

  bool set_in(const pattern::Pattern& pattern, Index panel, Index after, Index before) const {
    const auto count = static_cast<Index>(pattern.panels[panel].outline.edges.size());
    std::set<Index> met;
    for (Index e = (after + 1) % count; e != before; e = (e + 1) % count) {
      const auto others = others_.find({panel, e});
      if (others == others_.end()) return false;
      met.insert(others->second.begin(), others->second.end());
    }
    return met.size() >= 2;
  }

  std::map<std::pair<Index, Index>, std::set<Index>> others_;  ///< of panel and edge
};

/// What a seam joins, whichever way it runs: edges and their parts.
using Joined = std::pair<std::vector<std::array<double, 4>>, std::vector<std::array<double, 4>>>;

Joined joined_by(const pattern::Seam& seam) {
  const auto told = [](const std::vector<pattern::SeamEdge>& side) {
    std::vector<std::array<double, 4>> parts;
    parts.reserve(side.size());
    for (const pattern::SeamEdge& e : side)
      parts.push_back({static_cast<double>(e.panel), static_cast<double>(e.edge), e.from, e.to});
    std::sort(parts.begin(), parts.end());
    return parts;
  };
  Joined joined{told(seam.a), told(seam.b)};
  if (joined.second < joined.first) std::swap(joined.first, joined.second);
  return joined;
}

bool any_of_panels(const pattern::Seam& seam, const auto& is) {
  const std::vector<pattern::SeamEdge> edges = both_sides(seam);
  return std::any_of(edges.begin(), edges.end(), [&](const pattern::SeamEdge& e) { return is(e.panel); });
}

/// Which of them are `sure` enough and want no part of an edge that one before them has taken.
std::vector<bool> sewn_where(std::span<const SeamProposal> proposals, const auto& sure) {
  TakenEdges taken;
  std::vector<bool> sewn;
  for (const SeamProposal& p : proposals) {
    sewn.push_back(sure(p) && !taken.clashes(p.seam));
    if (sewn.back()) taken.take(p.seam);
  }
  return sewn;
}

/// Of each proposal how sure it is that its edges belong together: its own confidence and those of the others
/// that join them the other way round, as of a collar that may be turned over.
std::vector<double> whichever_way(std::span<const SeamProposal> proposals) {
  std::map<Joined, double> sum;
  for (const SeamProposal& p : proposals) sum[joined_by(p.seam)] += p.confidence;
  std::vector<double> sure;
  sure.reserve(proposals.size());
  for (const SeamProposal& p : proposals) sure.push_back(sum[joined_by(p.seam)]);
  return sure;
}

}  // namespace

std::vector<bool> sewn_together(std::span<const SeamProposal> proposals, double least_confidence) {
  return sewn_where(proposals, [&](const SeamProposal& p) { return p.confidence >= least_confidence; });
}

std::vector<bool> sewn_to_wear(const pattern::Pattern& pattern, std::span<const SeamProposal> proposals,
                               double least_confidence) {
  const std::vector<char> last = sewn_last(pattern);
  std::vector<bool> sewn = sewn_where(proposals, [&](const SeamProposal& p) {
    const bool beside = any_of_panels(p.seam, [&](Index panel) { return last[panel] != 0; });
    return p.confidence >= (beside ? least_confidence : std::min(least_confidence, kFits));
  });
  const std::vector<char> loose =
      loose_panels(pattern, proposals, sewn_together(proposals, least_confidence));
  const std::vector<double> sure = whichever_way(proposals);
  TakenEdges taken;
  SewnTo sewn_to;
  const auto sew = [&](const pattern::Seam& seam) {
    taken.take(seam);
    sewn_to.sew(seam);
  };
  for (std::size_t i = 0; i < proposals.size(); ++i)
    if (sewn[i]) sew(proposals[i].seam);
  // A garment is worn without a belt, and with it sewn on anywhere it is not.
  const auto never_in_doubt = [&](Index panel) {
    return last[panel] != 0 || is_tied(words_of(pattern.panels[panel].id));
  };
  for (std::size_t i = 0; i < proposals.size(); ++i) {
    const pattern::Seam& seam = proposals[i].seam;
    if (sewn[i] || taken.clashes(seam) || any_of_panels(seam, never_in_doubt)) continue;
    const bool wanted = any_of_panels(seam, [&](Index panel) { return loose[panel] != 0; });
    const bool likely =
        sure[i] >= kLikely && (wanted || taken.goes_on(seam) || closes_leg(pattern, both_sides(seam)));
    if (!likely && (sure[i] < kClosesTube || !sewn_to.closes_tube(pattern, seam))) continue;
    sewn[i] = true;
    sew(seam);
  }
  return sewn;
}

}  // namespace toile::seams
