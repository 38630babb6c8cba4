#pragma once
// What a garment is made of that only its names tell of.

#include <string>
#include <vector>

#include "core/project/project.h"

namespace toile::create {

/// Name in the library of the fabric that garments of such a name are usually made of: a T-shirt of a jersey,
/// trousers of a twill. Where the name tells nothing, a neckband without a collar tells of a jersey, and
/// pieces named as trouser legs with no torso among them tell of trousers; else the shirting.
std::string garment_fabric(const std::string& name, const std::vector<std::string>& pieces);

/// Name of the fabric of a piece that is not cut of the garment's own: a lining, an interlining. Empty: it
/// is.
std::string piece_fabric(const std::string& piece);

/// Says both in the document.
void choose_fabrics(project::Project& project);

}  // namespace toile::create
