#include "core/manifest/manifest.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "core/base/hash.h"
#include "core/drape/checkpoint.h"
#include "core/json/fields/reader.h"
#include "core/json/fields/schema.h"
#include "core/json/fields/writer.h"
#include "core/manifest/fields.h"

namespace toile::manifest {

FileMark mark_of(std::string name, std::string_view bytes) {
  return {std::move(name), static_cast<double>(bytes.size()), hash_of(bytes)};
}

FileMark mark_of(std::string name, const project::Project& project) {
  return mark_of(std::move(name), std::string_view(project::write_project_line(project)));
}

Maker this_program(std::string hash) {
  return {TOILE_VERSION, static_cast<int>(drape::kCheckpointVersion), std::move(hash)};
}

std::string write_manifest(const Manifest& manifest) {
  Manifest copy = manifest;  // a visitor takes places, and writes to none of them here
  return json::write_json(fields::json_of(copy));
}

Result<Manifest> parse_manifest(std::string_view text) {
  const auto damaged = [](const Error& error) {
    return Error{"manifest.damaged", error.message, error.where, ErrorKind::kInput};
  };
  const Result<json::JsonValue> tree = json::parse_json(text);
  if (!tree) return damaged(tree.error());
  Manifest manifest;
  std::optional<Error> error;
  fields::read(fields::FieldPlace{*tree, "", error}, manifest, fields::kAnything);
  if (error) return damaged(*error);
  return manifest;
}

json::JsonValue manifest_schema() {
  fields::Definitions definitions;
  const json::JsonValue schema = fields::schema_of(Manifest{}, fields::kAnything, definitions);
  return fields::schema_file("Toile manifest", "", schema, definitions);
}

Comparison compare(const std::vector<FileMark>& expected, const std::vector<FileMark>& found) {
  std::map<std::string, const FileMark*> there;
  for (const FileMark& file : found) there[file.name] = &file;
  Comparison out;
  for (const FileMark& file : expected) {
    const auto at = there.find(file.name);
    if (at == there.end()) {
      out.missing.push_back(file.name);
      continue;
    }
    (*at->second == file ? out.same : out.changed).push_back(file.name);
    there.erase(at);
  }
  for (const auto& [name, file] : there) out.added.push_back(name);
  return out;
}

}  // namespace toile::manifest
