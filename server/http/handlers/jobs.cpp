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
std::vector<JsonMember> members_with_progress(const Api& api, const JobRow& job) {
  std::vector<JsonMember> members = job_members(job);
  JsonValue progress;
  if (!is_final(job.state)) {
    const Result<JobProgress> now = api.jobs.progress(kLocalOwner, job.id);
    if (now) progress = JsonValue(progress_members(*now));
  }
  members.push_back({"progress", std::move(progress)});
  return members;
}

HttpResponse job_answer(const Api& api, const JobRow& job) {
  return json_answer(200, members_with_progress(api, job), "report",
                     job.report.empty() ? "null" : job.report);
}

HttpResponse submit(const Api& api, const HttpRequest& request) {
  const Result<JsonValue> given = read_object(request, {"project_id"}, {.bytes = kSmallBody, .depth = 32});
  if (!given) return problem(given.error());
  const JsonValue* id = given->find("project_id");
  if (!id || !id->text()) {
    return problem(422, {"request.project_id", "\"project_id\" is the id of a project", "/project_id"});
  }
  const Result<Made<JobRow>> job =
      api.jobs.submit(kLocalOwner, *id->text(), request.header("idempotency-key"));
  if (job) return made_answer(job_answer(api, *job), job->anew, place_of(*job));
  if (job.error().kind != ErrorKind::kNotFound) return problem(job.error());
  return problem(404, {"store.not_found", "there is no project " + in_quotes(*id->text()), "/project_id",
                       ErrorKind::kNotFound});
}

HttpResponse list(const Api& api, const HttpRequest& request) {
  const Result<Page> page = read_page(request);
  if (!page) return problem(400, page.error());
  Result<std::vector<JobRow>> rows = api.store.jobs(kLocalOwner, page->cursor, page->limit + 1);
  if (!rows) return problem(rows.error());
  return page_answer("jobs", *page, std::move(*rows),
                     [&api](const JobRow& row) { return JsonValue(members_with_progress(api, row)); });
}

HttpResponse show(const Api& api, const HttpRequest& request) {
  const Result<JobRow> job = api.store.job(kLocalOwner, request.captures[0]);
  return job ? job_answer(api, *job) : problem(job.error());
}

using Act = Result<JobRow> (JobService::*)(const OwnerId&, const std::string&);

HttpResponse act(const Api& api, const HttpRequest& request, Act what) {
  const Result<JobRow> job = (api.jobs.*what)(kLocalOwner, request.captures[0]);
  return job ? job_answer(api, *job) : problem(job.error());
}

HttpResponse list_results(const Api& api, const HttpRequest& request) {
  const Result<JobRow> job = api.store.job(kLocalOwner, request.captures[0]);
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

HttpResponse result(const Api& api, const HttpRequest& request) {
  const Result<JobRow> job = api.store.job(kLocalOwner, request.captures[0]);
  if (!job) return problem(job.error());
  const std::string& name = request.captures[1];
  if (!job->results.contains(name)) {
    return problem(
        404, {"store.not_found", "the job has no result of that name", clipped(name), ErrorKind::kNotFound});
  }
  Result<std::string> bytes = api.store.result_bytes(kLocalOwner, job->id, name);
  if (!bytes) return problem(bytes.error());
  HttpResponse response = file_answer(std::move(*bytes), content_type_of(name), name);
  response.headers.emplace_back("Cache-Control", "no-cache");
  return response;
}

HttpResponse body(const Api& api, const HttpRequest& request) {
  const Result<JobRow> job = api.store.job(kLocalOwner, request.captures[0]);
  if (!job) return problem(job.error());
  Result<std::string> bytes = body_bytes(job->document, files_in_store(api.store, kLocalOwner, job->files));
  if (!bytes) return problem(bytes.error());
  HttpResponse response = file_answer(std::move(*bytes), "application/octet-stream", "body.bin");
  response.headers.emplace_back("Cache-Control", "private, max-age=31536000, immutable");
  return response;
}

/// Before the upgrade: is there such a job? The stream itself is served by ws.
HttpResponse stream(const Api& api, const HttpRequest& request) {
  const Result<JobRow> job = api.store.job(kLocalOwner, request.captures[0]);
  return job ? HttpResponse{} : problem(job.error());
}

}  // namespace

void add_job_routes(Router& router, const Api& api) {
  const std::string one = "/api/v1/jobs/{id}";
  const auto add = [&](const char* method, const std::string& pattern, auto handler) -> Route {
    return {.method = method, .pattern = pattern, .handler = [&api, handler](const HttpRequest& request) {
              return handler(api, request);
            }};
  };
  Route posting = add("POST", "/api/v1/jobs", submit);
  posting.body = BodyKind::kJson;
  posting.heavy = true;
  router.add(std::move(posting));
  router.add(add("GET", "/api/v1/jobs", list));
  router.add(add("GET", one, show));
  for (const auto& [verb, what] :
       {std::pair{"/pause", &JobService::pause}, std::pair{"/resume", &JobService::resume},
        std::pair{"/cancel", &JobService::cancel}}) {
    const Act wish = what;
    router.add(add("POST", one + verb, [wish](const Api& service, const HttpRequest& request) {
      return act(service, request, wish);
    }));
  }
  router.add(add("GET", one + "/results", list_results));
  router.add(add("GET", one + "/results/{name}", result));
  Route mesh = add("GET", one + "/body", body);
  mesh.heavy = true;
  router.add(std::move(mesh));
  Route live = add("GET", one + "/stream", stream);
  live.websocket = true;
  router.add(std::move(live));
}

}  // namespace toile
