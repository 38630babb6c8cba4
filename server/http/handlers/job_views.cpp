#include "server/http/handlers/job_views.h"

#include <charconv>
#include <memory>
#include <string>
#include <system_error>
#include <utility>

#include "core/base/names.h"
#include "core/exports/report_page.h"
#include "core/fabric/library.h"
#include "core/image/reduce.h"
#include "server/documents/projects.h"
#include "server/documents/read_cloth.h"
#include "server/documents/seen_pieces.h"
#include "server/documents/views.h"
#include "server/http/handlers/answer.h"
#include "server/http/problem.h"
#include "server/http/static_files.h"
#include "server/jobs/end_bodies.h"
#include "server/ws/job_message.h"

namespace toile::handlers {
namespace {

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

}  // namespace

std::vector<json::JsonMember> job_members_now(const Api& api, const store::RequestContext& context,
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

http::HttpResponse job_result(const Api& api, const store::RequestContext& context,
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

http::HttpResponse small_job_result(const Api& api, const store::RequestContext& context,
                                    const http::HttpRequest& request) {
  const Result<int> width = read_width(request);
  if (!width) return http::problem(400, width.error());
  http::HttpResponse whole = job_result(api, context, request);
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

http::HttpResponse job_report_page(const Api& api, const store::RequestContext& context,
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

namespace {

Result<std::string> moved_bodies(const Api& api, const store::RequestContext& context,
                                 const store::JobRow& job) {
  return documents::mesh_bytes(TRY(jobs::end_bodies(api.store, context, job)));
}

}  // namespace

http::HttpResponse job_pieces(const Api& api, const store::RequestContext& context,
                              const http::HttpRequest& request) {
  const Result<store::JobRow> job = api.store.job(context, request.captures[0]);
  if (!job) return http::problem(job.error());
  const auto read = documents::read_cloth(api.documents, context, job->document, job->files);
  if (!read) return http::problem(read.error());
  documents::SeenPieces seen = documents::seen_pieces(**read);
  std::vector<json::JsonValue> cards;
  for (const std::string& name : seen.fabrics)
    if (const fabric::FabricCard* card = fabric::find(name)) cards.push_back(fabric::fabric_json(*card));
  return json_answer(200, {{"pieces", std::move(seen.pieces)}, {"fabrics", std::move(cards)}});
}

http::HttpResponse job_body(const Api& api, const store::RequestContext& context,
                            const http::HttpRequest& request) {
  const Result<store::JobRow> job = api.store.job(context, request.captures[0]);
  if (!job) return http::problem(job.error());
  const bool moves = documents::has_moving_bodies(job->document), ended = jobs::has_end_bodies(*job);
  const Result<std::string> bytes =
      moves && ended ? moved_bodies(api, context, *job)
                     : documents::body_bytes(job->document,
                                             documents::files_in_store(api.documents, context, job->files));
  if (!bytes) return http::problem(bytes.error());
  http::HttpResponse response = file_answer(*bytes, "application/octet-stream", "body.bin");
  const bool stays = !moves || ended;
  response.headers.emplace_back("Cache-Control", stays ? "private, max-age=31536000, immutable" : "no-cache");
  return response;
}

}  // namespace toile::handlers
