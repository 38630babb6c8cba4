#include "server/jobs/on_demand.h"

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <exception>
#include <utility>

#include "core/base/hash.h"
#include "core/base/names.h"
#include "core/base/text.h"
#include "server/jobs/results.h"
#include "server/movie/film_codec.h"
#include "server/render/still.h"

namespace toile::jobs {
namespace {

constexpr int kGivesWay = 10;              // as nice(1) counts: drapes come first
constexpr std::size_t kMostFailures = 64;  // that are remembered
constexpr int kTries = 2;                  // where the machine was at fault

struct StateWord {
  OrderState state;
  std::string_view word;
};
constexpr std::array kStateWords{
    StateWord{OrderState::kQueued, "queued"}, StateWord{OrderState::kMaking, "making"},
    StateWord{OrderState::kMade, "made"}, StateWord{OrderState::kFailed, "failed"}};

bool is_under_way(OrderState state) { return state == OrderState::kQueued || state == OrderState::kMaking; }

}  // namespace

std::string_view word_of(OrderState state) {
  const auto found = std::find_if(kStateWords.begin(), kStateWords.end(),
                                  [state](const StateWord& entry) { return entry.state == state; });
  return found->word;
}

OnDemand::OnDemand(store::Store& store, OrderLimits limits, ThingMade thing)
    : store_(store), limits_(limits), thing_(thing), thread_([this] { work(); }) {}

Status OnDemand::check_job(const store::JobRow& job) const {
  if (store::is_final(job.state) && job.results.contains(movie::kFilmFile)) return {};
  return Error{thing_.no_film,
               std::string("there is nothing to make a ") + thing_.name +
                   " of: the job has not ended, or was draped by an older program",
               job.id, ErrorKind::kConflict};
}

void OnDemand::stop() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
    for (auto& [key, order] : orders_) *order.dropped = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

Status OnDemand::check_room(const store::RequestContext& context, const store::JobRow& job) const {
  const auto waiting =
      static_cast<std::size_t>(std::count_if(orders_.begin(), orders_.end(), [](const auto& entry) {
        return is_under_way(entry.second.shown.state);
      }));
  const auto own = static_cast<std::size_t>(std::count_if(orders_.begin(), orders_.end(), [&](const auto& e) {
    return std::get<0>(e.first) == context.owner && is_under_way(e.second.shown.state);
  }));
  if (waiting >= limits_.waiting || own >= limits_.waiting_of_owner) {
    return Error{
        thing_.busy,
        std::string("too many ") + thing_.name + "s are waiting to be made; ask again when some are done", "",
        ErrorKind::kTooMany};
  }
  const auto kept =
      static_cast<std::size_t>(std::count_if(job.results.begin(), job.results.end(),
                                             [this](const auto& file) { return thing_.is_one(file.first); }));
  if (kept < limits_.of_job) return {};
  return Error{thing_.too_many,
               std::string("the job has as many ") + thing_.name + "s as are kept (" +
                   std::to_string(limits_.of_job) + ")",
               job.id, ErrorKind::kConflict};
}

Result<Order> OnDemand::ask(const store::RequestContext& context, const std::string& job_id,
                            const std::string& name, Make make) {
  const store::JobRow job = TRY(store_.job(context, job_id));
  TRY(check_job(job));
  if (job.results.contains(name)) return Order{name, OrderState::kMade, 1, std::nullopt};
  const Key key{context.owner, job_id, name};
  const std::lock_guard lock(mutex_);
  const auto found = orders_.find(key);
  if (found != orders_.end() && is_under_way(found->second.shown.state)) return found->second.shown;
  TRY(check_room(context, job));
  Asked asked;
  asked.context = context.for_job(job_id);
  asked.make = std::move(make);
  asked.shown.name = name;
  asked.number = ++asked_;
  Order shown = asked.shown;
  orders_.insert_or_assign(key, std::move(asked));
  shares_.enter(context.owner);
  changed_.notify_one();
  return shown;
}

Result<std::vector<Order>> OnDemand::of_job(const store::RequestContext& context, const std::string& job_id) {
  std::vector<Order> told;
  {  // before the row is read: what is made in between is then in both, and not in neither
    const std::lock_guard lock(mutex_);
    for (const auto& [key, order] : orders_)
      if (std::get<0>(key) == context.owner && std::get<1>(key) == job_id) told.push_back(order.shown);
  }
  const store::JobRow job = TRY(store_.job(context, job_id));
  std::erase_if(told, [&](const Order& order) { return job.results.contains(order.name); });
  for (const auto& [name, file] : job.results)
    if (thing_.is_one(name)) told.push_back({name, OrderState::kMade, 1, std::nullopt});
  return told;
}

Status OnDemand::cancel(const store::RequestContext& context, const std::string& job_id,
                        const std::string& name) {
  const std::lock_guard lock(mutex_);
  const auto found = orders_.find({context.owner, job_id, name});
  if (found == orders_.end() || !is_under_way(found->second.shown.state)) {
    return Error{"store.not_found", std::string("no such ") + thing_.name + " is being made", clipped(name),
                 ErrorKind::kNotFound};
  }
  *found->second.dropped = true;
  if (found->second.shown.state == OrderState::kQueued) {
    orders_.erase(found);
    shares_.leave(context.owner);
  }
  return {};
}

/// Of the owner who has had least of the thread's time, what was asked for first.
std::optional<OnDemand::Key> OnDemand::next() const {
  std::optional<Key> best;
  std::pair<double, std::int64_t> least;
  for (const auto& [key, order] : orders_) {
    if (order.shown.state != OrderState::kQueued) continue;
    const std::pair<double, std::int64_t> stands{shares_.had(std::get<0>(key)), order.number};
    if (best && least <= stands) continue;
    best = key;
    least = stands;
  }
  return best;
}

void OnDemand::work() {
  ::setpriority(PRIO_PROCESS, 0, kGivesWay);  // of this thread, and of the ffmpeg that it starts
  render::Stills stills;
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return stopping_ || next().has_value(); });
    if (stopping_) return;
    const Key key = *next();
    Asked& asked = orders_.at(key);
    asked.shown.state = OrderState::kMaking;
    const Asked copy = asked;
    lock.unlock();
    const auto before = std::chrono::steady_clock::now();
    const Status made = make(key, copy, stills);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - before;
    lock.lock();
    shares_.charge(std::get<0>(key), took.count());
    end(key, made);
  }
}

