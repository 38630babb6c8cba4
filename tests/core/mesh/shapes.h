#pragma once
// Outlines for the tests of this room: polygons in metres, panels in millimetres.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/units.h"
#include "core/mesh/lattice.h"
#include "core/pattern/curve.h"
#include "core/pattern/pattern.h"

namespace toile {

/// A fixed sequence of numbers in [0, 1), the same everywhere.
class Sequence {
 public:
  explicit Sequence(std::uint64_t seed) : state_(seed * 2654435761u + 12345) {}
  double next() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state_ >> 40) / static_cast<double>(1u << 24);
  }

 private:
  std::uint64_t state_;
};

/// The sides of a polygon cut into parts of about h.
inline mesh::Polygon sampled(const mesh::Polygon& corners, double h) {
  mesh::Polygon points;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 a = corners[i], b = corners[(i + 1) % corners.size()];
    const int n = std::max(1, static_cast<int>(std::lround(length(b - a) / h)));
    for (int k = 0; k < n; ++k) points.push_back(a + (b - a) * (double(k) / n));
  }
  return points;
}

inline mesh::Polygon circle(Vec2 centre, double radius, double h) {
  const int n = std::max(3, static_cast<int>(std::lround(2 * kPi * radius / h)));
  mesh::Polygon points;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * kPi * i / n;
    points.push_back(centre + Vec2{radius * std::cos(a), radius * std::sin(a)});
  }
  return points;
}

inline mesh::Polygon clockwise(mesh::Polygon p) {
  std::reverse(p.begin(), p.end());
  return p;
}

inline mesh::Polygon rectangle(double width, double height) {
  return {{0, 0}, {width, 0}, {width, height}, {0, height}};
}

/// 2 · tips corners, alternating radii.
inline mesh::Polygon star(int tips, double outer, double inner) {
  mesh::Polygon points;
  for (int i = 0; i < 2 * tips; ++i) {
    const double r = i % 2 == 0 ? outer : inner, a = kPi * i / tips;
    points.push_back({r * std::cos(a), r * std::sin(a)});
  }
  return points;
}

/// Half a skirt: the part of a ring between two radii and angles.
inline mesh::Polygon ring_sector(double inner, double outer, double from, double to, double h) {
  const auto arc = [&](double r) {
    const int n = static_cast<int>(std::lround(r * (to - from) / h));
    mesh::Polygon points;
    for (int i = 0; i <= n; ++i) {
      const double a = from + (to - from) * i / n;
      points.push_back({r * std::cos(a), r * std::sin(a)});
    }
    return points;
  };
  mesh::Polygon all;
  const auto append = [&](const mesh::Polygon& path) {
    const int n = path.size() == 2 ? static_cast<int>(std::lround(length(path[1] - path[0]) / h)) : 0;
    for (int k = 0; k < n; ++k) all.push_back(path[0] + (path[1] - path[0]) * (double(k) / n));
    if (n == 0) all.insert(all.end(), path.begin(), path.end() - 1);
  };
  const mesh::Polygon out = arc(outer), in = clockwise(arc(inner));
  append(out);
  append({out.back(), in.front()});
  append(in);
  append({in.back(), out.front()});
  return all;
}

/// A panel with one straight edge per side; corners in mm.
inline pattern::Panel straight_panel(const std::string& id, const std::vector<Vec2>& corners_mm) {
  pattern::Panel panel;
  panel.id = id;
  for (std::size_t i = 0; i < corners_mm.size(); ++i) {
    const Vec2 a = corners_mm[i], b = corners_mm[(i + 1) % corners_mm.size()];
    panel.outline.edges.push_back({"e" + std::to_string(i), {pattern::line_segment(a, b)}});
  }
  return panel;
}

/// Edges: 0 bottom (left to right), 1 right (up), 2 top (right to left), 3 left (down).
inline pattern::Panel rectangle_panel(const std::string& id, double width_mm, double height_mm) {
  return straight_panel(id, {{0, 0}, {width_mm, 0}, {width_mm, height_mm}, {0, height_mm}});
}

/// A closed loop of four quarter arcs.
inline pattern::Loop circle_loop(Vec2 centre_mm, double radius_mm, bool counter_clockwise, int edges) {
  constexpr double k = 0.5522847498307936;
  std::vector<pattern::CubicBezier> quarters;
  for (int i = 0; i < 4; ++i) {
    const Vec2 u{std::round(std::cos(kPi / 2 * i)), std::round(std::sin(kPi / 2 * i))};
    const Vec2 v = perpendicular(u);
    const auto at = [&](double a, double b) { return centre_mm + (u * a + v * b) * radius_mm; };
    quarters.push_back({at(1, 0), at(1, k), at(k, 1), at(0, 1)});
  }
  pattern::Loop loop;
  for (int e = 0; e < edges; ++e) {
    pattern::PanelEdge edge{"arc" + std::to_string(e), {}};
    for (int i = 4 * e / edges; i < 4 * (e + 1) / edges; ++i) edge.curves.push_back(quarters[i]);
    loop.edges.push_back(edge);
  }
  return counter_clockwise ? loop : pattern::reversed(loop);
}

}  // namespace toile
