#include "core/project/schema.h"

#include "core/project/fields.h"

namespace toile::project {

json::JsonValue project_schema() {
  fields::Definitions definitions;
  const json::JsonValue schema = fields::schema_of(Project{}, fields::kAnything, definitions);
  return fields::schema_file("Toile project", "", schema, definitions);
}

fields::Definitions project_definitions() {
  fields::Definitions definitions;
  fields::schema_of(Project{}, fields::kAnything, definitions);
  return definitions;
}

}  // namespace toile::project
