#include "core/drape/left_open.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/base/text.h"
#include "core/base/units.h"
#include "core/pattern/curve.h"
#include "core/pattern/seams/check.h"
#include "core/preflight/check_pattern.h"

namespace toile::drape {
namespace {

/// Of what hangs together by all seams, this share of its cloth still has to without those left open.
constexpr double kLeastTogether = 0.5;
constexpr int kFacing = 8;  // parts of a seam, between which its gap is measured

bool can_be_sewn(const pattern::Pattern& pattern, const pattern::Seam& seam) {
  const double a = seams::series_length(pattern, seam.a), b = seams::series_length(pattern, seam.b);
  return std::max(a, b) <= preflight::kMostGathered * std::min(a, b);
}

double area_of(const pattern::Panel& panel) {
  double area = pattern::signed_area(panel.outline);
  for (const pattern::Loop& hole : panel.holes) area += pattern::signed_area(hole);  // clockwise
  return area;
}

/// A series of edges as one line of the garment's vertices, with the way along the flat cloth to each, m.
struct Line {
  std::vector<Index> vertices;
  std::vector<double> along;

  Index at(double share) const {
    const double wanted = share * along.back();
    const auto less = [](double a, double b) { return a < b; };
    const auto next = std::lower_bound(along.begin(), along.end(), wanted, less);
    auto k = static_cast<std::size_t>(next - along.begin());
    if (k > 0 && wanted - along[k - 1] < along[k] - wanted) --k;
    return vertices[k];
  }
};

Line line_of(const std::vector<pattern::SeamEdge>& side, const mesh::PanelMeshes& meshes,
             const sewing::GarmentMesh& garment) {
  Line line;
  double before = 0;
  for (const pattern::SeamEdge& e : side) {
    std::vector<Index> edge = meshes.panels[e.panel].edge_vertices[e.edge];
    if (e.reversed) std::reverse(edge.begin(), edge.end());
    const Index first = garment.first_vertex[e.panel];
    std::vector<double> along{0};
    for (std::size_t k = 1; k < edge.size(); ++k)
      along.push_back(along.back() +
                      length(garment.rest[first + edge[k]] - garment.rest[first + edge[k - 1]]));
    const double whole = along.back();
    const double from = whole * (e.reversed ? 1 - e.to : e.from),
                 to = whole * (e.reversed ? 1 - e.from : e.to);
    for (std::size_t k = 0; k < edge.size(); ++k) {
      line.vertices.push_back(first + edge[k]);
      line.along.push_back(before + std::clamp(along[k], from, to) - from);
    }
    before += to - from;
  }
  return line;
}

}  // namespace

double most_together(const pattern::Pattern& pattern) {
  DisjointSets panels(pattern.panels.size());
  for (const pattern::Seam& seam : pattern.seams)
    for (const std::vector<pattern::SeamEdge>* side : {&seam.a, &seam.b})
      for (const pattern::SeamEdge& e : *side) panels.join(seam.a.front().panel, e.panel);
  std::vector<double> area(pattern.panels.size(), 0);
  for (std::size_t p = 0; p < area.size(); ++p)
    area[panels.root(static_cast<Index>(p))] += area_of(pattern.panels[p]);
  return area.empty() ? 0 : *std::max_element(area.begin(), area.end());
}

DrapeInput with_seams_that_can_be_sewn(DrapeInput input) {
  const auto can = [&](const pattern::Seam& seam) { return can_be_sewn(input.pattern, seam); };
  if (std::all_of(input.pattern.seams.begin(), input.pattern.seams.end(), can)) return input;
  DrapeInput some = input;
  std::erase_if(some.pattern.seams, [&](const pattern::Seam& seam) { return !can(seam); });
  const bool enough = !some.pattern.seams.empty() &&
                      most_together(some.pattern) >= kLeastTogether * most_together(input.pattern);
  if (!enough) return input;
  for (const pattern::Seam& seam : input.pattern.seams)
    if (!can(seam)) some.left_open.push_back(seam);
  return some;
}

std::vector<std::vector<std::array<Index, 2>>> facing_of_left_open(const DrapeInput& input,
                                                                   const mesh::PanelMeshes& meshes,
                                                                   const sewing::GarmentMesh& garment) {
  std::vector<std::vector<std::array<Index, 2>>> facing;
  for (const pattern::Seam& seam : input.left_open) {
    const Line a = line_of(seam.a, meshes, garment), b = line_of(seam.b, meshes, garment);
    std::vector<std::array<Index, 2>>& pairs = facing.emplace_back();
    for (int k = 0; k <= kFacing; ++k) {
      const double share = static_cast<double>(k) / kFacing;
      pairs.push_back({a.at(share), b.at(seam.same_direction ? share : 1 - share)});
    }
  }
  return facing;
}

std::vector<OpenSeam> gaps_left_open(const DrapeInput& input,
                                     const std::vector<std::vector<std::array<Index, 2>>>& facing,
                                     std::span<const Vec3> x) {
  std::vector<OpenSeam> open;
  for (std::size_t s = 0; s < facing.size(); ++s) {
    OpenSeam& seam = open.emplace_back(OpenSeam{input.left_open[s].id, 0});
    for (const auto& [i, j] : facing[s]) seam.gap = std::max(seam.gap, length(x[i] - x[j]));
  }
  return open;
}

void tell_left_open(const DrapeInput& input, const mesh::PanelMeshes& meshes,
                    const sewing::Assembly& assembly, preflight::Findings& findings) {
  const auto facing = facing_of_left_open(input, meshes, assembly.garment);
  for (std::size_t s = 0; s < facing.size(); ++s) {
    const pattern::Seam& seam = input.left_open[s];
    const double a = seams::series_length(input.pattern, seam.a),
                 b = seams::series_length(input.pattern, seam.b);
    Vec3 place;
    for (const auto& [i, j] : facing[s])
      place +=
          (assembly.positions[i] + assembly.positions[j]) * (0.5 / static_cast<double>(facing[s].size()));
    preflight::Finding told = preflight::found(
        preflight::FindingKind::kLengthRatio,
        preflight::length_text(metres_from_mm(std::max(a, b))) + " are sewn to " +
            preflight::length_text(metres_from_mm(std::min(a, b))) +
            "; more than 1:3 cannot be gathered, so that the seam is left open: see to the edges and units",
        {preflight::seam_named(seam.id)}, place);
    told.severity = preflight::Severity::kWarning;
    findings.push_back(std::move(told));
  }
  preflight::sort_by_severity(findings);
}

}  // namespace toile::drape
