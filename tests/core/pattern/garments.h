#pragma once
// Garments drawn by code, with their true seams: none of them is like a file that anybody keeps.

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "core/pattern/curve.h"
#include "core/pattern/pattern.h"

namespace toile::garments {

/// A corner of a piece; with `control` the edge that starts here is a quadratic curve, with `second` a cubic.
struct Node {
  double x, y;
  std::optional<Vec2> control = {}, second = {};
};

inline pattern::Panel piece(const std::string& id, const std::vector<Node>& nodes) {
  pattern::Panel panel;
  panel.id = id;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Node &n = nodes[i], &m = nodes[(i + 1) % nodes.size()];
    const Vec2 a{n.x, n.y}, b{m.x, m.y};
    pattern::CubicBezier c = pattern::line_segment(a, b);
    if (n.control) {
      c.p1 = a + (*n.control - a) * (2.0 / 3);
      c.p2 = b + (*n.control - b) * (2.0 / 3);
    }
    if (n.second) {
      c.p1 = *n.control;
      c.p2 = *n.second;
    }
    panel.outline.edges.push_back({"e" + std::to_string(i), {c}});
  }
  return panel;
}

inline double length_of(const pattern::Panel& p, int edge) {
  return pattern::arc_length(p.outline.edges[edge]);
}

/// Edge k keeps its name; the outline runs on counter-clockwise.
inline pattern::Panel mirrored(const pattern::Panel& panel, const std::string& id) {
  pattern::Panel other = panel;
  other.id = id;
  for (pattern::PanelEdge& edge : other.outline.edges)
    for (pattern::CubicBezier& c : edge.curves)
      for (Vec2* p : {&c.p0, &c.p1, &c.p2, &c.p3}) p->x = -p->x;
  for (pattern::Notch& notch : other.notches) notch.at.x = -notch.at.x;
  other.outline = pattern::reversed(other.outline);
  return other;
}

inline pattern::Panel turned(pattern::Panel panel, double radians) {
  const Vec2 u{std::cos(radians), std::sin(radians)};
  const auto turn = [&](Vec2 p) { return u * p.x + perpendicular(u) * p.y; };
  for (pattern::PanelEdge& edge : panel.outline.edges)
    for (pattern::CubicBezier& c : edge.curves) c = {turn(c.p0), turn(c.p1), turn(c.p2), turn(c.p3)};
  panel.grain = turn(panel.grain);
  return panel;
}

/// A side of a true seam: piece and edges by name.
struct Side {
  std::string piece;
  std::vector<std::string> edges;
};

struct Garment {
  std::string name;
  std::vector<pattern::Panel> panels;
  using Seams = std::vector<std::pair<std::vector<Side>, std::vector<Side>>>;
  Seams seams;
  Seams as_good = {};  ///< instead of others, where nothing but a name tells left from right
};

inline pattern::Panel skirt_half(const std::string& id, double dart) {
  return piece(id, {{0, 0},
                    {500, 0},
                    {440, 560},
                    {350, 568},
                    {350 - dart / 2, 460},
                    {350 - dart, 568},
                    {150 + dart, 568},
                    {150 + dart / 2, 460},
                    {150, 568},
                    {60, 560}});
}

/// Front and back with two darts each, and a band in one piece.
inline Garment dart_skirt() {
  const pattern::Panel front = skirt_half("front", 20), back = skirt_half("back", 30);
  double waist = 0;
  for (const pattern::Panel* p : {&front, &back})
    for (const int e : {2, 5, 8}) waist += length_of(*p, e);
  const pattern::Panel band = piece("band", {{0, 0}, {waist, 0}, {waist, 40}, {0, 40}});
  Garment g{"skirt with darts", {front, back, band}, {}};
  for (const char* id : {"front", "back"}) {
    g.seams.push_back({{{id, {"e3"}}}, {{id, {"e4"}}}});
    g.seams.push_back({{{id, {"e6"}}}, {{id, {"e7"}}}});
  }
  g.seams.push_back({{{"front", {"e1"}}}, {{"back", {"e9"}}}});
  g.seams.push_back({{{"front", {"e9"}}}, {{"back", {"e1"}}}});
  g.seams.push_back({{{"band", {"e1"}}}, {{"band", {"e3"}}}});
  g.seams.push_back({{{"front", {"e2", "e5", "e8"}}, {"back", {"e2", "e5", "e8"}}}, {{"band", {"e0"}}}});
  // A rectangle has no lower edge.
  g.as_good.push_back({{{"front", {"e2", "e5", "e8"}}, {"back", {"e2", "e5", "e8"}}}, {{"band", {"e2"}}}});
  return g;
}

