#include "core/pattern/outline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "core/base/text.h"
#include "core/geometry/polygon2.h"
#include "core/pattern/corners.h"
#include "core/pattern/curve.h"
#include "core/pattern/fit.h"

namespace toile::pattern {

std::string place_text(Vec2 p) {
  return "(" + significant_text(p.x, 6) + ", " + significant_text(p.y, 6) + ") mm";
}

namespace {

constexpr double kForcedReach = 0.5;  // mm from a forced corner to its vertex
constexpr std::size_t kNothing = std::numeric_limits<std::size_t>::max();

using Points = std::span<const Vec2>;

std::optional<Error> not_finite(const std::vector<Vec2>& points) {
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!is_finite(points[i]))
      return Error{"pattern.not_finite", "A coordinate is not a finite number.",
                   "point " + std::to_string(i)};
  return std::nullopt;
}

/// Drops points nearer than the joint tolerance to the one kept before.
std::vector<Vec2> apart(const std::vector<Vec2>& points) {
  std::vector<Vec2> kept;
  for (Vec2 p : points)
    if (kept.empty() || length(p - kept.back()) >= kJointTolerance) kept.push_back(p);
  return kept;
}

}  // namespace

std::variant<std::vector<Vec2>, BadOutline> clean_outline(const std::vector<Vec2>& points) {
  if (const auto error = not_finite(points))
    return BadOutline{OutlineFault::kNotFinite, error->message, error->where};
  std::vector<Vec2> loop = apart(points);
  while (loop.size() > 1 && length(loop.back() - loop.front()) < kJointTolerance) loop.pop_back();
  const std::string where = points.empty() ? std::string() : "near " + place_text(points.front());
  if (loop.size() < 3)
    return BadOutline{OutlineFault::kTooFewPoints,
                      "An outline needs at least three points apart from each other.", where};
  // A figure of eight may sum to nothing as well: there the crossing is the better news.
  if (std::abs(geometry::signed_area(loop)) < kLeastArea && geometry::is_flat(loop, kJointTolerance))
    return BadOutline{OutlineFault::kZeroArea, "The outline encloses no area.", where};
  const std::vector<std::vector<Vec2>> loops{loop};
  const std::optional<geometry::Crossing> crossing = geometry::find_crossing(loops);
  if (crossing)
    return BadOutline{OutlineFault::kSelfCrossing,
                      "The outline crosses or touches itself at " + place_text(crossing->point) + ".",
                      "at " + place_text(crossing->point)};
  return loop;
}

namespace {

Error error_of(const BadOutline& bad) {
  const auto code = [&] {
    switch (bad.fault) {
      case OutlineFault::kNotFinite:
        return "pattern.not_finite";
      case OutlineFault::kTooFewPoints:
        return "pattern.too_few_points";
      case OutlineFault::kZeroArea:
        return "pattern.zero_area";
      case OutlineFault::kSelfCrossing:
        break;
    }
    return "pattern.self_crossing";
  };
  return {code(), bad.message, bad.where};
}

Result<std::vector<std::size_t>> forced_vertices(Points loop, Points corners) {
  std::vector<std::size_t> indices;
  for (std::size_t c = 0; c < corners.size(); ++c) {
    std::size_t best = kNothing;
    for (std::size_t i = 0; i < loop.size(); ++i)
      if (best == kNothing || length(loop[i] - corners[c]) < length(loop[best] - corners[c])) best = i;
    const double off = length(loop[best] - corners[c]);
    if (!(off <= kForcedReach))
      return Error{"pattern.corner_off_outline",
                   "Corner " + std::to_string(c) + " at " + place_text(corners[c]) +
                       " is not within 0.5 mm of a vertex of the outline; the nearest is " +
                       place_text(loop[best]) + ".",
                   "corner " + std::to_string(c)};
    if (std::find(indices.begin(), indices.end(), best) == indices.end()) indices.push_back(best);
  }
  return indices;
}

/// Index of the vertex of the polyline at p, which becomes one where it lies on a segment; nothing away from
/// it.
std::optional<std::size_t> vertex_at(std::vector<Vec2>& line, Vec2 p) {
  constexpr double kOnLine = 0.05;  // mm
  std::size_t best = 0;
  double nearest = kOnLine;
  bool found = false;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double off = geometry::distance_to_segment(p, line[i], line[i + 1]);
    if (off < nearest) {
      nearest = off;
      best = i;
      found = true;
    }
  }
  if (!found) return std::nullopt;
  for (const std::size_t i : {best, best + 1})
    if (length(line[i] - p) <= kOnLine) return i;
  line.insert(line.begin() + std::ptrdiff_t(best) + 1, p);
  return best + 1;
}

