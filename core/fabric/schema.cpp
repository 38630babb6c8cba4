#include "core/fabric/schema.h"

#include "core/fabric/fields.h"
#include "core/json/fields/schema.h"

namespace toile::fabric {

json::JsonValue fabric_schema() {
  fields::Definitions definitions;
  const json::JsonValue schema = fields::schema_of(FabricCard{}, fields::kAnything, definitions);
  return fields::schema_file("Toile fabric", "", schema, definitions);
}

}  // namespace toile::fabric
