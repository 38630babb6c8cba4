// Edits ↔ JSON.

#include <algorithm>
#include <type_traits>
#include <utility>

#include "core/base/names.h"
#include "core/json/fields/reader.h"
#include "core/json/fields/schema.h"
#include "core/json/fields/writer.h"
#include "core/project/editing/edits.h"
#include "core/project/editing/fields.h"
#include "core/project/schema.h"

namespace toile::editing {
namespace {

constexpr const char* kKind = "edit";

/// Calls `act` with each NamedEdit.
template <typename Act>
void for_each_edit(Act act) {
  std::apply([&](const auto&... named) { (act(named), ...); }, fields::kEditNames);
}

template <typename Edit>
ProjectEdit project_edit(Edit edit) {
  if constexpr (std::is_constructible_v<edit::PatternEdit, Edit>) {
    return edit::PatternEdit(std::move(edit));
  } else {
    return edit;
  }
}

/// The object without its kind, which is no field of the edit.
json::JsonValue without_kind(const json::JsonValue& object) {
  std::vector<json::JsonMember> members = *object.object();
  std::erase_if(members, [](const json::JsonMember& member) { return member.key == kKind; });
  return members;
}

Result<ProjectEdit> read_edit(const json::JsonValue& value, const std::string& where) {
  const json::JsonValue* kind = value.find(kKind);
  const std::string* name = kind ? kind->text() : nullptr;
  if (!name) {
    return Error{"edit.unknown", "an edit is an object that says in \"edit\" which it is",
                 kind ? json::pointer_to(where, kKind) : where};
  }
  const json::JsonValue fields_only = without_kind(value);
  std::optional<ProjectEdit> edit;
  std::optional<Error> error;
  for_each_edit([&](const auto& named) {
    if (*name != named.name) return;
    typename std::decay_t<decltype(named)>::Type one{};
    fields::read(fields::FieldPlace{fields_only, where, error}, one, fields::kAnything);
    edit = project_edit(std::move(one));
  });
  if (error) return *std::move(error);
  if (edit) return *std::move(edit);
  return Error{"edit.unknown", "there is no edit " + in_quotes(*name) + "; " + advice(*name, edit_names()),
               json::pointer_to(where, kKind)};
}

template <typename Edit>
json::JsonValue edit_json(Edit edit) {
  std::vector<json::JsonMember> members;
  for_each_edit([&](const auto& named) {
    if constexpr (std::is_same_v<typename std::decay_t<decltype(named)>::Type, Edit>) {
      members.push_back({kKind, std::string(named.name)});
    }
  });
  const json::JsonValue own = fields::json_of(edit);
  members.insert(members.end(), own.object()->begin(), own.object()->end());
  return members;
}

}  // namespace

Result<std::vector<ProjectEdit>> read_edits(const json::JsonValue& list, const std::string& where) {
  const auto* elements = list.array();
  if (!elements) return Error{"project.wrong_type", "this must be a list of edits", where};
  if (elements->size() > kMostEdits) {
    return Error{"edit.too_many", "at most " + std::to_string(kMostEdits) + " edits go at a time", where};
  }
  std::vector<ProjectEdit> edits;
  for (std::size_t i = 0; i < elements->size(); ++i) {
    ProjectEdit edit = TRY(read_edit((*elements)[i], json::pointer_to(where, i)));
    edits.push_back(std::move(edit));
  }
  return edits;
}

json::JsonValue edits_json(std::span<const ProjectEdit> edits) {
  std::vector<json::JsonValue> list;
  for (const ProjectEdit& edit : edits) {
    const auto write = [&](const auto& one) { list.push_back(edit_json(one)); };
    if (const auto* of_pattern = std::get_if<edit::PatternEdit>(&edit)) {
      std::visit(write, *of_pattern);
    } else if (const auto* texture = std::get_if<SetTexture>(&edit)) {
      write(*texture);
    } else if (const auto* physical = std::get_if<SetPhysical>(&edit)) {
      write(*physical);
    } else if (const auto* solver = std::get_if<SetSolver>(&edit)) {
      write(*solver);
    } else if (const auto* time = std::get_if<SetMaxTime>(&edit)) {
      write(*time);
    } else {
      write(std::get<RestoreLists>(edit));
    }
  }
  return list;
}

std::vector<std::string> edit_names() {
  std::vector<std::string> names;
  for_each_edit([&](const auto& named) { names.emplace_back(named.name); });
  return names;
}

json::JsonValue edit_schema() {
  const fields::Definitions of_projects = project::project_definitions();
  fields::Definitions definitions(of_projects, "project.schema.json");
  std::vector<json::JsonValue> kinds;
  for_each_edit([&](const auto& named) {
    typename std::decay_t<decltype(named)>::Type edit{};
    kinds.push_back(definitions.refer(named.name, [&] {
      fields::SchemaWriter writer(definitions);
      writer.constant(kKind, "Which edit this is.", named.name);
      describe(writer, edit);
      return writer.schema();
    }));
  });
  const json::JsonValue list = fields::list_schema(std::vector<json::JsonMember>{{"oneOf", std::move(kinds)}},
                                                   {0, static_cast<double>(kMostEdits)});
  return fields::schema_file(
      "Toile edits",
      "Edits of a project, one after the other: in requests, in the undo history and in a replay.", list,
      definitions);
}

}  // namespace toile::editing
