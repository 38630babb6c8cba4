// Where the pieces of a project stand, and what the look at them before a drape finds.

#include "server/documents/arrangement.h"

#include <utility>

#include "server/documents/starts.h"
#include "server/http/handlers/answer.h"
#include "server/http/handlers/api.h"
#include "server/http/handlers/project_answer.h"
#include "server/http/problem.h"

namespace toile::handlers {
namespace {

http::HttpResponse arrange_all(const Api& api, const store::RequestContext& context,
                               const http::HttpRequest& request) {
  const Result<int> revision = required_revision(request);
  if (!revision) return revision_problem(revision.error());
  const Result<documents::ArrangedProject> made =
      documents::arrange_project(api.documents, context, request.captures[0], *revision);
  if (!made) return revision_problem(made.error());
  std::vector<json::JsonMember> members = project_members(made->project);
  members.push_back({"arrangement", made->arrangement});
  http::HttpResponse response = json_answer(200, std::move(members), "document", made->project.document);
  response.headers.emplace_back("ETag", etag_of(made->project));
  return response;
}

http::HttpResponse place_one(const Api& api, const store::RequestContext& context,
                             const http::HttpRequest& request) {
  const Result<int> revision = required_revision(request);
  if (!revision) return revision_problem(revision.error());
  const Result<json::JsonValue> tree = read_object(
      request, {"piece", "part", "side", "at_mm", "away_mm", "turn", "wrapped", "flipped", "with_partner"},
      {.bytes = http::kSmallBody, .depth = 8});
  if (!tree) return http::problem(tree.error());
  const Result<documents::PieceWish> wish = documents::read_piece_wish(*tree);
  if (!wish) return http::problem(wish.error());
  const Result<store::ProjectRow> project =
      documents::place_piece(api.documents, context, request.captures[0], *wish, *revision);
  return project ? project_answer(*project) : revision_problem(project.error());
}

/// The start of the project that a request names, and the project.
struct ShownStart {
  store::ProjectRow project;
  std::shared_ptr<const documents::StartView> start;
};

Result<ShownStart> shown_start(const Api& api, const store::RequestContext& context,
                               const http::HttpRequest& request) {
  store::ProjectRow project = TRY(api.store.project(context, request.captures[0]));
  const auto start = TRY(documents::start_of(api.documents, context, project));
  return ShownStart{std::move(project), start};
}

http::HttpResponse check(const Api& api, const store::RequestContext& context,
                         const http::HttpRequest& request) {
  const Result<ShownStart> at = shown_start(api, context, request);
  if (!at) return http::problem(at.error());
  http::HttpResponse response = json_answer(200, at->start->check);
  response.headers.emplace_back("ETag", etag_of(at->project));
  return response;
}

http::HttpResponse start(const Api& api, const store::RequestContext& context,
                         const http::HttpRequest& request) {
  const Result<ShownStart> at = shown_start(api, context, request);
  if (!at) return http::problem(at.error());
  http::HttpResponse response = file_answer(at->start->geometry, "application/octet-stream", "start.bin");
  response.headers.emplace_back("Cache-Control", "no-cache");
  response.headers.emplace_back("ETag", etag_of(at->project));
  return response;
}

}  // namespace

ApiRoutes arrangement_routes() {
  return {
      {.method = "POST",
       .pattern = "/api/v1/projects/{id}/arrange",
       .handler = arrange_all,
       .work = http::Work::kHeavy},
      {.method = "POST",
       .pattern = "/api/v1/projects/{id}/place",
       .handler = place_one,
       .body = http::BodyKind::kJson,
       .work = http::Work::kHeavy},
      {.pattern = "/api/v1/projects/{id}/check", .handler = check, .work = http::Work::kHeavy},
      {.pattern = "/api/v1/projects/{id}/start", .handler = start, .work = http::Work::kHeavy},
  };
}

}  // namespace toile::handlers
