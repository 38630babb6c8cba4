#include "core/pattern/seams/strap_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>

#include "core/pattern/seams/accept.h"
#include "core/pattern/seams/model.h"
#include "core/pattern/seams/piece_words.h"
#include "core/pattern/seams/shapes.h"
#include "core/pattern/seams/taken_edges.h"
#include "core/pattern/seams/weights.h"

namespace toile::seams {
namespace {

/// Where a strap's end is sewn on.
struct StrapPlace {
  Index run = kNone;
  double from = 0, to = 0;  ///< mm along the run
  double height = 0;        ///< mm along the piece's grain
};

/// The places of one face of the body, on the wearer's right and left.
using FacePlaces = std::array<std::optional<StrapPlace>, 2>;

class StrapPlaces {
 public:
  StrapPlaces(const pattern::Pattern& pattern, const std::vector<SeamProposal>& proposals)
      : model_(make_seam_model(pattern)),
        first_(first_runs(pattern)),
        sewn_(model_.runs.size(), 0),
        partner_(model_.runs.size(), kNone) {
    for (const pattern::Seam& seam : pattern.seams) take(seam);
    const std::vector<bool> likely = sewn_together(proposals, kLikely);
    for (std::size_t i = 0; i < proposals.size(); ++i)
      if (likely[i]) take(proposals[i].seam);
  }

  std::vector<SeamProposal> proposals() const {
    std::vector<SeamProposal> found;
    const std::vector<Index> straps = loose_straps();
    if (straps.empty()) return found;
    const double width = model_.runs[ends_of(straps.front())[0]].length;
    const std::array<FacePlaces, 2> places{places_of(-1, width), places_of(1, width)};  // back, front
    for (std::size_t k = 0; k < straps.size(); ++k) {
      const std::array<Index, 2> ends = ends_of(straps[k]);
      const bool any = sewn_[ends[0]] || sewn_[ends[1]];
      const std::optional<StrapPlace> there =
          any ? sewn_at(sewn_[ends[0]] ? ends[0] : ends[1]) : std::nullopt;
      if (any && !there) continue;
      const bool left = any ? side_of(*there) > 0 : k > 0;
      const std::optional<StrapPlace>&back = places[0][left], &front = places[1][left];
      if (any) {  // the other end is for the other face
        const std::optional<StrapPlace>& other =
            model_.words[model_.runs[there->run].panel].face > 0 ? back : front;
        if (other) found.push_back(sewn_on(sewn_[ends[0]] ? ends[1] : ends[0], *other));
      } else if (back && front) {
        found.push_back(sewn_on(ends[0], *front));
        found.push_back(sewn_on(ends[1], *back));
      }
    }
    return found;
  }

 private:
  void take(const pattern::Seam& seam) {
    for (const pattern::SeamEdge& e : both_sides(seam))
      if (first_[e.panel] + e.edge < first_[e.panel + 1]) sewn_[first_[e.panel] + e.edge] = 1;
    if (seam.a.size() != 1 || seam.b.size() != 1) return;
    const Index a = first_[seam.a[0].panel] + seam.a[0].edge, b = first_[seam.b[0].panel] + seam.b[0].edge;
    partner_[a] = b;
    partner_[b] = a;
  }

  /// Where that end is sewn on, as far as it is to one edge of a front or a back.
  std::optional<StrapPlace> sewn_at(Index end) const {
    const Index r = partner_[end];
    if (r == kNone || model_.words[model_.runs[r].panel].face == 0) return std::nullopt;
    return StrapPlace{r, 0, model_.runs[r].length, 0};
  }

  /// The edges at both ends of a strip, between its two long ones: of a pointed end the middle one. kNone
  /// where it is none.
  std::array<Index, 2> ends_of(Index panel) const {
    std::vector<Index> ends[2];
    std::size_t sides = 0;
    for (Index r = first_[panel]; r < first_[panel + 1]; ++r) {
      const double share = model_.runs[r].length / model_.girth[panel];
      if (share > kLongSide)
        ++sides;
      else if (share > kWideEnd)
        return {kNone, kNone};
      else
        ends[sides % 2].push_back(r);
    }
    if (sides != 2 || ends[0].empty() || ends[1].empty()) return {kNone, kNone};
    std::rotate(ends[0].begin(), first_behind_gap(ends[0]), ends[0].end());
    const Index a = ends[0][ends[0].size() / 2], b = ends[1][ends[1].size() / 2];
    return {std::min(a, b), std::max(a, b)};
  }

  /// An end may begin before the outline does: the first of its edges, behind the two long ones.
  static std::vector<Index>::iterator first_behind_gap(std::vector<Index>& end) {
    const auto gap = std::adjacent_find(end.begin(), end.end(), [](Index a, Index b) { return b != a + 1; });
    return gap == end.end() ? end.begin() : gap + 1;
  }

  /// Straps of which an end is not sewn, at most the two that are worn.
  std::vector<Index> loose_straps() const {
    std::vector<Index> straps;
    for (Index p = 0; p < static_cast<Index>(model_.words.size()) && straps.size() < 2; ++p) {
      if (!model_.words[p].over_shoulder || model_.words[p].layer) continue;
      const std::array<Index, 2> ends = ends_of(p);
      if (ends[0] != kNone && ends[1] != kNone && !(sewn_[ends[0]] && sewn_[ends[1]])) straps.push_back(p);
    }
    return straps;
  }

  /// Whether straps hang the piece: of a trunk, and for that face.
  bool holds(Index panel, int face) const {
    using enum PieceKind;
    const PieceWords& words = model_.words[panel];
    return words.face == face && !words.layer && !words.limb && words.kind != kStrap && words.kind != kLegs;
  }