/// The inner vertices of the polyline where curves are to end; it gains those that are missing.
std::vector<std::size_t> curve_ends(std::vector<Vec2>& line, Points places) {
  std::vector<Vec2> there;
  for (const Vec2 p : places)
    if (const auto i = vertex_at(line, p)) there.push_back(line[*i]);
  std::vector<std::size_t> ends;
  for (std::size_t i = 1; i + 1 < line.size(); ++i)
    if (std::find(there.begin(), there.end(), line[i]) != there.end()) ends.push_back(i);
  return ends;
}

/// Edges between consecutive corners; corners ascend from the start of e0, which the loop begins with.
Loop fitted_loop(const std::vector<Vec2>& loop, const std::vector<std::size_t>& corners,
                 const OutlineSettings& settings) {
  Loop result;
  const std::size_t n = loop.size();
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const std::size_t begin = corners[k], end = k + 1 < corners.size() ? corners[k + 1] : n;
    std::vector<Vec2> run(loop.begin() + std::ptrdiff_t(begin), loop.begin() + std::ptrdiff_t(end));
    run.push_back(loop[end % n]);
    const std::vector<std::size_t> ends = curve_ends(run, settings.curve_ends);
    result.edges.push_back(
        {std::string("e").append(std::to_string(k)), fit_polyline(run, settings.fit_tolerance_mm, ends)});
  }
  if (corners.empty()) {
    std::vector<Vec2> run = loop;
    run.push_back(loop[0]);
    const std::vector<std::size_t> ends = curve_ends(run, settings.curve_ends);
    run.pop_back();
    result.edges.push_back({"e0", fit_smooth_loop(run, settings.fit_tolerance_mm, ends)});
  }
  return result;
}

/// Adds the vertices nearest to further places. Of corners nearer than 1.5 mm the further place stays: it is
/// where the drawing itself parts the outline.
void add_corners(Points loop, Points places, std::vector<std::size_t>& corners) {
  std::vector<std::size_t> added;
  for (const Vec2 p : places) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < loop.size(); ++i)
      if (length(loop[i] - p) < length(loop[best] - p)) best = i;
    const auto near = [&](std::size_t i) { return length(loop[i] - loop[best]) < kCornerWindow; };
    if (length(loop[best] - p) > kForcedReach || std::any_of(added.begin(), added.end(), near)) continue;
    std::erase_if(corners, near);
    added.push_back(best);
  }
  corners.insert(corners.end(), added.begin(), added.end());
  std::sort(corners.begin(), corners.end());
}

/// The blunt corners that the drawing tells.
std::vector<Vec2> told_corners(Points loop, const OutlineSettings& settings) {
  std::vector<Vec2> told;
  if (settings.turn_points.empty()) return told;
  for (const std::size_t i : find_corners(loop, settings.told_angle))
    if (std::any_of(settings.turn_points.begin(), settings.turn_points.end(),
                    [&](Vec2 p) { return length(p - loop[i]) <= kForcedReach; }))
      told.push_back(loop[i]);
  return told;
}

}  // namespace

Result<Loop> loop_from_polyline(const std::vector<Vec2>& points_mm, std::span<const Vec2> forced_corners,
                                const OutlineSettings& settings) {
  auto cleaned = clean_outline(points_mm);
  if (const auto* bad = std::get_if<BadOutline>(&cleaned)) return error_of(*bad);
  std::vector<Vec2> loop = std::get<std::vector<Vec2>>(std::move(cleaned));
  const std::size_t n = loop.size();
  const bool clockwise = geometry::signed_area(loop) < 0;
  if (clockwise) std::reverse(loop.begin() + 1, loop.end());

  std::vector<std::size_t> corners;
  std::size_t first = kNothing;
  if (!forced_corners.empty()) {
    std::vector<std::size_t> forced = TRY(forced_vertices(loop, forced_corners));
    corners = forced;
    first = corners.front();
  } else {
    corners = find_corners(loop, settings.corner_angle);
    add_corners(loop, blunt_corners(loop, settings), corners);
    add_corners(loop, told_corners(loop, settings), corners);
    add_corners(loop, settings.further_corners, corners);
    if (corners.empty() && n < 4) corners = {0};
    // Vertex i of a reversed loop was vertex n - i of the file; vertex 0 stays.
    const auto in_file = [&](std::size_t i) { return clockwise ? (n - i) % n : i; };
    for (std::size_t c : corners)
      if (first == kNothing || in_file(c) < in_file(first)) first = c;
  }
  if (first != kNothing) {
    std::rotate(loop.begin(), loop.begin() + std::ptrdiff_t(first), loop.end());
    for (std::size_t& c : corners) c = (c + n - first) % n;
    std::sort(corners.begin(), corners.end());
  }
  return fitted_loop(loop, corners, settings);
}

