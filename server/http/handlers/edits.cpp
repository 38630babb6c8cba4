// /api/v1/projects/{id}/edits, undo, redo and proposals; /api/v1/imports.

#include "server/documents/edits.h"
#include "core/base/text.h"

#include <utility>

#include "server/documents/imports.h"
#include "server/documents/projects.h"
#include "server/documents/proposals.h"
#include "server/http/handlers/answer.h"
#include "server/http/handlers/api.h"
#include "server/http/handlers/project_answer.h"
#include "server/http/problem.h"

namespace toile {
namespace {

HttpResponse answer(const Result<ProjectRow>& project) {
  return project ? project_answer(*project) : revision_problem(project.error());
}

HttpResponse edit(const Api& api, const RequestContext& context, const HttpRequest& request) {
  const Result<int> revision = required_revision(request);
  if (!revision) return revision_problem(revision.error());
  const Result<JsonValue> tree =
      read_object(request, {"edits", "files"}, {.bytes = kMostRequestBytes, .depth = 32});
  if (!tree) return problem(tree.error());
  const JsonValue* edits = tree->find("edits");
  if (!edits) return problem({"request.edits", "\"edits\" is a list of edits", "/edits"});
  const Result<ProjectFileMap> files = read_files(*tree);
  if (!files) return problem(files.error());
  return answer(edit_project(api.documents, context, request.captures[0], *edits, *revision, *files));
}

HttpResponse undo(const Api& api, const RequestContext& context, const HttpRequest& request) {
  const Result<int> revision = required_revision(request);
  if (!revision) return revision_problem(revision.error());
  return answer(undo_edit(api.documents, context, request.captures[0], *revision));
}

HttpResponse redo(const Api& api, const RequestContext& context, const HttpRequest& request) {
  const Result<int> revision = required_revision(request);
  if (!revision) return revision_problem(revision.error());
  return answer(redo_edit(api.documents, context, request.captures[0], *revision));
}

HttpResponse history(const Api& api, const RequestContext& context, const HttpRequest& request) {
  const Result<Page> page = read_page(request);
  if (!page) return problem(400, page.error());
  std::int64_t before = 0;
  if (!page->cursor.empty()) {
    before = number_in<std::int64_t>(page->cursor).value_or(0);
    if (before < 1)
      return problem(
          {"store.cursor", "the cursor is not one that a list gave", "cursor", ErrorKind::kMalformed});
  }
  Result<std::string> text = history_json(api.documents, context, request.captures[0], before, page->limit);
  return text ? json_answer(200, std::move(*text)) : problem(text.error());
}

HttpResponse proposals(const Api& api, const RequestContext& context, const HttpRequest& request) {
  const Result<ProjectRow> project = api.store.project(context, request.captures[0]);
  if (!project) return problem(project.error());
  const ProjectFiles files = files_in_store(api.documents, context, project->files);
  const Result<std::string> text = proposals_json(project->document, files);
  if (!text) return problem(text.error());
  HttpResponse response = json_answer(200, *text);
  response.headers.emplace_back("ETag", etag_of(*project));
  return response;
}

/// The text under a key, empty when there is none. Error: request.import.
Result<std::string> text_of(const JsonValue& tree, const char* key) {
  const JsonValue* value = tree.find(key);
  if (!value) return std::string();
  if (const std::string* text = value->text()) return *text;
  return Error{"request.import", "this is a text in quotes", pointer_to("", key)};
}

HttpResponse import(const Api& api, const RequestContext& context, const HttpRequest& request) {
  const Result<JsonValue> tree =
      read_object(request, {"asset", "unit", "size"}, {.bytes = kSmallBody, .depth = 4});
  if (!tree) return problem(tree.error());
  const Result<std::string> asset = text_of(*tree, "asset"), unit = text_of(*tree, "unit"),
                            size = text_of(*tree, "size");
  for (const Result<std::string>* text : {&asset, &unit, &size})
    if (!*text) return problem(text->error());
  if (asset->empty()) return problem({"request.import", "\"asset\" is the id of an uploaded file", "/asset"});
  Result<std::string> report = import_pattern(api.documents, context, *asset, {*unit, *size});
  return report ? json_answer(200, std::move(*report)) : problem(report.error());
}

}  // namespace

ApiRoutes edit_routes() {
  constexpr const char* kEdits = "/api/v1/projects/{id}/edits";
  return {
      document_route("POST", kEdits, edit),
      {.pattern = kEdits, .handler = history},
      {.method = "POST", .pattern = "/api/v1/projects/{id}/undo", .handler = undo, .heavy = true},
      {.method = "POST", .pattern = "/api/v1/projects/{id}/redo", .handler = redo, .heavy = true},
      {.pattern = "/api/v1/projects/{id}/proposals", .handler = proposals, .heavy = true},
      {.method = "POST",
       .pattern = "/api/v1/imports",
       .handler = import,
       .body = BodyKind::kJson,
       .heavy = true},
  };
}

}  // namespace toile
