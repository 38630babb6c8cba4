#include "core/pattern/dxf/branches.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/geometry/polygon2.h"

namespace toile::dxf {
namespace {

constexpr int kDeepestBranches = 8;    // lines within lines within lines
constexpr double kDirectionReach = 2;  // mm along a stroke, where its direction at its end is measured

Index index(std::size_t i) { return static_cast<Index>(i); }

/// The place of each end: number 2 i + (0 start, 1 end) of stroke i.
std::vector<std::size_t> places_of(const std::vector<DxfStroke>& strokes, double tolerance) {
  using Entry = std::tuple<std::int64_t, std::int64_t, std::size_t>;
  const auto cell = [&](double v) { return static_cast<std::int64_t>(std::floor(v / tolerance)); };
  const auto point = [&](std::size_t end) { return strokes[end / 2].end(end % 2 == 1); };
  std::vector<Entry> entries;
  for (std::size_t e = 0; e < 2 * strokes.size(); ++e)
    entries.emplace_back(cell(point(e).x), cell(point(e).y), e);
  std::sort(entries.begin(), entries.end());
  DisjointSets places(entries.size());
  for (const auto& [x, y, e] : entries) {
    for (std::int64_t dx = 0; dx <= 1; ++dx) {
      for (std::int64_t dy = dx == 0 ? 0 : -1; dy <= 1; ++dy) {
        auto it = std::lower_bound(entries.begin(), entries.end(), Entry{x + dx, y + dy, 0});
        for (int seen = 0; it != entries.end() && seen < kMostAtOnePlace; ++it, ++seen) {
          if (std::get<0>(*it) != x + dx || std::get<1>(*it) != y + dy) break;
          if (length(point(std::get<2>(*it)) - point(e)) <= tolerance)
            places.join(index(e), index(std::get<2>(*it)));
        }
      }
    }
  }
  std::vector<std::size_t> roots(entries.size());
  for (std::size_t e = 0; e < roots.size(); ++e) roots[e] = static_cast<std::size_t>(places.root(index(e)));
  return roots;
}

/// The point at distance s along the stroke from one of its ends.
Vec2 point_along(const std::vector<Vec2>& p, bool from_end, double s) {
  const std::size_t n = p.size();
  const auto at = [&](std::size_t i) { return from_end ? p[n - 1 - i] : p[i]; };
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const double l = length(at(i + 1) - at(i));
    if (l >= s && l > 0) return at(i) + (at(i + 1) - at(i)) * (s / l);
    s -= l;
  }
  return at(n - 1);
}

/// Numbers of strokes, ascending unless said otherwise.
using Strokes = std::vector<std::size_t>;
/// Links one after the other, each from where the one before ends.
using Walk = std::vector<DxfLink>;

/// Strokes and the places where they meet. It stays as it is; what is looked for among the strokes goes by
/// their numbers.
struct StrokeGraph {
  const std::vector<DxfStroke>& strokes;
  double tolerance;                 ///< mm
  std::vector<std::size_t> places;  ///< of each end: number 2 i + (0 start, 1 end) of stroke i
  std::vector<double> lengths;      ///< mm, of each stroke

