#include "core/pattern/dxf/branches.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/geometry/polygon2.h"

namespace toile {
namespace {

constexpr int kDeepest = 8;            // lines within lines within lines
constexpr int kMostAtOnePlace = 64;    // ends compared around a place
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

class Brancher {
 public:
  Brancher(const std::vector<DxfStroke>& strokes, double tolerance)
      : strokes_(strokes), tolerance_(tolerance), place_(places_of(strokes, tolerance)) {
    for (const DxfStroke& s : strokes_) lengths_.push_back(polyline_length(s.points));
  }

  DxfBranches run() {
    std::vector<std::size_t> all(strokes_.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    for (std::vector<std::size_t>& part : parts_of(all)) {
      if (!branches(part)) {
        result_.plain.insert(result_.plain.end(), part.begin(), part.end());
        continue;
      }
      drop_repeated(part);
      const std::size_t before = result_.loops.size();
      outer_places_.clear();
      std::vector<std::size_t> left = take_closed(part);
      for (int depth = 0; depth < kDeepest && !left.empty(); ++depth) {
        std::vector<std::size_t> rest;
        for (const std::vector<std::size_t>& piece : parts_of(left)) take_outer(piece, rest);
        if (rest.size() == left.size()) break;
        left = std::move(rest);
      }
      std::vector<std::size_t>& list = result_.loops.size() > before ? result_.inner : result_.plain;
      list.insert(list.end(), left.begin(), left.end());
    }
    std::sort(result_.plain.begin(), result_.plain.end());
    return std::move(result_);
  }

 private:
  std::size_t start(const DxfLink& l) const { return place_[2 * l.stroke + (l.reversed ? 1 : 0)]; }
  std::size_t end(const DxfLink& l) const { return place_[2 * l.stroke + (l.reversed ? 0 : 1)]; }
  bool returns(std::size_t i) const { return place_[2 * i] == place_[2 * i + 1]; }
  bool is_dot(std::size_t i) const { return returns(i) && lengths_[i] <= 2 * tolerance_; }

  /// Strokes that hang together, by their first.
  std::vector<std::vector<std::size_t>> parts_of(const std::vector<std::size_t>& strokes) const {
    DisjointSets places(place_.size());
    for (const std::size_t i : strokes) places.join(index(place_[2 * i]), index(place_[2 * i + 1]));
    std::map<Index, std::size_t> number;
    std::vector<std::vector<std::size_t>> parts;
    for (const std::size_t i : strokes) {
      const auto [it, fresh] = number.emplace(places.root(index(place_[2 * i])), parts.size());
      if (fresh) parts.emplace_back();
      parts[it->second].push_back(i);
    }
    return parts;
  }

  bool branches(const std::vector<std::size_t>& part) const {
    std::map<std::size_t, int> ends;
    for (const std::size_t i : part)
      if (!is_dot(i))
        for (const std::size_t place : {place_[2 * i], place_[2 * i + 1]})
          if (++ends[place] > 2) return true;
    return false;
  }

  bool same_line(std::size_t i, std::size_t k) const {
    if (std::abs(lengths_[i] - lengths_[k]) > tolerance_) return false;
    const bool against = place_[2 * i] != place_[2 * k];
    for (const double share : {0.25, 0.5, 0.75}) {
      const Vec2 a = point_along(strokes_[i].points, false, share * lengths_[i]);
      if (length(point_along(strokes_[k].points, against, share * lengths_[k]) - a) > tolerance_)
        return false;
    }
    return true;
  }

  void drop_repeated(std::vector<std::size_t>& part) {
    std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> between;
    std::vector<std::size_t> kept;
    for (const std::size_t i : part) {
      std::vector<std::size_t>& others = between[std::minmax(place_[2 * i], place_[2 * i + 1])];
      const bool known = others.size() < kMostAtOnePlace && !is_dot(i) &&
                         std::any_of(others.begin(), others.end(), [&](auto k) { return same_line(i, k); });
      if (!known) others.push_back(i);
      (known ? result_.repeated : kept).push_back(i);
    }
    part = std::move(kept);
  }

  /// Takes the strokes out that close by themselves; gives the others.
  std::vector<std::size_t> take_closed(const std::vector<std::size_t>& part) {
    std::vector<std::size_t> left;
    for (const std::size_t i : part) {
      if (returns(i) && !is_dot(i)) {
        result_.loops.push_back({{{i, false}}, false});
      } else {
        left.push_back(i);
      }
    }
    return left;
  }

  using Fan = std::vector<DxfLink>;  // leaving one place, counter-clockwise

  std::map<std::size_t, Fan> fans_of(const std::vector<std::size_t>& part) const {
    std::map<std::size_t, Fan> fans;
    for (const std::size_t i : part) {
      if (is_dot(i)) continue;
      for (const bool reversed : {false, true}) fans[start({i, reversed})].push_back({i, reversed});
    }
    for (auto& [place, fan] : fans) {
      double reach = kDirectionReach;
      for (const DxfLink& l : fan) reach = std::min(reach, lengths_[l.stroke] / 3);
      std::vector<std::pair<double, std::size_t>> order;
      for (std::size_t k = 0; k < fan.size(); ++k) {
        const std::vector<Vec2>& p = strokes_[fan[k].stroke].points;
        const Vec2 d = point_along(p, fan[k].reversed, reach) - strokes_[fan[k].stroke].end(fan[k].reversed);
        order.emplace_back(std::atan2(d.y, d.x), k);
      }
      std::sort(order.begin(), order.end());
      Fan sorted;
      for (const auto& [angle, k] : order) sorted.push_back(fan[k]);
      fan = std::move(sorted);
    }
    return fans;
  }

  double area_of(const std::vector<DxfLink>& walk) const {
    std::vector<Vec2> points;
    for (const DxfLink& l : walk) {
      const std::vector<Vec2>& p = strokes_[l.stroke].points;
      if (l.reversed) points.insert(points.end(), p.rbegin(), p.rend());
      if (!l.reversed) points.insert(points.end(), p.begin(), p.end());
    }
    return signed_area(points);
  }

  /// All walks that keep their face at the left.
  std::vector<std::vector<DxfLink>> faces_of(const std::vector<std::size_t>& part) const {
    const std::map<std::size_t, Fan> fans = fans_of(part);
    std::map<std::pair<std::size_t, bool>, std::size_t> rank;  // of each link in its fan
    for (const auto& [place, fan] : fans)
      for (std::size_t k = 0; k < fan.size(); ++k) rank[{fan[k].stroke, fan[k].reversed}] = k;
    std::map<std::pair<std::size_t, bool>, bool> seen;
    std::vector<std::vector<DxfLink>> faces;
    for (const auto& [key, unused] : rank) {
      if (seen[key]) continue;
      std::vector<DxfLink>& walk = faces.emplace_back();
      DxfLink at{key.first, key.second};
      while (!seen[{at.stroke, at.reversed}]) {
        seen[{at.stroke, at.reversed}] = true;
        walk.push_back(at);
        const Fan& fan = fans.at(end(at));
        at = fan[(rank.at({at.stroke, !at.reversed}) + fan.size() - 1) % fan.size()];
      }
    }
    return faces;
  }

  /// The walk in loops that pass no place twice; what is walked both ways is in none.
  std::vector<std::vector<DxfLink>> simple_loops(const std::vector<DxfLink>& walk) const {
    std::vector<std::vector<DxfLink>> loops;
    std::vector<DxfLink> stack;
    std::map<std::size_t, std::size_t> depth;  // of each place on the stack, counted from 1
    for (const DxfLink& link : walk) {
      depth.emplace(start(link), stack.size() + 1);
      stack.push_back(link);
      const auto there = depth.find(end(link));
      if (there == depth.end() || there->second == 0) continue;
      const std::size_t from = there->second - 1;
      std::vector<DxfLink> loop(stack.begin() + std::ptrdiff_t(from), stack.end());
      for (std::size_t k = from; k < stack.size(); ++k) depth.erase(start(stack[k]));
      stack.resize(from);
      if (loop.size() > 2 || loop.front().stroke != loop.back().stroke) loops.push_back(std::move(loop));
    }
    return loops;
  }

  /// Takes the loops around the outside of strokes that hang together; `rest` gets the others.
  void take_outer(const std::vector<std::size_t>& part, std::vector<std::size_t>& rest) {
    const std::vector<std::vector<DxfLink>> faces = faces_of(part);
    std::size_t outer = 0;
    double least = std::numeric_limits<double>::max();
    for (std::size_t f = 0; f < faces.size(); ++f)
      if (const double area = area_of(faces[f]); area < least) {
        least = area;
        outer = f;
      }
    std::vector<std::vector<DxfLink>> loops;
    if (!faces.empty()) loops = simple_loops(faces[outer]);
    // What an outline holds by one line at most is a hole of its own; what it holds by several is a part of
    // it.
    std::map<std::size_t, bool> held_at;
    for (const std::size_t i : part)
      for (const std::size_t place : {place_[2 * i], place_[2 * i + 1]})
        if (outer_places_.contains(place)) held_at.emplace(place, true);
    std::vector<std::size_t> used;
    for (std::vector<DxfLink>& loop : loops) {
      const bool touches =
          std::any_of(loop.begin(), loop.end(), [&](const DxfLink& l) { return held_at.contains(start(l)); });
      const bool inner = touches || held_at.size() > 1;
      for (const DxfLink& l : loop) used.push_back(l.stroke);
      if (!inner && faces.size() > loops.size() + 1) result_.parted.push_back(loop.front().stroke);
      result_.loops.push_back({std::move(loop), inner});
    }
    for (const std::size_t i : used)
      for (const std::size_t place : {place_[2 * i], place_[2 * i + 1]}) outer_places_.emplace(place, true);
    std::sort(used.begin(), used.end());
    for (const std::size_t i : part)
      if (!std::binary_search(used.begin(), used.end(), i)) rest.push_back(i);
  }

  const std::vector<DxfStroke>& strokes_;
  double tolerance_;
  std::vector<std::size_t> place_;
  std::vector<double> lengths_;
  std::map<std::size_t, bool> outer_places_;  // of the loops found so far among strokes that hang together
  DxfBranches result_;
};

}  // namespace

DxfBranches part_branches(const std::vector<DxfStroke>& strokes, double tolerance) {
  return Brancher(strokes, std::max(tolerance, 1e-6)).run();
}

}  // namespace toile
