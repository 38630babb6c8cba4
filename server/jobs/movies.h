#pragma once
// Movies of jobs that have ended, made when somebody first asks for them and kept among the job's results.
// They are made one by one on a thread of their own that gives way to drapes, by turns of owners: no request
// waits for one, and no drape fails for one.

#include <atomic>
#include <condition_variable>
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
#include "server/movie/make_movie.h"
#include "server/shares/owner_shares.h"
#include "server/store/store.h"

namespace toile::jobs {

enum class MovieState { kQueued, kMaking, kMade, kFailed };
/// "queued", "making", "made", "failed".
std::string_view word_of(MovieState state);

/// How a movie stands that was asked for.
struct MovieOrder {
  std::string name;  ///< of the result that it is or becomes
  MovieState state = MovieState::kQueued;
  double fraction = 0;         ///< of its making
  std::optional<Error> error;  ///< why it failed; asking again tries again
};

struct MovieLimits {
  std::size_t waiting = 64;  ///< of all owners
  std::size_t waiting_of_owner = 8;
  std::size_t of_job = 12;  ///< that are kept
  int side = 2048;          ///< pixels
};

class Movies {
 public:
  explicit Movies(store::Store& store, MovieLimits limits = {});
  ~Movies() { stop(); }
  Movies(const Movies&) = delete;
  Movies& operator=(const Movies&) = delete;

  /// Whoever asks twice gets the same movie. Errors: movie.settings, movie.kind, movie.format; movie.no_film
  /// for a job that has not ended or left no film; movie.too_many; those of the store.
  Result<MovieOrder> ask(const store::RequestContext& context, const std::string& job_id,
                         const movie::MovieSettings& settings);
  /// Those of a job: made, under way, and failed since the service was started.
  Result<std::vector<MovieOrder>> of_job(const store::RequestContext& context, const std::string& job_id);
  /// Takes back what was asked for. Error: store.not_found when no such movie is waiting or under way.
  Status cancel(const store::RequestContext& context, const std::string& job_id, const std::string& name);
  /// Ends what is under way; what waits is forgotten, and made when it is asked for again.
  void stop();

 private:
  using Key = std::tuple<store::OwnerId, std::string, std::string>;  // owner, job, name
  struct Order {
    store::RequestContext context;
    movie::MovieSettings settings;
    MovieOrder shown;
    std::int64_t number = 0;  ///< in which it was asked for
    std::shared_ptr<std::atomic<bool>> dropped = std::make_shared<std::atomic<bool>>(false);
  };

  void work();
  std::optional<Key> next() const;
  Status make(const Key& key, const Order& order);
  Status make_once(const Key& key, const Order& order);
  Status keep(const Key& key, const store::RequestContext& context, const std::string& bytes);
  void tell(const Key& key, double fraction);
  void end(const Key& key, const Status& made);
  Status check_room(const store::RequestContext& context, const store::JobRow& job) const;
  void forget_old_failures();

  store::Store& store_;
  const MovieLimits limits_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::map<Key, Order> orders_;  ///< those that are made are not among them
  std::int64_t asked_ = 0;
  shares::OwnerShares shares_;  ///< of this thread's time
  bool stopping_ = false;
  std::thread thread_;  // last: it uses all of the above
};

/// The name of the result: "drape-720x900-25.mp4".
std::string movie_name(const movie::MovieSettings& settings);

}  // namespace toile::jobs
