// The panel of a piece: which corners part its edges, and where its curves end.

#include <algorithm>
#include <optional>
#include <utility>

#include "core/geometry/polygon2.h"
#include "core/pattern/curve.h"
#include "core/pattern/dxf/read.h"
#include "core/pattern/validate.h"

namespace toile::dxf {
namespace {

constexpr double kNotchReach = 60;  // mm between a notch on the cut line and the sew line: a hem's allowance
constexpr double kTurnReach = 0.5;  // mm

std::vector<pattern::Notch> notches_on_outline(const DxfPiece& piece) {
  std::vector<pattern::Notch> notches;
  for (const pattern::Notch& notch : piece.notches) {
    const Vec2 foot = geometry::nearest_on(piece.outline, notch.at);
    if (length(foot - notch.at) > (piece.on_sew_line ? kNotchReach : kNotchReach / 4)) continue;
    notches.push_back({foot, notch.depth, notch.inwards});
  }
  return notches;
}

/// The line without points that repeat the one before; empty when nothing is left of it.
std::vector<Vec2> without_repeats(const std::vector<Vec2>& line) {
  std::vector<Vec2> points;
  for (const Vec2 p : line)
    if (points.empty() || length(p - points.back()) >= pattern::kJointTolerance) points.push_back(p);
  return points.size() < 2 ? std::vector<Vec2>{} : points;
}

/// What is drawn within the piece: pockets, buttonholes, fold lines, as i0, i1, …
std::vector<pattern::InnerLine> drawn_lines(const DxfPiece& piece) {
  std::vector<pattern::InnerLine> lines;
  for (const std::vector<Vec2>& internal : piece.internals) {
    std::vector<Vec2> points = without_repeats(internal);
    if (points.empty()) continue;
    lines.push_back({std::string("i").append(std::to_string(lines.size())), std::move(points), true});
  }
  return lines;
}

/// The panel with curves that pass the drawing's vertices as closely as the settings ask.
Result<pattern::Panel> fitted_panel(const DxfPiece& piece, std::span<const Vec2> forced_corners,
                                    const pattern::OutlineSettings& settings) {
  const auto place = [&](Error error) {
    error.where = "piece " + piece.name + (error.where.empty() ? "" : ", " + error.where);
    return error;
  };
  pattern::Panel panel;
  panel.id = piece.name;
  panel.notches = notches_on_outline(piece);
  pattern::OutlineSettings own = settings;
  for (const pattern::Notch& notch : panel.notches) own.curve_ends.push_back(notch.at);
  for (const Vec2 turn : piece.turn_points)
    if (const Vec2 foot = geometry::nearest_on(piece.outline, turn); length(foot - turn) <= kTurnReach) {
      own.curve_ends.push_back(foot);
      own.turn_points.push_back(foot);
    }
  if (piece.breaks_are_edges) own.further_corners = piece.breaks;
  Result<pattern::Loop> outline = pattern::loop_from_polyline(piece.outline, forced_corners, own);
  if (!outline) return place(outline.error());
  panel.outline = std::move(*outline);
  panel.grain = piece.grain.value_or(Vec2{0, 1});
  for (std::size_t h = 0; h < piece.holes.size(); ++h) {
    Result<pattern::Loop> hole = pattern::loop_from_polyline(piece.holes[h], {}, settings);
    if (!hole) return place(hole.error());
    panel.holes.push_back(pattern::reversed(*hole));
    for (pattern::PanelEdge& edge : panel.holes.back().edges)
      edge.id = std::string("h").append(std::to_string(h)).append(edge.id);
  }
  panel.lines = drawn_lines(piece);
  return panel;
}

/// The edge straight from vertex to vertex of the outline; nothing when its ends are none.
std::optional<pattern::PanelEdge> straightened(const pattern::PanelEdge& edge,
                                               const std::vector<Vec2>& outline) {
  const std::size_t n = outline.size();
  const auto number_of = [&](Vec2 p) {
    return std::size_t(std::find(outline.begin(), outline.end(), p) - outline.begin());
  };
  const std::size_t first = number_of(edge.curves.front().p0), last = number_of(edge.curves.back().p3);
  if (first == n || last == n || first == last) return std::nullopt;
  const std::size_t step = geometry::signed_area(outline) < 0 ? n - 1 : 1;
  pattern::PanelEdge chords{edge.id, {}};
  for (std::size_t i = first; i != last; i = (i + step) % n)
    chords.curves.push_back(pattern::line_segment(outline[i], outline[(i + step) % n]));
  return chords;
}

/// The panel with as few edges drawn straight from vertex to vertex as keep its lines apart: one, else all
/// that can be.
pattern::Panel without_crossings(const pattern::Panel& panel, const std::vector<Vec2>& outline) {
  pattern::Panel all = panel;
  for (std::size_t i = 0; i < panel.outline.edges.size(); ++i) {
    const std::optional<pattern::PanelEdge> chords = straightened(panel.outline.edges[i], outline);
    if (!chords) continue;
    pattern::Panel one = panel;
    one.outline.edges[i] = *chords;
    if (!pattern::has_crossing_lines(one)) return one;
    all.outline.edges[i] = *chords;
  }
  return all;
}

}  // namespace

Result<pattern::Panel> panel_from_piece(const DxfPiece& piece, std::span<const Vec2> forced_corners,
                                        const pattern::OutlineSettings& settings) {
  constexpr double kCloser = 0.25;  // times the tolerance before
  constexpr int kMostTries = 3;
  pattern::Panel panel = TRY(fitted_panel(piece, forced_corners, settings));
  // Lines that part at an angle of a degree or two, or run side by side within the tolerance, do not cross in
  // the drawing; their curves may.
  pattern::OutlineSettings closer = settings;
  for (int i = 0; i < kMostTries && pattern::has_crossing_lines(panel); ++i) {
    closer.fit_tolerance_mm *= kCloser;
    panel = TRY(fitted_panel(piece, forced_corners, closer));
  }
  return pattern::has_crossing_lines(panel) ? without_crossings(panel, piece.outline) : panel;
}

}  // namespace toile::dxf
