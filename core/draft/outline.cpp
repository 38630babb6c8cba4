#include "core/draft/outline.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/base/aabb.h"
#include "core/base/check.h"
#include "core/pattern/curve.h"

namespace toile::draft {
namespace {

constexpr double kPiecesApart = 40;  // mm between pieces of a layout
constexpr double kNotchDepth = 5;    // mm
constexpr double kTolerance = 0.1;   // mm, of the boxes by which pieces are laid out

Vec2 flip(Vec2 p) { return {-p.x, p.y}; }

pattern::CubicBezier turned_over(const pattern::CubicBezier& c) {
  return {flip(c.p3), flip(c.p2), flip(c.p1), flip(c.p0)};
}

std::vector<pattern::CubicBezier> turned_over(const std::vector<pattern::CubicBezier>& curves) {
  std::vector<pattern::CubicBezier> out;
  for (auto c = curves.rbegin(); c != curves.rend(); ++c) out.push_back(turned_over(*c));
  return out;
}

/// Two straight halves that meet in line are one straight line.
std::vector<pattern::CubicBezier> joined(std::vector<pattern::CubicBezier> first,
                                         const std::vector<pattern::CubicBezier>& second) {
  const bool straight = first.size() == 1 && second.size() == 1 && pattern::is_straight(first[0]) &&
                        pattern::is_straight(second[0]) && first[0].p0.y == second[0].p3.y;
  if (straight) return {pattern::line_segment(first[0].p0, second[0].p3)};
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// Moves every point of the panel.
void move_points(pattern::Panel& panel, const std::function<Vec2(Vec2)>& moved) {
  for (pattern::PanelEdge& edge : panel.outline.edges)
    for (pattern::CubicBezier& c : edge.curves) c = {moved(c.p0), moved(c.p1), moved(c.p2), moved(c.p3)};
  for (pattern::Loop& hole : panel.holes)
    for (pattern::PanelEdge& edge : hole.edges)
      for (pattern::CubicBezier& c : edge.curves) c = {moved(c.p0), moved(c.p1), moved(c.p2), moved(c.p3)};
  for (pattern::InnerLine& line : panel.lines)
    for (Vec2& p : line.points) p = moved(p);
  for (pattern::Notch& n : panel.notches) {
    n.inwards = moved(n.inwards) - moved({});
    n.at = moved(n.at);
  }
}

/// Notches at these places, cut square to the edge that they lie on.
void add_notches(pattern::Panel& panel, const std::vector<Vec2>& marks) {
  for (const Vec2 at : marks) {
    Vec2 inwards;
    double nearest = HUGE_VAL;
    for (const pattern::PanelEdge& edge : panel.outline.edges) {
      const std::vector<Vec2> points = pattern::flatten(edge, kTolerance);
      for (size_t i = 1; i < points.size(); ++i) {
        const double off =
            length(points[i] - at) + length(points[i - 1] - at) - length(points[i] - points[i - 1]);
        if (off >= nearest) continue;
        nearest = off;
        inwards = perpendicular(normalized(points[i] - points[i - 1]));
      }
    }
    panel.notches.push_back({at, kNotchDepth, inwards});
  }
}

}  // namespace

Outline& Outline::add(const pattern::CubicBezier& curve) {
  edges_.back().curves.push_back(curve);
  at_ = curve.p3;
  return *this;
}

Outline& Outline::line(Vec2 to) { return add(pattern::line_segment(at_, to)); }

Outline& Outline::curve(Vec2 handle, Vec2 other_handle, Vec2 to) {
  return add({at_, handle, other_handle, to});
}

Outline& Outline::line(const std::string& edge, Vec2 to) {
  edges_.push_back({edge, {}});
  return line(to);
}

Outline& Outline::curve(const std::string& edge, Vec2 handle, Vec2 other_handle, Vec2 to) {
  edges_.push_back({edge, {}});
  return curve(handle, other_handle, to);
}

Outline& Outline::notch(double along) {
  const pattern::PanelEdge& edge = edges_.back();
  marks_.push_back(pattern::point_at_length(edge, along >= 0 ? along : pattern::arc_length(edge) + along));
  return *this;
}

pattern::Panel piece(const std::string& id, const Outline& outline) {
  pattern::Panel panel;
  panel.id = id;
  panel.outline.edges = outline.edges();
  TOILE_CHECK(length(outline.at() - outline.edges().front().curves.front().p0) < 1e-6);
  panel.outline.edges.back().curves.back().p3 = panel.outline.edges.front().curves.front().p0;
  add_notches(panel, outline.marks());
  return panel;
}

pattern::Panel rectangle(const std::string& id, double width, double height) {
  Outline out({-width / 2, 0});
  out.line("bottom", {width / 2, 0}).line("right", {width / 2, height});
  out.line("top", {-width / 2, height}).line("left", {-width / 2, 0});
  return piece(id, out);
}

pattern::Panel unfolded(const std::string& id, const Outline& half, const std::string& plus,
                        const std::string& minus) {
  const std::vector<pattern::PanelEdge>& edges = half.edges();
  pattern::Panel panel;
  panel.id = id;
  std::vector<pattern::PanelEdge>& out = panel.outline.edges;
  out.push_back({edges.front().id, joined(turned_over(edges.front().curves), edges.front().curves)});
  for (size_t i = 1; i + 1 < edges.size(); ++i) out.push_back({edges[i].id + "_" + plus, edges[i].curves});
  out.push_back({edges.back().id, joined(edges.back().curves, turned_over(edges.back().curves))});
  for (size_t i = edges.size() - 2; i > 0; --i)
    out.push_back({edges[i].id + "_" + minus, turned_over(edges[i].curves)});
  std::vector<Vec2> marks = half.marks();
  for (const Vec2 at : half.marks())
    if (at.x > kTolerance) marks.push_back(flip(at));
  add_notches(panel, marks);
  return panel;
}

pattern::Panel mirrored(const pattern::Panel& panel, const std::string& id) {
  pattern::Panel out = panel;
  out.id = id;
  move_points(out, flip);
  std::reverse(out.outline.edges.begin(), out.outline.edges.end());
  for (pattern::PanelEdge& edge : out.outline.edges) edge = pattern::reversed(edge);
  for (pattern::Loop& hole : out.holes) hole = pattern::reversed(hole);
  out.grain.x = -out.grain.x;
  return out;
}

pattern::Panel turned(pattern::Panel panel, double angle) {
  const double s = std::sin(angle), c = std::cos(angle);
  const auto turn = [&](Vec2 p) { return Vec2{c * p.x - s * p.y, s * p.x + c * p.y}; };
  move_points(panel, turn);
  panel.grain = turn(panel.grain);
  return panel;
}

void lay_out(std::vector<pattern::Panel>& panels) {
  double x = 0;
  for (pattern::Panel& panel : panels) {
    const Aabb2 box = bounding_box(pattern::flatten(panel.outline, kTolerance));
    const Vec2 by{x - box.low.x, -box.low.y};
    move_points(panel, [&](Vec2 p) { return p + by; });
    x += box.size().x + kPiecesApart;
  }
}

const pattern::PanelEdge& edge_of(const pattern::Panel& panel, const std::string& edge) {
  const std::vector<pattern::PanelEdge>& edges = panel.outline.edges;
  const auto found =
      std::find_if(edges.begin(), edges.end(), [&](const pattern::PanelEdge& e) { return e.id == edge; });
  TOILE_CHECK(found != edges.end());
  return *found;
}

}  // namespace toile::draft
