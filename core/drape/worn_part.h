#pragma once
// A garment without the seams that cannot be sewn and the pieces that nothing holds on.

#include <string>
#include <vector>

#include "core/base/types.h"
#include "core/drape/drape_input.h"
#include "core/preflight/finding.h"

namespace toile::drape {

/// The input without seams that cannot be sewn (core/drape/left_open.h) and without what would fall off a
/// person: pieces that no seam, attachment, button or cushion joins to the rest, and that cannot be worn by
/// themselves: they do not close around anything (one border), are trifles beside the rest (a pocket sewn to
/// itself), or are sleeves, collars, cuffs or frills by their names. A pocket bag, a lining or a trim whose
/// seams are not told would otherwise keep the whole from being draped. `left_out` names them; what is told
/// of them alone goes with them.
///
/// All pieces where it is not for a person, where pieces are sewn from where they stand
/// (`settings.dress`), where layers are told, or where nothing is sewn.
DrapeInput worn_part(DrapeInput input);

/// A finding for each piece that was left out.
void tell_left_out(const DrapeInput& input, preflight::Findings& findings);

/// Ids of the pieces that were left out.
std::vector<std::string> names_left_out(const DrapeInput& input);

/// The input with these panels alone, `kept` rising, and what is told of them. What is left out has no place
/// yet.
DrapeInput with_panels(const DrapeInput& input, const std::vector<Index>& kept);

}  // namespace toile::drape
