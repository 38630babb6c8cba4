#include "core/project/create/drawn_darts.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "core/geometry/polygon2.h"
#include "core/pattern/curve.h"
#include "core/pattern/loop_part.h"

namespace toile::create {
namespace {

constexpr double kMeet = 0.5;                        // mm, from one leg's end to the other's at the tip
constexpr double kAtOutline = 2;                     // mm, that a leg may end before it
constexpr double kLeastLeg = 25;                     // mm
constexpr double kLeastMouth = 4, kMostMouth = 130;  // mm
constexpr double kMostAngle = 0.75;                  // radians, about 43 degrees
constexpr double kAlike = 0.08;                      // share by which legs differ, at most
constexpr double kMostCap = 1.35;  // times its breadth, that the outline across the mouth is long
constexpr double kFlat = 0.05;     // mm, chords from the outline

/// From the tip outwards, up to the outline.
std::optional<std::vector<Vec2>> leg_to_outline(const std::vector<Vec2>& line,
                                                const std::vector<Vec2>& outline) {
  std::vector<Vec2> leg{line.front()};
  for (std::size_t k = 1; k < line.size(); ++k) {
    std::optional<Vec2> hit;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vec2 a = outline[i], b = outline[(i + 1) % outline.size()];
      const std::optional<Vec2> at = geometry::segment_intersection(line[k - 1], line[k], a, b);
      if (at && (!hit || length(*at - line[k - 1]) < length(*hit - line[k - 1]))) hit = at;
    }
    leg.push_back(hit ? *hit : line[k]);
    if (hit) return leg;
  }
  const Vec2 end = geometry::nearest_on(outline, leg.back());
  if (length(end - leg.back()) > kAtOutline) return std::nullopt;
  leg.back() = end;
  return leg;
}

/// A corner of the outline, or a place between two.
struct OutlinePlace {
  std::size_t segment = 0;
  double along = 0;  ///< mm, from the outline's start
};

OutlinePlace place_on(const std::vector<Vec2>& outline, Vec2 p) {
  OutlinePlace best;
  double least = HUGE_VAL, before = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 a = outline[i], b = outline[(i + 1) % outline.size()];
    const double off = geometry::distance_to_segment(p, a, b);
    if (off < least) {
      least = off;
      best = {i, before + std::min(length(p - a), length(b - a))};
    }
    before += length(b - a);
  }
  return best;
}

/// The two legs as a dart, where they make one.
std::optional<DrawnDart> dart_of(const std::vector<Vec2>& a, const std::vector<Vec2>& b,
                                 const std::vector<Vec2>& outline) {
  const Vec2 tip = a.front();
  if (!geometry::contains(outline, tip) || length(geometry::nearest_on(outline, tip) - tip) < kLeastLeg / 2)
    return std::nullopt;
  const auto x = leg_to_outline(a, outline), y = leg_to_outline(b, outline);
  if (!x || !y) return std::nullopt;
  const double lx = geometry::polyline_length(*x), ly = geometry::polyline_length(*y);
  const double mouth = length(x->back() - y->back());
  if (std::min(lx, ly) < kLeastLeg || mouth < kLeastMouth || mouth > kMostMouth) return std::nullopt;
  if (std::max(lx, ly) * (1 - kAlike) > std::min(lx, ly)) return std::nullopt;
  const Vec2 ex = x->back() - tip, ey = y->back() - tip;
  if (std::abs(std::atan2(cross(ex, ey), dot(ex, ey))) > kMostAngle) return std::nullopt;
  std::vector<Vec2> closed = outline;
  closed.push_back(outline.front());
  const double whole = geometry::polyline_length(closed);
  double ahead = place_on(outline, y->back()).along - place_on(outline, x->back()).along;
  if (ahead < 0) ahead += whole;
  if (std::min(ahead, whole - ahead) > kMostCap * mouth + kAtOutline) return std::nullopt;
  if (ahead < whole - ahead) return DrawnDart{x->back(), tip, y->back()};
  return DrawnDart{y->back(), tip, x->back()};
}

