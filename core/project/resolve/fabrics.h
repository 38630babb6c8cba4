#pragma once
// The fabrics of a document, and which piece is made of which.

#include "core/base/result.h"
#include "core/drape/drape_input.h"
#include "core/project/project.h"

namespace toile::resolve {

/// Sets fabrics and fabric_of_panel: the document's fabrics, then one more for each piece that has its own.
/// Errors: project.unknown_fabric, project.unstable_fabric.
Status add_fabrics(const project::Project& project, drape::DrapeInput& input);

}  // namespace toile::resolve
