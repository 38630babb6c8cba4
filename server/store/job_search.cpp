#include "server/store/job_search.h"

namespace toile::store {

Result<Tags> tags_of_job(Store& store, const RequestContext& context, const std::string& job) {
  JobSearch* const search = job_search_of(store);
  if (!search) return Tags{};
  const std::map<std::string, Tags> tags = TRY(search->tags_of_jobs(context.owner, job, job));
  const auto found = tags.find(job);
  return found == tags.end() ? Tags{} : found->second;
}

}  // namespace toile::store
