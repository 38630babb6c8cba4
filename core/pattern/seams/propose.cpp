#include "core/pattern/seams/propose.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>
#include <set>
#include <utility>

#include "core/geometry/polygon2.h"
#include "core/pattern/curve.h"
#include "core/pattern/own_mirror.h"
#include "core/pattern/seams/accept.h"
#include "core/pattern/seams/confidence.h"
#include "core/pattern/seams/lines.h"
#include "core/pattern/seams/mirror_images.h"
#include "core/pattern/seams/open_collars.h"
#include "core/pattern/seams/runs_to_edges.h"
#include "core/pattern/seams/search.h"
#include "core/pattern/seams/sleeve_head.h"
#include "core/pattern/seams/strangers.h"
#include "core/pattern/seams/strap_places.h"
#include "core/pattern/seams/taken_edges.h"
#include "core/pattern/seams/weights.h"

namespace toile::seams {
namespace {

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

SeamProposal proposal_of(const FoundSeams& found, const FoundSeam& seam, double belief) {
  SeamProposal p;
  p.seam.a = edges_of_runs(found, seam.a, p.length_a);
  std::vector<Index> other(seam.b.rbegin(), seam.b.rend());  // walked with the cloth at the left, too
  p.seam.b = edges_of_runs(found, other, p.length_b);
  say_plainly(p.seam);
  p.confidence = confidence_of(found, seam, p.length_a, p.length_b) * belief;
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

/// Pieces of the pattern, in this order, with the seams that join no others.
pattern::Pattern in_order(const pattern::Pattern& pattern, const std::vector<Index>& order) {
  std::vector<Index> place(pattern.panels.size(), kNone);
  pattern::Pattern sorted;
  for (std::size_t i = 0; i < order.size(); ++i) {
    place[order[i]] = static_cast<Index>(i);
    sorted.panels.push_back(pattern.panels[order[i]]);
  }
  for (pattern::Seam seam : pattern.seams) {
    bool inside = true;
    for (std::vector<pattern::SeamEdge>* side : {&seam.a, &seam.b})
      for (pattern::SeamEdge& e : *side) {
        e.panel = place[e.panel];
        inside = inside && e.panel != kNone;
      }
    if (inside) sorted.seams.push_back(std::move(seam));
  }
  return sorted;
}

/// A dart's legs to each other.
SeamProposal closing(const pattern::Pattern& pattern, const SeamDart& dart) {
  const std::vector<pattern::PanelEdge>& edges = pattern.panels[dart.panel].outline.edges;
  SeamProposal p;
  p.seam.a = {{dart.panel, dart.first}};
  p.seam.b = {{dart.panel, dart.second}};
  p.confidence = kConfidenceWeights.dart;
  p.length_a = pattern::arc_length(edges[dart.first]);
  p.length_b = pattern::arc_length(edges[dart.second]);
  return p;
}

/// The seam's lines as edges of the pattern.
void name_edges(const SeamLines& lines, const pattern::Pattern& pattern, pattern::Seam& seam) {
  for (std::vector<pattern::SeamEdge>* side : {&seam.a, &seam.b}) {
    std::vector<pattern::SeamEdge> edges;
    for (const pattern::SeamEdge& part : *side) {
      const std::vector<pattern::SeamEdge> more = edges_of_line(lines, pattern, part);
      edges.insert(edges.end(), more.begin(), more.end());
    }
    *side = std::move(edges);
  }
}

/// Lengths from the series' start to the end of each of its edges, mm.
std::vector<double> ends_along(const pattern::Pattern& pattern, const std::vector<pattern::SeamEdge>& side) {
  std::vector<double> ends;
  ends.reserve(side.size());
  double at = 0;
  for (const pattern::SeamEdge& e : side)
    ends.push_back(at += (e.to - e.from) *
                         pattern::arc_length(*pattern::edges_of(pattern.panels[e.panel])[e.edge]));
  return ends;
}

/// The seam in parts that meet where an edge ends on both sides, in the order of side a.
std::vector<SeamProposal> parted(const pattern::Pattern& pattern, SeamProposal whole) {
  constexpr double kMeetShare = 0.01;  // of the seam's length
  pattern::Seam& seam = whole.seam;
  if (!seam.same_direction) std::reverse(seam.b.begin(), seam.b.end());  // as side a meets them
  const std::vector<double> a = ends_along(pattern, seam.a), b = ends_along(pattern, seam.b);
  std::vector<SeamProposal> parts;
  std::size_t from_a = 0, from_b = 0;
  for (std::size_t i = 0, j = 0; i < a.size(); ++i) {
    const double here = a[i] / a.back();
    while (j + 1 < b.size() && b[j] / b.back() < here - kMeetShare) ++j;
    if (i + 1 < a.size() && (j + 1 == b.size() || std::abs(b[j] / b.back() - here) > kMeetShare)) continue;
    if (i + 1 == a.size()) j = b.size() - 1;
    SeamProposal part = whole;
    part.seam.a.assign(seam.a.begin() + static_cast<std::ptrdiff_t>(from_a),
                       seam.a.begin() + static_cast<std::ptrdiff_t>(i + 1));
    part.seam.b.assign(seam.b.begin() + static_cast<std::ptrdiff_t>(from_b),
                       seam.b.begin() + static_cast<std::ptrdiff_t>(j + 1));
    if (!seam.same_direction) std::reverse(part.seam.b.begin(), part.seam.b.end());
    part.length_a = ends_along(pattern, part.seam.a).back();
    part.length_b = ends_along(pattern, part.seam.b).back();
    parts.push_back(std::move(part));
    from_a = i + 1;
    from_b = j + 1;
  }
  return parts;
}

/// Whether both sides are whole borders, so that the one could be turned against the other.
bool goes_around(const FoundSeams& found, const FoundSeam& seam) {
  const std::vector<Index> other(seam.b.rbegin(), seam.b.rend());
  return is_whole_border(found.model, found.gluing, seam.a) &&
         is_whole_border(found.model, found.gluing, other);
}

bool surer(const SeamProposal& x, const SeamProposal& y) { return x.confidence > y.confidence; }

/// The proposals for one order of the pieces, surest first.
std::vector<SeamProposal> proposals_in_order(const pattern::Pattern& pattern,
                                             const ProposalSettings& settings, const RunContext& context) {
  const SeamLines lines = lines_of(pattern);
  std::vector<std::array<Index, 2>> sewn;
  std::vector<Index> blocked;
  sort_sewn(lines.pattern, sewn, blocked);
  FoundSeams found =
      search_seams(lines.pattern, sewn, blocked, {settings.sides_known, settings.clockwise}, context);
  std::vector<SeamProposal> proposals;
  if (context.cancelled()) return proposals;
  for (const SeamDart& dart : lines.darts)
    if (!dart.slit) proposals.push_back(closing(pattern, dart));
  share_margins(found);
  const double belief = belief_in(found, settings.sides_known);
  found.model.open_neck = found.model.open_neck || settings.open_neck;
  std::vector<Index> rings;
  for (const FoundSeam& seam : found.seams)
    for (const FoundSeam& part : parts_of(found, begun_at_an_end(found, seam, goes_around(found, seam)))) {
      SeamProposal proposal = proposal_of(found, part, belief);
      if (closes_open_collar(found.model, proposal.seam)) continue;
      begin_in_front(found.model, proposal.seam);
      name_edges(lines, pattern, proposal.seam);
      std::vector<SeamProposal> parts = parted(pattern, std::move(proposal));
      if (parts.size() == 1 && goes_around(found, part))
        rings.push_back(static_cast<Index>(proposals.size()));
      std::move(parts.begin(), parts.end(), std::back_inserter(proposals));
    }
  set_in_sleeves(pattern, found.model, rings, proposals);
  std::stable_sort(proposals.begin(), proposals.end(), surer);
  return proposals;
}

/// ProposalSettings::clockwise without what tells nothing: a band looks the same from both sides, and where
/// all pieces that do not are drawn one way, or most where none does, it is sewn with its right side out as
/// they are.
std::vector<char> telling_windings(const pattern::Pattern& pattern, std::vector<char> clockwise) {
  std::vector<std::size_t> alike;
  std::array<std::size_t, 2> others{}, all{};
  for (std::size_t p = 0; p < clockwise.size(); ++p) {
    const bool is_alike = pattern::is_own_mirror(pattern.panels[p].outline);
    if (is_alike) alike.push_back(p);
    ++all[clockwise[p] != 0];
    others[clockwise[p] != 0] += is_alike ? 0 : 1;
  }
  const bool any = others[0] + others[1] > 0;
  if (any ? std::min(others[0], others[1]) > 0 : all[0] == all[1]) return clockwise;
  for (const std::size_t p : alike) clockwise[p] = any ? others[1] > 0 : all[1] > all[0];
  return clockwise;
}

std::vector<SeamProposal> proposals_of(const pattern::Pattern& pattern, const std::vector<Index>& pieces,
                                       const ProposalSettings& settings, const RunContext& context) {
  ProposalSettings sorted = settings;
  sorted.clockwise.clear();
  sorted.open_neck = sorted.open_neck || has_open_neck(pattern);
  if (!settings.clockwise.empty())
    for (const Index p : pieces) sorted.clockwise.push_back(settings.clockwise[p]);
  std::vector<SeamProposal> proposals = proposals_in_order(in_order(pattern, pieces), sorted, context);
  for (SeamProposal& p : proposals)
    for (std::vector<pattern::SeamEdge>* side : {&p.seam.a, &p.seam.b})
      for (pattern::SeamEdge& e : *side) e.panel = pieces[e.panel];
  return proposals;
}

/// First for the pieces that make the garment, then for what lies on them and for strangers: linings, facings
/// and pockets repeat their outlines, and would take their edges, and so would strips.
std::vector<SeamProposal> proposals_by_layers(const pattern::Pattern& pattern,
                                              const ProposalSettings& settings, const RunContext& context) {
  const std::vector<Index> all = order_of_pieces(pattern);
  const std::vector<char> last = sewn_last(pattern);
  std::vector<Index> shell;
  std::copy_if(all.begin(), all.end(), std::back_inserter(shell), [&](Index p) { return !last[p]; });
  if (shell.size() < 2 || shell.size() == all.size()) return proposals_of(pattern, all, settings, context);
  std::vector<SeamProposal> proposals = proposals_of(pattern, shell, settings, context);
  const std::vector<bool> taken = sewn_together(proposals, kConfidenceWeights.settled);
  pattern::Pattern sewn = pattern;
  for (std::size_t i = 0; i < proposals.size(); ++i)
    if (taken[i]) sewn.seams.push_back(proposals[i].seam);
  for (SeamProposal& p : proposals_of(sewn, all, settings, context)) proposals.push_back(std::move(p));
  std::stable_sort(proposals.begin(), proposals.end(), surer);
  return proposals;
}

}  // namespace

bool runs_clockwise(std::span<const Vec2> outline) { return geometry::signed_area(outline) < 0; }

std::vector<SeamProposal> propose_seams(const pattern::Pattern& pattern, const ProposalSettings& settings,
                                        const RunContext& context) {
  ProposalSettings telling = settings;
  telling.clockwise = telling_windings(pattern, settings.clockwise);
  std::vector<SeamProposal> proposals =
      with_strap_places(pattern, with_mirror_images(pattern, proposals_by_layers(pattern, telling, context)));
  std::set<std::string> ids;
  for (const pattern::Seam& seam : pattern.seams) ids.insert(seam.id);
  int number = 0;
  for (SeamProposal& p : proposals) {
    do p.seam.id = "seam" + std::to_string(number++);
    while (ids.contains(p.seam.id));
  }
  return proposals;
}

}  // namespace toile::seams
