// Bodies: size tables, figures made from measures, what the tape says of uploads, and who a project dresses.

#include <utility>

#include "server/documents/dress.h"
#include "server/documents/figures.h"
#include "server/documents/landmarks.h"
#include "server/documents/projects.h"
#include "server/documents/views.h"
#include "server/http/handlers/answer.h"
#include "server/http/handlers/api.h"
#include "server/http/handlers/asset_answer.h"
#include "server/http/handlers/project_answer.h"
#include "server/http/problem.h"

namespace toile::handlers {
namespace {

http::HttpResponse presets(const Api&, const store::RequestContext&, const http::HttpRequest&) {
  return json_answer(200, documents::body_presets_json());
}

http::HttpResponse make_body(const Api& api, const store::RequestContext& context,
                             const http::HttpRequest& request) {
  const Result<json::JsonValue> tree =
      read_object(request, {"mannequin", "name"}, {.bytes = http::kSmallBody, .depth = 8});
  if (!tree) return http::problem(tree.error());
  const json::JsonValue* mannequin = tree->find("mannequin");
  if (!mannequin) return http::problem({"request.body", "\"mannequin\" says what it measures", "/mannequin"});
  std::string name = "mannequin.obj";
  if (const json::JsonValue* given = tree->find("name")) {
    if (!given->text()) return http::problem({"request.body", "this is a text in quotes", "/name"});
    name = *given->text();
  }
  Result<documents::MadeBody> made = documents::make_body(api.documents, context, *mannequin, name);
  if (!made) return http::problem(made.error());
  std::vector<json::JsonMember> members = std::move(made->figure);
  return created(json_answer(201, std::move(members), "asset", asset_json(made->asset)),
                 "/api/v1/assets/" + made->asset.id);
}

http::HttpResponse figure(const Api& api, const store::RequestContext& context,
                          const http::HttpRequest& request) {
  Result<std::string> text = documents::asset_figure_json(api.documents, context, request.captures[0]);
  return text ? json_answer(200, std::move(*text)) : http::problem(text.error());
}

http::HttpResponse bodies(const Api& api, const store::RequestContext& context,
                          const http::HttpRequest& request) {
  const Result<store::ProjectRow> project = api.store.project(context, request.captures[0]);
  if (!project) return http::problem(project.error());
  Result<std::string> text = documents::project_bodies_json(
      api.documents, project->document, documents::files_in_store(api.documents, context, project->files));
  if (!text) return http::problem(text.error());
  http::HttpResponse response = json_answer(200, std::move(*text));
  response.headers.emplace_back("ETag", etag_of(*project));
  return response;
}

http::HttpResponse project_body(const Api& api, const store::RequestContext& context,
                                const http::HttpRequest& request) {
  const Result<store::ProjectRow> project = api.store.project(context, request.captures[0]);
  if (!project) return http::problem(project.error());
  Result<std::string> bytes = documents::body_bytes(
      project->document, documents::files_in_store(api.documents, context, project->files));
  if (!bytes) return http::problem(bytes.error());
  http::HttpResponse response = file_answer(std::move(*bytes), "application/octet-stream", "body.bin");
  response.headers.emplace_back("Cache-Control", "no-cache");
  response.headers.emplace_back("ETag", etag_of(*project));
  return response;
}

http::HttpResponse dress(const Api& api, const store::RequestContext& context,
                         const http::HttpRequest& request) {
  const Result<int> revision = required_revision(request);
  if (!revision) return revision_problem(revision.error());
  const Result<json::JsonValue> wish =
      json::parse_json(request.body, {.bytes = http::kSmallBody, .depth = 8});
  if (!wish) return http::problem(wish.error());
  const Result<store::ProjectRow> project = documents::dress_project(
      api.documents, context, request.captures[0], request.captures[1], *wish, *revision);
  return project ? project_answer(*project) : revision_problem(project.error());
}

http::HttpResponse undress(const Api& api, const store::RequestContext& context,
                           const http::HttpRequest& request) {
  const Result<int> revision = required_revision(request);
  if (!revision) return revision_problem(revision.error());
  const Result<store::ProjectRow> project =
      documents::undress_project(api.documents, context, request.captures[0], request.captures[1], *revision);
  return project ? project_answer(*project) : revision_problem(project.error());
}

http::HttpResponse mark(const Api& api, const store::RequestContext& context,
                        const http::HttpRequest& request) {
  const Result<int> revision = required_revision(request);
  if (!revision) return revision_problem(revision.error());
  const Result<json::JsonValue> tree =
      read_object(request, {"place"}, {.bytes = http::kSmallBody, .depth = 8});
  if (!tree) return http::problem(tree.error());
  const json::JsonValue* given = tree->find("place");
  const auto* list = given ? given->array() : nullptr;
  Vec3 place;
  double* const at[] = {&place.x, &place.y, &place.z};
  for (std::size_t k = 0; k < 3; ++k) {
    const double* number = list && list->size() == 3 ? (*list)[k].number() : nullptr;
    if (!number)
      return http::problem({"request.landmark", "\"place\" is a list of three numbers, metres", "/place"});
    *at[k] = *number;
  }
  const Result<store::ProjectRow> project =
      documents::move_landmark(api.documents, context, request.captures[0], request.captures[1],
                               request.captures[2], place, *revision);
  return project ? project_answer(*project) : revision_problem(project.error());
}

http::HttpResponse unmark(const Api& api, const store::RequestContext& context,
                          const http::HttpRequest& request) {
  const Result<int> revision = required_revision(request);
  if (!revision) return revision_problem(revision.error());
  const Result<store::ProjectRow> project = documents::forget_landmark(
      api.documents, context, request.captures[0], request.captures[1], request.captures[2], *revision);
  return project ? project_answer(*project) : revision_problem(project.error());
}

}  // namespace

ApiRoutes body_routes() {
  constexpr const char* kOne = "/api/v1/projects/{id}/bodies/{body}";
  constexpr const char* kLandmark = "/api/v1/projects/{id}/bodies/{body}/landmarks/{landmark}";
  return {
      {.pattern = "/api/v1/bodies/presets", .handler = presets},
      {.method = "POST",
       .pattern = "/api/v1/bodies/mannequins",
       .handler = make_body,
       .body = http::BodyKind::kJson,
       .work = http::Work::kHeavy},
      {.pattern = "/api/v1/bodies/{id}/figure", .handler = figure, .work = http::Work::kHeavy},
      {.pattern = "/api/v1/projects/{id}/bodies", .handler = bodies, .work = http::Work::kHeavy},
      {.pattern = "/api/v1/projects/{id}/body", .handler = project_body, .work = http::Work::kHeavy},
      {.method = "PUT",
       .pattern = kOne,
       .handler = dress,
       .body = http::BodyKind::kJson,
       .work = http::Work::kHeavy},
      {.method = "DELETE", .pattern = kOne, .handler = undress, .work = http::Work::kHeavy},
      {.method = "PUT",
       .pattern = kLandmark,
       .handler = mark,
       .body = http::BodyKind::kJson,
       .work = http::Work::kHeavy},
      {.method = "DELETE", .pattern = kLandmark, .handler = unmark, .work = http::Work::kHeavy},
  };
}

}  // namespace toile::handlers