/// REQUIRES mutex_.
void OnDemand::end(const Key& key, const Status& made) {
  Asked& asked = orders_.at(key);
  shares_.leave(std::get<0>(key));
  const bool wanted = !*asked.dropped;
  if (made || !wanted) {
    orders_.erase(key);
    return;
  }
  asked.context.log.warn(std::string(thing_.name) + " not made", made.error());
  asked.shown.state = OrderState::kFailed;
  asked.shown.error = made.error();
  forget_old_failures();
}

void OnDemand::forget_old_failures() {
  std::vector<std::pair<std::int64_t, Key>> failed;
  for (const auto& [key, order] : orders_)
    if (order.shown.state == OrderState::kFailed) failed.emplace_back(order.number, key);
  if (failed.size() <= kMostFailures) return;
  orders_.erase(std::min_element(failed.begin(), failed.end())->second);
}

Status OnDemand::make(const Key& key, const Asked& asked, render::Stills& stills) {
  Status made;
  for (int tried = 0; tried < kTries; ++tried) {
    try {
      made = make_once(key, asked, stills);
    } catch (const std::exception& e) {
      made = Error{thing_.failed, std::string("the making of the ") + thing_.name + " broke off: " + e.what(),
                   "", ErrorKind::kSystem};
    }
    if (made || *asked.dropped || made.error().kind != ErrorKind::kSystem) return made;
  }
  return made;
}

Status OnDemand::make_once(const Key& key, const Asked& asked, render::Stills& stills) {
  const std::string& job_id = std::get<1>(key);
  const auto result = [&](const std::string& name) {
    return store_.result_bytes(asked.context, job_id, name);
  };
  const std::string bytes = TRY(result(movie::kFilmFile));
  const std::unique_ptr<TemporaryFolder> folder = TRY(TemporaryFolder::make(store_.scratch_folder()));
  RunContext context;
  context.cancel = asked.dropped.get();
  context.on_progress = [&](const Progress& progress) { tell(key, progress.fraction); };
  movie::Film film = TRY(movie::decode_film(bytes));
  const Ingredients from{std::move(film), result, folder->path(), stills};
  const std::string made = TRY(asked.make(from, context));
  return keep(key, asked.context, made);
}

/// The file first and its name last: a crash in between leaves no half of a movie.
Status OnDemand::keep(const Key& key, const store::RequestContext& context, const std::string& bytes) {
  const std::string &job_id = std::get<1>(key), &name = std::get<2>(key);
  TRY(store_.put_result(context, job_id, name, bytes));
  const Result<store::JobRow> kept = store_.change_job(context, job_id, [&](store::JobRow& row) -> Status {
    TRY(check_job(row));
    row.results[name] = {static_cast<std::int64_t>(bytes.size()), hash_of(std::string_view(bytes))};
    return {};
  });
  if (!kept) return kept.error();
  context.log.info(std::string(thing_.name) + " made",
                   {{"name", name}, {"bytes", std::to_string(bytes.size())}});
  return {};
}

void OnDemand::tell(const Key& key, double fraction) {
  const std::lock_guard lock(mutex_);
  const auto found = orders_.find(key);
  if (found != orders_.end()) found->second.shown.fraction = fraction;
}

}  // namespace toile::jobs
