#pragma once
// Sweeps: one garment on several bodies and of several fabrics, a drape for each pair. A sweep is made with
// all its drapes at once and goes with the last of them; what it has come to stands in their rows.

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "server/store/store.h"

namespace toile::store {

struct SweepRow {
  std::string id;  ///< "s_" and 20 characters; rises with time
  std::string project_id;
  int project_revision = 0;
  std::string name;
  std::vector<std::string> bodies;   ///< what its rows are called
  std::vector<std::string> fabrics;  ///< and its columns
  std::int64_t created_ms = 0;
};

/// A sweep with the drapes that its cells stand for.
struct SweptJobs {
  SweepRow sweep;
  std::vector<JobRow> jobs;  ///< each names its cell; without documents once they are kept
};

/// Calls are thread-safe and durable, as those of Store, with its errors.
class Sweeps {
 public:
  virtual ~Sweeps() = default;
  /// Keeps sweep and jobs in one transaction, or none of them; ids and times are the store's to give. With an
  /// idempotency key that this owner has used for a sweep, gives back that one with the drapes that are there
  /// now. Errors: store.idempotency_mismatch when that was of another project, store.idempotency_key,
  /// quota.bytes, quota.jobs.
  virtual Result<Made<SweptJobs>> create_sweep(const RequestContext& context, SweptJobs wanted,
                                               const std::string& idempotency_key) = 0;
  /// What create_sweep() gives back for a key that was used; an empty id: it was not.
  virtual Result<SweptJobs> sweep_of_key(const RequestContext& context,
                                         const std::string& idempotency_key) = 0;
  virtual Result<SweepRow> sweep(const RequestContext& context, const std::string& id) = 0;
  /// Newest first, as Store::projects; of every project when `project_id` is empty.
  virtual Result<std::vector<SweepRow>> sweeps(const RequestContext& context, const std::string& project_id,
                                               const std::string& cursor, int limit) = 0;
  /// All that were made for it and are there, the oldest first, without documents. What was tried again is a
  /// job more: the newest of a cell is what the cell stands at.
  virtual Result<std::vector<JobRow>> jobs_of_sweep(const RequestContext& context, const std::string& id) = 0;
};

/// Those of a store that keeps sweeps; null else.
inline Sweeps* sweeps_of(Store& store) { return dynamic_cast<Sweeps*>(&store); }

}  // namespace toile::store
