#pragma once
// Jobs looked for by what they are, and the words that their owner puts on them.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "server/store/store.h"

namespace toile::store {

/// What a job must be to be found; what is empty or 0 asks nothing.
struct JobQuery {
  std::vector<JobState> states;  ///< one of these
  std::string project_id;
  std::string tag;
  std::string sweep;          ///< id; kAlone: of none
  std::int64_t since_ms = 0;  ///< made then or later, Unix time
  std::int64_t until_ms = 0;  ///< made before
  static constexpr const char* kAlone = "none";
};

/// Calls are thread-safe and durable, as those of Store, with its errors.
class JobSearch {
 public:
  virtual ~JobSearch() = default;
  /// As Store::jobs, of those that fit.
  virtual Result<std::vector<JobRow>> find_jobs(const RequestContext& context, const JobQuery& query,
                                                const std::string& cursor, int limit) = 0;
  /// In place of those that the job has. Error: store.not_found.
  virtual Status set_tags(const RequestContext& context, const std::string& job, const Tags& tags) = 0;
  /// Of jobs with ids from `first` to `last`, by id, in order; a job without any is not there.
  virtual Result<std::map<std::string, Tags>> tags_of_jobs(const OwnerId& owner, const std::string& first,
                                                           const std::string& last) = 0;
};

/// That of a store that can; null else.
inline JobSearch* job_search_of(Store& store) { return dynamic_cast<JobSearch*>(&store); }

/// Those of one job; none in a store that keeps none.
Result<Tags> tags_of_job(Store& store, const RequestContext& context, const std::string& job);

}  // namespace toile::store