  /// mm along the piece's grain, of its highest point.
  double top_of(Index panel) const {
    double top = -HUGE_VAL;
    for (Index r = first_[panel]; r < first_[panel + 1]; ++r)
      for (const Vec2 at : model_.runs[r].at) top = std::max(top, dot(at, model_.up[panel]));
    return top;
  }

  /// A place on the run, `width` wide at most: at its end or its start.
  StrapPlace at_end(Index r, bool end, double width) const {
    const SeamRun& run = model_.runs[r];
    const double length = run.length, most = std::min(width, length);
    const Vec2 corner = end ? run.at.back() : run.at.front();
    return {r, end ? length - most : 0, end ? length : most, dot(corner, model_.up[run.panel])};
  }

  /// Places at corners of the outline with free edges on either side.
  void add_corners(Index panel, double width, std::vector<StrapPlace>& places) const {
    constexpr double kCorner = 165;  // degrees of cloth at most
    for (Index r = first_[panel]; r < first_[panel + 1]; ++r) {
      const SeamRun& before = run_before(model_, model_.runs[r]);
      const Index b = first_[panel] + before.edge;
      if (sewn_[r] || sewn_[b] || model_.runs[r].angle > kCorner) continue;
      const bool on_first = before.up > model_.runs[r].up;
      places.push_back(at_end(on_first ? b : r, on_first, width));
    }
  }

  /// Places at notches of a free upper edge, or, with `quarters`, at a quarter and three quarters of one.
  void add_along(Index panel, double width, bool quarters, std::vector<StrapPlace>& places) const {
    constexpr double kLevel = 0.7, kNear = 3;  // facing; mm
    for (Index r = first_[panel]; r < first_[panel + 1]; ++r) {
      const SeamRun& run = model_.runs[r];
      if (sewn_[r] || run.up < kLevel || run.length < 2 * width) continue;
      const std::vector<double> at =
          quarters ? std::vector<double>{run.length / 4, 3 * run.length / 4} : run.notches;
      const bool pair = at.size() == 2 && std::abs(at[0] + at[1] - run.length) < kNear;
      if (!pair) continue;
      for (const double s : at) {
        const double from = std::clamp(s - width / 2, 0.0, run.length - width);
        places.push_back({r, from, from + width, dot(run.at[SeamRun::kSamples / 2], model_.up[panel])});
      }
    }
  }

  /// +1 on the wearer's left, −1 on the right: seen from outside, a front's right half is worn on the left.
  int side_of(const StrapPlace& place) const {
    const SeamRun& run = model_.runs[place.run];
    const Index panel = run.panel;
    const Vec2 up = model_.up[panel], right{up.y, -up.x};
    double low = HUGE_VAL, high = -HUGE_VAL, outer = 0;
    for (Index r = first_[panel]; r < first_[panel + 1]; ++r) {
      for (const Vec2 at : model_.runs[r].at) {
        low = std::min(low, dot(at, right));
        high = std::max(high, dot(at, right));
      }
      if (sewn_[r] && begins_at_hem(model_, model_.runs[r])) outer += faces_right(model_, model_.runs[r]);
    }
    const double share = (place.from + place.to) / (2 * run.length) * (SeamRun::kSamples - 1);
    const double at = dot(run.at[static_cast<std::size_t>(std::lround(share))], right);
    const Index twin = model_.twin[panel];  // a copy that lies on it is no other half
    const bool whole = twin == panel || twin == kNone || model_.words[twin].layer;
    const double there = whole ? at - (low + high) / 2 : outer;
    return (there > 0 ? 1 : -1) * model_.words[panel].face;
  }

  FacePlaces places_of(int face, double width) const {
    std::vector<Index> panels;
    for (Index p = 0; p < static_cast<Index>(model_.words.size()); ++p)
      if (holds(p, face)) panels.push_back(p);
    std::vector<StrapPlace> places;
    for (const Index p : panels) add_along(p, width, false, places);
    for (const Index p : panels)
      if (places.empty()) add_corners(p, width, places);
    for (const Index p : panels)
      if (places.empty()) add_along(p, width, true, places);
    FacePlaces best;
    for (const StrapPlace& place : places) {
      const bool left = side_of(place) > 0;
      const auto below_top = [&](const StrapPlace& x) { return top_of(model_.runs[x.run].panel) - x.height; };
      if (!best[left] || below_top(place) < below_top(*best[left])) best[left] = place;
    }
    return best;
  }

  SeamProposal sewn_on(Index end, const StrapPlace& place) const {
    const SeamRun &strap = model_.runs[end], &run = model_.runs[place.run];
    SeamProposal p;
    p.seam.a = {{strap.panel, strap.edge}};
    p.seam.b = {{run.panel, run.edge, false, place.from / run.length, place.to / run.length}};
    p.confidence = kConfidenceWeights.strap_place;
    p.length_a = strap.length;
    p.length_b = place.to - place.from;
    return p;
  }

  static constexpr double kLongSide = 0.3, kWideEnd = kPairWeights.strap_end;  // of the outline

  const SeamModel model_;
  const std::vector<Index> first_;
  std::vector<char> sewn_;      ///< of each run: a likely seam takes it
  std::vector<Index> partner_;  ///< and the run that it is sewn to, where that is one alone
};

}  // namespace

std::vector<SeamProposal> with_strap_places(const pattern::Pattern& pattern,
                                            std::vector<SeamProposal> proposals) {
  std::vector<SeamProposal> places = StrapPlaces(pattern, proposals).proposals();
  std::move(places.begin(), places.end(), std::back_inserter(proposals));
  std::stable_sort(proposals.begin(), proposals.end(),
                   [](const SeamProposal& x, const SeamProposal& y) { return x.confidence > y.confidence; });
  return proposals;
}

}  // namespace toile::seams
