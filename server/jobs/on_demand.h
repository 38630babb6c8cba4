#pragma once
// Results of jobs that have ended, made when somebody first asks for them and kept among the job's others:
// movies and stills. They are made one by one on a thread of their own that gives way to drapes, by turns of
// owners: no request waits for one, and no drape fails for one.

#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <tuple>
#include <vector>

#include "core/base/result.h"
#include "core/base/run_context.h"
#include "server/movie/film.h"
#include "server/shares/owner_shares.h"
#include "server/store/store.h"

namespace toile::render {
class Stills;
}

namespace toile::jobs {

enum class OrderState { kQueued, kMaking, kMade, kFailed };
/// "queued", "making", "made", "failed".
std::string_view word_of(OrderState state);

/// How a result stands that was asked for.
struct Order {
  std::string name;  ///< of the result that it is or becomes
  OrderState state = OrderState::kQueued;
  double fraction = 0;         ///< of its making
  std::optional<Error> error;  ///< why it failed; asking again tries again
};

struct OrderLimits {
  std::size_t waiting = 64;  ///< of all owners
  std::size_t waiting_of_owner = 8;
  std::size_t of_job = 12;  ///< that are kept
  int side = 2048;          ///< pixels
};

/// What is made on demand, in English, and the codes of its errors.
struct ThingMade {
  const char* name;
  const char *no_film, *busy, *too_many, *failed;
  bool (*is_one)(const std::string& name);  ///< whether a result of a job is such
};

/// What is made of a job.
struct Ingredients {
  movie::Film film;
  std::function<Result<std::string>(const std::string& name)> result;  ///< the bytes of another result
  std::filesystem::path scratch;                                       ///< an empty folder
  render::Stills& stills;                                              ///< of the thread
};

class OnDemand {
 public:
  /// The bytes of the result, made on the one thread of its OnDemand. Progress counts; it is called once more
  /// where the machine was at fault.
  using Make = std::function<Result<std::string>(const Ingredients& from, const RunContext& context)>;

  OnDemand(store::Store& store, OrderLimits limits, ThingMade thing);
  ~OnDemand() { stop(); }
  OnDemand(const OnDemand&) = delete;
  OnDemand& operator=(const OnDemand&) = delete;

  /// Whoever asks twice for one name gets the same. Errors: THING.no_film for a job that has not ended or
  /// left no film; THING.busy, THING.too_many; those of the store.
  Result<Order> ask(const store::RequestContext& context, const std::string& job_id, const std::string& name,
                    Make make);
  /// Those of a job: made, under way, and failed since the service was started.
  Result<std::vector<Order>> of_job(const store::RequestContext& context, const std::string& job_id);
  /// Takes back what was asked for. Error: store.not_found when nothing of the name waits or is under way.
  Status cancel(const store::RequestContext& context, const std::string& job_id, const std::string& name);
  /// Ends what is under way; what waits is forgotten, and made when it is asked for again.
  void stop();

 protected:
  const OrderLimits& limits() const { return limits_; }

 private:
  using Key = std::tuple<store::OwnerId, std::string, std::string>;  // owner, job, name
  struct Asked {
    store::RequestContext context;
    Make make;
    Order shown;
    std::int64_t number = 0;  ///< in which it was asked for
    std::shared_ptr<std::atomic<bool>> dropped = std::make_shared<std::atomic<bool>>(false);
  };

  void work();
  std::optional<Key> next() const;
  Status make(const Key& key, const Asked& asked, render::Stills& stills);
  Status make_once(const Key& key, const Asked& asked, render::Stills& stills);
  Status keep(const Key& key, const store::RequestContext& context, const std::string& bytes);
  void tell(const Key& key, double fraction);
  void end(const Key& key, const Status& made);
  Status check_job(const store::JobRow& job) const;
  Status check_room(const store::RequestContext& context, const store::JobRow& job) const;
  void forget_old_failures();

  store::Store& store_;
  const OrderLimits limits_;
  const ThingMade thing_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::map<Key, Asked> orders_;  ///< those that are made are not among them
  std::int64_t asked_ = 0;
  shares::OwnerShares shares_;  ///< of this thread's time
  bool stopping_ = false;
  std::thread thread_;  // last: it uses all of the above
};

}  // namespace toile::jobs
