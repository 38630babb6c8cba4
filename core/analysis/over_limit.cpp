#include "core/analysis/over_limit.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/text.h"

namespace toile::analysis {
namespace {

/// Strain over the limit that a spring behind it leaves, and that nobody sees.
constexpr double kOver = 0.02;

/// m in the flat: a finding's edges are no farther from its worst one.
constexpr double kNear = 0.1;

struct Edge {
  Index panel = kNone;
  Vec2 middle;  ///< m in the flat
  Vec3 place;   ///< m, of its middle
  double strain = 0, limit = 0;
};

bool has_limits(const material::Fabric& fabric) { return fabric.limit_warp > 0 && fabric.limit_weft > 0; }

Edge edge_between(Index panel, Index a, Index b, const drape::DrapeInput& input,
                  const drape::DrapeResult& result) {
  const Vec2 p = result.garment.rest[a], q = result.garment.rest[b];
  const Vec3 x = result.positions[a], y = result.positions[b];
  const Vec2 warp = input.pattern.panels[panel].grain, along = normalized(q - p);
  const material::Fabric& fabric = input.fabrics[input.fabric_of_panel[panel]];
  return {panel, (p + q) * 0.5, (x + y) * 0.5, length(y - x) / length(q - p) - 1,
          stretch_limit(fabric, {cross(along, warp), dot(along, warp)})};
}

/// The worst first.
std::vector<Edge> edges_over(const drape::DrapeInput& input, const drape::DrapeResult& result) {
  const sewing::GarmentMesh& g = result.garment;
  std::vector<std::array<Index, 3>> sides;  // panel, ends
  for (std::size_t t = 0; t < g.triangles.size(); ++t) {
    const Index panel = g.panel_of_triangle[t];
    if (!has_limits(input.fabrics[input.fabric_of_panel[panel]])) continue;
    const auto& [a, b, c] = g.triangles[t];
    for (const auto& [i, j] : {std::pair{a, b}, {b, c}, {c, a}})
      sides.push_back({panel, std::min(i, j), std::max(i, j)});
  }
  std::sort(sides.begin(), sides.end());
  sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
  std::vector<Edge> over;
  for (const auto& [panel, a, b] : sides) {
    const Edge edge = edge_between(panel, a, b, input, result);
    if (edge.strain > edge.limit + kOver) over.push_back(edge);
  }
  std::stable_sort(over.begin(), over.end(),
                   [](const Edge& a, const Edge& b) { return a.strain > b.strain; });
  return over;
}

preflight::Finding finding_of(const Edge& worst, std::size_t count, const std::string& piece) {
  const std::string edges =
      count == 1 ? "one edge of its mesh is" : std::to_string(count) + " edges of its mesh are";
  return preflight::found(preflight::FindingKind::kOverLimit,
                          edges + " stretched beyond the fabric's limit of " +
                              fixed_text(100 * worst.limit, 1) + " %, by up to " +
                              fixed_text(100 * worst.strain, 1) + " % " + preflight::place_text(worst.place) +
                              ": the piece is tight there, or hangs by a corner",
                          {preflight::piece_named(piece)}, worst.place);
}

}  // namespace

double stretch_limit(const material::Fabric& fabric, Vec2 along) {
  return std::hypot(along.x * (1 + fabric.limit_weft), along.y * (1 + fabric.limit_warp)) - 1;
}

preflight::Findings find_over_limit(const drape::DrapeInput& input, const drape::DrapeResult& result) {
  preflight::Findings findings;
  std::vector<Edge> left = edges_over(input, result);
  while (!left.empty()) {
    const Edge worst = left.front();
    const std::size_t count = std::erase_if(left, [&](const Edge& e) {
      return e.panel == worst.panel && length(e.middle - worst.middle) <= kNear;
    });
    findings.push_back(finding_of(worst, count, input.pattern.panels[worst.panel].id));
  }
  return findings;
}

}  // namespace toile::analysis
