// /api/v1/jobs: drapes, their results and what viewers need beside the stream.

#include <charconv>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "core/base/names.h"
#include "core/exports/report_page.h"
#include "core/image/reduce.h"
#include "server/documents/projects.h"
#include "server/documents/views.h"
#include "server/http/handlers/answer.h"
#include "server/http/handlers/api.h"
#include "server/http/problem.h"
#include "server/http/static_files.h"
#include "server/ws/job_message.h"

namespace toile::handlers {
namespace {

std::string place_of(const store::JobRow& job) { return "/api/v1/jobs/" + job.id; }

/// A job with what it is doing now; no progress once it has ended and its figures are in the report.
std::vector<json::JsonMember> members_with_progress(const Api& api, const store::RequestContext& context,
                                                    const store::JobRow& job) {
  std::vector<json::JsonMember> members = ws::job_members(job);
  json::JsonValue progress;
  if (!store::is_final(job.state)) {
    const Result<jobs::JobProgress> now = api.jobs.progress(context, job.id);
    if (now) progress = json::JsonValue(ws::progress_members(*now));
  }
  members.push_back({"progress", std::move(progress)});
  return members;
}

http::HttpResponse job_answer(const Api& api, const store::RequestContext& context,
                              const store::JobRow& job) {
  return json_answer(200, members_with_progress(api, context, job), "report",
                     job.report.empty() || !store::is_final(job.state) ? "null" : job.report);
}

Result<jobs::JobWish> read_wish(const json::JsonValue& given) {
  jobs::JobWish wish;
  if (const json::JsonValue* word = given.find("priority")) {
    const Result<store::JobPriority> priority = store::job_priority_from(word->text() ? *word->text() : "");
    if (!priority) return Error{"request.priority", priority.error().message, "/priority"};
    wish.priority = *priority;
  }
  if (const json::JsonValue* anew = given.find("anew")) {
    if (!anew->boolean()) return Error{"request.anew", "\"anew\" is true or false", "/anew"};
    wish.anew = *anew->boolean();
  }
  if (const json::JsonValue* from = given.find("from")) {
    if (!from->text()) return Error{"request.from", "\"from\" is the id of a job", "/from"};
    wish.from = *from->text();
  }
  return wish;
}

http::HttpResponse submit(const Api& api, const store::RequestContext& context,
                          const http::HttpRequest& request) {
  const Result<json::JsonValue> given = read_object(request, {"project_id", "priority", "anew", "from"},
                                                    {.bytes = http::kSmallBody, .depth = 32});
  if (!given) return http::problem(given.error());
  const json::JsonValue* id = given->find("project_id");
  if (!id || !id->text()) {
    return http::problem(422, {"request.project_id", "\"project_id\" is the id of a project", "/project_id"});
  }
  const Result<jobs::JobWish> wish = read_wish(*given);
  if (!wish) return http::problem(422, wish.error());
  const Result<store::Made<store::JobRow>> job =
      api.jobs.submit(context, *id->text(), request.header("idempotency-key"), *wish);
  if (job) return made_answer(job_answer(api, context, *job), job->anew, place_of(*job));
  if (job.error().kind != ErrorKind::kNotFound) return http::problem(job.error());
  return http::problem(404, {"store.not_found", "there is no project " + in_quotes(*id->text()),
                             "/project_id", ErrorKind::kNotFound});
}

http::HttpResponse list(const Api& api, const store::RequestContext& context,
                        const http::HttpRequest& request) {
  const Result<Page> page = read_page(request);
  if (!page) return http::problem(400, page.error());
  Result<std::vector<store::JobRow>> rows = api.store.jobs(context, page->cursor, page->limit + 1);
  if (!rows) return http::problem(rows.error());
  return page_answer("jobs", *page, std::move(*rows), [&](const store::JobRow& row) {
    return json::JsonValue(members_with_progress(api, context, row));
  });
}

http::HttpResponse show(const Api& api, const store::RequestContext& context,
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

http::HttpResponse cancel(const Api& api, const store::RequestContext& context,
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

http::HttpResponse remove(const Api& api, const store::RequestContext& context,
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

http::HttpResponse result(const Api& api, const store::RequestContext& context,
                          const http::HttpRequest& request) {
  const Result<store::JobRow> job = api.store.job(context, request.captures[0]);
  if (!job) return http::problem(job.error());
  const std::string& name = request.captures[1];
  if (!job->results.contains(name)) {
    return http::problem(
        404, {"store.not_found", "the job has no result of that name", clipped(name), ErrorKind::kNotFound});
  }
  const Result<std::string> path = api.store.result_path(context, job->id, name);
  if (!path) return http::problem(path.error());
  http::HttpResponse response = file_answer_from(*path, http::content_type_of(name), name);
  response.headers.emplace_back("Cache-Control", "no-cache");
  return response;
}

constexpr int kLeastWidth = 16, kMostWidth = 1024, kUsualWidth = 320;  // pixels

/// Of ?width. Error: request.width.
Result<int> read_width(const http::HttpRequest& request) {
  const std::string given = request.parameter("width");
  if (given.empty()) return kUsualWidth;
  int width = 0;
  const auto [end, wrong] = std::from_chars(given.data(), given.data() + given.size(), width);
  const bool whole = wrong == std::errc() && end == given.data() + given.size();
  if (whole && width >= kLeastWidth && width <= kMostWidth) return width;
  return Error{"request.width",
               "\"width\" is a whole number of pixels from " + std::to_string(kLeastWidth) + " to " +
                   std::to_string(kMostWidth),
               "?width"};
}

/// A picture among the results, made smaller. What has ended never changes, so that whoever has it keeps it.
http::HttpResponse small_result(const Api& api, const store::RequestContext& context,
                                const http::HttpRequest& request) {
  const Result<int> width = read_width(request);
  if (!width) return http::problem(400, width.error());
  http::HttpResponse whole = result(api, context, request);
  if (!whole.file) return whole;
  const std::string bytes = whole.file->read(0, static_cast<std::size_t>(whole.file->size()));
  Result<std::string> small = image::reduced_png(bytes, *width);
  if (!small)
    return http::problem(422, {"request.no_picture", "only PNG pictures are made smaller",
                               clipped(request.captures[1]), ErrorKind::kInput});
  http::HttpResponse response = file_answer(std::move(*small), "image/png", request.captures[1]);
  response.headers.emplace_back("Cache-Control", "private, max-age=86400, immutable");
  return response;
}

constexpr int kPageWidth = 440;  // pixels of a picture on the report's page

/// Those of the job's stills that there are, made smaller.
std::vector<exports::PagePicture> page_pictures(const Api& api, const store::RequestContext& context,
                                                const store::JobRow& job) {
  std::vector<exports::PagePicture> pictures;
  for (const char* view : {"front", "side", "back"}) {
    const std::string name = std::string(view) + ".png";
    if (!job.results.contains(name)) continue;
    const Result<std::string> path = api.store.result_path(context, job.id, name);
    if (!path) continue;
    const std::shared_ptr<const http::AnswerFile> file = http::AnswerFile::open(*path);
    if (!file) continue;
    Result<std::string> small =
        image::reduced_png(file->read(0, static_cast<std::size_t>(file->size())), kPageWidth);
    if (small) pictures.push_back({view, std::move(*small)});
  }
  return pictures;
}

/// The report as a page, made when it is asked for: a drape costs nothing for what nobody looks at.
http::HttpResponse report_page(const Api& api, const store::RequestContext& context,
                               const http::HttpRequest& request) {
  const Result<store::JobRow> job = api.store.job(context, request.captures[0]);
  if (!job) return http::problem(job.error());
  const auto report = json::parse_json(job->report);
  if (!store::is_final(job->state) || !report) {
    return http::problem(
        404, {"jobs.no_report", "the job has no report, or none yet", job->id, ErrorKind::kNotFound});
  }
  http::HttpResponse response = file_answer(exports::report_page(*report, page_pictures(api, context, *job)),
                                            "text/html; charset=utf-8", "report.html");
  for (auto& [name, value] : response.headers)
    if (name == "Content-Security-Policy")
      value = "default-src 'none'; img-src data:; style-src 'unsafe-inline'; sandbox";
  response.headers.emplace_back("Cache-Control", "no-cache");
  return response;
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

http::HttpResponse body(const Api& api, const store::RequestContext& context,
                        const http::HttpRequest& request) {
  const Result<store::JobRow> job = api.store.job(context, request.captures[0]);
  if (!job) return http::problem(job.error());
  Result<std::string> bytes =
      documents::body_bytes(job->document, documents::files_in_store(api.documents, context, job->files));
  if (!bytes) return http::problem(bytes.error());
  http::HttpResponse response = file_answer(std::move(*bytes), "application/octet-stream", "body.bin");
  response.headers.emplace_back("Cache-Control", "private, max-age=31536000, immutable");
  return response;
}

/// Before the upgrade: is there such a job? The stream itself is served by ws.
http::HttpResponse stream(const Api& api, const store::RequestContext& context,
                          const http::HttpRequest& request) {
  const Result<store::JobRow> job = api.store.job(context, request.captures[0]);
  return job ? http::HttpResponse{} : http::problem(job.error());
}

}  // namespace

ApiRoutes job_routes() {
  return {
      {.method = "POST",
       .pattern = "/api/v1/jobs",
       .handler = submit,
       .body = http::BodyKind::kJson,
       .work = http::Work::kDocument},
      {.pattern = "/api/v1/jobs", .handler = list, .parameters = kPageParameters},
      {.pattern = "/api/v1/jobs/{id}", .handler = show},
      {.method = "DELETE", .pattern = "/api/v1/jobs/{id}", .handler = remove},
      {.method = "POST", .pattern = "/api/v1/jobs/{id}/pause", .handler = pause},
      {.method = "POST", .pattern = "/api/v1/jobs/{id}/resume", .handler = resume},
      {.method = "POST", .pattern = "/api/v1/jobs/{id}/cancel", .handler = cancel},
      {.method = "POST", .pattern = "/api/v1/jobs/{id}/retry", .handler = retry},
      {.pattern = "/api/v1/jobs/{id}/results", .handler = list_results},
      {.pattern = "/api/v1/jobs/{id}/results/{name}", .handler = result},
      {.pattern = "/api/v1/jobs/{id}/results/{name}/small",
       .handler = small_result,
       .work = http::Work::kDocument,
       .parameters = {"width"}},
      {.pattern = "/api/v1/jobs/{id}/report", .handler = report_page, .work = http::Work::kDocument},
      {.pattern = "/api/v1/jobs/{id}/log", .handler = log},
      {.pattern = "/api/v1/jobs/{id}/body", .handler = body, .work = http::Work::kHeavy},
      {.pattern = "/api/v1/jobs/{id}/stream", .handler = stream, .websocket = true},
  };
}

}  // namespace toile::handlers
