#include "core/drape/make_features.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/drape/fold_hinges.h"
#include "core/drape/shoulder_holds.h"
#include "core/sewing/attached_places.h"

namespace toile::drape {

namespace {

sewing::ClothPoint mapped(const sewing::ClothPoint& point, std::span<const Index> vertex_of) {
  return {{vertex_of[point.v[0]], vertex_of[point.v[1]], vertex_of[point.v[2]]}, point.share};
}

std::vector<solver::constraints::PointTie> ties_of(const DrapeInput& input, const sewing::Assembly& assembly,
                                                   std::span<const Index> vertex_of) {
  std::vector<solver::constraints::PointTie> ties;
  for (std::size_t i = 0; i < input.notions.buttons.size(); ++i) {
    const auto& [a, b] = assembly.notions.buttons[i];
    solver::constraints::PointTie tie;
    tie.a = mapped(a, vertex_of);
    tie.b = mapped(b, vertex_of);
    tie.start_length =
        length(sewing::position_of(b, assembly.positions) - sewing::position_of(a, assembly.positions));
    tie.end_length = input.notions.buttons[i].distance;
    ties.push_back(tie);
  }
  return ties;
}

/// Edges of cloth that make a fold at least.
constexpr std::size_t kGathered = 4;

std::vector<solver::constraints::ElasticSegment> elastics_of(const DrapeInput& input,
                                                             const sewing::Assembly& assembly,
                                                             std::span<const Index> vertex_of) {
  std::vector<solver::constraints::ElasticSegment> segments;
  for (std::size_t i = 0; i < input.notions.elastics.size(); ++i) {
    const sewing::Elastic& elastic = input.notions.elastics[i];
    // What hangs by hooks is gathered by their places, and its band goes from hook to hook.
    const bool gathers = elastic.factor < 1 && !input.hangs_by_hooks();
    for (const std::vector<Index>& chain : assembly.notions.elastics[i]) {
      // Between a band's segments the cloth buckles: one edge alone cannot, and would have to be squeezed.
      const std::size_t edges = chain.size() - 1, stride = gathers ? kGathered : 1;
      const std::size_t parts = std::max<std::size_t>(1, (edges + stride / 2) / stride);
      for (std::size_t part = 0; part < parts; ++part) {
        const std::size_t from = part * edges / parts, to = (part + 1) * edges / parts;
        double flat = 0;
        for (std::size_t k = from; k < to; ++k)
          flat += length(assembly.garment.rest[chain[k + 1]] - assembly.garment.rest[chain[k]]);
        const Index v0 = vertex_of[chain[from]], v1 = vertex_of[chain[to]];
        if (v0 != v1) segments.push_back({v0, v1, flat, elastic.factor * flat, elastic.stiffness});
      }
    }
  }
  return segments;
}

std::vector<solver::constraints::PressureChamber> chambers_of(const DrapeInput& input,
                                                              const sewing::Assembly& assembly,
                                                              std::span<const Index> vertex_of,
                                                              Index vertex_count) {
  std::vector<solver::constraints::PressureChamber> chambers;
  const sewing::GarmentMesh& garment = assembly.garment;
  for (const sewing::Cushion& cushion : input.notions.cushions) {
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
    chambers.push_back(
        solver::constraints::make_chamber(skin, vertex_count, cushion.pressure, cushion.full_volume));
  }
  return chambers;
}

std::vector<solver::constraints::Tether> tethers_of(const DrapeInput& input, const sewing::Assembly& assembly,
                                                    std::span<const Index> vertex_of,
                                                    const std::vector<bool>& released) {
  std::vector<solver::constraints::Tether> tethers;
  for (std::size_t a = 0; a < input.attachments.size(); ++a) {
    if (released[a] || assembly.led[a].empty()) continue;
    const auto goal = std::make_shared<const std::vector<Vec3>>(input.attachments[a].goal);
    for (const sewing::ClothPoint& point : assembly.led[a]) {
      const double start = solver::constraints::length_of({point, goal, 0}, assembly.positions);
      tethers.push_back({mapped(point, vertex_of), goal, start});
    }
  }
  return tethers;
}

}  // namespace

solver::ClothFeatures make_features(const DrapeInput& input, const sewing::Assembly& assembly,
                                    std::span<const Index> vertex_of, Index vertex_count,
                                    const std::vector<bool>& released,
                                    const std::optional<dressing::Person>& wearer) {
  return {input.settings.air,
          ties_of(input, assembly, vertex_of),
          elastics_of(input, assembly, vertex_of),
          fold_hinges(input.notions.creases, assembly, vertex_of),
          chambers_of(input, assembly, vertex_of, vertex_count),
          tethers_of(input, assembly, vertex_of, released),
          wearer ? make_shoulder_holds(assembly, wearer->figure, vertex_of, vertex_count)
                 : std::vector<solver::constraints::ShoulderHold>{},
          {}};
}

double off_hold(const DrapeInput& input, const sewing::Assembly& assembly, std::size_t a,
                std::span<const Vec3> x) {
  const sewing::Attachment& attachment = input.attachments[a];
  double most = 0;
  for (const sewing::ClothPoint& point : assembly.led[a]) {
    const Vec3 p = sewing::position_of(point, x);
    most = std::max(most, length(sewing::nearest_on_goal(attachment.goal, p) - p));
  }
  for (const Index v : assembly.attached[a]) {
    const Vec3 d = x[v] - assembly.positions[v];
    most = std::max(most, attachment.hold == sewing::Attachment::Hold::kHeight ? std::abs(d.y) : length(d));
  }
  return most;
}

}  // namespace toile::drape
