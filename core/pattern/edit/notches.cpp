#include "core/pattern/edit/notches.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/geometry/polygon2.h"
#include "core/pattern/curve.h"
#include "core/pattern/edit/places.h"
#include "core/pattern/edit/shape.h"
#include "core/pattern/outline.h"

namespace toile::edit {
namespace {

constexpr double kDeepest = 1000;   // mm
constexpr double kSamePlace = 0.1;  // mm; notches nearer than this are one
constexpr double kSnap = 0.5;       // mm
constexpr double kAlike = 0.02;     // mm, that curves may differ when two become one

Error out_of_range(const char* what, const std::string& where) { return {"edit.out_of_range", what, where}; }

/// The distance along the edge, or that of a joint or end of it near by: a notch there is meant to be at it.
double joint_near(const pattern::PanelEdge& edge, double along) {
  double joint = 0, best = along, least = kSnap;
  for (std::size_t k = 0; k <= edge.curves.size(); ++k) {
    if (std::abs(joint - along) < least) {
      least = std::abs(joint - along);
      best = joint;
    }
    if (k < edge.curves.size()) joint += pattern::arc_length(edge.curves[k]);
  }
  return best;
}

/// The point there, which the edge has from now on.
Vec2 part_at(pattern::PanelEdge& edge, double along) {
  for (std::size_t k = 0; k < edge.curves.size(); ++k) {
    const double whole = pattern::arc_length(edge.curves[k]);
    if (along <= pattern::kJointTolerance) return edge.curves[k].p0;
    if (along < whole - pattern::kJointTolerance) {
      const auto [first, second] =
          pattern::split(edge.curves[k], pattern::parameter_at_length(edge.curves[k], along));
      edge.curves[k] = first;
      edge.curves.insert(edge.curves.begin() + std::ptrdiff_t(k) + 1, second);
      return second.p0;
    }
    along -= whole;
  }
  return edge.curves.back().p3;
}

/// A notch at a fraction of the edge's length, cut from there into the cloth. The edge gets a point there.
Result<pattern::Notch> notch_on(pattern::Panel& panel, const std::string& edge_id, double at, double depth) {
  const EdgePlace found = TRY(find_edge(panel, edge_id));
  const std::string where = edge_text(panel.id, edge_id);
  if (!(at >= 0 && at <= 1))
    return out_of_range("A place on an edge is a fraction of its length, 0 to 1.", where);
  if (!(std::abs(depth) <= kDeepest)) return out_of_range("A notch is at most 1 m deep.", where);
  pattern::PanelEdge& edge = loop_at(panel, found.loop).edges[found.edge];
  const double along = joint_near(edge, at * pattern::arc_length(edge));
  // Cloth lies on the left of every edge.
  const Vec2 inwards = perpendicular(direction_at(edge, along));
  const pattern::Notch notch{part_at(edge, along), depth, inwards};
  for (const pattern::Notch& other : panel.notches)
    if (length(other.at - notch.at) < kSamePlace) return out_of_range("There is a notch already.", where);
  return notch;
}

double distance_to_line(Vec2 p, const std::vector<Vec2>& line) {
  double nearest = length(line[0] - p);
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    nearest = std::min(nearest, geometry::distance_to_segment(p, line[i], line[i + 1]));
  return nearest;
}

/// Whether one curve passes where two did.
bool looks_alike(const pattern::CubicBezier& one, const pattern::CubicBezier& first,
                 const pattern::CubicBezier& second) {
  const std::vector<Vec2> line = pattern::flatten(one, kAlike / 4);
  for (const pattern::CubicBezier& was : {first, second})
    for (const double t : {0.25, 0.5, 0.75, 1.0})
      if (distance_to_line(pattern::evaluate(was, t), line) > kAlike) return false;
  return true;
}

/// The panel without the point at `at` within an edge, where two curves go on as one.
void forget_point(pattern::Panel& panel, Vec2 at) {
  for (const pattern::PanelEdge* edge : pattern::edges_of(panel)) {
    for (std::size_t k = 1; k < edge->curves.size(); ++k) {
      if (length(edge->curves[k].p0 - at) > pattern::kJointTolerance) continue;
      pattern::Panel without = panel;
      if (!edit_shape(without, DeletePoint{panel.id, edge->id, int(k)})) return;
      const EdgePlace place = find_edge(without, edge->id).value();
      const pattern::CubicBezier& one = loop_at(without, place.loop).edges[place.edge].curves[k - 1];
      if (!looks_alike(one, edge->curves[k - 1], edge->curves[k])) return;
      panel = std::move(without);
      return;
    }
  }
}

Error unknown_notch(const pattern::Panel& panel, int notch) {
  return {"edit.unknown_notch",
          panel.notches.empty()
              ? "The piece has no notches."
              : "The piece has no notch " + std::to_string(notch) + "; they count from 0 to " +
                    std::to_string(panel.notches.size() - 1) + ".",
          piece_text(panel.id)};
}

/// The panel without that notch; and the notch.
Result<pattern::Notch> take_notch(pattern::Panel& panel, int notch) {
  if (notch < 0 || std::size_t(notch) >= panel.notches.size()) return unknown_notch(panel, notch);
  const auto at = panel.notches.begin() + notch;
  const pattern::Notch taken = *at;
  panel.notches.erase(at);
  return taken;
}

}  // namespace

Result<EditEffect> edit_piece(pattern::Pattern& pattern, const AddNotch& edit) {
  const Index at = TRY(find_piece(pattern, edit.piece));
  pattern::Panel& panel = pattern.panels[std::size_t(at)];
  const pattern::Notch notch = TRY(notch_on(panel, edit.edge, edit.at, edit.depth_mm));
  panel.notches.push_back(notch);
  return reshaped(edit.piece);
}

Result<EditEffect> edit_piece(pattern::Pattern& pattern, const MoveNotch& edit) {
  const Index at = TRY(find_piece(pattern, edit.piece));
  pattern::Panel& panel = pattern.panels[std::size_t(at)];
  const pattern::Notch was = TRY(take_notch(panel, edit.notch));
  // The new place first: its fraction counts on the curves as they are.
  const pattern::Notch now = TRY(notch_on(panel, edit.edge, edit.at, edit.depth_mm.value_or(was.depth)));
  if (length(now.at - was.at) > pattern::kJointTolerance) forget_point(panel, was.at);
  panel.notches.insert(panel.notches.begin() + edit.notch, now);
  return reshaped(edit.piece);
}

Result<EditEffect> edit_piece(pattern::Pattern& pattern, const RemoveNotch& edit) {
  const Index at = TRY(find_piece(pattern, edit.piece));
  pattern::Panel& panel = pattern.panels[std::size_t(at)];
  const pattern::Notch notch = TRY(take_notch(panel, edit.notch));
  forget_point(panel, notch.at);
  return reshaped(edit.piece);
}

}  // namespace toile::edit
