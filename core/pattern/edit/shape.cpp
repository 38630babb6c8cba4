#include "core/pattern/edit/shape.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/pattern/curve.h"
#include "core/pattern/edit/places.h"
#include "core/pattern/outline.h"

namespace toile::edit {
namespace {

constexpr double kShortest = 0.1, kLongest = 1e5;  // mm, of an edge's length

/// The edge that an edit names, in its loop.
struct Found {
  pattern::Loop* loop;
  std::size_t at;
  pattern::PanelEdge* edge;
  std::string where;
};

Result<Found> found(pattern::Panel& panel, const std::string& edge) {
  const EdgePlace place = TRY(find_edge(panel, edge));
  pattern::Loop& loop = loop_at(panel, place.loop);
  return Found{&loop, place.edge, &loop.edges[place.edge], edge_text(panel.id, edge)};
}

Error no_point(const Found& at, int point, std::size_t least, std::size_t most) {
  return {"edit.unknown_point",
          "The edge has no point or curve " + std::to_string(point) + " to do this to; they count from " +
              std::to_string(least) + " to " + std::to_string(most) + ".",
          at.where};
}

bool counts(int index, std::size_t least, std::size_t most) {
  return index >= 0 && std::size_t(index) >= least && std::size_t(index) <= most;
}

void start_at(pattern::CubicBezier& c, Vec2 to, bool straight) {
  if (straight) {
    c = pattern::line_segment(to, c.p3);
  } else {
    c.p1 = c.p1 + (to - c.p0);
    c.p0 = to;
  }
}

void end_at(pattern::CubicBezier& c, Vec2 to, bool straight) {
  if (straight) {
    c = pattern::line_segment(c.p0, to);
  } else {
    c.p2 = c.p2 + (to - c.p3);
    c.p3 = to;
  }
}

/// The curves that meet at a joint, before and after it.
std::pair<pattern::CubicBezier*, pattern::CubicBezier*> curves_at(const Found& at, std::size_t point) {
  std::vector<pattern::PanelEdge>& edges = at.loop->edges;
  const std::size_t n = edges.size();
  std::vector<pattern::CubicBezier>& own = at.edge->curves;
  pattern::CubicBezier* before = point > 0 ? &own[point - 1] : &edges[(at.at + n - 1) % n].curves.back();
  pattern::CubicBezier* after = point < own.size() ? &own[point] : &edges[(at.at + 1) % n].curves.front();
  return {before, after};
}

void scale_about(pattern::PanelEdge& edge, Vec2 centre, double factor) {
  const auto scale = [&](Vec2& p) { p = centre + (p - centre) * factor; };
  for (pattern::CubicBezier& c : edge.curves)
    for (Vec2* p : {&c.p0, &c.p1, &c.p2, &c.p3}) scale(*p);
}

bool same_curves(const pattern::PanelEdge& a, const pattern::PanelEdge& b) {
  return std::equal(a.curves.begin(), a.curves.end(), b.curves.begin(), b.curves.end(),
                    [](const pattern::CubicBezier& x, const pattern::CubicBezier& y) {
                      return x.p0 == y.p0 && x.p1 == y.p1 && x.p2 == y.p2 && x.p3 == y.p3;
                    });
}

/// Where a notch lies on its edge: how far along, and at which joint if it is at one.
struct NotchSpot {
  EdgePlace place;
  double along = 0;  ///< mm
  int joint = -1;
  double off = 1;  ///< mm, from the edge; farther than this it belongs to none
};

Vec2 joint_of(const pattern::PanelEdge& edge, std::size_t joint) {
  return joint < edge.curves.size() ? edge.curves[joint].p0 : edge.curves.back().p3;
}

double length_to(const pattern::PanelEdge& edge, std::size_t joint) {
  double sum = 0;
  for (std::size_t k = 0; k < joint; ++k) sum += pattern::arc_length(edge.curves[k]);
  return sum;
}

void improve_spot(NotchSpot& best, const pattern::PanelEdge& edge, EdgePlace place, Vec2 at) {
  constexpr double kAtJoint = 0.05, kFlat = 0.02;  // mm
  for (std::size_t k = 0; k <= edge.curves.size(); ++k) {
    const double off = length(joint_of(edge, k) - at);
    if (off <= kAtJoint && off < best.off) best = {place, length_to(edge, k), int(k), off};
  }
  const std::vector<Vec2> line = pattern::flatten(edge, kFlat);
  double along = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec2 d = line[i + 1] - line[i];
    const double l2 = dot(d, d), t = l2 > 0 ? std::clamp(dot(at - line[i], d) / l2, 0.0, 1.0) : 0;
    const double off = length(line[i] + d * t - at);
    if (off + kAtJoint < best.off) best = {place, along + t * std::sqrt(l2), -1, off};
    along += std::sqrt(l2);
  }
}

NotchSpot spot_of(const pattern::Panel& panel, Vec2 at) {
  NotchSpot best;
  for (const pattern::PanelEdge* edge : pattern::edges_of(panel)) {
    const Result<EdgePlace> place = find_edge(panel, edge->id);
    if (place) improve_spot(best, *edge, *place, at);
  }
  return best;
}

/// `v` turned as `from` is turned into `to`, unit vectors.
Vec2 turned_like(Vec2 v, Vec2 from, Vec2 to) {
  const double c = dot(from, to), s = cross(from, to);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

void carry_notch(pattern::Notch& notch, const NotchSpot& spot, const pattern::PanelEdge& was,
                 const pattern::PanelEdge& now) {
  const bool joint = spot.joint >= 0 && was.curves.size() == now.curves.size();
  const double long_was = pattern::arc_length(was);
  const double along = joint          ? length_to(now, std::size_t(spot.joint))
                       : long_was > 0 ? pattern::arc_length(now) * spot.along / long_was
                                      : 0;
  notch.at = joint ? joint_of(now, std::size_t(spot.joint)) : pattern::point_at_length(now, along);
  const Vec2 from = direction_at(was, spot.along), to = direction_at(now, along);
  if (from == Vec2{} || to == Vec2{}) return;
  notch.inwards = normalized(turned_like(notch.inwards, from, to));
}

}  // namespace

Result<CurvePlace> place_on_edge(const pattern::PanelEdge& edge, double at, const std::string& where) {
  const auto out_of_range = [&](const char* what) { return Error{"edit.out_of_range", what, where}; };
  if (!(at > 0 && at < 1)) return out_of_range("A place on an edge is a fraction of its length, 0 to 1.");
  const double whole = pattern::arc_length(edge);
  double s = at * whole;
  if (!(s > pattern::kJointTolerance && whole - s > pattern::kJointTolerance)) {
    return out_of_range("This place is less than 0.01 mm from the edge's end.");
  }
  for (std::size_t k = 0; k < edge.curves.size(); ++k) {
    const double l = pattern::arc_length(edge.curves[k]);
    if (std::abs(s - l) <= pattern::kJointTolerance && k + 1 < edge.curves.size())
      return CurvePlace{k + 1, 0};
    if (s < l) return CurvePlace{k, pattern::parameter_at_length(edge.curves[k], s)};
    s -= l;
  }
  return out_of_range("This place is the edge's end.");
}

Vec2 direction_at(const pattern::PanelEdge& edge, double along) {
  constexpr double kStep = 0.5;  // mm
  return normalized(pattern::point_at_length(edge, along + kStep) -
                    pattern::point_at_length(edge, std::max(along - kStep, 0.0)));
}

void carry_notches(const pattern::Panel& was, pattern::Panel& panel) {
  const std::vector<const pattern::PanelEdge*> before = pattern::edges_of(was),
                                               now = pattern::edges_of(panel);
  for (std::size_t i = 0; i < was.notches.size(); ++i) {
    const NotchSpot spot = spot_of(was, was.notches[i].at);
    if (spot.off >= NotchSpot{}.off) continue;
    const auto edge = std::size_t(spot.place.index);
    if (edge >= now.size() || same_curves(*before[edge], *now[edge])) continue;
    carry_notch(panel.notches[i], spot, *before[edge], *now[edge]);
  }
}

Status edit_shape(pattern::Panel& panel, const MovePoint& edit) {
  const Found at = TRY(found(panel, edit.edge));
  if (!counts(edit.point, 0, at.edge->curves.size())) {
    return no_point(at, edit.point, 0, at.edge->curves.size());
  }
  const auto [before, after] = curves_at(at, std::size_t(edit.point));
  const bool line_before = pattern::is_straight(*before), line_after = pattern::is_straight(*after);
  end_at(*before, edit.to, line_before);
  start_at(*after, edit.to, line_after);
  return {};
}

Status edit_shape(pattern::Panel& panel, const MoveHandle& edit) {
  const Found at = TRY(found(panel, edit.edge));
  if (!counts(edit.curve, 0, at.edge->curves.size() - 1)) {
    return no_point(at, edit.curve, 0, at.edge->curves.size() - 1);
  }
  if (edit.handle != 1 && edit.handle != 2) {
    return Error{"edit.unknown_point", "A curve has handles 1 and 2.", at.where};
  }
  pattern::CubicBezier& curve = at.edge->curves[std::size_t(edit.curve)];
  (edit.handle == 1 ? curve.p1 : curve.p2) = edit.to;
  return {};
}

Status edit_shape(pattern::Panel& panel, const InsertPoint& edit) {
  const Found at = TRY(found(panel, edit.edge));
  const CurvePlace place = TRY(place_on_edge(*at.edge, edit.at, at.where));
  if (place.t == 0) return Error{"edit.out_of_range", "There is a point already.", at.where};
  std::vector<pattern::CubicBezier>& curves = at.edge->curves;
  const auto [first, second] = pattern::split(curves[place.curve], place.t);
  curves[place.curve] = first;
  curves.insert(curves.begin() + std::ptrdiff_t(place.curve) + 1, second);
  return {};
}

Status edit_shape(pattern::Panel& panel, const DeletePoint& edit) {
  const Found at = TRY(found(panel, edit.edge));
  std::vector<pattern::CubicBezier>& curves = at.edge->curves;
  if (curves.size() < 2) {
    return Error{"edit.unknown_point", "The edge is one curve; to remove a corner, join its edges first.",
                 at.where};
  }
  if (!counts(edit.point, 1, curves.size() - 1)) return no_point(at, edit.point, 1, curves.size() - 1);
  const auto second = curves.begin() + edit.point;
  pattern::CubicBezier& first = *(second - 1);
  const double a = length(first.p3 - first.p2), b = length(second->p1 - second->p0);
  // Where a curve is parted at t, the handles beside the joint are t to 1 - t; t tells how long they were.
  const double t = a + b > 0 ? std::clamp(a / (a + b), 0.05, 0.95) : 0.5;
  const Vec2 p1 = first.p0 + (first.p1 - first.p0) * (1 / t);
  const Vec2 p2 = second->p3 + (second->p2 - second->p3) * (1 / (1 - t));
  first = {first.p0, p1, p2, second->p3};
  curves.erase(second);
  return {};
}

Status edit_shape(pattern::Panel& panel, const StraightenEdge& edit) {
  const Found at = TRY(found(panel, edit.edge));
  std::vector<pattern::CubicBezier>& curves = at.edge->curves;
  if (edit.curve == -1) {
    curves = {pattern::line_segment(curves.front().p0, curves.back().p3)};
    return {};
  }
  if (!counts(edit.curve, 0, curves.size() - 1)) return no_point(at, edit.curve, 0, curves.size() - 1);
  pattern::CubicBezier& curve = curves[std::size_t(edit.curve)];
  curve = pattern::line_segment(curve.p0, curve.p3);
  return {};
}

Status edit_shape(pattern::Panel& panel, const BendEdge& edit) {
  const Found at = TRY(found(panel, edit.edge));
  std::vector<pattern::CubicBezier>& curves = at.edge->curves;
  if (!counts(edit.curve, 0, curves.size() - 1)) return no_point(at, edit.curve, 0, curves.size() - 1);
  curves[std::size_t(edit.curve)].p1 = edit.handle1;
  curves[std::size_t(edit.curve)].p2 = edit.handle2;
  return {};
}

Status edit_shape(pattern::Panel& panel, const SetEdgeLength& edit) {
  const Found at = TRY(found(panel, edit.edge));
  const double now = pattern::arc_length(*at.edge);
  if (!(edit.length_mm >= kShortest && edit.length_mm <= kLongest) || !(now > 0)) {
    return Error{"edit.out_of_range", "An edge is 0.1 mm to 100 m long.", at.where};
  }
  if (edit.keep != "start" && edit.keep != "end" && edit.keep != "middle") {
    return Error{"edit.out_of_range", "What stays is the edge's start, its end or the middle.", at.where};
  }
  const Vec2 start = at.edge->curves.front().p0, end = at.edge->curves.back().p3;
  const auto [before, own_start] = curves_at(at, 0);
  const auto [own_end, after] = curves_at(at, at.edge->curves.size());
  const bool alone = at.loop->edges.size() == 1;
  const bool line_before = pattern::is_straight(*before), line_after = pattern::is_straight(*after);
  const Vec2 centre = edit.keep == "start" ? start : edit.keep == "end" ? end : (start + end) * 0.5;
  scale_about(*at.edge, centre, edit.length_mm / now);
  // Rounding must not open a joint that stays.
  if (edit.keep == "start") own_start->p0 = start;
  if (edit.keep == "end") own_end->p3 = end;
  if (alone) {
    own_end->p3 = own_start->p0;
    return {};
  }
  end_at(*before, own_start->p0, line_before);
  start_at(*after, own_end->p3, line_after);
  return {};
}

EditEffect reshaped(const std::string& piece) {
  EditEffect effect;
  effect.piece = effect.was = piece;
  effect.reshaped = true;
  return effect;
}

}  // namespace toile::edit
