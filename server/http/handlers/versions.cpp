// /api/v1/projects/{id}/versions: states of a project that were named, and the way back to them.

#include "server/documents/versions.h"

#include <utility>
#include <vector>

#include "core/base/check.h"
#include "server/http/handlers/answer.h"
#include "server/http/handlers/api.h"
#include "server/http/handlers/project_answer.h"
#include "server/http/problem.h"

namespace toile::handlers {
namespace {

store::Versions& versions_in(const Api& api) {
  store::Versions* const versions = store::versions_of(api.store);
  TOILE_CHECK(versions != nullptr);
  return *versions;
}

std::vector<json::JsonMember> members_of(const store::ToldVersion& told) {
  std::vector<json::JsonValue> jobs;
  for (const std::string& job : told.jobs) jobs.emplace_back(job);
  return {{"id", told.version.id},
          {"name", told.version.name},
          {"revision", static_cast<double>(told.version.revision)},
          {"created_ms", static_cast<double>(told.version.created_ms)},
          {"current", told.current},
          {"jobs", std::move(jobs)}};
}

http::HttpResponse list_versions(const Api& api, const store::RequestContext& context,
                                 const http::HttpRequest& request) {
  const Result<std::vector<store::ToldVersion>> told =
      versions_in(api).versions(context, request.captures[0]);
  if (!told) return http::problem(told.error());
  std::vector<json::JsonValue> versions;
  for (const store::ToldVersion& one : *told) versions.emplace_back(members_of(one));
  return json_answer(200, {{"versions", std::move(versions)}});
}

http::HttpResponse name(const Api& api, const store::RequestContext& context,
                        const http::HttpRequest& request) {
  const Result<int> revision = required_revision(request);
  if (!revision) return revision_problem(revision.error());
  const Result<json::JsonValue> given =
      read_object(request, {"name"}, {.bytes = http::kSmallBody, .depth = 4});
  if (!given) return http::problem(given.error());
  const json::JsonValue* const text = given->find("name");
  if (!text || !text->text())
    return http::problem(422, {"versions.name", "\"name\" is a text: what the version is called", "/name"});
  const std::string& project = request.captures[0];
  const Result<store::VersionRow> made =
      documents::name_version(api.documents, context, project, *text->text(), *revision);
  if (!made) return revision_problem(made.error());
  // As the list has it, with drapes that there may be of it already.
  const Result<std::vector<store::ToldVersion>> told = versions_in(api).versions(context, project);
  if (!told) return http::problem(told.error());
  for (const store::ToldVersion& one : *told)
    if (one.version.id == made->id)
      return created(json_answer(200, members_of(one)),
                     "/api/v1/projects/" + project + "/versions/" + made->id);
  return http::problem({"store.not_found", "the version is gone already", "", ErrorKind::kNotFound});
}

http::HttpResponse restore(const Api& api, const store::RequestContext& context,
                           const http::HttpRequest& request) {
  const Result<int> revision = required_revision(request);
  if (!revision) return revision_problem(revision.error());
  const Result<store::ProjectRow> project =
      documents::restore_version(api.documents, context, request.captures[0], request.captures[1], *revision);
  return project ? project_answer(*project) : revision_problem(project.error());
}

http::HttpResponse remove_version(const Api& api, const store::RequestContext& context,
                                  const http::HttpRequest& request) {
  const Status gone = versions_in(api).remove_version(context, request.captures[0], request.captures[1]);
  return gone ? no_content() : http::problem(gone.error());
}

}  // namespace

ApiRoutes version_routes() {
  constexpr const char* kVersions = "/api/v1/projects/{id}/versions";
  return {
      {.pattern = kVersions, .handler = list_versions},
      {.method = "POST",
       .pattern = kVersions,
       .handler = name,
       .body = http::BodyKind::kJson,
       .work = http::Work::kDocument},
      {.method = "POST",
       .pattern = "/api/v1/projects/{id}/versions/{version}/restore",
       .handler = restore,
       .work = http::Work::kDocument},
      {.method = "DELETE", .pattern = "/api/v1/projects/{id}/versions/{version}", .handler = remove_version},
  };
}

}  // namespace toile::handlers
