// /api/v1/sweeps: one garment on several bodies and of several fabrics, as one request.

#include "server/http/handlers/sweeps.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/base/check.h"
#include "core/sweep/table.h"
#include "server/http/handlers/answer.h"
#include "server/http/handlers/sweep_wish.h"
#include "server/http/problem.h"
#include "server/jobs/sweeps.h"
#include "server/store/sweeps.h"

namespace toile::handlers {
namespace {

std::string place_of(const std::string& id) { return "/api/v1/sweeps/" + id; }

store::Sweeps& sweeps_in(const Api& api) {
  store::Sweeps* const sweeps = store::sweeps_of(api.store);
  TOILE_CHECK(sweeps != nullptr);
  return *sweeps;
}

json::JsonValue counts_json(const sweep::Counts& counts) {
  return std::vector<json::JsonMember>{
      {"queued", double(counts.queued)},  {"running", double(counts.running)},
      {"paused", double(counts.paused)},  {"succeeded", double(counts.succeeded)},
      {"failed", double(counts.failed)},  {"cancelled", double(counts.cancelled)},
      {"removed", double(counts.removed)}};
}

json::JsonValue label_list(const std::vector<std::string>& labels) {
  return std::vector<json::JsonValue>(labels.begin(), labels.end());
}

std::vector<json::JsonMember> sweep_members(const store::SweepRow& sweep, const sweep::Table& table) {
  const sweep::Counts counts = sweep::counts_of(table);
  return {{"id", sweep.id},
          {"project_id", sweep.project_id},
          {"project_revision", double(sweep.project_revision)},
          {"name", sweep.name},
          {"created_ms", static_cast<double>(sweep.created_ms)},
          {"ended", counts.unfinished() == 0},
          {"fraction", counts.fraction},
          {"bodies", label_list(sweep.bodies)},
          {"fabrics", label_list(sweep.fabrics)},
          {"counts", counts_json(counts)}};
}

/// With its cells, body by body.
http::HttpResponse sweep_answer(const Api& api, const store::RequestContext& context,
                                const store::SweepRow& sweep, const std::vector<store::JobRow>& jobs) {
  const sweep::Table table = jobs::table_of(api.jobs, context, sweep, jobs);
  std::vector<json::JsonValue> cells;
  for (std::size_t body = 0; body < table.bodies.size(); ++body)
    for (std::size_t fabric = 0; fabric < table.fabrics.size(); ++fabric)
      cells.push_back(sweep::cell_json(table, body, fabric));
  std::vector<json::JsonMember> members = sweep_members(sweep, table);
  members.push_back({"cells", std::move(cells)});
  return json_answer(200, std::move(members));
}

http::HttpResponse submit_sweep(const Api& api, const store::RequestContext& context,
                                const http::HttpRequest& request) {
  const Result<jobs::SweepWish> wish = read_sweep_wish(request);
  if (!wish) return http::problem(wish.error());
  const auto made = api.jobs.submit_sweep(context, *wish, request.header("idempotency-key"));
  if (!made) return http::problem(made.error());
  return made_answer(sweep_answer(api, context, made->sweep, made->jobs), made->anew,
                     place_of(made->sweep.id));
}

http::HttpResponse list_sweeps(const Api& api, const store::RequestContext& context,
                               const http::HttpRequest& request) {
  const Result<Page> page = read_page(request);
  if (!page) return http::problem(400, page.error());
  auto rows = sweeps_in(api).sweeps(context, request.parameter("project"), page->cursor, page->limit + 1);
  if (!rows) return http::problem(rows.error());
  return page_answer("sweeps", *page, std::move(*rows), [&](const store::SweepRow& row) {
    const auto jobs = sweeps_in(api).jobs_of_sweep(context, row.id);
    if (!jobs) context.log.warn("a sweep's drapes are not told", jobs.error());
    const std::vector<store::JobRow> known = jobs ? *jobs : std::vector<store::JobRow>();
    return json::JsonValue(
        sweep_members(row, jobs::table_of(api.jobs, context, row, known, jobs::Reports::kLeft)));
  });
}

/// A sweep as it stands now.
struct Standing {
  store::SweepRow sweep;
  std::vector<store::JobRow> jobs;
};

Result<Standing> standing(const Api& api, const store::RequestContext& context, const std::string& id) {
  store::SweepRow sweep = TRY(sweeps_in(api).sweep(context, id));
  std::vector<store::JobRow> jobs = TRY(sweeps_in(api).jobs_of_sweep(context, id));
  return Standing{std::move(sweep), std::move(jobs)};
}

http::HttpResponse show_sweep(const Api& api, const store::RequestContext& context,
                              const http::HttpRequest& request) {
  const Result<Standing> now = standing(api, context, request.captures[0]);
  return now ? sweep_answer(api, context, now->sweep, now->jobs) : http::problem(now.error());
}

http::HttpResponse cancel_sweep(const Api& api, const store::RequestContext& context,
                                const http::HttpRequest& request) {
  const Status cancelled = jobs::cancel_sweep(api.store, api.jobs, context, request.captures[0]);
  return cancelled ? show_sweep(api, context, request) : http::problem(cancelled.error());
}

http::HttpResponse remove_sweep(const Api& api, const store::RequestContext& context,
                                const http::HttpRequest& request) {
  const Status removed = jobs::remove_sweep(api.store, api.jobs, context, request.captures[0]);
  return removed ? no_content() : http::problem(removed.error());
}

http::HttpResponse csv(const Api& api, const store::RequestContext& context,
                       const http::HttpRequest& request) {
  const Result<Standing> now = standing(api, context, request.captures[0]);
  if (!now) return http::problem(now.error());
  http::HttpResponse response =
      file_answer(sweep::table_csv(jobs::table_of(api.jobs, context, now->sweep, now->jobs)),
                  "text/csv; charset=utf-8", now->sweep.name + ".csv");
  response.headers.emplace_back("Cache-Control", "no-cache");
  return response;
}

/// Error: request.view.
Result<std::string> read_view(const http::HttpRequest& request) {
  const std::string given = request.parameter("view");
  const std::vector<std::string> known{"front", "side", "back"};
  if (given.empty()) return known.front() + ".png";
  if (std::find(known.begin(), known.end(), given) != known.end()) return given + ".png";
  return Error{"request.view", "\"view\" is front, side or back", "view", ErrorKind::kMalformed};
}

http::HttpResponse sheet(const Api& api, const store::RequestContext& context,
                         const http::HttpRequest& request) {
  const Result<std::string> still = read_view(request);
  if (!still) return http::problem(still.error());
  const Result<Standing> now = standing(api, context, request.captures[0]);
  if (!now) return http::problem(now.error());
  Result<std::string> png =
      jobs::sheet_png(api.store, context, jobs::table_of(api.jobs, context, now->sweep, now->jobs), *still);
  if (!png) return http::problem(png.error());
  http::HttpResponse response = file_answer(std::move(*png), "image/png", now->sweep.name + ".png");
  response.headers.emplace_back("Cache-Control", "no-cache");
  return response;
}

}  // namespace

ApiRoutes sweep_routes() {
  return {
      {.method = "POST",
       .pattern = "/api/v1/sweeps",
       .handler = submit_sweep,
       .body = http::BodyKind::kJson,
       .work = http::Work::kHeavy},
      {.pattern = "/api/v1/sweeps", .handler = list_sweeps, .parameters = {"cursor", "limit", "project"}},
      {.pattern = "/api/v1/sweeps/{id}", .handler = show_sweep},
      {.method = "DELETE", .pattern = "/api/v1/sweeps/{id}", .handler = remove_sweep},
      {.method = "POST", .pattern = "/api/v1/sweeps/{id}/cancel", .handler = cancel_sweep},
      {.pattern = "/api/v1/sweeps/{id}/table.csv", .handler = csv},
      {.pattern = "/api/v1/sweeps/{id}/sheet.png",
       .handler = sheet,
       .work = http::Work::kHeavy,
       .parameters = {"view"}},
  };
}

}  // namespace toile::handlers
