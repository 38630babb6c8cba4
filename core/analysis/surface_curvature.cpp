#include "core/analysis/surface_curvature.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace toile::analysis {
namespace {

/// The triangles on both sides of an edge, by its welded ends; kNone where there is none.
using Sides = std::map<std::pair<Index, Index>, std::array<Index, 2>>;

Sides sides_of(const sewing::GarmentMesh& g) {
  Sides sides;
  for (std::size_t t = 0; t < g.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = g.weld[g.triangles[t][k]], b = g.weld[g.triangles[t][(k + 1) % 3]];
      const auto [at, fresh] = sides.try_emplace(std::minmax(a, b), std::array{static_cast<Index>(t), kNone});
      if (!fresh && at->second[1] == kNone) at->second[1] = static_cast<Index>(t);
    }
  }
  return sides;
}

/// The angle between triangles, positive where the second, towards which `to_second` goes, bends away from
/// the right side of the first.
double bend_between(Vec3 first_normal, Vec3 second_normal, Vec3 to_second) {
  const double angle =
      std::atan2(length(cross(first_normal, second_normal)), dot(first_normal, second_normal));
  return dot(first_normal, to_second) > 0 ? -angle : angle;
}

Vec3 middle(const Tri& t, std::span<const Vec3> x) { return (x[t[0]] + x[t[1]] + x[t[2]]) * (1.0 / 3); }

std::vector<SymmetricTensor> summed_at_vertices(const sewing::GarmentMesh& g,
                                                std::span<const SymmetricTensor> of_triangle) {
  std::vector<SymmetricTensor> sums(g.rest.size());
  for (std::size_t t = 0; t < g.triangles.size(); ++t)
    for (const Index v : g.triangles[t]) sums[g.weld[v]].add(1, of_triangle[t]);
  return sums;
}

}  // namespace

void SymmetricTensor::add(double s, Vec3 a, Vec3 b) {
  xx += s * a.x * b.x;
  yy += s * a.y * b.y;
  zz += s * a.z * b.z;
  xy += 0.5 * s * (a.x * b.y + a.y * b.x);
  xz += 0.5 * s * (a.x * b.z + a.z * b.x);
  yz += 0.5 * s * (a.y * b.z + a.z * b.y);
}

void SymmetricTensor::add(double s, const SymmetricTensor& other) {
  xx += s * other.xx;
  yy += s * other.yy;
  zz += s * other.zz;
  xy += s * other.xy;
  xz += s * other.xz;
  yz += s * other.yz;
}

double SymmetricTensor::along(Vec3 a) const {
  return xx * a.x * a.x + yy * a.y * a.y + zz * a.z * a.z +
         2 * (xy * a.x * a.y + xz * a.x * a.z + yz * a.y * a.z);
}

double contracted(const SymmetricTensor& a, const SymmetricTensor& b) {
  return a.xx * b.xx + a.yy * b.yy + a.zz * b.zz + 2 * (a.xy * b.xy + a.xz * b.xz + a.yz * b.yz);
}

std::vector<double> triangle_areas(const sewing::GarmentMesh& garment, std::span<const Vec3> positions) {
  std::vector<double> areas;
  areas.reserve(garment.triangles.size());
  for (const Tri& t : garment.triangles)
    areas.push_back(0.5 *
                    length(cross(positions[t[1]] - positions[t[0]], positions[t[2]] - positions[t[0]])));
  return areas;
}

std::vector<SymmetricTensor> spread(const sewing::GarmentMesh& g,
                                    std::span<const SymmetricTensor> of_triangle,
                                    std::span<const double> weights) {
  // A triangle takes the mean of its corners and gives it on to them: what lies two edges away counts once
  // more.
  std::vector<SymmetricTensor> values(of_triangle.begin(), of_triangle.end());
  std::vector<SymmetricTensor> at(g.rest.size());
  for (int round = 0; round < 2; ++round) {
    std::vector<SymmetricTensor> weighted(values.size());
    for (std::size_t t = 0; t < values.size(); ++t) weighted[t].add(weights[t], values[t]);
    at = summed_at_vertices(g, weighted);
    std::vector<double> area(g.rest.size(), 0);
    for (std::size_t t = 0; t < values.size(); ++t)
      for (const Index v : g.triangles[t]) area[g.weld[v]] += weights[t];
    for (std::size_t v = 0; v < at.size(); ++v) {
      const SymmetricTensor sum = std::exchange(at[v], {});
      if (area[v] > 0) at[v].add(1 / area[v], sum);
    }
    for (std::size_t t = 0; t < values.size(); ++t) {
      values[t] = {};
      for (const Index v : g.triangles[t]) values[t].add(1.0 / 3, at[g.weld[v]]);
    }
  }
  for (std::size_t v = 0; v < at.size(); ++v) at[v] = at[g.weld[v]];
  return at;
}

std::vector<SymmetricTensor> surface_curvature(const sewing::GarmentMesh& g, std::span<const Vec3> x) {
  std::vector<Vec3> normals;
  normals.reserve(g.triangles.size());
  for (const Tri& t : g.triangles) normals.push_back(normalized(cross(x[t[1]] - x[t[0]], x[t[2]] - x[t[0]])));
  const std::vector<double> areas = triangle_areas(g, x);
  std::vector<SymmetricTensor> bent(g.triangles.size());
  for (const auto& [ends, sides] : sides_of(g)) {
    if (sides[1] == kNone) continue;
    const auto [one, other] = sides;
    const Vec3 edge = x[ends.second] - x[ends.first];
    const double angle = bend_between(normals[one], normals[other],
                                      middle(g.triangles[other], x) - middle(g.triangles[one], x));
    const Vec3 across = normalized(cross(edge, normals[one] + normals[other]));
    for (const Index t : sides)
      if (areas[t] > 0) bent[t].add(0.5 * angle * length(edge) / areas[t], across, across);
  }
  return spread(g, bent, areas);
}

}  // namespace toile::analysis
