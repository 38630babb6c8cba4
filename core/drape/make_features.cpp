#include "core/drape/make_features.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/mesh/topology.h"
#include "core/sewing/attached_places.h"

namespace toile {

namespace {

/// Sines differ in their last bit between processors; the same input must give the same bytes.
double rounded(double value) { return std::nearbyint(value * 0x1p40) / 0x1p40; }

ClothPoint mapped(const ClothPoint& point, std::span<const Index> vertex_of) {
  return {{vertex_of[point.v[0]], vertex_of[point.v[1]], vertex_of[point.v[2]]}, point.share};
}

std::vector<PointTie> ties_of(const DrapeInput& input, const Assembly& assembly,
                              std::span<const Index> vertex_of) {
  std::vector<PointTie> ties;
  for (std::size_t i = 0; i < input.notions.buttons.size(); ++i) {
    const auto& [a, b] = assembly.notions.buttons[i];
    PointTie tie;
    tie.a = mapped(a, vertex_of);
    tie.b = mapped(b, vertex_of);
    tie.start_length = length(position_of(b, assembly.positions) - position_of(a, assembly.positions));
    tie.end_length = input.notions.buttons[i].distance;
    ties.push_back(tie);
  }
  return ties;
}

std::vector<ElasticSegment> elastics_of(const DrapeInput& input, const Assembly& assembly,
                                        std::span<const Index> vertex_of) {
  std::vector<ElasticSegment> segments;
  for (std::size_t i = 0; i < input.notions.elastics.size(); ++i) {
    const Elastic& elastic = input.notions.elastics[i];
    for (const std::vector<Index>& chain : assembly.notions.elastics[i]) {
      for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
        const Index v0 = vertex_of[chain[k]], v1 = vertex_of[chain[k + 1]];
        const double flat = length(assembly.garment.rest[chain[k + 1]] - assembly.garment.rest[chain[k]]);
        if (v0 != v1) segments.push_back({v0, v1, flat, elastic.factor * flat, elastic.stiffness});
      }
    }
  }
  return segments;
}

std::vector<FoldHinge> folds_of(const DrapeInput& input, const Assembly& assembly,
                                std::span<const Index> vertex_of) {
  std::vector<FoldHinge> hinges;
  if (input.notions.creases.empty()) return hinges;
  const GarmentMesh& garment = assembly.garment;
  std::map<std::pair<Index, Index>, MeshEdge> edges;
  for (const MeshEdge& e : edges_of(garment.triangles, garment.vertex_count())) {
    edges.emplace(std::minmax(e.v0, e.v1), e);
  }
  for (std::size_t i = 0; i < input.notions.creases.size(); ++i) {
    const Crease& crease = input.notions.creases[i];
    const double sine = rounded(std::sin(crease.angle / 2)), cosine = rounded(std::cos(crease.angle / 2));
    for (const std::vector<Index>& chain : assembly.notions.creases[i]) {
      for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
        const auto found = edges.find(std::minmax(chain[k], chain[k + 1]));
        if (found == edges.end() || found->second.t1 == kNone) continue;
        const MeshEdge& e = found->second;
        hinges.push_back({vertex_of[e.v0], vertex_of[e.v1], vertex_of[e.opposite0], vertex_of[e.opposite1],
                          sine, cosine, crease.stiffness * length(garment.rest[e.v1] - garment.rest[e.v0])});
      }
    }
  }
  return hinges;
}

std::vector<PressureChamber> chambers_of(const DrapeInput& input, const Assembly& assembly,
                                         std::span<const Index> vertex_of, Index vertex_count) {
  std::vector<PressureChamber> chambers;
  const GarmentMesh& garment = assembly.garment;
  for (const Cushion& cushion : input.notions.cushions) {
    std::vector<Tri> skin;
    for (const Index panel : cushion.panels) {
      for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
        if (garment.panel_of_triangle[t] != panel) continue;
        const auto [a, b, c] = garment.triangles[t];
        const Tri joined{vertex_of[a], vertex_of[b], vertex_of[c]};
        // A weld may draw two corners into one: a triangle without area holds nothing.
        if (joined[0] == joined[1] || joined[1] == joined[2] || joined[2] == joined[0]) continue;
        skin.push_back(joined);
      }
    }
    chambers.push_back(make_chamber(skin, vertex_count, cushion.pressure, cushion.full_volume));
  }
  return chambers;
}

std::vector<Tether> tethers_of(const DrapeInput& input, const Assembly& assembly,
                               std::span<const Index> vertex_of, const std::vector<bool>& released) {
  std::vector<Tether> tethers;
  for (std::size_t a = 0; a < input.attachments.size(); ++a) {
    if (released[a] || assembly.led[a].empty()) continue;
    const auto goal = std::make_shared<const std::vector<Vec3>>(input.attachments[a].goal);
    for (const ClothPoint& point : assembly.led[a]) {
      const double start = length_of({point, goal, 0}, assembly.positions);
      tethers.push_back({mapped(point, vertex_of), goal, start});
    }
  }
  return tethers;
}

}  // namespace

ClothFeatures make_features(const DrapeInput& input, const Assembly& assembly,
                            std::span<const Index> vertex_of, Index vertex_count,
                            const std::vector<bool>& released) {
  return {input.settings.air,
          ties_of(input, assembly, vertex_of),
          elastics_of(input, assembly, vertex_of),
          folds_of(input, assembly, vertex_of),
          chambers_of(input, assembly, vertex_of, vertex_count),
          tethers_of(input, assembly, vertex_of, released)};
}

double off_hold(const DrapeInput& input, const Assembly& assembly, std::size_t a, std::span<const Vec3> x) {
  const Attachment& attachment = input.attachments[a];
  double most = 0;
  for (const ClothPoint& point : assembly.led[a]) {
    const Vec3 p = position_of(point, x);
    most = std::max(most, length(nearest_on_goal(attachment.goal, p) - p));
  }
  for (const Index v : assembly.attached[a]) {
    const Vec3 d = x[v] - assembly.positions[v];
    most = std::max(most, attachment.hold == Attachment::Hold::kHeight ? std::abs(d.y) : length(d));
  }
  return most;
}

}  // namespace toile
