// /api/v1/jobs: drapes, their results and what viewers need beside the stream.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/base/names.h"
#include "server/http/handlers/answer.h"
#include "server/http/handlers/api.h"
#include "server/http/handlers/job_tags.h"
#include "server/http/handlers/job_views.h"
#include "server/http/handlers/job_wish.h"
#include "server/http/problem.h"
#include "server/http/static_files.h"
#include "server/ws/job_message.h"

namespace toile::handlers {
namespace {

std::string place_of(const store::JobRow& job) { return "/api/v1/jobs/" + job.id; }

/// Where it stands in a sweep; null: it was asked for by itself.
json::JsonValue cell_json(const store::SweepCell& cell) {
  if (cell.sweep.empty()) return {};
  return std::vector<json::JsonMember>{
      {"id", cell.sweep}, {"body", double(cell.body)}, {"fabric", double(cell.fabric)}};
}

http::HttpResponse job_answer(const Api& api, const store::RequestContext& context,
                              const store::JobRow& job) {
  std::vector<json::JsonMember> members = job_members_now(api, context, job);
  members.push_back({"tags", tags_of(api, context, job.id)});
  members.push_back({"sweep", cell_json(job.cell)});
  return json_answer(200, std::move(members), "report",
                     job.report.empty() || !store::is_final(job.state) ? "null" : job.report);
}

http::HttpResponse submit_job(const Api& api, const store::RequestContext& context,
                              const http::HttpRequest& request) {
  const Result<json::JsonValue> given =
      read_object(request, {"project_id", "priority", "pictures", "anew", "from", "tags"},
                  {.bytes = http::kSmallBody, .depth = 32});
  if (!given) return http::problem(given.error());
  const json::JsonValue* id = given->find("project_id");
  if (!id || !id->text()) {
    return http::problem(422, {"request.project_id", "\"project_id\" is the id of a project", "/project_id"});
  }
  const Result<jobs::JobWish> wish = read_job_wish(*given);
  if (!wish) return http::problem(422, wish.error());
  const Result<store::Made<store::JobRow>> job =
      api.jobs.submit(context, *id->text(), request.header("idempotency-key"), *wish);
  if (job) return made_answer(job_answer(api, context, *job), job->anew, place_of(*job));
  if (job.error().kind != ErrorKind::kNotFound) return http::problem(job.error());
  return http::problem(404, {"store.not_found", "there is no project " + in_quotes(*id->text()),
                             "/project_id", ErrorKind::kNotFound});
}

http::HttpResponse list_jobs(const Api& api, const store::RequestContext& context,
                             const http::HttpRequest& request) {
  const Result<Page> page = read_page(request);
  if (!page) return http::problem(400, page.error());
  const Result<store::JobQuery> query = read_query(request);
  if (!query) return http::problem(query.error());
  store::JobSearch& search = search_in(api);
  Result<std::vector<store::JobRow>> rows = search.find_jobs(context, *query, page->cursor, page->limit + 1);
  if (!rows) return http::problem(rows.error());
  std::map<std::string, store::Tags> tags;
  if (!rows->empty()) {
    auto found = search.tags_of_jobs(context.owner, rows->back().id, rows->front().id);
    if (!found) return http::problem(found.error());
    tags = std::move(*found);
  }
  return page_answer("jobs", *page, std::move(*rows), [&](const store::JobRow& row) {
    std::vector<json::JsonMember> members = job_members_now(api, context, row);
    members.push_back({"tags", tag_list(tags[row.id])});
    members.push_back({"sweep", cell_json(row.cell)});
    return json::JsonValue(std::move(members));
  });
}

/// In place of those that the job has.
http::HttpResponse tag(const Api& api, const store::RequestContext& context,
                       const http::HttpRequest& request) {
  const Result<json::JsonValue> given =
      read_object(request, {"tags"}, {.bytes = http::kSmallBody, .depth = 8});
  if (!given) return http::problem(given.error());
  const Result<store::Tags> tags = read_tags(*given);
  if (!tags) return http::problem(422, tags.error());
  const Status kept = search_in(api).set_tags(context, request.captures[0], *tags);
  return kept ? json_answer(200, {{"tags", tag_list(*tags)}}) : http::problem(kept.error());
}

http::HttpResponse show_job(const Api& api, const store::RequestContext& context,
                            const http::HttpRequest& request) {
  const Result<store::JobRow> job = api.store.job(context, request.captures[0]);
  return job ? job_answer(api, context, *job) : http::problem(job.error());
}

http::HttpResponse changed(const Api& api, const store::RequestContext& context,
                           const Result<store::JobRow>& job) {
  return job ? job_answer(api, context, *job) : http::problem(job.error());
}

http::HttpResponse pause(const Api& api, const store::RequestContext& context,
                         const http::HttpRequest& request) {
  return changed(api, context, api.jobs.pause(context, request.captures[0]));
}

http::HttpResponse resume(const Api& api, const store::RequestContext& context,
                          const http::HttpRequest& request) {
  return changed(api, context, api.jobs.resume(context, request.captures[0]));
}

http::HttpResponse step(const Api& api, const store::RequestContext& context,
                        const http::HttpRequest& request) {
  return changed(api, context, api.jobs.step(context, request.captures[0]));
}

http::HttpResponse cancel_job(const Api& api, const store::RequestContext& context,
                              const http::HttpRequest& request) {
  return changed(api, context, api.jobs.cancel(context, request.captures[0]));
}

http::HttpResponse retry(const Api& api, const store::RequestContext& context,
                         const http::HttpRequest& request) {
  const Result<store::Made<store::JobRow>> job =
      api.jobs.retry(context, request.captures[0], request.header("idempotency-key"));
  if (!job) return http::problem(job.error());
  return made_answer(job_answer(api, context, *job), job->anew, place_of(*job));
}

/// The edited project in place of what drapes.
http::HttpResponse go_on(const Api& api, const store::RequestContext& context,
                         const http::HttpRequest& request) {
  const Result<store::Made<store::JobRow>> job =
      api.jobs.go_on(context, request.captures[0], request.header("idempotency-key"));
  if (!job) return http::problem(job.error());
  return made_answer(job_answer(api, context, *job), job->anew, place_of(*job));
}

http::HttpResponse remove_job(const Api& api, const store::RequestContext& context,
                              const http::HttpRequest& request) {
  const Status removed = api.jobs.remove(context, request.captures[0]);
  return removed ? no_content() : http::problem(removed.error());
}

http::HttpResponse list_results(const Api& api, const store::RequestContext& context,
                                const http::HttpRequest& request) {
  const Result<store::JobRow> job = api.store.job(context, request.captures[0]);
  if (!job) return http::problem(job.error());
  std::vector<json::JsonValue> results;
  for (const auto& [name, file] : job->results) {
    results.push_back(std::vector<json::JsonMember>{{"name", name},
                                                    {"size", static_cast<double>(file.bytes)},
                                                    {"xxh3", file.hash},
                                                    {"content_type", http::content_type_of(name)},
                                                    {"href", place_of(*job) + "/results/" + name}});
  }
  return json_answer(200, {{"results", std::move(results)}});
}

/// What the service did for the job, a line of JSON each.
http::HttpResponse log(const Api& api, const store::RequestContext& context,
                       const http::HttpRequest& request) {
  Result<std::string> lines = api.store.job_log(context, request.captures[0]);
  if (!lines) return http::problem(lines.error());
  http::HttpResponse response = file_answer(std::move(*lines), "application/x-ndjson", "log.jsonl");
  response.headers.emplace_back("Cache-Control", "no-cache");
  return response;
}

/// Before the upgrade: is there such a job? The stream itself is served by ws.
http::HttpResponse stream_job(const Api& api, const store::RequestContext& context,
                              const http::HttpRequest& request) {
  const Result<store::JobRow> job = api.store.job(context, request.captures[0]);
  return job ? http::HttpResponse{} : http::problem(job.error());
}

std::vector<std::string> list_parameters() {
  std::vector<std::string> names = kPageParameters;
  names.insert(names.end(), kQueryParameters.begin(), kQueryParameters.end());
  return names;
}

}  // namespace

ApiRoutes job_routes() {
  return {
      {.method = "POST",
       .pattern = "/api/v1/jobs",
       .handler = submit_job,
       .body = http::BodyKind::kJson,
       .work = http::Work::kSubmit},
      {.pattern = "/api/v1/jobs", .handler = list_jobs, .parameters = list_parameters()},
      {.method = "PUT", .pattern = "/api/v1/jobs/{id}/tags", .handler = tag, .body = http::BodyKind::kJson},
      {.pattern = "/api/v1/jobs/{id}", .handler = show_job},
      {.method = "DELETE", .pattern = "/api/v1/jobs/{id}", .handler = remove_job},
      {.method = "POST", .pattern = "/api/v1/jobs/{id}/pause", .handler = pause},
      {.method = "POST", .pattern = "/api/v1/jobs/{id}/resume", .handler = resume},
      {.method = "POST", .pattern = "/api/v1/jobs/{id}/step", .handler = step},
      {.method = "POST", .pattern = "/api/v1/jobs/{id}/cancel", .handler = cancel_job},
      {.method = "POST", .pattern = "/api/v1/jobs/{id}/retry", .handler = retry, .work = http::Work::kSubmit},
      {.method = "POST",
       .pattern = "/api/v1/jobs/{id}/go_on",
       .handler = go_on,
       .work = http::Work::kDocument},
      {.pattern = "/api/v1/jobs/{id}/results", .handler = list_results},
      {.pattern = "/api/v1/jobs/{id}/results/{name}", .handler = job_result},
      {.pattern = "/api/v1/jobs/{id}/results/{name}/small",
       .handler = small_job_result,
       .work = http::Work::kDocument,
       .parameters = {"width"}},
      {.pattern = "/api/v1/jobs/{id}/report", .handler = job_report_page, .work = http::Work::kDocument},
      {.pattern = "/api/v1/jobs/{id}/log", .handler = log},
      {.pattern = "/api/v1/jobs/{id}/pieces", .handler = job_pieces, .work = http::Work::kDocument},
      {.pattern = "/api/v1/jobs/{id}/body", .handler = job_body, .work = http::Work::kHeavy},
      {.pattern = "/api/v1/jobs/{id}/stream", .handler = stream_job, .websocket = true},
  };
}

}  // namespace toile::handlers
