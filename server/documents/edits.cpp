#include "server/documents/edits.h"

#include <memory>
#include <utility>
#include <vector>

#include "core/project/editing/edits.h"
#include "core/project/project.h"
#include "server/documents/projects.h"
#include "server/documents/read_cloth.h"

namespace toile::documents {
namespace {

/// A project that edits may be done to: it stands at the revision that was expected.
struct Standing {
  store::ProjectRow row;
  project::Project project;
  std::shared_ptr<const ReadCloth> read;  ///< its cloth, where the text was read lately
};

Result<Standing> standing(Documents& documents, const store::RequestContext& context, const std::string& id,
                          int expected) {
  store::ProjectRow row = TRY(documents.store().project(context, id));
  if (expected != 0 && row.revision != expected) {
    return Error{"store.conflict",
                 "the project has changed since; it is at revision " + std::to_string(row.revision), "",
                 ErrorKind::kStale};
  }
  auto read = kept_cloth(documents, context.owner, row.document, row.files);
  project::Project project = read ? read->project : TRY(project::parse_project(row.document));
  return Standing{std::move(row), std::move(project), std::move(read)};
}

Result<editing::EditedProject> apply(const Standing& at, const std::vector<editing::ProjectEdit>& edits,
                                     resolve::OpenedFiles& files) {
  return editing::apply_edits(at.project, edits, files, at.read ? &at.read->cloth.pattern : nullptr);
}

Result<editing::EditedProject> apply(Documents& documents, const store::RequestContext& context,
                                     const Standing& at, const std::vector<editing::ProjectEdit>& edits) {
  resolve::OpenedFiles files(files_in_store(documents, context, at.row.files));
  return apply(at, edits, files);
}

/// Keeps the project in the store as edited, and what was read of it for whoever asks next. `original`: the
/// text to keep where it is not the one that the edits gave.
Result<store::ProjectRow> keep(Documents& documents, const store::RequestContext& context,
                               const store::ProjectRow& was, editing::EditedProject edited,
                               store::EditStep step, const store::EditRow& edit,
                               const std::string& original = "") {
  store::ProjectRow row = was;
  if (original.empty()) {
    row.document = std::move(edited.document);
  } else {
    row.document = original;
  }
  row.name = edited.project.name;
  store::ProjectRow kept = TRY(documents.store().edit_project(context, row, was.revision, step, edit));
  if (original.empty()) {
    keep_cloth(documents, context.owner, kept.document, kept.files,
               {std::move(edited.read_back), std::move(edited.cloth)});
  }
  return kept;
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

/// Does the edits, as the newest step of the project's history.
Result<store::ProjectRow> do_edits(Documents& documents, const store::RequestContext& context,
                                   const Standing& at, const std::vector<editing::ProjectEdit>& edits,
                                   resolve::OpenedFiles& files) {
  editing::EditedProject edited = TRY(apply(at, edits, files));
  TRY(check_pictures(documents, context, at.row.files, edits));
  store::EditRow step;
  step.edits = json::write_json_line(editing::edits_json(edits));
  step.inverse = json::write_json_line(editing::edits_json(edited.inverse));
  if (project::write_project_line(at.project) != at.row.document) step.original = at.row.document;
  return keep(documents, context, at.row, std::move(edited), store::EditStep::kDo, step);
}

}  // namespace

Result<store::ProjectRow> edit_project(Documents& documents, const store::RequestContext& context,
                                       const std::string& id, const json::JsonValue& edits, int expected,
                                       const ProjectFileMap& more_files) {
  Standing at = TRY(standing(documents, context, id, expected));
  TRY(check_more_files(documents, context, at.row.files, more_files));
  at.row.files.insert(more_files.begin(), more_files.end());
  const std::vector<editing::ProjectEdit> wanted = TRY(editing::read_edits(edits, "/edits"));
  resolve::OpenedFiles files(files_in_store(documents, context, at.row.files));
  return do_edits(documents, context, at, wanted, files);
}

Result<store::ProjectRow> change_project(Documents& documents, const store::RequestContext& context,
                                         const std::string& id, int expected, const ProjectChange& change) {
  Standing at = TRY(standing(documents, context, id, expected));
  const auto files = std::make_shared<ProjectFileMap>(at.row.files);  // a change may add to it
  resolve::OpenedFiles opened(growing_files_in_store(documents, context, files));
  const project::Project wanted = TRY(change(at.project, *files, opened));
  if (wanted == at.project) return std::move(at.row);
  TRY(check_more_files(documents, context, at.row.files, *files));
  at.row.files.insert(files->begin(), files->end());
  // Through JSON, as a stranger's: so that a change can do no more than an edit may.
  const std::vector<editing::ProjectEdit> difference{editing::edit_between(at.project, wanted)};
  const std::vector<editing::ProjectEdit> edits =
      TRY(editing::read_edits(editing::edits_json(difference), "/edits"));
  return do_edits(documents, context, at, edits, opened);
}

Result<store::ProjectRow> undo_edit(Documents& documents, const store::RequestContext& context,
                                    const std::string& id, int expected) {
  const Standing at = TRY(standing(documents, context, id, expected));
  const store::EditRow step = TRY(next_step(documents, context, id, store::EditStep::kUndo));
  const std::vector<editing::ProjectEdit> inverse = TRY(kept_edits(step.inverse, id));
  editing::EditedProject edited = TRY(apply(documents, context, at, inverse));
  return keep(documents, context, at.row, std::move(edited), store::EditStep::kUndo, step, step.original);
}

Result<store::ProjectRow> redo_edit(Documents& documents, const store::RequestContext& context,
                                    const std::string& id, int expected) {
  const Standing at = TRY(standing(documents, context, id, expected));
  const store::EditRow step = TRY(next_step(documents, context, id, store::EditStep::kRedo));
  const std::vector<editing::ProjectEdit> edits = TRY(kept_edits(step.edits, id));
  editing::EditedProject edited = TRY(apply(documents, context, at, edits));
  return keep(documents, context, at.row, std::move(edited), store::EditStep::kRedo, step);
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
