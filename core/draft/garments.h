#pragma once
// What there is to draft.

#include <string_view>
#include <vector>

#include "core/draft/garment.h"
#include "core/draft/wearer.h"

namespace toile::draft {

struct GarmentKind {
  std::string_view name;  ///< as Garment::name
  std::string_view summary;
  std::string_view preset;  ///< the mannequin that the kept sample is drafted for; empty: nobody wears it
  Garment (*draft)(const Wearer&);
};

/// In the order in which they are shown.
const std::vector<GarmentKind>& garment_kinds();
/// Null where there is none of that name.
const GarmentKind* find_garment(std::string_view name);

}  // namespace toile::draft
