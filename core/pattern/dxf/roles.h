#pragma once
// What the chains of a place are drawn for, and which of them close.

#include <cstddef>
#include <vector>

#include "core/pattern/dxf/chains.h"
#include "core/pattern/dxf/fold.h"
#include "core/pattern/dxf/layers.h"

namespace toile::dxf {

struct DxfRoles {
  bool by_aama = false;  ///< layers have the meaning of their numbers; else any closed line may be an outline
  std::vector<DxfRole> of;  ///< each chain
  std::vector<bool> told;   ///< of each chain, whether that holds whatever by_aama is (told_role)

  /// Whether chain i may be the outline of a piece.
  bool makes_outlines(std::size_t i) const { return of[i] == DxfRole::kCut || of[i] == DxfRole::kSew; }
  /// What chain i means beside that; other where nothing tells.
  DxfRole meaning(std::size_t i) const { return by_aama || told[i] ? of[i] : DxfRole::kOther; }
};

/// Whether layers of such names have AAMA's meaning where a line stands on this one: it is one of outlines.
bool makes_aama(const std::string& layer, const DxfLayerMap& given);

/// Layers have AAMA's meaning where any line stands on those of outlines. Layers that repeat others (84 to
/// 87) count as the others where nothing stands on those. What is `given` holds in any case.
DxfRoles roles_of(const std::vector<DxfChain>& chains, const DxfLayerMap& given);

/// A mirror line of the place.
struct DxfFold {
  std::size_t chain = 0;
  FoldAxis axis;
};
std::vector<DxfFold> folds_of(const std::vector<DxfChain>& chains, const DxfRoles& roles);

struct DxfClosed {
  std::vector<DxfChain> chains;
  DxfNotes notes;
};

/// The chains, with those outlines closed that end at a fold or stop a little short.
DxfClosed closed_at_gaps(std::vector<DxfChain> chains, const DxfRoles& roles,
                         const std::vector<DxfFold>& folds);

}  // namespace toile::dxf
