#pragma once
// Sweeps as jobs: what is draped for one that is asked for, what it has come to, and all of its drapes at
// once cancelled or removed.

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/json/tree.h"
#include "core/sweep/table.h"
#include "server/documents/documents.h"
#include "server/jobs/limits.h"
#include "server/jobs/wish.h"
#include "server/store/sweeps.h"

namespace toile::jobs {

class JobService;

/// A row of a sweep: who wears the garment, and in which size it is cut.
struct SweepBody {
  std::string label;                    ///< empty: what the body is called
  std::string project_id;               ///< of the same garment in another size; empty: the sweep's
  std::optional<json::JsonValue> body;  ///< as documents::dress_project takes it; nothing: the project's own
};

/// A column.
struct SweepFabric {
  std::string label;   ///< empty: the fabric's name
  std::string fabric;  ///< as sweep::cut_of takes it; empty: as the project is cut
};

struct SweepWish {
  std::string project_id;
  std::string name;     ///< empty: the project's
  std::string body_id;  ///< which of the document's bodies the rows replace; empty: the first
  std::vector<SweepBody> bodies;
  std::vector<SweepFabric> fabrics;
  JobWish manner;  ///< of each drape; it begins from the pieces
};

/// Cells of one sweep at most, and of either side.
inline constexpr std::size_t kMostSwept = 200, kMostOfASide = 50;

/// A drape for each cell, once it is known that all can be made; rows that say the same as the project keep
/// its very document, so that an equal drape of before answers. Errors: sweep.too_many, sweep.none,
/// sweep.duplicate (two rows or columns of one name), sweep.moving_body, store.not_found,
/// project.unknown_fabric, and those of dress_project and row_of_drape. First in `where` stands the row or
/// column: "/bodies/2", "/fabrics/0".
Result<store::SweptJobs> swept_jobs(documents::Documents& documents, const store::RequestContext& context,
                                    const SweepWish& wish, const JobLimits& limits = {});

enum class Reports { kRead, kLeft };
/// What it has come to, with the figures of its reports unless they are left. `jobs` are those of the sweep.
sweep::Table table_of(JobService& service, const store::RequestContext& context, const store::SweepRow& sweep,
                      const std::vector<store::JobRow>& jobs, Reports reports = Reports::kRead);

/// The contact sheet as a PNG file: each cell's still of that name ("front.png"), where there is one. Errors:
/// movie.no_ffmpeg, movie.failed; those of the store; sweep.given_up.
Result<std::string> sheet_png(store::Store& store, const store::RequestContext& context,
                              const sweep::Table& table, const std::string& still);

/// Cancels what has not ended. Errors: store.not_found; jobs.stopped and those of the store, when some may be
/// cancelled and others not.
Status cancel_sweep(store::Store& store, JobService& service, const store::RequestContext& context,
                    const std::string& id);

/// Removes all of its drapes with their results, and with the last of them the sweep. After a crash in
/// between, asking again removes the rest. Errors: store.not_found, jobs.state while one has not ended.
Status remove_sweep(store::Store& store, JobService& service, const store::RequestContext& context,
                    const std::string& id);

}  // namespace toile::jobs
