// Document text → Project.

#include "core/json/fields/reader.h"
#include "core/json/tree.h"
#include "core/project/fields.h"
#include "core/project/project.h"

namespace toile::project {

Result<Project> parse_project(std::string_view text) {
  const json::JsonValue tree = TRY(json::parse_json(text));
  if (!tree.object()) return Error{"project.wrong_type", "a project document is a JSON object", ""};
  const json::JsonValue* version = tree.find("toile");
  if (!version) {
    return Error{"project.version", "this is no project document: it does not begin with \"toile\": 1", ""};
  }
  if (!version->number() || *version->number() != 1) {
    return Error{"project.version", "this program reads version 1 of the format only", "/toile"};
  }
  std::optional<Error> error;
  Project project;
  fields::read(fields::FieldPlace{tree, "", error}, project, fields::kAnything);
  if (error) return *std::move(error);
  return project;
}

}  // namespace toile::project
