#pragma once
// Loops of named edges, from polylines or from edges given one by one.

#include <cstddef>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/base/result.h"
#include "core/base/types.h"
#include "core/base/units.h"
#include "core/pattern/pattern.h"

namespace toile::pattern {

struct OutlineSettings {
  /// Radians. Where an outline turns by more, an edge ends. The turn is measured between the directions over
  /// 1.5 mm (or the next vertex) on both sides, so that a curve sampled finely, or rounded by less than about
  /// 2 mm, is judged by its shape and not by its samples. 35° passes over curves sampled every 5 mm down to a
  /// radius of 8 mm, and finds the corners of panels, which are seldom blunter than 60°.
  double corner_angle = radians_from_degrees(35);
  /// Radians. Blunter corners, as of a flared cuff or of a sleeve's cap and its underarm, end an edge from
  /// this turn on, if a straight line of the drawing ends there and no vertex beside it turns nearly as much:
  /// then it is no sample of a curve. Between two curves it takes 5/3 of that, and where a line meets a curve
  /// half of it beyond what the curve itself turns there.
  double blunt_corner_angle = radians_from_degrees(9);
  /// mm, the farthest a fitted curve may pass from a vertex of the polyline.
  double fit_tolerance_mm = 0.1;
  /// Places on the outline where edges end too, beside the corners: at the nearest vertex within 0.5 mm. Of
  /// no effect where corners are forced.
  std::vector<Vec2> further_corners = {};
  /// Places on the outline where a curve ends, smoothly: notches, turn points.
  std::vector<Vec2> curve_ends = {};
  /// Places that the drawing tells as turn points. Programs set them at smooth joints, too, so that an edge
  /// ends there only where the outline turns by more than `told_angle` (radians).
  std::vector<Vec2> turn_points = {};
  double told_angle = radians_from_degrees(15);
};

/// Joints of explicit edges that are this close are snapped; vertices this close are one.
inline constexpr double kJointTolerance = 0.01;  // mm

/// An outline around less is a fault of the drawing, not cloth.
inline constexpr double kLeastArea = 1e-2;  // mm²

/// Why a closed polyline is no outline. Whoever read it gives it a code of his own.
enum class OutlineFault { kNotFinite, kTooFewPoints, kZeroArea, kSelfCrossing };

struct BadOutline {
  OutlineFault fault = OutlineFault::kTooFewPoints;
  std::string message;
  std::string where;  ///< with coordinates, mm
};

/// The closed polyline without repeated vertices and segments under 0.01 mm, first vertex kept.
std::variant<std::vector<Vec2>, BadOutline> clean_outline(const std::vector<Vec2>& points_mm);

/// The closed polyline `points_mm` as a loop of fitted edges e0, e1, …: counter-clockwise, whatever the order
/// of the points was. Repeated vertices, a repeated first vertex and segments under 0.01 mm are dropped
/// first. With `forced_corners` edges end at exactly those places (each at the nearest vertex, which must be
/// within 0.5 mm; a corner named twice counts once), otherwise where the outline turns sharply. e0 starts at
/// the first forced corner, or at the first corner in the order of the points. A line without corners becomes
/// one edge that starts and ends at the first point. Errors: pattern.not_finite, pattern.too_few_points,
/// pattern.zero_area, pattern.self_crossing, pattern.corner_off_outline; `where` holds coordinates in mm.
Result<Loop> loop_from_polyline(const std::vector<Vec2>& points_mm, std::span<const Vec2> forced_corners,
                                const OutlineSettings& settings = {});

/// An edge fitted to an open polyline, mm. Points under 0.01 mm apart count as one; both ends are kept
/// exactly. Errors: pattern.not_finite, pattern.too_few_points.
Result<PanelEdge> edge_from_points(std::string id, const std::vector<Vec2>& points_mm,
                                   const OutlineSettings& settings = {});

/// A loop of edges given one by one, in order, each starting where the one before ends. Joints up to 0.01 mm
/// wide are closed. Counter-clockwise: a clockwise series is run the other way, edge 0 stays first.
/// Errors: pattern.empty_edge, pattern.duplicate_id, pattern.not_finite, pattern.open_outline (with the edge
/// and both coordinates), pattern.zero_area.
Result<Loop> loop_from_edges(std::vector<PanelEdge> edges);

/// "(12.5, -3) mm", as messages name a place.
std::string place_text(Vec2 p);

}  // namespace toile::pattern
