// What is draped for a sweep that is asked for.

#include <algorithm>
#include <memory>
#include <set>
#include <utility>

#include "core/base/names.h"
#include "core/project/project.h"
#include "core/sweep/variants.h"
#include "server/documents/dress.h"
#include "server/documents/projects.h"
#include "server/jobs/input.h"
#include "server/jobs/sweeps.h"

namespace toile::jobs {
namespace {

std::string place(const char* list, std::size_t index) {
  return json::pointer_to(std::string("/") + list, index);
}

/// A pointer of its own goes on from the row's, a place in a document stands behind it.
Error within(const std::string& row, bool own_pointer, Error error) {
  if (!own_pointer || !error.where.starts_with('/')) return json::error_at(row, std::move(error));
  error.where.insert(0, row);
  if (const std::size_t at = error.where.find(": /"); at != std::string::npos) error.where.erase(at, 2);
  return error;
}

Status check_size_of(const SweepWish& wish) {
  if (wish.bodies.empty()) return Error{"sweep.none", "a sweep has one body at least", "/bodies"};
  if (wish.fabrics.empty()) return Error{"sweep.none", "a sweep has one fabric at least", "/fabrics"};
  const std::string most = std::to_string(kMostOfASide);
  if (wish.bodies.size() > kMostOfASide)
    return Error{"sweep.too_many", "a sweep has at most " + most + " bodies", "/bodies"};
  if (wish.fabrics.size() > kMostOfASide)
    return Error{"sweep.too_many", "a sweep has at most " + most + " fabrics", "/fabrics"};
  const std::size_t cells = wish.bodies.size() * wish.fabrics.size();
  if (cells <= kMostSwept) return {};
  return Error{"sweep.too_many",
               "these are " + std::to_string(cells) + " drapes, and a sweep has at most " +
                   std::to_string(kMostSwept) + "; part it",
               "/bodies"};
}

/// The garment of a row, before it is cut.
struct SweepRow {
  store::ProjectRow kept;
  project::Project was, now;  ///< as the project has it, and on the row's body
  documents::ProjectFileMap files;
  std::string label;
};

Result<store::ProjectRow> project_of(documents::Documents& documents, const store::RequestContext& context,
                                     const std::string& id, const std::string& where) {
  Result<store::ProjectRow> row = documents.store().project(context, id);
  if (row || row.error().kind != ErrorKind::kNotFound) return row;
  return Error{"store.not_found", "there is no project " + in_quotes(id), where, ErrorKind::kNotFound};
}

std::string label_of(const SweepRow& row, const SweepBody& wish, const std::string& body_id) {
  if (!wish.label.empty()) return wish.label;
  if (!wish.project_id.empty() && !wish.body) return row.kept.name;
  for (const project::ProjectBody& body : row.now.bodies)
    if (body.id == body_id) return sweep::name_of(body);
  return row.kept.name;
}

Result<SweepRow> sweep_row_of(documents::Documents& documents, const store::RequestContext& context,
                              const SweepWish& wish, const SweepBody& asked, const std::string& where) {
  SweepRow row;
  const bool own = asked.project_id.empty();
  row.kept = TRY(project_of(documents, context, own ? wish.project_id : asked.project_id,
                            own ? "/project_id" : where + "/project_id"));
  const Result<project::Project> read = project::parse_project(row.kept.document);
  if (!read) return within(where, false, read.error());
  row.was = row.now = *read;
  row.files = row.kept.files;
  const std::string body_id = wish.body_id.empty() ? sweep::main_body(row.was) : wish.body_id;
  if (asked.body) {
    const Result<documents::DressedBody> body =
        documents::body_of_wish(documents, context, body_id, *asked.body, row.files);
    if (!body) return within(where, true, body.error());
    row.files = body->files;
    Result<project::Project> worn = sweep::worn_by(row.was, body->body);
    if (!worn) return within(where, true, worn.error());
    row.now = std::move(*worn);
  }
  row.label = label_of(row, asked, body_id);
  return row;
}

/// The project's own text where nothing is another, so that equal drapes have equal inputs.
Result<std::string> document_of(const SweepRow& row, const project::Project& wanted) {
  if (wanted == row.was) return row.kept.document;
  project::WrittenProject written = TRY(project::write_checked(wanted));
  return std::move(written.line);
}

Result<store::JobRow> cell_of(documents::Documents& documents, const store::RequestContext& context,
                              const SweepRow& row, const SweepFabric& asked, const JobLimits& limits,
                              const std::string& fabric_at, const std::string& body_at) {
  project::Project wanted = row.now;
  if (!asked.fabric.empty()) {
    Result<project::Project> cut = sweep::cut_of(row.now, asked.fabric);
    if (!cut) return within(fabric_at, true, cut.error());
    wanted = std::move(*cut);
  }
  const Result<std::string> document = document_of(row, wanted);
  if (!document) return within(body_at, false, document.error());
  store::ProjectRow variant = row.kept;
  variant.document = *document;
  variant.files = row.files;
  Result<store::JobRow> job = row_of_project(documents, context, variant, limits);
  if (!job) return within(body_at, false, job.error());
  return job;
}

std::string fabric_label(const SweepRow& row, const SweepFabric& asked) {
  if (!asked.label.empty()) return asked.label;
  return asked.fabric.empty() ? sweep::main_fabric(row.was) : asked.fabric;
}

Status take_label(std::set<std::string>& taken, std::vector<std::string>& labels, const std::string& label,
                  const std::string& where) {
  labels.push_back(label.empty() ? "-" : label);
  if (taken.insert(label).second) return {};
  return Error{
      "sweep.duplicate",
      "there is another of the name " + in_quotes(label) + "; give this one a \"label\", or leave it out",
      where};
}

}  // namespace

Result<store::SweptJobs> swept_jobs(documents::Documents& documents, const store::RequestContext& context,
                                    const SweepWish& wish, const JobLimits& limits) {
  const store::ProjectRow project = TRY(project_of(documents, context, wish.project_id, "/project_id"));
  TRY(check_size_of(wish));
  store::SweptJobs swept;
  swept.sweep.project_id = project.id;
  swept.sweep.project_revision = project.revision;
  swept.sweep.name = wish.name.empty() ? project.name : wish.name;
  std::set<std::string> bodies, fabrics;
  for (std::size_t b = 0; b < wish.bodies.size(); ++b) {
    const std::string body_at = place("bodies", b);
    const SweepRow row = TRY(sweep_row_of(documents, context, wish, wish.bodies[b], body_at));
    TRY(take_label(bodies, swept.sweep.bodies, row.label, body_at));
    for (std::size_t f = 0; f < wish.fabrics.size(); ++f) {
      const std::string fabric_at = place("fabrics", f);
      if (b == 0) {
        TRY(take_label(fabrics, swept.sweep.fabrics, fabric_label(row, wish.fabrics[f]), fabric_at));
      }
      if (context.is_given_up())
        return Error{"sweep.given_up", "nobody waits for it any more", "", ErrorKind::kCancelled};
      store::JobRow job = TRY(cell_of(documents, context, row, wish.fabrics[f], limits, fabric_at, body_at));
      job.name = swept.sweep.name + " · " + row.label + " · " + swept.sweep.fabrics[f];
      job.priority = wish.manner.priority;
      job.pictures = wish.manner.pictures;
      job.tags = wish.manner.tags;
      job.cell = {"", static_cast<int>(b), static_cast<int>(f)};
      swept.jobs.push_back(std::move(job));
    }
  }
  return swept;
}

}  // namespace toile::jobs
