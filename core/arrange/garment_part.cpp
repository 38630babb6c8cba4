#include "core/arrange/garment_part.h"

#include <algorithm>

#include "core/mesh/sewn_part.h"

namespace toile::arrange {

namespace {

/// The seam by the numbers that its panels have now; false where one of them is gone.
bool renumber(pattern::Seam& seam, const std::vector<Index>& now) {
  bool stays = true;
  for (std::vector<pattern::SeamEdge>* side : {&seam.a, &seam.b})
    for (pattern::SeamEdge& e : *side) {
      e.panel = now[e.panel];
      stays = stays && e.panel != kNone;
    }
  return stays;
}

void take_seams(const pattern::Pattern& pattern, const mesh::PanelMeshes& meshes,
                const std::vector<Index>& now, GarmentPart& part) {
  std::vector<Index> seam_now(pattern.seams.size(), kNone);
  for (std::size_t s = 0; s < pattern.seams.size(); ++s) {
    pattern::Seam seam = pattern.seams[s];
    if (!renumber(seam, now)) continue;
    seam_now[s] = static_cast<Index>(part.pattern.seams.size());
    part.pattern.seams.push_back(std::move(seam));
  }
  for (mesh::MatchedSeam seam : meshes.seams) {
    seam.seam = seam_now[seam.seam];
    if (seam.seam == kNone) continue;
    for (mesh::SewnPair& pair : seam.pairs)
      for (mesh::PanelVertex* v : {&pair.a, &pair.b}) v->panel = now[v->panel];
    part.meshes.seams.push_back(std::move(seam));
  }
}

}  // namespace

GarmentPart garment_of(const pattern::Pattern& pattern, const mesh::PanelMeshes& meshes,
                       std::vector<Index> panels) {
  GarmentPart part;
  std::vector<Index> now(pattern.panels.size(), kNone);
  for (const Index p : panels) {
    now[p] = static_cast<Index>(part.pattern.panels.size());
    part.pattern.panels.push_back(pattern.panels[p]);
    part.meshes.panels.push_back(meshes.panels[p]);
  }
  take_seams(pattern, meshes, now, part);
  part.panels = std::move(panels);
  return part;
}

std::vector<GarmentPart> garment_parts(const pattern::Pattern& pattern, const mesh::PanelMeshes& meshes) {
  std::vector<GarmentPart> parts;
  for (mesh::SewnPart& sewn : mesh::sewn_parts(meshes)) {
    parts.push_back(garment_of(pattern, meshes, std::move(sewn.panels)));
    parts.back().area = sewn.area;
  }
  std::stable_sort(parts.begin(), parts.end(),
                   [](const GarmentPart& a, const GarmentPart& b) { return a.area > b.area; });
  return parts;
}

}  // namespace toile::arrange
