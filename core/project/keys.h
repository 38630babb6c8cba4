#pragma once
// The document's keys as a flat list, for whoever must agree with the reader: the schema.

#include <vector>

#include "core/json/fields/lister.h"

namespace toile {

/// Every key that parse_project knows.
std::vector<fields::FieldKey> project_keys();

}  // namespace toile
