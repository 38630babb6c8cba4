#include "server/jobs/sweeps.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

#include "core/base/check.h"
#include "server/jobs/service.h"
#include "server/store/events.h"

namespace toile::jobs {
namespace {

store::Sweeps& sweeps_in(store::Store& store) {
  store::Sweeps* const sweeps = store::sweeps_of(store);
  TOILE_CHECK(sweeps != nullptr);
  return *sweeps;
}

/// How much of a drape's time its phases usually take, in their order.
constexpr std::pair<std::string_view, double> kShares[] = {{"mesh", 0.04},  {"place", 0.01}, {"dress", 0.05},
                                                           {"sew", 0.25},   {"drape", 0.58}, {"move", 0},
                                                           {"check", 0.02}, {"stills", 0.05}};

/// Of the whole drape, from how much of a phase is done.
double overall(const JobProgress& now) {
  double before = 0;
  for (const auto& [phase, share] : kShares) {
    if (phase == now.phase) return before + share * std::clamp(now.fraction, 0.0, 1.0);
    before += share;
  }
  return 0;
}

double fraction_of(JobService& service, const store::RequestContext& context, const store::JobRow& job) {
  if (store::is_final(job.state)) return 1;
  const Result<JobProgress> now = service.progress(context, job.id);
  return now ? overall(*now) : 0;
}

sweep::Cell cell_of(JobService& service, const store::RequestContext& context, const store::JobRow& job,
                    Reports reports) {
  sweep::Cell cell;
  cell.job = job.id;
  cell.state = store::name_of(job.state);
  cell.reason_code = job.reason_code;
  cell.reason = job.reason;
  cell.fraction = fraction_of(service, context, job);
  if (!store::is_final(job.state)) return cell;
  cell.pictured = job.results.contains("front.png");
  if (reports == Reports::kLeft) return cell;
  const Result<json::JsonValue> report = json::parse_json(job.report);
  if (report) cell.figures = sweep::figures_of(*report);
  return cell;
}

}  // namespace

sweep::Table table_of(JobService& service, const store::RequestContext& context, const store::SweepRow& sweep,
                      const std::vector<store::JobRow>& jobs, Reports reports) {
  sweep::Table table;
  table.name = sweep.name;
  table.bodies = sweep.bodies;
  table.fabrics = sweep.fabrics;
  sweep::Cell removed;
  removed.state = store::kRemoved;
  removed.fraction = 1;
  table.cells.assign(sweep.bodies.size() * sweep.fabrics.size(), removed);
  std::map<std::size_t, const store::JobRow*> newest;  // by cell; the list begins with the oldest
  for (const store::JobRow& job : jobs)
    newest[static_cast<std::size_t>(job.cell.body) * sweep.fabrics.size() +
           static_cast<std::size_t>(job.cell.fabric)] = &job;
  for (const auto& [at, job] : newest)
    if (at < table.cells.size()) table.cells[at] = cell_of(service, context, *job, reports);
  return table;
}

Status cancel_sweep(store::Store& store, JobService& service, const store::RequestContext& context,
                    const std::string& id) {
  const std::vector<store::JobRow> jobs = TRY(sweeps_in(store).jobs_of_sweep(context, id));
  for (const store::JobRow& job : jobs) {
    if (store::is_final(job.state)) continue;
    const Result<store::JobRow> cancelled = service.cancel(context, job.id);
    if (cancelled || cancelled.error().kind == ErrorKind::kNotFound) continue;
    const Result<store::JobRow> now = store.job(context, job.id);
    if (now && store::is_final(now->state)) continue;  // it has ended by itself since
    return cancelled.error();
  }
  return {};
}

Status remove_sweep(store::Store& store, JobService& service, const store::RequestContext& context,
                    const std::string& id) {
  const std::vector<store::JobRow> jobs = TRY(sweeps_in(store).jobs_of_sweep(context, id));
  for (const store::JobRow& job : jobs) {
    if (store::is_final(job.state)) continue;
    return Error{
        "jobs.state",
        "a sweep whose drapes have not all ended cannot be removed; cancel it first and wait until it "
        "has ended",
        job.id, ErrorKind::kConflict};
  }
  for (const store::JobRow& job : jobs) {
    Status removed = service.remove(context, job.id);
    if (!removed && removed.error().kind != ErrorKind::kNotFound) return removed;
  }
  return {};
}

}  // namespace toile::jobs
