// /api/v1/projects/{id}/edits, undo, redo and proposals; /api/v1/imports,
// /api/v1/assets/{id}/layers.

#include "server/documents/edits.h"
#include "core/base/text.h"

#include <utility>

#include "server/documents/imports.h"
#include "server/documents/projects.h"
#include "server/documents/proposals.h"
#include "server/documents/read_cloth.h"
#include "server/http/handlers/answer.h"
#include "server/http/handlers/api.h"
#include "server/http/handlers/project_answer.h"
#include "server/http/problem.h"

namespace toile::handlers {
namespace {

http::HttpResponse answer(const Result<store::ProjectRow>& project) {
  return project ? project_answer(*project) : revision_problem(project.error());
}

http::HttpResponse edit(const Api& api, const store::RequestContext& context,
                        const http::HttpRequest& request) {
  const Result<int> revision = required_revision(request);
  if (!revision) return revision_problem(revision.error());
  const Result<json::JsonValue> tree =
      read_object(request, {"edits", "files"}, {.bytes = kMostRequestBytes, .depth = 32});
  if (!tree) return http::problem(tree.error());
  const json::JsonValue* edits = tree->find("edits");
  if (!edits) return http::problem({"request.edits", "\"edits\" is a list of edits", "/edits"});
  const Result<documents::ProjectFileMap> files = read_files(*tree);
  if (!files) return http::problem(files.error());
  return answer(
      documents::edit_project(api.documents, context, request.captures[0], *edits, *revision, *files));
}

http::HttpResponse undo(const Api& api, const store::RequestContext& context,
                        const http::HttpRequest& request) {
  const Result<int> revision = required_revision(request);
  if (!revision) return revision_problem(revision.error());
  return answer(documents::undo_edit(api.documents, context, request.captures[0], *revision));
}

http::HttpResponse redo(const Api& api, const store::RequestContext& context,
                        const http::HttpRequest& request) {
  const Result<int> revision = required_revision(request);
  if (!revision) return revision_problem(revision.error());
  return answer(documents::redo_edit(api.documents, context, request.captures[0], *revision));
}

http::HttpResponse history(const Api& api, const store::RequestContext& context,
                           const http::HttpRequest& request) {
  const Result<Page> page = read_page(request);
  if (!page) return http::problem(400, page.error());
  std::int64_t before = 0;
  if (!page->cursor.empty()) {
    before = number_in<std::int64_t>(page->cursor).value_or(0);
    if (before < 1)
      return http::problem(
          {"store.cursor", "the cursor is not one that a list gave", "cursor", ErrorKind::kMalformed});
  }
  Result<std::string> text =
      documents::history_json(api.documents, context, request.captures[0], before, page->limit);
  return text ? json_answer(200, std::move(*text)) : http::problem(text.error());
}

http::HttpResponse proposals(const Api& api, const store::RequestContext& context,
                             const http::HttpRequest& request) {
  const Result<store::ProjectRow> project = api.store.project(context, request.captures[0]);
  if (!project) return http::problem(project.error());
  const auto read = documents::read_cloth(api.documents, context, project->document, project->files);
  if (!read) return http::problem(read.error());
  http::HttpResponse response = json_answer(200, documents::proposals_json((*read)->cloth.pattern));
  response.headers.emplace_back("ETag", etag_of(*project));
  return response;
}

/// The text under a key, empty when there is none. Error: request.import.
Result<std::string> text_of(const json::JsonValue& tree, const char* key) {
  const json::JsonValue* value = tree.find(key);
  if (!value) return std::string();
  if (const std::string* text = value->text()) return *text;
  return Error{"request.import", "this is a text in quotes", json::pointer_to("", key)};
}

/// "layers" of a request: layer → what it is; none when it is not there. Error: request.import.
Result<std::vector<std::pair<std::string, std::string>>> read_layers(const json::JsonValue& tree) {
  std::vector<std::pair<std::string, std::string>> out;
  const json::JsonValue* layers = tree.find("layers");
  if (!layers) return out;
  if (!layers->object())
    return Error{"request.import", "\"layers\" is an object of layers, each with what it is", "/layers"};
  for (const json::JsonMember& layer : *layers->object()) {
    const std::string* word = layer.value.text();
    if (!word)
      return Error{"request.import", "this is a text in quotes", json::pointer_to("/layers", layer.key)};
    out.emplace_back(layer.key, *word);
  }
  return out;
}

http::HttpResponse import(const Api& api, const store::RequestContext& context,
                          const http::HttpRequest& request) {
  const Result<json::JsonValue> tree =
      read_object(request, {"asset", "unit", "size", "layers"}, {.bytes = http::kSmallBody, .depth = 4});
  if (!tree) return http::problem(tree.error());
  const Result<std::string> asset = text_of(*tree, "asset"), unit = text_of(*tree, "unit"),
                            size = text_of(*tree, "size");
  for (const Result<std::string>* text : {&asset, &unit, &size})
    if (!*text) return http::problem(text->error());
  const auto layers = read_layers(*tree);
  if (!layers) return http::problem(layers.error());
  if (asset->empty())
    return http::problem({"request.import", "\"asset\" is the id of an uploaded file", "/asset"});
  Result<std::string> report =
      documents::import_pattern(api.documents, context, *asset, {*unit, *size, *layers});
  return report ? json_answer(200, std::move(*report)) : http::problem(report.error());
}

http::HttpResponse layers(const Api& api, const store::RequestContext& context,
                          const http::HttpRequest& request) {
  Result<std::string> text = documents::pattern_layers(api.documents, context, request.captures[0]);
  return text ? json_answer(200, std::move(*text)) : http::problem(text.error());
}

}  // namespace

ApiRoutes edit_routes() {
  constexpr const char* kEdits = "/api/v1/projects/{id}/edits";
  return {
      document_route("POST", kEdits, edit),
      {.pattern = kEdits, .handler = history, .parameters = kPageParameters},
      {.method = "POST",
       .pattern = "/api/v1/projects/{id}/undo",
       .handler = undo,
       .work = http::Work::kDocument},
      {.method = "POST",
       .pattern = "/api/v1/projects/{id}/redo",
       .handler = redo,
       .work = http::Work::kDocument},
      {.pattern = "/api/v1/projects/{id}/proposals", .handler = proposals, .work = http::Work::kHeavy},
      {.method = "POST",
       .pattern = "/api/v1/imports",
       .handler = import,
       .body = http::BodyKind::kJson,
       .work = http::Work::kHeavy},
      {.pattern = "/api/v1/assets/{id}/layers", .handler = layers, .work = http::Work::kHeavy},
  };
}

}  // namespace toile::handlers
