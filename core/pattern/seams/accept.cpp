#include "core/pattern/seams/accept.h"

#include <algorithm>
#include <cmath>

#include "core/base/disjoint_sets.h"
#include "core/pattern/curve.h"
#include "core/pattern/seams/piece_words.h"
#include "core/pattern/seams/second_layers.h"
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
  const std::vector<char> layers = lying_on_others(pattern);
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
    if (sewn[i] || p.confidence < kLikely || taken.clashes(p.seam) || any(layers)) continue;
    if (!wanted && !taken.goes_on(p.seam) && !closes_leg(pattern, edges)) continue;
    sewn[i] = true;
    taken.take(p.seam);
  }
  return sewn;
}

}  // namespace toile::seams
