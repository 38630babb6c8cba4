// /api/v1/shared: what whoever has a share link sees of its job. Nobody is known here: each handler asks the
// link's secret first, and then does what it does as the link's owner, for that one job and nothing else.

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "server/accounts/secrets.h"
#include "server/documents/assets.h"
#include "server/documents/read_cloth.h"
#include "server/documents/seen_pieces.h"
#include "server/http/handlers/answer.h"
#include "server/http/handlers/api.h"
#include "server/http/handlers/job_views.h"
#include "server/http/handlers/link_answer.h"
#include "server/http/identify.h"
#include "server/http/problem.h"
#include "server/http/static_files.h"
#include "server/ws/job_message.h"

namespace toile::handlers {
namespace {

/// Somebody who looks on.
struct Visit {
  store::RequestContext context;  ///< of the job's owner, but with no scope: nothing can be changed by it
  std::shared_ptr<const store::LinkRow> link;
  store::JobRow job;
};
using Shown = std::function<http::HttpResponse(const Visit&)>;

http::HttpResponse gone(Error error) {
  error.kind = ErrorKind::kNotFound;
  return http::problem(410, error);
}

http::HttpResponse refused(const accounts::Opened& opened) {
  if (opened.over) return gone(opened.link.error());
  return http::not_let_in(opened.link.error(), opened.unknown, opened.wait);
}

http::HttpResponse with_link(const Api& api, const store::RequestContext& asked, store::LinkRow opened,
                             const std::string& hash, const Shown& show) {
  Visit visit;
  visit.context = store::RequestContext(opened.owner, asked.request_id, asked.log.with("link", opened.id));
  visit.context.scopes = {};
  visit.context.key = hash;
  visit.context.given_up = asked.given_up;
  visit.link = std::make_shared<const store::LinkRow>(std::move(opened));
  visit.context.link = visit.link;
  Result<store::JobRow> job = api.store.job(visit.context, visit.link->job);
  if (!job && job.error().kind == ErrorKind::kNotFound)
    return gone({"links.removed", "what this link showed has been removed by its owner", ""});
  if (!job) return http::problem(job.error());
  visit.job = std::move(*job);
  http::HttpResponse response = show(visit);
  // Why something of the owner's cannot be read names what is theirs.
  if (response.status == 422 || response.status == 500)
    response = http::problem(response.status, {"links.not_shown", "this part of it cannot be shown", ""});
  for (auto& [name, value] : response.headers)
    if (name == "Cache-Control") value = "private, no-cache";  // until it is taken back, and no longer
  return response;
}

/// To whom shows the secret of the link that the address names.
http::HttpResponse visited(const Api& api, const store::RequestContext& asked,
                           const http::HttpRequest& request, const Shown& show) {
  const std::string& id = request.captures[0];
  const std::string secret = http::link_secret_of(request, id, api.link_door->secure);
  const accounts::Opened opened = api.link_door->gate.open(secret, request.sender);
  if (!opened.link) return refused(opened);
  if (opened.link->id == id)
    return with_link(api, asked, *opened.link, accounts::hash_of_secret(secret), show);
  return http::not_let_in({"links.unknown", "this is for whoever has another link", ""}, true, {});
}

/// The request as one for the job itself.
http::HttpRequest for_job(const http::HttpRequest& request, const Visit& visit) {
  http::HttpRequest inner = request;
  inner.captures[0] = visit.job.id;
  return inner;
}

http::HttpResponse not_to_take() {
  return http::problem(403, {"links.take", "whoever shared this does not give it away", ""});
}

std::vector<json::JsonValue> stills_of(const store::JobRow& job) {
  std::vector<json::JsonValue> names;
  if (!store::is_final(job.state)) return names;
  for (const auto& [name, file] : job.results)
    if (name.ends_with(".png")) names.emplace_back(name);
  return names;
}

http::HttpResponse shown(const Api& api, const Visit& visit) {
  const bool ended = store::is_final(visit.job.state);
  // Of the job itself, as it is known by: its progress is found under its own id.
  std::vector<json::JsonMember> now = job_members_now(api, visit.context, visit.job);
  json::JsonValue progress;
  for (json::JsonMember& member : now)
    if (member.key == "progress") progress = std::move(member.value);
  std::vector<json::JsonMember> members = ws::job_members(store::shown_by(*visit.link, visit.job));
  members.push_back({"progress", std::move(progress)});
  members.push_back({"label", visit.link->label});
  members.push_back({"expires_ms", static_cast<double>(visit.link->expires_ms)});
  members.push_back({"take", takes_list(visit.link->takes)});
  members.push_back({"stills", stills_of(visit.job)});
  members.push_back({"cloth", ended && visit.job.results.contains("final.obj")});
  return json_answer(200, std::move(members), "report",
                     visit.job.report.empty() || !ended ? "null" : visit.job.report);
}

/// A link's secret against a cookie for its addresses, for browsers, whose pictures and streams show no
/// token.
http::HttpResponse open(const Api& api, const store::RequestContext& asked,
                        const http::HttpRequest& request) {
  const Result<json::JsonValue> given = read_object(request, {"secret"}, kStrangerLimits);
  if (!given) return http::problem(given.error());
  const json::JsonValue* found = given->find("secret");
  const std::string secret = found && found->text() ? *found->text() : "";
  const accounts::Opened opened = api.link_door->gate.open(secret, request.sender);
  if (!opened.link) return refused(opened);
  return with_link(api, asked, *opened.link, accounts::hash_of_secret(secret), [&](const Visit& visit) {
    http::HttpResponse response = shown(api, visit);
    response.headers.emplace_back("Set-Cookie",
                                  http::link_cookie(visit.link->id, api.link_door->secure, secret));
    return response;
  });
}

http::HttpResponse show_shared(const Api& api, const store::RequestContext& asked,
                               const http::HttpRequest& request) {
  return visited(api, asked, request, [&](const Visit& visit) { return shown(api, visit); });
}

/// final.obj: whoever sees the cloth has its shape.
http::HttpResponse cloth(const Api& api, const store::RequestContext& asked,
                         const http::HttpRequest& request) {
  return visited(api, asked, request, [&](const Visit& visit) {
    http::HttpRequest inner = for_job(request, visit);
    inner.captures.emplace_back("final.obj");
    return job_result(api, visit.context, inner);
  });
}

http::HttpResponse shared_pieces(const Api& api, const store::RequestContext& asked,
                                 const http::HttpRequest& request) {
  return visited(api, asked, request,
                 [&](const Visit& visit) { return job_pieces(api, visit.context, for_job(request, visit)); });
}

/// A picture that is on a piece.
http::HttpResponse picture(const Api& api, const store::RequestContext& asked,
                           const http::HttpRequest& request) {
  return visited(api, asked, request, [&](const Visit& visit) -> http::HttpResponse {
    const std::string& name = request.captures[1];
    const auto read =
        documents::read_cloth(api.documents, visit.context, visit.job.document, visit.job.files);
    if (!read) return http::problem(read.error());
    const std::vector<std::string> worn = documents::seen_pieces(**read).pictures;
    const auto file = visit.job.files.find(name);
    if (std::find(worn.begin(), worn.end(), name) == worn.end() || file == visit.job.files.end())
      return http::problem({"store.not_found", "there is no such picture on it", "", ErrorKind::kNotFound});
    const Result<std::string> path = api.store.asset_path(visit.context, file->second);
    if (!path) return http::problem(path.error());
    http::HttpResponse response = file_answer_from(*path, "application/octet-stream", name);
    constexpr std::size_t kOpening = 16;
    if (response.file) response.content_type = documents::image_media_type(response.file->read(0, kOpening));
    response.headers.emplace_back("Cache-Control", "no-cache");
    return response;
  });
}

http::HttpResponse shared_body(const Api& api, const store::RequestContext& asked,
                               const http::HttpRequest& request) {
  return visited(api, asked, request,
                 [&](const Visit& visit) { return job_body(api, visit.context, for_job(request, visit)); });
}

http::HttpResponse result(const Api& api, const store::RequestContext& asked,
                          const http::HttpRequest& request) {
  return visited(api, asked, request, [&](const Visit& visit) {
    if (!store::may_take(visit.link->takes, request.captures[1])) return not_to_take();
    return job_result(api, visit.context, for_job(request, visit));
  });
}

http::HttpResponse small_still(const Api& api, const store::RequestContext& asked,
                               const http::HttpRequest& request) {
  return visited(api, asked, request, [&](const Visit& visit) {
    if (!request.captures[1].ends_with(".png")) return not_to_take();
    return small_job_result(api, visit.context, for_job(request, visit));
  });
}

http::HttpResponse report(const Api& api, const store::RequestContext& asked,
                          const http::HttpRequest& request) {
  return visited(api, asked, request, [&](const Visit& visit) {
    if (!visit.link->takes.report) return not_to_take();
    return job_report_page(api, visit.context, for_job(request, visit));
  });
}

/// Before the upgrade. A page of another site might make a browser bring the cookie along.
http::HttpResponse stream_shared(const Api& api, const store::RequestContext& asked,
                                 const http::HttpRequest& request) {
  return visited(api, asked, request, [&](const Visit& visit) {
    if (request.header("authorization").empty() && request.header("origin").empty())
      return http::problem(403,
                           {"http.origin", "with a cookie a request says whose page it is of", "Origin"});
    store::RequestContext context = visit.context;
    context.link = api.link_door->gate.seat(*visit.link);
    if (!context.link)
      return http::problem({"links.viewers",
                            "as many look on by this link as there is room for; try again later", "",
                            ErrorKind::kTooMany});
    http::HttpResponse response;
    response.watched = std::make_shared<const http::Watched>(http::Watched{std::move(context), visit.job.id});
    return response;
  });
}

ApiRoute look(const char* pattern,
              http::HttpResponse (*handler)(const Api&, const store::RequestContext&,
                                            const http::HttpRequest&),
              http::Work work = http::Work::kStore) {
  return {.pattern = pattern, .handler = handler, .work = work, .access = http::Access::kOpen};
}

}  // namespace

ApiRoutes shared_routes() {
  ApiRoutes routes{
      look("/api/v1/shared/{id}", show_shared),
      look("/api/v1/shared/{id}/cloth", cloth),
      look("/api/v1/shared/{id}/pieces", shared_pieces, http::Work::kDocument),
      look("/api/v1/shared/{id}/pictures/{name}", picture, http::Work::kDocument),
      look("/api/v1/shared/{id}/body", shared_body, http::Work::kHeavy),
      look("/api/v1/shared/{id}/results/{name}", result),
      look("/api/v1/shared/{id}/results/{name}/small", small_still, http::Work::kDocument),
      look("/api/v1/shared/{id}/report", report, http::Work::kDocument),
      look("/api/v1/shared/{id}/stream", stream_shared),
  };
  for (ApiRoute& route : routes) {
    if (std::string_view(route.pattern).ends_with("/small")) route.parameters = {"width"};
    if (std::string_view(route.pattern).ends_with("/stream")) route.websocket = true;
  }
  routes.push_back({.method = "POST",
                    .pattern = "/api/v1/shared",
                    .handler = open,
                    .body = http::BodyKind::kJson,
                    .limit = [](const http::HttpRequest&) { return kStrangerBytes; },
                    .access = http::Access::kOpen});
  return routes;
}

}  // namespace toile::handlers
