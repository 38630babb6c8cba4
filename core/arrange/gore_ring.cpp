#include "core/arrange/gore_ring.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace toile::arrange {

namespace {

constexpr std::size_t kFewest = 5;  // four go on two sheets

/// Where a piece is sewn to another, in its own plane.
std::vector<Vec2> ties_between(const GarmentGraph& graph, Index piece, Index other) {
  std::vector<Vec2> at;
  for (const GarmentTie& t : graph.ties) {
    if (t.a == piece && t.b == other) at.push_back(t.at_a);
    if (t.b == piece && t.a == other) at.push_back(t.at_b);
  }
  return at;
}

Vec2 mean_of(const std::vector<Vec2>& points) {
  Vec2 sum;
  for (const Vec2 p : points) sum = sum + p;
  return sum * (1.0 / static_cast<double>(std::max<std::size_t>(1, points.size())));
}

std::vector<std::vector<Index>> neighbours_among(const GarmentGraph& graph, const std::vector<bool>& may) {
  std::vector<std::vector<Index>> next(graph.pieces.size());
  const auto join = [&](Index a, Index b) {
    if (std::find(next[a].begin(), next[a].end(), b) == next[a].end()) next[a].push_back(b);
  };
  for (const GarmentTie& t : graph.ties) {
    if (t.a == t.b || !may[t.a] || !may[t.b]) continue;
    join(t.a, t.b);
    join(t.b, t.a);
  }
  return next;
}

/// The ring that `first` is in, from it on; empty where it is in none.
std::vector<Index> ring_from(const std::vector<std::vector<Index>>& next, Index first) {
  std::vector<Index> ring;
  for (Index before = kNone, at = first; at != first || ring.empty();) {
    if (next[at].size() != 2 || ring.size() > next.size()) return {};
    ring.push_back(at);
    const Index on = next[at][0] == before ? next[at][1] : next[at][0];
    before = at;
    at = on;
  }
  return ring;
}

double spread_about(const std::vector<Vec2>& left, const std::vector<Vec2>& right, Vec2 up, bool upper) {
  const auto end = [&](const std::vector<Vec2>& points) {
    return *std::max_element(points.begin(), points.end(), [&](Vec2 a, Vec2 b) {
      return upper ? dot(a, up) < dot(b, up) : dot(a, up) > dot(b, up);
    });
  };
  return length(end(left) - end(right));
}

/// Between the neighbours before and after it; upwards is where other pieces are sewn on, or the narrow end.
Gore gore_of(const GarmentGraph& graph, Index before, Index piece, Index after) {
  const std::vector<Vec2> from = ties_between(graph, piece, before), to = ties_between(graph, piece, after);
  const Vec2 across = normalized(mean_of(to) - mean_of(from));
  Gore gore{piece, {}, {-across.y, across.x}, 0, 0, 0, 0};
  Vec2 held;
  int count = 0;
  for (const GarmentTie& t : graph.ties) {
    const bool first = t.a == piece;
    const Index other = first ? t.b : t.a;
    if ((!first && t.b != piece) || other == piece || other == before || other == after) continue;
    held = held + (first ? t.at_a : t.at_b);
    ++count;
  }
  const Vec2 middle = graph.pieces[piece].centroid;
  const bool downwards = count > 0
                             ? dot(held * (1.0 / count) - middle, gore.up) < 0
                             : spread_about(from, to, gore.up, true) > spread_about(from, to, gore.up, false);
  if (downwards) gore.up = -gore.up;
  double highest = -HUGE_VAL, lowest = HUGE_VAL;
  for (const Vec2 p : graph.pieces[piece].outline) {
    highest = std::max(highest, dot(p - middle, gore.up));
    lowest = std::min(lowest, dot(p - middle, gore.up));
  }
  gore.top = middle + gore.up * highest;
  gore.width = spread_about(from, to, gore.up, true);
  gore.below = spread_about(from, to, gore.up, false);
  gore.length = highest - lowest;
  return gore;
}

}  // namespace

std::vector<Gore> gore_ring(const GarmentGraph& graph, const std::vector<bool>& taken) {
  std::vector<bool> may(graph.pieces.size());
  for (std::size_t p = 0; p < may.size(); ++p) {
    const GarmentPiece& piece = graph.pieces[p];
    may[p] = !taken[p] && piece.face == 0 && piece.hand == 0 && !piece.tube &&
             (piece.cover == Cover::kSkirt || piece.cover == Cover::kUnknown);
  }
  const auto next = neighbours_among(graph, may);
  std::vector<Index> ring;
  for (Index p = 0; p < static_cast<Index>(may.size()) && ring.size() < kFewest; ++p)
    if (may[p]) ring = ring_from(next, p);
  if (ring.size() < kFewest) return {};
  std::vector<Gore> gores;
  double around = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    gores.push_back(
        gore_of(graph, ring[(i + ring.size() - 1) % ring.size()], ring[i], ring[(i + 1) % ring.size()]));
    around += gores.back().width;
  }
  // With the outside up and the upper end up, the wearer's left in front is to the right.
  const Gore& first = gores.front();
  const Vec2 right{first.up.y, -first.up.x};
  const Vec2 onwards = mean_of(ties_between(graph, ring[0], ring[1])) - graph.pieces[ring[0]].centroid;
  const double sense = (dot(onwards, right) > 0 ? 1 : -1) * graph.pieces[ring[0]].outside;
  double at = -0.5 * first.width;
  for (Gore& gore : gores) {
    gore.angle = sense * 2 * std::numbers::pi * (at + 0.5 * gore.width) / std::max(1e-6, around);
    at += gore.width;
  }
  return gores;
}

}  // namespace toile::arrange
