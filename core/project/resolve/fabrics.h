#pragma once
// The fabrics of a document, and which piece is made of which.

#include "core/base/result.h"
#include "core/drape/drape_input.h"
#include "core/project/project.h"

namespace toile::resolve {

/// What the piece is made of: its own fabric's name, or the project's. Empty: neither says one.
const std::string& fabric_name(const project::Project& project, const project::ProjectPiece& piece);

/// Sets fabrics and fabric_of_panel: the document's fabrics, then those of the library that pieces name, then
/// one more for each piece that has its own. Errors: project.unknown_fabric, project.unstable_fabric,
/// project.missing_key (a piece of no fabric).
Status add_fabrics(const project::Project& project, drape::DrapeInput& input);

}  // namespace toile::resolve
