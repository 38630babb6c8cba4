#pragma once
// Seams that a kept project asks for.

#include <string>

#include "core/pattern/pattern.h"

namespace toile::documents {

/// {"proposals": [{"id", "confidence", "to_wear", "a", "b", "same_direction", "length_a_mm",
/// "length_b_mm"}]}, surest first, between edges that no seam of the document has yet; each as an edit
/// add_seam takes it. Some 0.1 to 2 s.
std::string proposals_json(const pattern::Pattern& pattern);

}  // namespace toile::documents
