#include "core/pattern/seams/accept.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
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
  TakenEdges taken;
  std::vector<bool> sewn;
  for (const SeamProposal& p : proposals) {
    sewn.push_back(p.confidence >= least_confidence && !taken.clashes(p.seam));
    if (sewn.back()) taken.take(p.seam);
  }
  return sewn;
}

std::vector<bool> sewn_to_wear(const pattern::Pattern& pattern, std::span<const SeamProposal> proposals,
                               double least_confidence) {
  std::vector<bool> sewn = sewn_together(proposals, std::min(least_confidence, kFits));
  const std::vector<char> loose =
      loose_panels(pattern, proposals, sewn_together(proposals, least_confidence));
  const std::vector<char> last = sewn_last(pattern);
  const std::vector<double> sure = whichever_way(proposals);
  TakenEdges taken;
  for (std::size_t i = 0; i < proposals.size(); ++i)
    if (sewn[i]) taken.take(proposals[i].seam);
  for (std::size_t i = 0; i < proposals.size(); ++i) {
    const SeamProposal& p = proposals[i];
    const std::vector<pattern::SeamEdge> edges = both_sides(p.seam);
    const auto any = [&](const std::vector<char>& of) {
      return std::any_of(edges.begin(), edges.end(),
                         [&](const pattern::SeamEdge& e) { return of[e.panel] != 0; });
    };
    const bool wanted = any(loose);
    if (std::any_of(edges.begin(), edges.end(), [&](const pattern::SeamEdge& e) {
          return is_tied(words_of(pattern.panels[e.panel].id));
        }))
      continue;  // a garment is worn without a belt, and with it sewn on anywhere it is not
    if (sewn[i] || sure[i] < kLikely || taken.clashes(p.seam) || any(last)) continue;
    if (!wanted && !taken.goes_on(p.seam) && !closes_leg(pattern, edges)) continue;
    sewn[i] = true;
    taken.take(p.seam);
  }
  return sewn;
}

}  // namespace toile::seams
