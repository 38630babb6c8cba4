// /api/v1/projects.

#include <charconv>
#include <optional>
#include <utility>

#include "proto/cpp/names.h"
#include "server/documents/projects.h"
#include "server/documents/views.h"
#include "server/http/handlers/answer.h"
#include "server/http/handlers/api.h"
#include "server/http/problem.h"

namespace toile {
namespace {

constexpr std::size_t kMostDocumentBytes = std::size_t{4} << 20;
/// What stands around a document in a request: the names of its files.
constexpr std::size_t kMostRequestBytes = kMostDocumentBytes + kSmallBody;

std::vector<JsonMember> project_members(const ProjectRow& project) {
  std::vector<JsonMember> files;
  for (const auto& [name, id] : project.files) files.push_back({name, id});
  return {{"id", project.id},
          {"name", project.name},
          {"revision", static_cast<double>(project.revision)},
          {"created_ms", static_cast<double>(project.created_ms)},
          {"updated_ms", static_cast<double>(project.updated_ms)},
          {"files", std::move(files)}};
}

std::string etag_of(const ProjectRow& project) {
  std::string tag = "\"";  // one append after the other: GCC 12 warns about "…" + a temporary
  tag += std::to_string(project.revision);
  return tag += '"';
}

HttpResponse project_answer(const ProjectRow& project) {
  HttpResponse response = json_answer(200, project_members(project), "document", project.document);
  response.headers.emplace_back("ETag", etag_of(project));
  return response;
}

struct Given {
  std::string document;
  ProjectFileMap files;
};

/// Puts `name` into a document in place of the one it has.
void rename_document(JsonValue& document, const JsonValue& name) {
  auto& members = std::get<std::vector<JsonMember>>(document.data);
  std::erase_if(members, [](const JsonMember& member) { return member.key == "name"; });
  members.push_back({"name", name});
}

/// {"document": {…}, "files": {name: asset id}, "name": replaces the document's own}.
Result<Given> read_given(const HttpRequest& request) {
  Result<JsonValue> tree =
      read_object(request, {"name", "document", "files"}, {.bytes = kMostRequestBytes, .depth = 32});
  if (!tree) return tree.error();
  const JsonValue* document = tree->find("document");
  if (!document || !document->object()) {
    return Error{"request.document", "\"document\" is the project's document, a JSON object", "/document"};
  }
  JsonValue whole = *document;
  if (const JsonValue* name = tree->find("name")) rename_document(whole, *name);
  Given given;
  given.document = write_json_line(whole);
  const JsonValue* files = tree->find("files");
  if (!files) return given;
  if (!files->object())
    return Error{"request.files", "\"files\" is an object of file name to asset id", "/files"};
  for (const JsonMember& file : *files->object()) {
    if (!file.value.text()) {
      return Error{"request.files", "a file stands for the id of an asset", pointer_to("/files", file.key)};
    }
    given.files[file.key] = *file.value.text();
  }
  return given;
}

/// The place of an error in the document, as a place in the request.
Error in_request(Error error) {
  const bool elsewhere = error.code == "documents.unknown_asset" || error.code == "documents.too_many_files";
  if (!elsewhere && error.where.starts_with('/')) error.where = "/document" + error.where;
  return error;
}

HttpResponse create(const Api& api, const HttpRequest& request) {
  const Result<Given> given = read_given(request);
  if (!given) return problem(given.error());
  const Result<Made<ProjectRow>> project = create_project(api.store, kLocalOwner, given->document,
                                                          given->files, request.header("idempotency-key"));
  if (!project) return problem(in_request(project.error()));
  return made_answer(project_answer(*project), project->anew, "/api/v1/projects/" + project->id);
}

HttpResponse list(const Api& api, const HttpRequest& request) {
  const Result<Page> page = read_page(request);
  if (!page) return problem(400, page.error());
  Result<std::vector<ProjectRow>> rows = api.store.projects(kLocalOwner, page->cursor, page->limit + 1);
  if (!rows) return problem(rows.error());
  return page_answer("projects", *page, std::move(*rows),
                     [](const ProjectRow& row) { return JsonValue(project_members(row)); });
}

HttpResponse show(const Api& api, const HttpRequest& request) {
  const Result<ProjectRow> project = api.store.project(kLocalOwner, request.captures[0]);
  if (!project) return problem(project.error());
  HttpResponse response = project_answer(*project);
  if (request.header("if-none-match") != etag_of(*project)) return response;
  response.status = 304;
  response.content_type.clear();
  response.body.clear();
  return response;
}

/// The revision of If-Match: 0 for "*"; nothing when it is no revision of ours.
std::optional<int> matched_revision(std::string_view tag) {
  if (tag == "*") return 0;
  if (tag.size() < 3 || tag.front() != '"' || tag.back() != '"') return std::nullopt;
  int revision = 0;
  const char* const end = tag.data() + tag.size() - 1;
  const auto [stop, failure] = std::from_chars(tag.data() + 1, end, revision);
  if (failure != std::errc() || stop != end || revision < 1) return std::nullopt;
  return revision;
}

HttpResponse stale() {
  return problem(412, {"store.conflict", "the project has changed since; read it again", "If-Match"});
}

HttpResponse replace(const Api& api, const HttpRequest& request) {
  const std::string tag = request.header("if-match");
  if (tag.empty()) {
    return problem(428, {"request.if_match", "say which revision this replaces: If-Match with the ETag, or *",
                         "If-Match"});
  }
  const std::optional<int> revision = matched_revision(tag);
  if (!revision) return stale();
  const Result<Given> given = read_given(request);
  if (!given) return problem(given.error());
  const Result<ProjectRow> project =
      replace_project(api.store, kLocalOwner, request.captures[0], given->document, given->files, *revision);
  if (project) return project_answer(*project);
  return project.error().code == "store.conflict" ? stale() : problem(in_request(project.error()));
}

/// Without If-Match whichever revision there is.
HttpResponse remove(const Api& api, const HttpRequest& request) {
  const std::string tag = request.header("if-match");
  const std::optional<int> revision = matched_revision(tag.empty() ? "*" : tag);
  if (!revision) return stale();
  const Status removed = api.store.remove_project(kLocalOwner, request.captures[0], *revision);
  if (!removed) return removed.error().code == "store.conflict" ? stale() : problem(removed.error());
  HttpResponse response;
  response.status = 204;
  return response;
}

HttpResponse pieces(const Api& api, const HttpRequest& request) {
  const Result<ProjectRow> project = api.store.project(kLocalOwner, request.captures[0]);
  if (!project) return problem(project.error());
  const Result<std::string> view =
      pieces_json(project->document, files_in_store(api.store, kLocalOwner, project->files));
  if (!view) return problem(view.error());
  HttpResponse response = json_answer(200, *view);
  response.headers.emplace_back("ETag", etag_of(*project));
  return response;
}

Route document_route(const char* method, const char* pattern, HttpHandler handler) {
  Route route{.method = method, .pattern = pattern, .handler = std::move(handler)};
  route.body = BodyKind::kJson;
  route.limit = [](const HttpRequest&) { return kMostRequestBytes; };
  route.heavy = true;
  return route;
}

}  // namespace

void add_project_routes(Router& router, const Api& api) {
  constexpr const char* kAll = "/api/v1/projects";
  constexpr const char* kOne = "/api/v1/projects/{id}";
  router.add(document_route("POST", kAll, [&api](const HttpRequest& r) { return create(api, r); }));
  router.add(document_route("PUT", kOne, [&api](const HttpRequest& r) { return replace(api, r); }));
  router.add(
      {.method = "GET", .pattern = kAll, .handler = [&api](const HttpRequest& r) { return list(api, r); }});
  router.add(
      {.method = "GET", .pattern = kOne, .handler = [&api](const HttpRequest& r) { return show(api, r); }});
  router.add({.method = "DELETE", .pattern = kOne, .handler = [&api](const HttpRequest& r) {
                return remove(api, r);
              }});
  Route view{.method = "GET",
             .pattern = "/api/v1/projects/{id}/pieces",
             .handler = [&api](const HttpRequest& r) { return pieces(api, r); }};
  view.heavy = true;
  router.add(std::move(view));
}

}  // namespace toile
