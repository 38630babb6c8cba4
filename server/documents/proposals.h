#pragma once
// Seams that a kept project asks for.

#include <string>

#include "core/base/result.h"
#include "core/project/resolve/resolve.h"

namespace toile::documents {

/// {"proposals": [{"id", "confidence", "a", "b", "same_direction", "length_a_mm", "length_b_mm"}]}, surest
/// first, between edges that no seam of the document has yet; each as an edit add_seam takes it. Some 0.1 to
/// 2 s. Errors: json.*, project.*, dxf.*, pattern.*, … as reading the project gives them.
Result<std::string> proposals_json(const std::string& document, const resolve::ProjectFiles& files);

}  // namespace toile::documents