  std::size_t start(const DxfLink& l) const { return places[2 * l.stroke + (l.reversed ? 1 : 0)]; }
  std::size_t end(const DxfLink& l) const { return places[2 * l.stroke + (l.reversed ? 0 : 1)]; }
  /// Whether stroke i ends where it begins, by itself a loop …
  bool returns(std::size_t i) const { return places[2 * i] == places[2 * i + 1]; }
  /// … or too short to be one.
  bool is_dot(std::size_t i) const { return returns(i) && lengths[i] <= 2 * tolerance; }
};

StrokeGraph graph_of(const std::vector<DxfStroke>& strokes, double tolerance) {
  StrokeGraph graph{strokes, tolerance, places_of(strokes, tolerance), {}};
  for (const DxfStroke& s : strokes) graph.lengths.push_back(geometry::polyline_length(s.points));
  return graph;
}

/// Strokes that hang together, by their first.
std::vector<Strokes> parts_of(const StrokeGraph& graph, const Strokes& strokes) {
  DisjointSets places(graph.places.size());
  for (const std::size_t i : strokes) places.join(index(graph.places[2 * i]), index(graph.places[2 * i + 1]));
  std::map<Index, std::size_t> number;
  std::vector<Strokes> parts;
  for (const std::size_t i : strokes) {
    const auto [it, fresh] = number.emplace(places.root(index(graph.places[2 * i])), parts.size());
    if (fresh) parts.emplace_back();
    parts[it->second].push_back(i);
  }
  return parts;
}

/// Whether more than two strokes meet anywhere.
bool branches(const StrokeGraph& graph, const Strokes& part) {
  std::map<std::size_t, int> ends;
  for (const std::size_t i : part)
    if (!graph.is_dot(i))
      for (const std::size_t place : {graph.places[2 * i], graph.places[2 * i + 1]})
        if (++ends[place] > 2) return true;
  return false;
}

/// Whether two strokes between the same places run along one another.
bool same_line(const StrokeGraph& graph, std::size_t i, std::size_t k) {
  if (std::abs(graph.lengths[i] - graph.lengths[k]) > graph.tolerance) return false;
  const bool against = graph.places[2 * i] != graph.places[2 * k];
  for (const double share : {0.25, 0.5, 0.75}) {
    const Vec2 a = point_along(graph.strokes[i].points, false, share * graph.lengths[i]);
    const Vec2 b = point_along(graph.strokes[k].points, against, share * graph.lengths[k]);
    if (length(b - a) > graph.tolerance) return false;
  }
  return true;
}

struct Repeats {
  Strokes kept, repeated;
};

/// Tells apart the strokes that are drawn a second time: left in, they would part the outline's inside.
Repeats repeats_of(const StrokeGraph& graph, const Strokes& part) {
  std::map<std::pair<std::size_t, std::size_t>, Strokes> between;  // strokes kept so far, by their places
  Repeats found;
  for (const std::size_t i : part) {
    Strokes& others = between[std::minmax(graph.places[2 * i], graph.places[2 * i + 1])];
    const bool known =
        others.size() < kMostAtOnePlace && !graph.is_dot(i) &&
        std::any_of(others.begin(), others.end(), [&](std::size_t k) { return same_line(graph, i, k); });
    if (!known) others.push_back(i);
    (known ? found.repeated : found.kept).push_back(i);
  }
  return found;
}

using Fan = std::vector<DxfLink>;  // leaving one place, counter-clockwise

/// The links by the place that they leave.
std::map<std::size_t, Fan> fans_of(const StrokeGraph& graph, const Strokes& part) {
  std::map<std::size_t, Fan> fans;
  for (const std::size_t i : part) {
    if (graph.is_dot(i)) continue;
    for (const bool reversed : {false, true}) fans[graph.start({i, reversed})].push_back({i, reversed});
  }
  for (auto& [place, fan] : fans) {
    double reach = kDirectionReach;
    for (const DxfLink& l : fan) reach = std::min(reach, graph.lengths[l.stroke] / 3);
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t k = 0; k < fan.size(); ++k) {
      const DxfStroke& stroke = graph.strokes[fan[k].stroke];
      const Vec2 d = point_along(stroke.points, fan[k].reversed, reach) - stroke.end(fan[k].reversed);
      order.emplace_back(std::atan2(d.y, d.x), k);
    }
    std::sort(order.begin(), order.end());
    Fan sorted;
    for (const auto& [angle, k] : order) sorted.push_back(fan[k]);
    fan = std::move(sorted);
  }
  return fans;
}

/// Signed area that the walk goes round, mm².
double area_of(const StrokeGraph& graph, const Walk& walk) {
  std::vector<Vec2> points;
  for (const DxfLink& l : walk) {
    const std::vector<Vec2>& p = graph.strokes[l.stroke].points;
    if (l.reversed) points.insert(points.end(), p.rbegin(), p.rend());
    if (!l.reversed) points.insert(points.end(), p.begin(), p.end());
  }
  return geometry::signed_area(points);
}

/// All walks that keep their face at the left: at each place on along the next link clockwise from the one
/// that leads back.
std::vector<Walk> faces_of(const StrokeGraph& graph, const Strokes& part) {
  const std::map<std::size_t, Fan> fans = fans_of(graph, part);
  std::map<std::pair<std::size_t, bool>, std::size_t> rank;  // of each link in its fan
  for (const auto& [place, fan] : fans)
    for (std::size_t k = 0; k < fan.size(); ++k) rank[{fan[k].stroke, fan[k].reversed}] = k;
  std::map<std::pair<std::size_t, bool>, bool> seen;
  std::vector<Walk> faces;
  for (const auto& [key, unused] : rank) {
    if (seen[key]) continue;
    Walk& walk = faces.emplace_back();
    DxfLink at{key.first, key.second};
    while (!seen[{at.stroke, at.reversed}]) {
      seen[{at.stroke, at.reversed}] = true;
      walk.push_back(at);
      const Fan& fan = fans.at(graph.end(at));
      at = fan[(rank.at({at.stroke, !at.reversed}) + fan.size() - 1) % fan.size()];
    }
  }
  return faces;
}

/// The walk in loops that pass no place twice; what is walked both ways is in none.
std::vector<Walk> simple_loops(const StrokeGraph& graph, const Walk& walk) {
  std::vector<Walk> loops;
  Walk stack;
  std::map<std::size_t, std::size_t> depth;  // of each place on the stack, counted from 1
  for (const DxfLink& link : walk) {
    depth.emplace(graph.start(link), stack.size() + 1);
    stack.push_back(link);
    const auto there = depth.find(graph.end(link));
    if (there == depth.end() || there->second == 0) continue;
    const std::size_t from = there->second - 1;
    Walk loop(stack.begin() + std::ptrdiff_t(from), stack.end());
    for (std::size_t k = from; k < stack.size(); ++k) depth.erase(graph.start(stack[k]));
    stack.resize(from);
    if (loop.size() > 2 || loop.front().stroke != loop.back().stroke) loops.push_back(std::move(loop));
  }
  return loops;
}

