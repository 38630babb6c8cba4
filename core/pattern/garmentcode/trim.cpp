#include "core/pattern/garmentcode/trim.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/text.h"
#include "core/pattern/curve.h"
#include "core/pattern/outline.h"

namespace toile::garmentcode {

namespace {

constexpr int kSteps = 64;              // chords of a curve
constexpr int kRefinements = 6;         // each finds the crossing 64 times as closely
constexpr double kLargestLoop = 0.02;   // of the panel's area
constexpr double kLongestLoop = 0.35;   // of either edge's length
constexpr double kNotTheCorner = 1e-3;  // mm

struct OnEdge {
  std::size_t curve = 0;
  double t = 0;
};

struct Meeting {
  OnEdge first, second;
  Vec2 at;
};

/// Parameters along p0→p1 and q0→q1 where these cross.
std::optional<std::pair<double, double>> crossing_of(Vec2 p0, Vec2 p1, Vec2 q0, Vec2 q1) {
  const Vec2 p = p1 - p0, q = q1 - q0;
  const double across = cross(p, q);
  if (across == 0) return std::nullopt;
  const double s = cross(q0 - p0, q) / across, t = cross(q0 - p0, p) / across;
  if (s < 0 || s > 1 || t < 0 || t > 1) return std::nullopt;
  return std::pair(s, t);
}

struct Span {
  double from = 0, to = 1;
  double at(double share) const { return from + (to - from) * share; }
};

/// Where two curves cross within the spans, sought by ever finer chords.
std::optional<std::pair<double, double>> meet(const pattern::CubicBezier& a, const pattern::CubicBezier& b,
                                              Span of_a, Span of_b, Vec2 corner) {
  for (int round = 0; round < kRefinements; ++round) {
    std::optional<std::pair<int, int>> found;
    for (int i = 0; i < kSteps && !found; ++i) {
      const Vec2 a0 = evaluate(a, of_a.at(double(i) / kSteps)),
                 a1 = evaluate(a, of_a.at(double(i + 1) / kSteps));
      for (int j = 0; j < kSteps && !found; ++j) {
        const Vec2 b0 = evaluate(b, of_b.at(double(j) / kSteps)),
                   b1 = evaluate(b, of_b.at(double(j + 1) / kSteps));
        const auto crossed = crossing_of(a0, a1, b0, b1);
        if (crossed && length(a0 + (a1 - a0) * crossed->first - corner) > kNotTheCorner) found = {i, j};
      }
    }
    if (!found) return std::nullopt;
    of_a = {of_a.at(double(found->first) / kSteps), of_a.at(double(found->first + 1) / kSteps)};
    of_b = {of_b.at(double(found->second) / kSteps), of_b.at(double(found->second + 1) / kSteps)};
    if (round + 1 == kRefinements || of_a.to - of_a.from < 1e-9) break;
  }
  return std::pair(of_a.at(0.5), of_b.at(0.5));
}

/// The crossing of two edges of which the second begins where the first ends, other than there.
std::optional<Meeting> meeting_of(const pattern::PanelEdge& first, const pattern::PanelEdge& second) {
  const Vec2 corner = second.curves.front().p0;
  for (std::size_t i = 0; i < first.curves.size(); ++i)
    for (std::size_t j = 0; j < second.curves.size(); ++j)
      if (const auto met = meet(first.curves[i], second.curves[j], {}, {}, corner))
        return Meeting{{i, met->first}, {j, met->second}, evaluate(first.curves[i], met->first)};
  return std::nullopt;
}

pattern::PanelEdge before(const pattern::PanelEdge& edge, OnEdge end, Vec2 at) {
  pattern::PanelEdge part{edge.id, {edge.curves.begin(), edge.curves.begin() + static_cast<long>(end.curve)}};
  part.curves.push_back(split(edge.curves[end.curve], end.t).first);
  part.curves.back().p3 = at;
  return part;
}

pattern::PanelEdge after(const pattern::PanelEdge& edge, OnEdge start, Vec2 at) {
  pattern::PanelEdge part{edge.id, {split(edge.curves[start.curve], start.t).second}};
  part.curves.front().p0 = at;
  part.curves.insert(part.curves.end(), edge.curves.begin() + static_cast<long>(start.curve) + 1,
                     edge.curves.end());
  return part;
}

}  // namespace

std::vector<std::string> trim_crossing_corners(pattern::Panel& panel) {
  std::vector<std::string> trimmed;
  std::vector<pattern::PanelEdge>& edges = panel.outline.edges;
  for (std::size_t i = 0; i < edges.size() && edges.size() > 2; ++i) {
    pattern::PanelEdge &first = edges[i], &second = edges[(i + 1) % edges.size()];
    const auto met = meeting_of(first, second);
    if (!met) continue;
    pattern::PanelEdge shorter = before(first, met->first, met->at);
    pattern::PanelEdge later = after(second, met->second, met->at);
    const double off_first = arc_length(first) - arc_length(shorter);
    const double off_second = arc_length(second) - arc_length(later);
    if (off_first > kLongestLoop * arc_length(first) || off_second > kLongestLoop * arc_length(second))
      continue;
    pattern::Panel mended = panel;
    mended.outline.edges[i] = std::move(shorter);
    mended.outline.edges[(i + 1) % edges.size()] = std::move(later);
    const double area = signed_area(panel.outline);
    if (std::abs(signed_area(mended.outline) - area) > kLargestLoop * std::abs(area)) continue;
    trimmed.push_back("edges " + first.id + " and " + second.id + " ran past each other; both end at " +
                      pattern::place_text(met->at));
    panel = std::move(mended);
  }
  return trimmed;
}

}  // namespace toile::garmentcode