/// Edges: hem, inseam, crotch, waist, outseam.
inline Garment trousers() {
  const pattern::Panel front =
      piece("front_l", {{0, 0}, {220, 0}, {250, 720, Vec2{195, 745}}, {185, 980}, {20, 990, Vec2{-35, 700}}});
  const pattern::Panel back =
      piece("back_l", {{0, 0}, {260, 0}, {290, 720, Vec2{205, 745}}, {190, 1020}, {20, 990, Vec2{-35, 700}}});
  // The back lies beside the front: its outseam is the front's, seen from the other side.
  pattern::Panel back_l = mirrored(back, "back_l");
  Garment g{"trousers", {front, back_l, mirrored(front, "front_r"), back}, {}};
  g.panels[3].id = "back_r";
  for (const std::string side : {"_l", "_r"}) {
    g.seams.push_back({{{"front" + side, {"e1"}}}, {{"back" + side, {"e1"}}}});
    g.seams.push_back({{{"front" + side, {"e4"}}}, {{"back" + side, {"e4"}}}});
  }
  g.seams.push_back({{{"front_l", {"e2"}}}, {{"front_r", {"e2"}}}});
  g.seams.push_back({{{"back_l", {"e2"}}}, {{"back_r", {"e2"}}}});
  return g;
}

/// Edges: hem, side, armhole, shoulder, neck, shoulder, armhole, side.
inline pattern::Panel bodice(const std::string& id, double neck, double armhole, double hem = 0) {
  return piece(id, {{0, hem},
                    {520, hem},
                    {520, 400, Vec2{520 - armhole, 410}},
                    {450, 600},
                    {345, 640, Vec2{260, neck}},
                    {175, 640},
                    {70, 600, Vec2{armhole, 410}},
                    {0, 400}});
}

/// A sleeve in one piece whose cap is as long as the armholes and 3 % more. Edges: hem, underarm, cap,
/// underarm.
inline pattern::Panel sleeve(const std::string& id, double cap) {
  const auto with_height = [&](double h) {
    return piece(id, {{40, 0}, {360, 0}, {400, 450}, {0, 450}}).outline.edges.size() == 4
               ? piece(id, {{40, 0}, {360, 0}, {400, 450, Vec2{280, 450 + h}, Vec2{120, 450 + h}}, {0, 450}})
               : pattern::Panel{};
  };
  double low = 0, high = 400;
  for (int k = 0; k < 60; ++k) {
    const double mid = (low + high) / 2;
    (length_of(with_height(mid), 2) < cap ? low : high) = mid;
  }
  return with_height(low);
}

inline Garment shirt() {
  const pattern::Panel front = bodice("front", 500, 85), back = bodice("back", 610, 70);
  const pattern::Panel right = sleeve("sleeve_r", 1.03 * (length_of(front, 2) + length_of(back, 2)));
  Garment g{"shirt", {front, back, right, mirrored(right, "sleeve_l")}, {}};
  g.seams = {{{{"front", {"e1"}}}, {{"back", {"e7"}}}},
             {{{"front", {"e7"}}}, {{"back", {"e1"}}}},
             {{{"front", {"e3"}}}, {{"back", {"e5"}}}},
             {{{"front", {"e5"}}}, {{"back", {"e3"}}}},
             {{{"sleeve_r", {"e1"}}}, {{"sleeve_r", {"e3"}}}},
             {{{"sleeve_l", {"e1"}}}, {{"sleeve_l", {"e3"}}}},
             {{{"sleeve_r", {"e2"}}}, {{"front", {"e6"}}, {"back", {"e2"}}}},
             {{{"sleeve_l", {"e2"}}}, {{"front", {"e2"}}, {"back", {"e6"}}}}};
  g.as_good = {{{{"sleeve_l", {"e2"}}}, {{"front", {"e6"}}, {"back", {"e2"}}}},
               {{{"sleeve_r", {"e2"}}}, {{"front", {"e2"}}, {"back", {"e6"}}}}};
  return g;
}

