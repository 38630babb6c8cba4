#include "core/solver/constraints/pressure.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/mesh/topology.h"

namespace toile::solver::constraints {

namespace {

constexpr double kMostOverfill = 4;

/// The triangles wound like the first of each part that edges hold together.
std::vector<Tri> wound_alike(std::span<const Tri> given) {
  std::vector<Tri> triangles(given.begin(), given.end());
  std::map<std::pair<Index, Index>, std::vector<Index>> at_edge;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(triangles[t][k], triangles[t][(k + 1) % 3]);
      at_edge[{a, b}].push_back(static_cast<Index>(t));
    }
  }
  const auto runs = [&](Index t, Index a, Index b) {
    const Tri& v = triangles[t];
    return (v[0] == a && v[1] == b) || (v[1] == a && v[2] == b) || (v[2] == a && v[0] == b);
  };
  std::vector<bool> seen(triangles.size(), false);
  std::vector<Index> open;
  for (std::size_t first = 0; first < triangles.size(); ++first) {
    if (seen[first]) continue;
    seen[first] = true;
    open.push_back(static_cast<Index>(first));
    while (!open.empty()) {
      const Index t = open.back();
      open.pop_back();
      const Tri v = triangles[t];
      for (int k = 0; k < 3; ++k) {
        const Index a = v[k], b = v[(k + 1) % 3];
        const std::vector<Index>& pair = at_edge[std::minmax(a, b)];
        if (pair.size() != 2) continue;
        const Index other = pair[0] == t ? pair[1] : pair[0];
        if (seen[other]) continue;
        seen[other] = true;
        if (runs(other, a, b)) std::swap(triangles[other][1], triangles[other][2]);
        open.push_back(other);
      }
    }
  }
  return triangles;
}

Vec3 middle_of(const std::vector<Index>& ring, std::span<const Vec3> x) {
  Vec3 sum;
  for (const Index v : ring) sum += x[v];
  return sum * (1.0 / static_cast<double>(ring.size()));
}

/// Calls f(ring, from, to) for the caps' rims, run against the skin's border.
template <typename F>
void for_rims(const PressureChamber& chamber, F&& f) {
  for (const std::vector<Index>& ring : chamber.openings) {
    for (std::size_t i = 0; i < ring.size(); ++i) f(ring, ring[(i + 1) % ring.size()], ring[i]);
  }
}

}  // namespace

PressureChamber make_chamber(std::span<const Tri> triangles, Index vertex_count, double pressure,
                             double full_volume) {
  PressureChamber chamber{wound_alike(triangles), {}, pressure, full_volume};
  const mesh::BoundaryLoops loops = mesh::boundary_loops(mesh::edges_of(chamber.skin, vertex_count));
  for (Index i = 0; i < loops.count(); ++i) {
    chamber.openings.emplace_back(loops.vertices.begin() + loops.first[i],
                                  loops.vertices.begin() + loops.first[i + 1]);
  }
  return chamber;
}

double volume_of(const PressureChamber& chamber, std::span<const Vec3> x) {
  if (chamber.skin.empty()) return 0;
  const Vec3 origin = x[chamber.skin[0][0]];  // near the shape: little is lost to rounding
  double six = 0;
  for (const auto& [a, b, c] : chamber.skin) {
    six += dot(x[a] - origin, cross(x[b] - origin, x[c] - origin));
  }
  for_rims(chamber, [&](const std::vector<Index>& ring, Index from, Index to) {
    six += dot(middle_of(ring, x) - origin, cross(x[from] - origin, x[to] - origin));
  });
  return six / 6;
}

double pressure_at(const PressureChamber& chamber, double volume) {
  if (!(chamber.full_volume > 0)) return chamber.pressure;
  const double least = chamber.full_volume / kMostOverfill;
  return chamber.pressure * chamber.full_volume / std::max(volume, least);
}

void add_pressure(const PressureChamber& chamber, double pressure, std::span<const Vec3> x,
                  std::span<Vec3> out) {
  const double share = pressure / 6;  // a third of the area, which is half the cross product
  for (const auto& [a, b, c] : chamber.skin) {
    const Vec3 push = cross(x[b] - x[a], x[c] - x[a]) * share;
    out[a] += push;
    out[b] += push;
    out[c] += push;
  }
  for (const std::vector<Index>& ring : chamber.openings) {
    const Vec3 middle = middle_of(ring, x);
    Vec3 on_middle;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Index from = ring[(i + 1) % ring.size()], to = ring[i];
      const Vec3 push = cross(x[from] - middle, x[to] - middle) * share;
      out[from] += push;
      out[to] += push;
      on_middle += push;
    }
    on_middle = on_middle * (1.0 / static_cast<double>(ring.size()));
    for (const Index v : ring) out[v] += on_middle;
  }
}

void inflate(std::span<const PressureChamber> chambers, double filled, std::span<const double> w, double h,
             std::span<const Vec3> x, std::vector<Vec3>& force, std::span<Vec3> v) {
  if (chambers.empty() || filled <= 0) return;
  force.assign(x.size(), Vec3{});
  for (const PressureChamber& chamber : chambers) {
    add_pressure(chamber, filled * pressure_at(chamber, volume_of(chamber, x)), x, force);
  }
  for (std::size_t i = 0; i < x.size(); ++i) v[i] += force[i] * (w[i] * h);
}

}  // namespace toile::solver::constraints
