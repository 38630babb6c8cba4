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

HttpResponse edit(const Api& api, const HttpRequest& request) {
  const Result<int> revision = required_revision(request);
  if (!revision) return revision_problem(revision.error());
  const Result<JsonValue> tree =
      read_object(request, {"edits", "files"}, {.bytes = kMostRequestBytes, .depth = 32});
  if (!tree) return problem(tree.error());
  const JsonValue* edits = tree->find("edits");
  if (!edits) return problem({"request.edits", "\"edits\" is a list of edits", "/edits"});
  const Result<ProjectFileMap> files = read_files(*tree);
  if (!files) return problem(files.error());
  return answer(edit_project(api.store, kLocalOwner, request.captures[0], *edits, *revision, *files));
}

using Turn = Result<ProjectRow> (*)(Store&, const OwnerId&, const std::string&, int);

HttpResponse turn(const Api& api, const HttpRequest& request, Turn act) {
  const Result<int> revision = required_revision(request);
  if (!revision) return revision_problem(revision.error());
  return answer(act(api.store, kLocalOwner, request.captures[0], *revision));
}

HttpResponse history(const Api& api, const HttpRequest& request) {
  const Result<Page> page = read_page(request);
  if (!page) return problem(400, page.error());
  std::int64_t before = 0;
  if (!page->cursor.empty()) {
    before = number_in<std::int64_t>(page->cursor).value_or(0);
    if (before < 1)
      return problem(
          {"store.cursor", "the cursor is not one that a list gave", "cursor", ErrorKind::kMalformed});
  }
  Result<std::string> text = history_json(api.store, kLocalOwner, request.captures[0], before, page->limit);
  return text ? json_answer(200, std::move(*text)) : problem(text.error());
}

HttpResponse proposals(const Api& api, const HttpRequest& request) {
  const Result<ProjectRow> project = api.store.project(kLocalOwner, request.captures[0]);
  if (!project) return problem(project.error());
  const ProjectFiles files = files_in_store(api.store, kLocalOwner, project->files);
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

HttpResponse import(const Api& api, const HttpRequest& request) {
  const Result<JsonValue> tree =
      read_object(request, {"asset", "unit", "size"}, {.bytes = kSmallBody, .depth = 4});
  if (!tree) return problem(tree.error());
  const Result<std::string> asset = text_of(*tree, "asset"), unit = text_of(*tree, "unit"),
                            size = text_of(*tree, "size");
  for (const Result<std::string>* text : {&asset, &unit, &size})
    if (!*text) return problem(text->error());
  if (asset->empty()) return problem({"request.import", "\"asset\" is the id of an uploaded file", "/asset"});
  Result<std::string> report = import_pattern(api.store, kLocalOwner, *asset, {*unit, *size});
  return report ? json_answer(200, std::move(*report)) : problem(report.error());
}

}  // namespace

void add_edit_routes(Router& router, const Api& api) {
  router.add(document_route("POST", "/api/v1/projects/{id}/edits",
                            [&api](const HttpRequest& r) { return edit(api, r); }));
  router.add({.method = "GET",
              .pattern = "/api/v1/projects/{id}/edits",
              .handler = [&api](const HttpRequest& r) { return history(api, r); }});
  const auto add_turn = [&](const char* pattern, Turn act) {
    Route route{.method = "POST", .pattern = pattern, .handler = [&api, act](const HttpRequest& r) {
                  return turn(api, r, act);
                }};
    route.heavy = true;
    router.add(std::move(route));
  };
  add_turn("/api/v1/projects/{id}/undo", undo_edit);
  add_turn("/api/v1/projects/{id}/redo", redo_edit);
  Route look{.method = "GET",
             .pattern = "/api/v1/projects/{id}/proposals",
             .handler = [&api](const HttpRequest& r) { return proposals(api, r); }};
  look.heavy = true;
  router.add(std::move(look));
  Route imports{.method = "POST", .pattern = "/api/v1/imports", .handler = [&api](const HttpRequest& r) {
                  return import(api, r);
                }};
  imports.body = BodyKind::kJson;
  imports.heavy = true;
  router.add(std::move(imports));
}

}  // namespace toile