/// A sleeveless top with a hood of two halves (edges: front of the neck, face, top and back, back of the
/// neck).
inline Garment hooded_top() {
  const pattern::Panel front = bodice("front", 500, 85), back = bodice("back", 610, 70);
  const auto half = [&](const pattern::Panel& p) {
    const auto parts = pattern::split(p.outline.edges[4].curves[0], 0.5);
    return std::pair(parts.first, parts.second);
  };
  Garment g{"hooded top", {front, back}, {}};
  for (pattern::Panel& p : g.panels) {  // the necks' middles are corners
    const auto [first, second] = half(p);
    p.outline.edges[4].curves = {first};
    p.outline.edges.insert(p.outline.edges.begin() + 5, pattern::PanelEdge{"e4b", {second}});
  }
  const double f = length_of(g.panels[0], 4), b = length_of(g.panels[1], 4);
  const pattern::Panel hood =
      piece("hood_r", {{0, 0}, {b, -20}, {b + f, -10}, {b + f + 20, 330}, {b + f - 60, 335, Vec2{-60, 350}}});
  pattern::Panel fitted = hood;
  fitted =
      piece("hood_r", {{0, 0}, {b, 0}, {b + f, 0}, {b + f + 15, 330}, {b + f - 90, 340, Vec2{-70, 345}}});
  g.panels.push_back(fitted);
  g.panels.push_back(mirrored(fitted, "hood_l"));
  g.seams = {{{{"front", {"e1"}}}, {{"back", {"e7"}}}},    {{{"front", {"e7"}}}, {{"back", {"e1"}}}},
             {{{"front", {"e3"}}}, {{"back", {"e5"}}}},    {{{"front", {"e5"}}}, {{"back", {"e3"}}}},
             {{{"hood_r", {"e3"}}}, {{"hood_l", {"e3"}}}}, {{{"hood_r", {"e4"}}}, {{"hood_l", {"e4"}}}},
             {{{"hood_r", {"e1"}}}, {{"front", {"e4b"}}}}, {{{"hood_l", {"e1"}}}, {{"front", {"e4"}}}},
             {{{"hood_r", {"e0"}}}, {{"back", {"e4"}}}},   {{{"hood_l", {"e0"}}}, {{"back", {"e4b"}}}}};
  return g;
}

/// A sleeveless bodice and a gathered skirt.
inline Garment dress() {
  const auto waisted = [](pattern::Panel p, double out) {
    for (pattern::PanelEdge& edge : p.outline.edges)
      for (pattern::CubicBezier& c : edge.curves)
        for (Vec2* q : {&c.p0, &c.p1, &c.p2, &c.p3})
          if (q->y < 70) q->x += q->x < 260 ? -out : out;
    for (const int e : {0, 1, 7})
      p.outline.edges[e].curves = {
          pattern::line_segment(p.outline.edges[e].curves[0].p0, p.outline.edges[e].curves[0].p3)};
    return p;
  };
  const auto skirt = [](const std::string& id, double top, double flare) {
    return piece(id, {{-flare, 0}, {top + flare, 0}, {top, 600}, {0, 600}});
  };
  const pattern::Panel front = waisted(bodice("bodice_front", 500, 85, 60), 0);
  const pattern::Panel back = waisted(bodice("bodice_back", 610, 70, 60), -12);
  Garment g{
      "dress", {front, back, skirt("skirt_front", 1.4 * 520, 60), skirt("skirt_back", 1.4 * 496, 60)}, {}};
  g.seams = {{{{"bodice_front", {"e1"}}}, {{"bodice_back", {"e7"}}}},
             {{{"bodice_front", {"e7"}}}, {{"bodice_back", {"e1"}}}},
             {{{"bodice_front", {"e3"}}}, {{"bodice_back", {"e5"}}}},
             {{{"bodice_front", {"e5"}}}, {{"bodice_back", {"e3"}}}},
             {{{"skirt_front", {"e1"}}}, {{"skirt_back", {"e3"}}}},
             {{{"skirt_front", {"e3"}}}, {{"skirt_back", {"e1"}}}},
             {{{"bodice_front", {"e0"}}}, {{"skirt_front", {"e2"}}}},
             {{{"bodice_back", {"e0"}}}, {{"skirt_back", {"e2"}}}}};
  return g;
}

inline std::vector<Garment> all() { return {dart_skirt(), trousers(), shirt(), hooded_top(), dress()}; }

}  // namespace toile::garments
