#pragma once
// The document's format as JSON Schema: what proto/schema/project.schema.json holds.

#include "core/json/fields/schema.h"
#include "core/json/tree.h"

namespace toile::project {

/// The whole file, made of the fields that the reader reads by.
json::JsonValue project_schema();

/// What it defines, for schemas beside it that refer to its objects.
fields::Definitions project_definitions();

}  // namespace toile::project
