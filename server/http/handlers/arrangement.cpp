// Where the pieces of a project stand, and what the look at them before a drape finds.

#include "server/documents/arrangement.h"

#include <utility>

#include "server/documents/starts.h"
#include "server/http/handlers/answer.h"
#include "server/http/handlers/api.h"
#include "server/http/handlers/project_answer.h"
#include "server/http/problem.h"

namespace toile {
namespace {

HttpResponse arrange_all(const Api& api, const RequestContext& context, const HttpRequest& request) {
  const Result<int> revision = required_revision(request);
  if (!revision) return revision_problem(revision.error());
  const Result<ArrangedProject> made =
      arrange_project(api.documents, context, request.captures[0], *revision);
  if (!made) return revision_problem(made.error());
  std::vector<JsonMember> members = project_members(made->project);
  members.push_back({"arrangement", made->arrangement});
  HttpResponse response = json_answer(200, std::move(members), "document", made->project.document);
  response.headers.emplace_back("ETag", etag_of(made->project));
  return response;
}

HttpResponse place_one(const Api& api, const RequestContext& context, const HttpRequest& request) {
  const Result<int> revision = required_revision(request);
  if (!revision) return revision_problem(revision.error());
  const Result<JsonValue> tree =
      read_object(request, {"piece", "part", "side", "at_mm", "away_mm", "turn", "wrapped", "with_partner"},
                  {.bytes = kSmallBody, .depth = 8});
  if (!tree) return problem(tree.error());
  const Result<PieceWish> wish = read_piece_wish(*tree);
  if (!wish) return problem(wish.error());
  const Result<ProjectRow> project =
      place_piece(api.documents, context, request.captures[0], *wish, *revision);
  return project ? project_answer(*project) : revision_problem(project.error());
}

/// The start of the project that a request names, and the project.
struct Shown {
  ProjectRow project;
  std::shared_ptr<const StartView> start;
};

Result<Shown> shown(const Api& api, const RequestContext& context, const HttpRequest& request) {
  ProjectRow project = TRY(api.store.project(context, request.captures[0]));
  const auto start = TRY(start_of(api.documents, context, project));
  return Shown{std::move(project), start};
}

HttpResponse check(const Api& api, const RequestContext& context, const HttpRequest& request) {
  const Result<Shown> at = shown(api, context, request);
  if (!at) return problem(at.error());
  HttpResponse response = json_answer(200, at->start->check);
  response.headers.emplace_back("ETag", etag_of(at->project));
  return response;
}

HttpResponse start(const Api& api, const RequestContext& context, const HttpRequest& request) {
  const Result<Shown> at = shown(api, context, request);
  if (!at) return problem(at.error());
  HttpResponse response = file_answer(at->start->geometry, "application/octet-stream", "start.bin");
  response.headers.emplace_back("Cache-Control", "no-cache");
  response.headers.emplace_back("ETag", etag_of(at->project));
  return response;
}

}  // namespace

ApiRoutes arrangement_routes() {
  return {
      {.method = "POST", .pattern = "/api/v1/projects/{id}/arrange", .handler = arrange_all, .heavy = true},
      {.method = "POST",
       .pattern = "/api/v1/projects/{id}/place",
       .handler = place_one,
       .body = BodyKind::kJson,
       .heavy = true},
      {.pattern = "/api/v1/projects/{id}/check", .handler = check, .heavy = true},
      {.pattern = "/api/v1/projects/{id}/start", .handler = start, .heavy = true},
  };
}

}  // namespace toile
