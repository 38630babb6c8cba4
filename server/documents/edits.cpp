#include "server/documents/edits.h"

#include <utility>
#include <vector>

#include "core/project/editing/edits.h"
#include "core/project/project.h"
#include "server/documents/projects.h"

namespace toile::documents {
namespace {

/// A project that edits may be done to: it stands at the revision that was expected.
struct Standing {
  store::ProjectRow row;
  project::Project project;
};

Result<Standing> standing(Documents& documents, const store::RequestContext& context, const std::string& id,
                          int expected) {
  store::ProjectRow row = TRY(documents.store().project(context, id));
  if (expected != 0 && row.revision != expected) {
    return Error{"store.conflict",
                 "the project has changed since; it is at revision " + std::to_string(row.revision), "",
                 ErrorKind::kStale};
  }
  project::Project project = TRY(project::parse_project(row.document));
  return Standing{std::move(row), std::move(project)};
}

Result<editing::EditedProject> apply_in_store(Documents& documents, const store::RequestContext& context,
                                              const Standing& at,
                                              const std::vector<editing::ProjectEdit>& edits) {
  return editing::apply_edits(at.project, edits, files_in_store(documents, context, at.row.files));
}

Result<store::ProjectRow> keep(Documents& documents, const store::RequestContext& context,
                               const store::ProjectRow& was, std::string document, const std::string& name,
                               store::EditStep step, const store::EditRow& edit) {
  store::ProjectRow row = was;
  row.document = std::move(document);
  row.name = name;
  return documents.store().edit_project(context, row, was.revision, step, edit);
}

/// The edits of a row, as this program wrote them.
Result<std::vector<editing::ProjectEdit>> kept_edits(const std::string& text, const std::string& id) {
  const Result<json::JsonValue> tree = json::parse_json(text, {.bytes = text.size(), .depth = 64});
  if (tree) {
    Result<std::vector<editing::ProjectEdit>> edits = editing::read_edits(*tree, "/edits");
    if (edits) return edits;
  }
  return Error{"store.corrupt", "a step of the project's history is damaged", id, ErrorKind::kSystem};
}

Result<store::EditRow> next_step(Documents& documents, const store::RequestContext& context,
                                 const std::string& id, store::EditStep step) {
  std::optional<store::EditRow> next = TRY(documents.store().next_edit(context, id, step));
  if (next) return std::move(*next);
  if (step == store::EditStep::kUndo)
    return Error{"edit.nothing_to_undo", "there is nothing to undo", "", ErrorKind::kConflict};
  return Error{"edit.nothing_to_redo", "nothing has been undone that could be done again", "",
               ErrorKind::kConflict};
}

/// Whether the pictures that the edits put on pieces are there.
Status check_pictures(Documents& documents, const store::RequestContext& context, const ProjectFileMap& files,
                      const std::vector<editing::ProjectEdit>& edits) {
  for (std::size_t i = 0; i < edits.size(); ++i) {
    const auto* const edit = std::get_if<editing::SetTexture>(&edits[i]);
    if (edit == nullptr || !edit->texture) continue;
    const std::string texture = json::pointer_to(json::pointer_to("/edits", i), "texture");
    TRY(check_image(documents, context, files, edit->texture->image, json::pointer_to(texture, "image")));
  }
  return {};
}

}  // namespace

Result<store::ProjectRow> edit_project(Documents& documents, const store::RequestContext& context,
                                       const std::string& id, const json::JsonValue& edits, int expected,
                                       const ProjectFileMap& more_files) {
  Standing at = TRY(standing(documents, context, id, expected));
  TRY(check_more_files(documents, context, at.row.files, more_files));
  at.row.files.insert(more_files.begin(), more_files.end());
  const std::vector<editing::ProjectEdit> wanted = TRY(editing::read_edits(edits, "/edits"));
  editing::EditedProject edited = TRY(apply_in_store(documents, context, at, wanted));
  TRY(check_pictures(documents, context, at.row.files, wanted));
  store::EditRow step;
  step.edits = json::write_json_line(editing::edits_json(wanted));
  step.inverse = json::write_json_line(editing::edits_json(edited.inverse));
  if (project::write_project_line(at.project) != at.row.document) step.original = at.row.document;
  return keep(documents, context, at.row, std::move(edited.document), edited.project.name,
              store::EditStep::kDo, step);
}

Result<store::ProjectRow> change_project(Documents& documents, const store::RequestContext& context,
                                         const std::string& id, int expected, const ProjectChange& change) {
  Standing at = TRY(standing(documents, context, id, expected));
  ProjectFileMap files = at.row.files;
  const project::Project wanted = TRY(change(at.project, files));
  if (wanted == at.project) return std::move(at.row);
  const std::vector<editing::ProjectEdit> edits{editing::edit_between(at.project, wanted)};
  return edit_project(documents, context, id, editing::edits_json(edits), at.row.revision, files);
}

Result<store::ProjectRow> undo_edit(Documents& documents, const store::RequestContext& context,
                                    const std::string& id, int expected) {
  const Standing at = TRY(standing(documents, context, id, expected));
  const store::EditRow step = TRY(next_step(documents, context, id, store::EditStep::kUndo));
  const std::vector<editing::ProjectEdit> inverse = TRY(kept_edits(step.inverse, id));
  const editing::EditedProject edited = TRY(apply_in_store(documents, context, at, inverse));
  const std::string& document = step.original.empty() ? edited.document : step.original;
  return keep(documents, context, at.row, document, edited.project.name, store::EditStep::kUndo, step);
}

Result<store::ProjectRow> redo_edit(Documents& documents, const store::RequestContext& context,
                                    const std::string& id, int expected) {
  const Standing at = TRY(standing(documents, context, id, expected));
  const store::EditRow step = TRY(next_step(documents, context, id, store::EditStep::kRedo));
  const std::vector<editing::ProjectEdit> edits = TRY(kept_edits(step.edits, id));
  editing::EditedProject edited = TRY(apply_in_store(documents, context, at, edits));
  return keep(documents, context, at.row, std::move(edited.document), edited.project.name,
              store::EditStep::kRedo, step);
}

Result<std::string> history_json(Documents& documents, const store::RequestContext& context,
                                 const std::string& id, std::int64_t before, int limit) {
  TRY(documents.store().project(context, id));
  std::vector<store::EditRow> steps = TRY(documents.store().edits(context, id, before, limit + 1));
  std::string next = "null", items;
  if (steps.size() > static_cast<std::size_t>(limit)) {
    steps.pop_back();
    next = "\"" + std::to_string(steps.back().number) + "\"";
  }
  for (const store::EditRow& step : steps) {
    items += items.empty() ? "" : ", ";
    items += "{\"number\": " + std::to_string(step.number);
    items += step.undone ? ", \"undone\": true" : ", \"undone\": false";
    items += ", \"created_ms\": " + std::to_string(step.created_ms) + ", \"edits\": " + step.edits + "}";
  }
  return "{\"edits\": [" + items + "], \"next\": " + next + "}\n";
}

}  // namespace toile::documents
