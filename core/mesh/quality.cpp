#include "core/mesh/quality.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/mesh/topology.h"

namespace toile::mesh {
namespace {

struct Spread {
  double min = 0, max = 0, mean = 0, deviation = 0;
};

Spread spread_of(const std::vector<double>& values) {
  if (values.empty()) return {};
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  double sum = 0, squares = 0;
  for (const double v : values) sum += v;
  const double mean = sum / static_cast<double>(values.size());
  for (const double v : values) squares += (v - mean) * (v - mean);
  return {*low, *high, mean, std::sqrt(squares / static_cast<double>(values.size()))};
}

}  // namespace

double least_angle(Vec2 a, Vec2 b, Vec2 c) {
  const double twice_area = cross(b - a, c - a);
  if (!(twice_area > 0)) return 0;
  return std::min({std::atan2(twice_area, dot(b - a, c - a)), std::atan2(twice_area, dot(c - b, a - b)),
                   std::atan2(twice_area, dot(a - c, b - c))});
}

MeshQuality quality_of(std::span<const Vec2> rest, std::span<const Tri> triangles) {
  MeshQuality q;
  if (triangles.empty()) return q;
  std::vector<double> areas, lengths;
  q.min_angle = 4;
  for (const Tri& t : triangles) {
    const double area = 0.5 * cross(rest[t[1]] - rest[t[0]], rest[t[2]] - rest[t[0]]);
    areas.push_back(area);
    q.area += area;
    if (!(area > 0)) ++q.inverted;
    q.min_angle = std::min(q.min_angle, least_angle(rest[t[0]], rest[t[1]], rest[t[2]]));
  }
  for (const MeshEdge& e : edges_of(triangles, static_cast<Index>(rest.size()))) {
    lengths.push_back(length(rest[e.v1] - rest[e.v0]));
  }
  q.triangles = static_cast<Index>(triangles.size());
  q.edges = static_cast<Index>(lengths.size());
  const Spread edge = spread_of(lengths), area = spread_of(areas);
  q.min_edge = edge.min;
  q.max_edge = edge.max;
  q.mean_edge = edge.mean;
  q.edge_deviation = edge.deviation;
  q.min_area = area.min;
  q.max_area = area.max;
  q.area_deviation = area.deviation;
  return q;
}

}  // namespace toile::mesh