Result<PanelEdge> edge_from_points(std::string id, const std::vector<Vec2>& points_mm,
                                   const OutlineSettings& settings) {
  if (auto error = not_finite(points_mm)) {
    error->where = "edge " + id + ", " + error->where;
    return *error;
  }
  std::vector<Vec2> points = apart(points_mm);
  while (points.size() > 1 && length(points.back() - points_mm.back()) < kJointTolerance) points.pop_back();
  if (points.empty() || (points.size() == 1 && length(points[0] - points_mm.back()) < kJointTolerance))
    return Error{"pattern.too_few_points", "An edge needs at least two points apart from each other.",
                 "edge " + id};
  points.push_back(points_mm.back());
  return PanelEdge{std::move(id), fit_polyline(points, settings.fit_tolerance_mm)};
}

namespace {

std::optional<Error> check_edges(const std::vector<PanelEdge>& edges) {
  std::set<std::string> ids;
  for (const PanelEdge& edge : edges) {
    const std::string where = "edge " + edge.id;
    if (edge.curves.empty()) return Error{"pattern.empty_edge", "The edge has no curves.", where};
    if (!ids.insert(edge.id).second)
      return Error{"pattern.duplicate_id", "Two edges of the loop are both called '" + edge.id + "'.", where};
    for (const CubicBezier& c : edge.curves)
      if (!is_finite(c.p0) || !is_finite(c.p1) || !is_finite(c.p2) || !is_finite(c.p3))
        return Error{"pattern.not_finite", "A coordinate is not a finite number.", where};
  }
  return std::nullopt;
}

/// Makes `next` start exactly where `previous` ends, when they are close enough.
std::optional<Error> snap(const CubicBezier& previous, CubicBezier& next, const std::string& edge) {
  const double gap = length(next.p0 - previous.p3);
  if (gap <= kJointTolerance) {
    const bool line = is_straight(next);
    next.p0 = previous.p3;
    if (line) next = line_segment(next.p0, next.p3);
    return std::nullopt;
  }
  return Error{"pattern.open_outline",
               "Edge " + edge + " starts at " + place_text(next.p0) + " but the curve before it ends at " +
                   place_text(previous.p3) + ": a gap of " + significant_text(gap, 4) + " mm.",
               "edge " + edge};
}

}  // namespace

Result<Loop> loop_from_edges(std::vector<PanelEdge> edges) {
  if (edges.empty()) return Error{"pattern.empty_edge", "The loop has no edges.", ""};
  if (auto error = check_edges(edges)) return *error;
  CubicBezier* previous = nullptr;
  for (PanelEdge& edge : edges) {
    for (CubicBezier& curve : edge.curves) {
      if (previous)
        if (auto error = snap(*previous, curve, edge.id)) return *error;
      previous = &curve;
    }
  }
  CubicBezier& first = edges.front().curves.front();
  if (length(first.p0 - previous->p3) > kJointTolerance) return *snap(*previous, first, edges.front().id);
  // The first curve starts the loop: the last one yields.
  CubicBezier closing = reversed(*previous);
  (void)snap(reversed(first), closing, edges.front().id);
  *previous = reversed(closing);
  Loop loop{std::move(edges)};
  const double area = signed_area(loop);
  if (!(std::abs(area) >= kLeastArea))
    return Error{"pattern.zero_area", "The outline encloses no area.", "edge " + loop.edges.front().id};
  return area < 0 ? reversed(loop) : loop;
}

}  // namespace toile::pattern
