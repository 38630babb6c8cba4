// /api/v1/projects.

#include <utility>

#include "core/base/names.h"
#include "server/documents/projects.h"
#include "server/documents/views.h"
#include "server/http/handlers/answer.h"
#include "server/http/handlers/api.h"
#include "server/http/handlers/project_answer.h"
#include "server/http/problem.h"
#include "server/http/url.h"

namespace toile::handlers {
namespace {

struct Given {
  std::string document;
  documents::ProjectFileMap files;
};

/// Puts `name` into a document in place of the one it has.
void rename_document(json::JsonValue& document, const json::JsonValue& name) {
  auto& members = std::get<std::vector<json::JsonMember>>(document.data);
  std::erase_if(members, [](const json::JsonMember& member) { return member.key == "name"; });
  members.push_back({"name", name});
}

/// {"document": {…}, "files": {name: asset id}, "name": replaces the document's own}.
Result<Given> read_given(const http::HttpRequest& request) {
  const json::JsonValue tree =
      TRY(read_object(request, {"name", "document", "files"}, {.bytes = kMostRequestBytes, .depth = 32}));
  const json::JsonValue* document = tree.find("document");
  if (!document || !document->object()) {
    return Error{"request.document", "\"document\" is the project's document, a JSON object", "/document"};
  }
  json::JsonValue whole = *document;
  if (const json::JsonValue* name = tree.find("name")) rename_document(whole, *name);
  Given given;
  given.document = json::write_json_line(whole);
  given.files = TRY(read_files(tree));
  return given;
}

http::HttpResponse create(const Api& api, const store::RequestContext& context,
                          const http::HttpRequest& request) {
  const Result<Given> given = read_given(request);
  if (!given) return http::problem(given.error());
  const Result<store::Made<store::ProjectRow>> project = documents::create_project(
      api.documents, context, given->document, given->files, request.header("idempotency-key"));
  if (!project) return http::problem(project.error());
  return made_answer(project_answer(*project), project->anew, "/api/v1/projects/" + project->id);
}

http::HttpResponse list_projects(const Api& api, const store::RequestContext& context,
                                 const http::HttpRequest& request) {
  const Result<Page> page = read_page(request);
  if (!page) return http::problem(400, page.error());
  Result<std::vector<store::ProjectRow>> rows = api.store.projects(context, page->cursor, page->limit + 1);
  if (!rows) return http::problem(rows.error());
  return page_answer("projects", *page, std::move(*rows),
                     [](const store::ProjectRow& row) { return json::JsonValue(project_members(row)); });
}

http::HttpResponse show_project(const Api& api, const store::RequestContext& context,
                                const http::HttpRequest& request) {
  const Result<store::ProjectRow> project = api.store.project(context, request.captures[0]);
  if (!project) return http::problem(project.error());
  http::HttpResponse response = project_answer(*project);
  if (!http::names_tag(request.header("if-none-match"), etag_of(*project))) return response;
  response.status = 304;
  response.content_type.clear();
  response.body.clear();
  return response;
}

http::HttpResponse replace(const Api& api, const store::RequestContext& context,
                           const http::HttpRequest& request) {
  const Result<int> revision = required_revision(request);
  if (!revision) return revision_problem(revision.error());
  const Result<Given> given = read_given(request);
  if (!given) return http::problem(given.error());
  const Result<store::ProjectRow> project = documents::replace_project(
      api.documents, context, request.captures[0], given->document, given->files, *revision);
  return project ? project_answer(*project) : revision_problem(project.error());
}

/// Jobs of a project that is gone, and files that nobody else uses. What stays for some reason (another
/// project uses the file) is no error.
Status remove_data(const Api& api, const store::RequestContext& context, const store::ProjectRow& project) {
  const std::vector<std::string> jobs = TRY(api.store.jobs_of_project(context, project.id));
  for (const std::string& id : jobs) {
    TRY(api.jobs.remove(context, id));
  }
  for (const auto& [name, id] : project.files) {
    Status removed = api.store.remove_asset(context, id);
    if (removed || removed.error().kind == ErrorKind::kConflict) continue;
    if (removed.error().kind != ErrorKind::kNotFound) return removed;
  }
  return {};
}

/// Error: jobs.state while a job of the project has not ended.
Status check_ended(const Api& api, const store::RequestContext& context, const std::string& project) {
  const std::vector<std::string> jobs = TRY(api.store.jobs_of_project(context, project));
  for (const std::string& id : jobs) {
    const store::JobRow job = TRY(api.store.job(context, id));
    if (store::is_final(job.state)) continue;
    return Error{"jobs.state", "a drape of the project has not ended; cancel it first", id,
                 ErrorKind::kConflict};
  }
  return {};
}

/// Without If-Match whichever revision there is.
http::HttpResponse remove_project(const Api& api, const store::RequestContext& context,
                                  const http::HttpRequest& request) {
  const bool any = request.header("if-match").empty();
  const Result<int> revision = any ? Result<int>(0) : required_revision(request);
  if (!revision) return revision_problem(revision.error());
  const std::string data = request.parameter("data");
  if (!data.empty() && data != "true" && data != "false")
    return http::problem(400, {"request.data", "data is true or false", "data"});
  const Result<store::ProjectRow> project = api.store.project(context, request.captures[0]);
  if (!project) return http::problem(project.error());
  if (data == "true") {
    const Status ended = check_ended(api, context, project->id);
    if (!ended) return http::problem(ended.error());
  }
  const Status removed = api.store.remove_project(context, project->id, *revision);
  if (!removed) return revision_problem(removed.error());
  const Status rest = data == "true" ? remove_data(api, context, *project) : Status();
  return rest ? no_content() : http::problem(rest.error());
}

http::HttpResponse project_pieces(const Api& api, const store::RequestContext& context,
                                  const http::HttpRequest& request) {
  const Result<store::ProjectRow> project = api.store.project(context, request.captures[0]);
  if (!project) return http::problem(project.error());
  const auto read = documents::read_cloth(api.documents, context, project->document, project->files);
  if (!read) return http::problem(read.error());
  http::HttpResponse response = json_answer(200, documents::pieces_json(**read));
  response.headers.emplace_back("ETag", etag_of(*project));
  return response;
}

/// Reads the document with its bodies.
ApiRoute whole_document_route(const char* method, const char* pattern, decltype(ApiRoute::handler) handler) {
  ApiRoute route = document_route(method, pattern, std::move(handler));
  route.work = http::Work::kHeavy;
  return route;
}

}  // namespace

ApiRoutes project_routes() {
  constexpr const char* kAll = "/api/v1/projects";
  constexpr const char* kOne = "/api/v1/projects/{id}";
  return {
      whole_document_route("POST", kAll, create),
      whole_document_route("PUT", kOne, replace),
      {.pattern = kAll, .handler = list_projects, .parameters = kPageParameters},
      {.pattern = kOne, .handler = show_project},
      {.method = "DELETE", .pattern = kOne, .handler = remove_project, .parameters = {"data"}},
      {.pattern = "/api/v1/projects/{id}/pieces", .handler = project_pieces, .work = http::Work::kDocument},
  };
}

}  // namespace toile::handlers
