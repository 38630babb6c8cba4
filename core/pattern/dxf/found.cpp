#include "core/pattern/dxf/found.h"

namespace toile::dxf {

std::size_t owner_of(const std::vector<DxfPlaced>& placed, const Aabb2& box, bool overlap_is_enough) {
  std::size_t best = placed.size();
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const DxfPlaced& p = placed[i];
    const Aabb2& around = p.cut ? p.cut->box : p.loop->box;
    const bool inside = around.grown(kBoxSlack).contains(box);
    if (!inside && !(overlap_is_enough && same_place(around, box))) continue;
    if (best == placed.size() || p.loop->area < placed[best].loop->area) best = i;
  }
  return best;
}

void tell(DxfNotes& notes, const DxfChain& chain, DxfFate fate, const std::string& reason, int piece) {
  for (const std::size_t entity : chain.entities) notes.mark(entity, fate, reason, piece);
}

}  // namespace toile::dxf
