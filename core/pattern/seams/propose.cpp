#include "core/pattern/seams/propose.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "core/geometry/polygon2.h"
#include "core/pattern/curve.h"
#include "core/pattern/seams/search.h"
#include "core/pattern/seams/weights.h"

namespace toile::seams {
namespace {

constexpr const ConfidenceWeights& kWeights = kConfidenceWeights;

/// Runs of uncut outlines are counted panel after panel.
std::vector<Index> first_runs(const pattern::Pattern& pattern) {
  std::vector<Index> first{0};
  for (const pattern::Panel& panel : pattern.panels)
    first.push_back(first.back() + static_cast<Index>(panel.outline.edges.size()));
  return first;
}

void sort_sewn(const pattern::Pattern& pattern, std::vector<std::array<Index, 2>>& sewn,
               std::vector<Index>& blocked) {
  const std::vector<Index> first = first_runs(pattern);
  const auto run_of = [&](const pattern::SeamEdge& e) -> Index {
    const Index r = first[e.panel] + e.edge;
    return r < first[e.panel + 1] ? r : kNone;  // edges of holes have no run
  };
  for (const pattern::Seam& seam : pattern.seams) {
    std::vector<Index> runs;
    for (const std::vector<pattern::SeamEdge>* side : {&seam.a, &seam.b})
      for (const pattern::SeamEdge& e : *side)
        if (const Index r = run_of(e); r != kNone) runs.push_back(r);
    if (runs.size() == 2 && seam.a.size() == 1 && seam.b.size() == 1)
      sewn.push_back({runs[0], runs[1]});
    else
      blocked.insert(blocked.end(), runs.begin(), runs.end());
  }
}

double confidence_of(double margin, double a, double b) {
  const double chance = 1 / (1 + std::exp(-(margin - kWeights.even) / kWeights.slope));
  const double difference = std::abs(a - b) / std::max(a, b);
  return chance * (1 - kWeights.gathers * std::max(0.0, difference - kWeights.gathers_begin));
}

/// The edges of one side, parts of one edge put together again.
std::vector<pattern::SeamEdge> series_of(const FoundSeams& found, const std::vector<Index>& runs,
                                         double& length) {
  std::vector<pattern::SeamEdge> series;
  for (const Index r : runs) {
    const SeamRun& run = found.model.runs[r];
    length += run.length;
    if (!series.empty() && series.back().panel == run.panel && series.back().edge == run.edge) continue;
    series.push_back({run.panel, run.edge, found.gluing.turned[run.panel] != 0});
  }
  return series;
}

/// The seam in parts, as many as there are places where an edge ends on both sides.
std::vector<FoundSeam> parts_of(const FoundSeams& found, const FoundSeam& seam) {
  const auto ends = [&](Index r, Index next) {
    const SeamRun &x = found.model.runs[r], &y = found.model.runs[next];
    return x.panel != y.panel || x.edge != y.edge;
  };
  std::vector<FoundSeam> parts;
  for (std::size_t k = 0; k < seam.a.size(); ++k) {
    if (k == 0 || (ends(seam.a[k - 1], seam.a[k]) && ends(seam.b[k - 1], seam.b[k])))
      parts.push_back({{}, {}, seam.margin});
    parts.back().a.push_back(seam.a[k]);
    parts.back().b.push_back(seam.b[k]);
  }
  return parts;
}

/// The pairs of runs that a seam joins, each with the lesser first, rising. With `mirrored`, those on the
/// mirrored pieces; nothing where one of them has no mirror image.
std::vector<std::array<Index, 2>> joined_runs(const SeamModel& model, const FoundSeam& seam, bool mirrored) {
  std::vector<std::array<Index, 2>> pairs;
  for (std::size_t k = 0; k < seam.a.size(); ++k) {
    const Index a = mirrored ? model.mirror[seam.a[k]] : seam.a[k];
    const Index b = mirrored ? model.mirror[seam.b[k]] : seam.b[k];
    if (a == kNone || b == kNone) return {};
    pairs.push_back({std::min(a, b), std::max(a, b)});
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// Left and right are sewn alike: a seam is as sure as its mirror image, of which the garment has both. Each
/// by itself may seem to be missed less, since the other's pieces could take its place.
void share_with_mirror_images(FoundSeams& found) {
  std::map<std::vector<std::array<Index, 2>>, double> margin;
  for (const FoundSeam& seam : found.seams) margin[joined_runs(found.model, seam, false)] = seam.margin;
  for (FoundSeam& seam : found.seams) {
    const auto twin = margin.find(joined_runs(found.model, seam, true));
    if (twin != margin.end()) seam.margin = std::max(seam.margin, twin->second);
  }
}

/// Where pieces lie upon others there is a seam for every edge in every layer, and nothing in their outlines
/// says which belong to one: such seams are for a person to decide, the more where a layer takes part.
double layer_share(const FoundSeams& found, const FoundSeam& seam) {
  const auto is_layer = [](const PieceWords& words) { return words.layer; };
  const std::vector<PieceWords>& words = found.model.words;
  if (std::none_of(words.begin(), words.end(), is_layer)) return 1;
  for (const std::vector<Index>* side : {&seam.a, &seam.b})
    for (const Index r : *side)
      if (words[found.model.runs[r].panel].layer) return kWeights.layer;
  return kWeights.beside_layer;
}

/// How far the garment that was found is to be believed in. Where few names tell fronts from backs, and it is
/// not known which side of the pieces one sees, another garment is often as good; and of very many edges, as
/// in a whole wardrobe, the best garment is seldom found. What is then proposed is for a person to decide.
double puzzle_share(const FoundSeams& found, bool sides_known) {
  double named = 0;
  for (const PieceWords& words : found.model.words)
    named += words.side != 0 || words.face != 0 || words.limb || words.layer ? 1 : 0;
  const double share =
      named / std::max(1.0, static_cast<double>(found.model.words.size())) / kWeights.enough_names;
  const double names = sides_known ? 1 : std::min(1.0, kWeights.nameless + (1 - kWeights.nameless) * share);
  const std::ptrdiff_t edges = std::count_if(found.model.runs.begin(), found.model.runs.end(),
                                             [](const SeamRun& run) { return run.from == 0; });
  return std::min(names, edges > kWeights.many ? kWeights.many_edges : 1);
}

bool all_reversed(const std::vector<pattern::SeamEdge>& side) {
  return std::all_of(side.begin(), side.end(), [](const pattern::SeamEdge& e) { return e.reversed; });
}

/// Says "reversed" for a whole side by the seam's direction, as people would.
void plainly(pattern::Seam& seam) {
  for (std::vector<pattern::SeamEdge>* side : {&seam.a, &seam.b}) {
    if (!all_reversed(*side)) continue;
    std::reverse(side->begin(), side->end());
    for (pattern::SeamEdge& e : *side) e.reversed = false;
    seam.same_direction = !seam.same_direction;
  }
}

SeamProposal proposal_of(const FoundSeams& found, const FoundSeam& seam, double belief) {
  SeamProposal p;
  p.seam.a = series_of(found, seam.a, p.length_a);
  std::vector<Index> other(seam.b.rbegin(), seam.b.rend());  // walked with the cloth at the left, too
  p.seam.b = series_of(found, other, p.length_b);
  plainly(p.seam);
  p.confidence = confidence_of(seam.margin, p.length_a, p.length_b) * layer_share(found, seam) * belief;
  return p;
}

/// An order of the pieces that does not depend on the file's: large ones first, those of one size by name.
std::vector<Index> order_of_pieces(const pattern::Pattern& pattern) {
  constexpr double kSameArea = 10;  // mm²: mirror images differ by less
  std::vector<double> area;
  for (const pattern::Panel& panel : pattern.panels)
    area.push_back(std::round(std::abs(pattern::signed_area(panel.outline)) / kSameArea));
  std::vector<Index> order(pattern.panels.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    return area[a] != area[b] ? area[a] > area[b] : pattern.panels[a].id < pattern.panels[b].id;
  });
  return order;
}

/// The pattern with its pieces in another order.
pattern::Pattern in_order(const pattern::Pattern& pattern, const std::vector<Index>& order) {
  std::vector<Index> place(order.size());
  pattern::Pattern sorted;
  for (std::size_t i = 0; i < order.size(); ++i) {
    place[order[i]] = static_cast<Index>(i);
    sorted.panels.push_back(pattern.panels[order[i]]);
  }
  sorted.seams = pattern.seams;
  for (pattern::Seam& seam : sorted.seams)
    for (std::vector<pattern::SeamEdge>* side : {&seam.a, &seam.b})
      for (pattern::SeamEdge& e : *side) e.panel = place[e.panel];
  return sorted;
}

/// The proposals for one order of the pieces, surest first.
std::vector<SeamProposal> proposals_in_order(const pattern::Pattern& pattern,
                                             const ProposalSettings& settings, const RunContext& context) {
  std::vector<std::array<Index, 2>> sewn;
  std::vector<Index> blocked;
  sort_sewn(pattern, sewn, blocked);
  FoundSeams found =
      search_seams(pattern, sewn, blocked, {settings.sides_known, settings.clockwise}, context);
  std::vector<SeamProposal> proposals;
  if (context.cancelled()) return proposals;
  share_with_mirror_images(found);
  const double belief = puzzle_share(found, settings.sides_known);
  for (const FoundSeam& seam : found.seams)
    for (const FoundSeam& part : parts_of(found, seam)) proposals.push_back(proposal_of(found, part, belief));
  std::stable_sort(proposals.begin(), proposals.end(),
                   [](const SeamProposal& x, const SeamProposal& y) { return x.confidence > y.confidence; });
  return proposals;
}

}  // namespace

bool runs_clockwise(std::span<const Vec2> outline) { return geometry::signed_area(outline) < 0; }

std::vector<SeamProposal> propose_seams(const pattern::Pattern& pattern, const ProposalSettings& settings,
                                        const RunContext& context) {
  const std::vector<Index> order = order_of_pieces(pattern);
  ProposalSettings sorted = settings;
  for (std::size_t i = 0; i < settings.clockwise.size(); ++i)
    sorted.clockwise[i] = settings.clockwise[order[i]];
  std::vector<SeamProposal> proposals = proposals_in_order(in_order(pattern, order), sorted, context);
  for (SeamProposal& p : proposals)
    for (std::vector<pattern::SeamEdge>* side : {&p.seam.a, &p.seam.b})
      for (pattern::SeamEdge& e : *side) e.panel = order[e.panel];
  std::set<std::string> ids;
  for (const pattern::Seam& seam : pattern.seams) ids.insert(seam.id);
  int number = 0;
  for (SeamProposal& p : proposals) {
    do p.seam.id = "seam" + std::to_string(number++);
    while (ids.contains(p.seam.id));
  }
  return proposals;
}

std::vector<bool> sewn_together(std::span<const SeamProposal> proposals, double least_confidence) {
  constexpr double kTouching = 1e-6;  // of an edge's length: parts that meet share nothing
  std::vector<pattern::SeamEdge> taken;
  const auto is_taken = [&](const pattern::SeamEdge& e) {
    return std::any_of(taken.begin(), taken.end(), [&](const pattern::SeamEdge& t) {
      return t.panel == e.panel && t.edge == e.edge &&
             std::min(t.to, e.to) - std::max(t.from, e.from) > kTouching;
    });
  };
  std::vector<bool> sewn;
  for (const SeamProposal& p : proposals) {
    std::vector<pattern::SeamEdge> edges = p.seam.a;
    edges.insert(edges.end(), p.seam.b.begin(), p.seam.b.end());
    sewn.push_back(p.confidence >= least_confidence && std::none_of(edges.begin(), edges.end(), is_taken));
    if (sewn.back()) taken.insert(taken.end(), edges.begin(), edges.end());
  }
  return sewn;
}

}  // namespace toile::seams
