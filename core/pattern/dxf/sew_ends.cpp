#include "core/pattern/dxf/sew_ends.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/geometry/polygon2.h"
#include "core/pattern/dxf/allowance.h"

namespace toile::dxf {
namespace {

constexpr double kEndReach = 1;  // mm between an end of the sew line and the cut line

/// A place on a closed line: how far it lies behind vertex `segment`, as a share of the segment there.
struct LoopPlace {
  std::size_t segment = 0;
  double share = 0;
};

/// Where the closed line passes p within reach.
std::optional<LoopPlace> place_within_reach(const std::vector<Vec2>& loop, Vec2 p) {
  std::optional<LoopPlace> best;
  double nearest = kEndReach;
  for (std::size_t i = 0, n = loop.size(); i < n; ++i) {
    const Vec2 a = loop[i], d = loop[(i + 1) % n] - a;
    const double off = geometry::distance_to_segment(p, a, a + d);
    if (off > nearest) continue;
    const double l2 = dot(d, d);
    nearest = off;
    best = LoopPlace{i, l2 > 0 ? std::min(1.0, std::max(0.0, dot(p - a, d) / l2)) : 0};
  }
  return best;
}

/// The vertices of the closed line on the way from one place to another, in its own direction.
std::vector<Vec2> way(const std::vector<Vec2>& loop, const LoopPlace& from, const LoopPlace& to) {
  const std::size_t n = loop.size();
  std::vector<Vec2> points;
  const bool at_once = from.segment == to.segment && from.share <= to.share;
  if (at_once) return points;
  for (std::size_t i = from.segment; i != to.segment || points.empty(); i = (i + 1) % n)
    points.push_back(loop[(i + 1) % n]);
  return points;
}

/// The sew line closed along the cut line, on the side where it goes around more; nothing when its ends lie
/// elsewhere or it does not follow the cut line.
std::optional<DxfChain> closed_along(const DxfChain& sew, const DxfChain& cut) {
  const std::vector<Vec2>& loop = cut.points;
  const std::optional<LoopPlace> first = place_within_reach(loop, sew.points.front()),
                                 last = place_within_reach(loop, sew.points.back());
  if (!first || !last) return std::nullopt;
  const std::vector<Vec2> onwards = way(loop, *last, *first), back = way(loop, *first, *last);
  DxfChain ahead = sew, other = sew;
  ahead.closed = other.closed = true;
  ahead.points.insert(ahead.points.end(), onwards.begin(), onwards.end());
  other.points.insert(other.points.end(), back.rbegin(), back.rend());
  const DxfLoop a = loop_of(ahead, 0, DxfRole::kSew), b = loop_of(other, 0, DxfRole::kSew);
  const bool follows =
      is_seam_line(a.area >= b.area ? a : b, loop_of(cut, 0, DxfRole::kCut), DxfSewClaim::kSaid);
  if (!follows) return std::nullopt;
  return a.area >= b.area ? std::move(ahead) : std::move(other);
}

}  // namespace

DxfClosed closed_at_cut_lines(std::vector<DxfChain> chains, const DxfRoles& roles) {
  DxfNotes notes;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    if (chains[i].closed || !roles.by_aama || roles.of[i] != DxfRole::kSew) continue;
    for (std::size_t k = 0; k < chains.size() && !chains[i].closed; ++k) {
      if (!chains[k].closed || roles.of[k] != DxfRole::kCut) continue;
      std::optional<DxfChain> whole = closed_along(chains[i], chains[k]);
      if (!whole) continue;
      notes.warn(chains[i].line, "the sew line ends on the cut line and is closed along it", -1,
                 chains[i].points.back());
      chains[i] = *std::move(whole);
    }
  }
  return {std::move(chains), std::move(notes)};
}

}  // namespace toile::dxf
