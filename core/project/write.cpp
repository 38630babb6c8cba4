// Project → document text, by the same list of fields that the reader uses.

#include <optional>
#include <string>
#include <utility>

#include "core/json/fields/reader.h"
#include "core/json/fields/writer.h"
#include "core/json/tree.h"
#include "core/project/fields.h"
#include "core/project/project.h"

namespace toile::project {
namespace {

json::JsonValue tree_of(const Project& project) {
  Project copy = project;  // a visitor takes places, and writes to none of them here
  return fields::json_of(copy);
}

}  // namespace

std::string write_project(const Project& project) { return json::write_json(tree_of(project)); }

std::string write_project_line(const Project& project) { return json::write_json_line(tree_of(project)); }

Result<WrittenProject> write_checked(const Project& project) {
  const json::JsonValue tree = tree_of(project);
  WrittenProject written{json::write_json_line(tree), {}};
  TRY(json::check_size(written.line, json::JsonLimits{}));
  std::optional<Error> error;
  fields::read(fields::FieldPlace{tree, "", error}, written.read_back, fields::kAnything);
  if (error) return *std::move(error);
  return written;
}

}  // namespace toile::project
