#pragma once
// The format of fabric files as JSON Schema: what proto/schema/fabric.schema.json holds.

#include "core/json/tree.h"

namespace toile::fabric {

/// The whole file, made of the fields that the reader reads by.
json::JsonValue fabric_schema();

}  // namespace toile::fabric
