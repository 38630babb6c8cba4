// /api/v1/jobs: drapes, their results and what viewers need beside the stream.

#include <utility>

#include "core/base/names.h"
#include "server/documents/projects.h"
#include "server/documents/views.h"
#include "server/http/handlers/answer.h"
#include "server/http/handlers/api.h"
#include "server/http/problem.h"
#include "server/http/static_files.h"
#include "server/ws/job_message.h"

namespace toile {
namespace {

std::string place_of(const JobRow& job) { return "/api/v1/jobs/" + job.id; }

/// A job with what it is doing now; no progress once it has ended and its figures are in the report.
std::vector<JsonMember> members_with_progress(const Api& api, const RequestContext& context,
                                              const JobRow& job) {
  std::vector<JsonMember> members = job_members(job);
  JsonValue progress;
  if (!is_final(job.state)) {
    const Result<JobProgress> now = api.jobs.progress(context, job.id);
    if (now) progress = JsonValue(progress_members(*now));
  }
  members.push_back({"progress", std::move(progress)});
  return members;
}

HttpResponse job_answer(const Api& api, const RequestContext& context, const JobRow& job) {
  return json_answer(200, members_with_progress(api, context, job), "report",
                     job.report.empty() ? "null" : job.report);
}

HttpResponse submit(const Api& api, const RequestContext& context, const HttpRequest& request) {
  const Result<JsonValue> given = read_object(request, {"project_id"}, {.bytes = kSmallBody, .depth = 32});
  if (!given) return problem(given.error());
  const JsonValue* id = given->find("project_id");
  if (!id || !id->text()) {
    return problem(422, {"request.project_id", "\"project_id\" is the id of a project", "/project_id"});
  }
  const Result<Made<JobRow>> job = api.jobs.submit(context, *id->text(), request.header("idempotency-key"));
  if (job) return made_answer(job_answer(api, context, *job), job->anew, place_of(*job));
  if (job.error().kind != ErrorKind::kNotFound) return problem(job.error());
  return problem(404, {"store.not_found", "there is no project " + in_quotes(*id->text()), "/project_id",
                       ErrorKind::kNotFound});
}

HttpResponse list(const Api& api, const RequestContext& context, const HttpRequest& request) {
  const Result<Page> page = read_page(request);
  if (!page) return problem(400, page.error());
  Result<std::vector<JobRow>> rows = api.store.jobs(context, page->cursor, page->limit + 1);
  if (!rows) return problem(rows.error());
  return page_answer("jobs", *page, std::move(*rows),
                     [&](const JobRow& row) { return JsonValue(members_with_progress(api, context, row)); });
}

HttpResponse show(const Api& api, const RequestContext& context, const HttpRequest& request) {
  const Result<JobRow> job = api.store.job(context, request.captures[0]);
  return job ? job_answer(api, context, *job) : problem(job.error());
}

HttpResponse changed(const Api& api, const RequestContext& context, const Result<JobRow>& job) {
  return job ? job_answer(api, context, *job) : problem(job.error());
}

HttpResponse pause(const Api& api, const RequestContext& context, const HttpRequest& request) {
  return changed(api, context, api.jobs.pause(context, request.captures[0]));
}

HttpResponse resume(const Api& api, const RequestContext& context, const HttpRequest& request) {
  return changed(api, context, api.jobs.resume(context, request.captures[0]));
}

HttpResponse cancel(const Api& api, const RequestContext& context, const HttpRequest& request) {
  return changed(api, context, api.jobs.cancel(context, request.captures[0]));
}

HttpResponse list_results(const Api& api, const RequestContext& context, const HttpRequest& request) {
  const Result<JobRow> job = api.store.job(context, request.captures[0]);
  if (!job) return problem(job.error());
  std::vector<JsonValue> results;
  for (const auto& [name, bytes] : job->results) {
    results.push_back(std::vector<JsonMember>{{"name", name},
                                              {"size", static_cast<double>(bytes)},
                                              {"content_type", content_type_of(name)},
                                              {"href", place_of(*job) + "/results/" + name}});
  }
  return json_answer(200, {{"results", std::move(results)}});
}

HttpResponse result(const Api& api, const RequestContext& context, const HttpRequest& request) {
  const Result<JobRow> job = api.store.job(context, request.captures[0]);
  if (!job) return problem(job.error());
  const std::string& name = request.captures[1];
  if (!job->results.contains(name)) {
    return problem(
        404, {"store.not_found", "the job has no result of that name", clipped(name), ErrorKind::kNotFound});
  }
  Result<std::string> bytes = api.store.result_bytes(context, job->id, name);
  if (!bytes) return problem(bytes.error());
  HttpResponse response = file_answer(std::move(*bytes), content_type_of(name), name);
  response.headers.emplace_back("Cache-Control", "no-cache");
  return response;
}

HttpResponse body(const Api& api, const RequestContext& context, const HttpRequest& request) {
  const Result<JobRow> job = api.store.job(context, request.captures[0]);
  if (!job) return problem(job.error());
  Result<std::string> bytes = body_bytes(job->document, files_in_store(api.documents, context, job->files));
  if (!bytes) return problem(bytes.error());
  HttpResponse response = file_answer(std::move(*bytes), "application/octet-stream", "body.bin");
  response.headers.emplace_back("Cache-Control", "private, max-age=31536000, immutable");
  return response;
}

/// Before the upgrade: is there such a job? The stream itself is served by ws.
HttpResponse stream(const Api& api, const RequestContext& context, const HttpRequest& request) {
  const Result<JobRow> job = api.store.job(context, request.captures[0]);
  return job ? HttpResponse{} : problem(job.error());
}

}  // namespace

ApiRoutes job_routes() {
  return {
      {.method = "POST",
       .pattern = "/api/v1/jobs",
       .handler = submit,
       .body = BodyKind::kJson,
       .heavy = true},
      {.pattern = "/api/v1/jobs", .handler = list},
      {.pattern = "/api/v1/jobs/{id}", .handler = show},
      {.method = "POST", .pattern = "/api/v1/jobs/{id}/pause", .handler = pause},
      {.method = "POST", .pattern = "/api/v1/jobs/{id}/resume", .handler = resume},
      {.method = "POST", .pattern = "/api/v1/jobs/{id}/cancel", .handler = cancel},
      {.pattern = "/api/v1/jobs/{id}/results", .handler = list_results},
      {.pattern = "/api/v1/jobs/{id}/results/{name}", .handler = result},
      {.pattern = "/api/v1/jobs/{id}/body", .handler = body, .heavy = true},
      {.pattern = "/api/v1/jobs/{id}/stream", .handler = stream, .websocket = true},
  };
}

}  // namespace toile