/// Of all faces the one around the outside: walked clockwise, it has the least signed area.
std::size_t outer_of(const StrokeGraph& graph, const std::vector<Walk>& faces) {
  std::size_t outer = 0;
  double least = std::numeric_limits<double>::max();
  for (std::size_t f = 0; f < faces.size(); ++f)
    if (const double area = area_of(graph, faces[f]); area < least) {
      least = area;
      outer = f;
    }
  return outer;
}

/// Places that loops pass.
using Places = std::set<std::size_t>;

/// The loops around the outside of strokes that hang together.
struct OuterLoops {
  std::vector<DxfBranchLoop> loops;
  Strokes parted;  ///< a stroke of each outline whose inside is parted by other lines
  Strokes rest;    ///< strokes of no loop
  Places places;   ///< that the loops pass
};

/// `known`: places of loops that were found further out among strokes that hung together with these.
OuterLoops outer_loops(const StrokeGraph& graph, const Strokes& part, const Places& known) {
  const std::vector<Walk> faces = faces_of(graph, part);
  std::vector<Walk> loops;
  if (!faces.empty()) loops = simple_loops(graph, faces[outer_of(graph, faces)]);
  // What an outline holds by one line at most is a hole of its own; what it holds by several is a part of it.
  Places held_at;
  for (const std::size_t i : part)
    for (const std::size_t place : {graph.places[2 * i], graph.places[2 * i + 1]})
      if (known.contains(place)) held_at.insert(place);
  OuterLoops found;
  Strokes used;
  for (Walk& loop : loops) {
    const bool touches = std::any_of(loop.begin(), loop.end(),
                                     [&](const DxfLink& l) { return held_at.contains(graph.start(l)); });
    const bool inner = touches || held_at.size() > 1;
    for (const DxfLink& l : loop) used.push_back(l.stroke);
    if (!inner && faces.size() > loops.size() + 1) found.parted.push_back(loop.front().stroke);
    found.loops.push_back({std::move(loop), inner});
  }
  for (const std::size_t i : used) found.places.insert({graph.places[2 * i], graph.places[2 * i + 1]});
  std::sort(used.begin(), used.end());
  for (const std::size_t i : part)
    if (!std::binary_search(used.begin(), used.end(), i)) found.rest.push_back(i);
  return found;
}

void append(Strokes& list, const Strokes& more) { list.insert(list.end(), more.begin(), more.end()); }

/// What a part that branches holds: strokes that close by themselves, then outer loops, and what hangs
/// together without those once more, down to kDeepestBranches.
DxfBranches sorted_out(const StrokeGraph& graph, const Strokes& part) {
  const Repeats repeats = repeats_of(graph, part);
  DxfBranches found;
  found.repeated = repeats.repeated;
  Strokes left;
  for (const std::size_t i : repeats.kept) {
    const bool closes = graph.returns(i) && !graph.is_dot(i);
    if (closes) found.loops.push_back({{{i, false}}, false});
    if (!closes) left.push_back(i);
  }
  Places places;
  for (int depth = 0; depth < kDeepestBranches && !left.empty(); ++depth) {
    Strokes rest;
    for (const Strokes& piece : parts_of(graph, left)) {
      OuterLoops outer = outer_loops(graph, piece, places);
      found.loops.insert(found.loops.end(), outer.loops.begin(), outer.loops.end());
      append(found.parted, outer.parted);
      append(rest, outer.rest);
      places.merge(outer.places);
    }
    if (rest.size() == left.size()) break;
    left = std::move(rest);
  }
  (found.loops.empty() ? found.plain : found.inner) = std::move(left);
  return found;
}

}  // namespace

DxfBranches part_branches(const std::vector<DxfStroke>& strokes, double tolerance) {
  const StrokeGraph graph = graph_of(strokes, std::max(tolerance, 1e-6));
  Strokes all(strokes.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  DxfBranches found;
  for (const Strokes& part : parts_of(graph, all)) {
    if (!branches(graph, part)) {
      append(found.plain, part);
      continue;
    }
    const DxfBranches here = sorted_out(graph, part);
    found.loops.insert(found.loops.end(), here.loops.begin(), here.loops.end());
    append(found.repeated, here.repeated);
    append(found.parted, here.parted);
    append(found.inner, here.inner);
    append(found.plain, here.plain);
  }
  std::sort(found.plain.begin(), found.plain.end());
  return found;
}

}  // namespace toile::dxf
