#pragma once
// What a garment is made of, as its pattern's materials and names tell.

#include <string>
#include <vector>

#include "core/pattern/pattern.h"
#include "core/project/project.h"

namespace toile::create {

/// Name in the library of the fabric that garments of such a name are usually made of: a T-shirt of a jersey,
/// trousers of a twill. Where the name tells nothing, a hood and ribs tell of a sweatshirt, a neckband
/// without a collar of a jersey, and pieces named as trouser legs with no torso among them tell of trousers,
/// and so do `legs` that shapes tell; else the shirting.
std::string garment_fabric(const std::string& name, const std::vector<std::string>& pieces,
                           bool legs = false);

/// Name of the fabric of a piece that is not cut of the garment's own: a lining, an interlining, a rib.
/// Empty: it is.
std::string piece_fabric(const std::string& piece);

/// Name of the fabric that a pattern's word for it means, in a dozen languages: "JERSEY", "Popeline",
/// "BORD-COTE". Empty where it means none, as "SELF" or "Oberstoff".
std::string material_fabric(const std::string& material);

/// Says all of it in the document. Materials, one per piece or none at all, tell more than names: what most
/// pieces are cut of is the garment's own, and the others have theirs. Without materials, legs that end too
/// narrow for a foot are of a cloth that stretches. `pattern`: the project's pieces.
void choose_fabrics(const pattern::Pattern& pattern, const std::vector<std::string>& materials,
                    project::Project& project);

}  // namespace toile::create