/// Legs that meet in a point, each from there on.
struct Legs {
  std::vector<Vec2> a, b;
};

/// The line broken at its farthest place from where its ends are.
Legs broken(const std::vector<Vec2>& line) {
  std::size_t tip = 1;
  const auto off = [&](std::size_t k) { return length(line[k] - (line.front() + line.back()) * 0.5); };
  for (std::size_t k = 1; k + 1 < line.size(); ++k)
    if (off(k) > off(tip)) tip = k;
  const auto at = line.begin() + static_cast<std::ptrdiff_t>(tip);
  Legs legs{{line.begin(), at + 1}, {at, line.end()}};
  std::reverse(legs.a.begin(), legs.a.end());
  return legs;
}

/// `line` from that end on.
std::vector<Vec2> from_end(const std::vector<Vec2>& line, bool last) {
  return last ? std::vector<Vec2>(line.rbegin(), line.rend()) : line;
}

std::vector<Legs> legs_of(const std::vector<pattern::InnerLine>& lines) {
  std::vector<const std::vector<Vec2>*> drawn;  // texts drawn in strokes are shorter, and there are many
  for (const pattern::InnerLine& line : lines)
    if (line.drawn && geometry::polyline_length(line.points) >= kLeastLeg) drawn.push_back(&line.points);
  std::vector<Legs> legs;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const std::vector<Vec2>& a = *drawn[i];
    if (a.size() > 2 && length(a.front() - a.back()) > kMeet) legs.push_back(broken(a));
    for (std::size_t j = i + 1; j < drawn.size(); ++j) {
      const std::vector<Vec2>& b = *drawn[j];
      for (const bool last_of_a : {false, true})
        for (const bool last_of_b : {false, true}) {
          const Vec2 tip = last_of_a ? a.back() : a.front();
          if (length(tip - (last_of_b ? b.back() : b.front())) > kMeet) continue;
          legs.push_back({from_end(a, last_of_a), from_end(b, last_of_b)});
          legs.back().b.front() = tip;
        }
    }
  }
  return legs;
}

bool same_place(Vec2 a, Vec2 b) { return length(a - b) < kAtOutline; }

}  // namespace

std::vector<DrawnDart> drawn_darts(const pattern::Panel& panel) {
  const std::vector<Vec2> outline = pattern::flatten(panel.outline, kFlat);
  std::vector<DrawnDart> darts;
  for (const Legs& legs : legs_of(panel.lines)) {
    const std::optional<DrawnDart> dart = dart_of(legs.a, legs.b, outline);
    if (!dart) continue;
    // Of lines that meet in one tip the outermost are the legs.
    const auto same = std::find_if(darts.begin(), darts.end(),
                                   [&](const DrawnDart& other) { return same_place(other.tip, dart->tip); });
    if (same == darts.end())
      darts.push_back(*dart);
    else if (length(dart->second - dart->first) > length(same->second - same->first))
      *same = *dart;
  }
  return darts;
}

pattern::Panel with_dart(const pattern::Panel& panel, const DrawnDart& dart) {
  pattern::Panel cut = panel;
  cut.outline.edges = pattern::edges_between(panel.outline, dart.second, dart.first);
  std::vector<pattern::PanelEdge>& edges = cut.outline.edges;
  const Vec2 from = edges.back().curves.back().p3, to = edges.front().curves.front().p0;
  edges.push_back({"", {pattern::line_segment(from, dart.tip)}});
  edges.push_back({"", {pattern::line_segment(dart.tip, to)}});
  for (std::size_t e = 0; e < edges.size(); ++e) edges[e].id = "e" + std::to_string(e);
  std::erase_if(cut.lines, [&](const pattern::InnerLine& line) {
    return line.drawn && std::any_of(line.points.begin(), line.points.end(),
                                     [&](Vec2 p) { return same_place(p, dart.tip); });
  });
  return cut;
}

}  // namespace toile::create
