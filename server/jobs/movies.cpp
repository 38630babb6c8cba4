#include "server/jobs/movies.h"

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <exception>
#include <utility>

#include "core/base/hash.h"
#include "core/base/names.h"
#include "core/base/read_file.h"
#include "core/base/text.h"
#include "server/jobs/results.h"
#include "server/movie/film_codec.h"

namespace toile::jobs {
namespace {

constexpr int kGivesWay = 10;              // as nice(1) counts: drapes come first
constexpr std::size_t kMostFailures = 64;  // that are remembered
constexpr int kTries = 2;                  // where the machine was at fault

struct StateWord {
  MovieState state;
  std::string_view word;
};
constexpr std::array kStateWords{
    StateWord{MovieState::kQueued, "queued"}, StateWord{MovieState::kMaking, "making"},
    StateWord{MovieState::kMade, "made"}, StateWord{MovieState::kFailed, "failed"}};

bool is_movie(const std::string& name) { return name.ends_with(".mp4") || name.ends_with(".avi"); }

bool is_under_way(MovieState state) { return state == MovieState::kQueued || state == MovieState::kMaking; }

Status check_job(const store::JobRow& job) {
  if (store::is_final(job.state) && job.results.contains(movie::kFilmFile)) return {};
  return Error{
      "movie.no_film",
      "there is nothing to make a movie of: the job has not ended, or was draped by an older program", job.id,
      ErrorKind::kConflict};
}

}  // namespace

std::string_view word_of(MovieState state) {
  const auto found = std::find_if(kStateWords.begin(), kStateWords.end(),
                                  [state](const StateWord& entry) { return entry.state == state; });
  return found->word;
}

std::string movie_name(const movie::MovieSettings& settings) {
  std::string name = std::string(movie::word_of(settings.kind)) + "-" + std::to_string(settings.width) + "x" +
                     std::to_string(settings.height) + "-" + std::to_string(settings.fps);
  if (settings.seconds) name += "-" + number_text(*settings.seconds) + "s";
  return name + "." + movie::word_of(settings.format);
}

Movies::Movies(store::Store& store, MovieLimits limits)
    : store_(store), limits_(limits), thread_([this] { work(); }) {}

void Movies::stop() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
    for (auto& [key, order] : orders_) *order.dropped = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

Status Movies::check_room(const store::RequestContext& context, const store::JobRow& job) const {
  const auto waiting =
      static_cast<std::size_t>(std::count_if(orders_.begin(), orders_.end(), [](const auto& entry) {
        return is_under_way(entry.second.shown.state);
      }));
  const auto own = static_cast<std::size_t>(std::count_if(orders_.begin(), orders_.end(), [&](const auto& e) {
    return std::get<0>(e.first) == context.owner && is_under_way(e.second.shown.state);
  }));
  if (waiting >= limits_.waiting || own >= limits_.waiting_of_owner) {
    return Error{"movie.busy", "too many movies are waiting to be made; ask again when some are done", "",
                 ErrorKind::kTooMany};
  }
  const auto kept = static_cast<std::size_t>(std::count_if(
      job.results.begin(), job.results.end(), [](const auto& file) { return is_movie(file.first); }));
  if (kept < limits_.of_job) return {};
  return Error{"movie.too_many",
               "the job has as many movies as are kept (" + std::to_string(limits_.of_job) + ")", job.id,
               ErrorKind::kConflict};
}

Result<MovieOrder> Movies::ask(const store::RequestContext& context, const std::string& job_id,
                               const movie::MovieSettings& settings) {
  TRY(movie::check_settings(settings));
  if (std::max(settings.width, settings.height) > limits_.side) {
    return Error{"movie.settings",
                 "a movie has at most " + std::to_string(limits_.side) + " pixels a side here",
                 settings.width > limits_.side ? "width" : "height"};
  }
  const store::JobRow job = TRY(store_.job(context, job_id));
  TRY(check_job(job));
  const std::string name = movie_name(settings);
  if (job.results.contains(name)) return MovieOrder{name, MovieState::kMade, 1, std::nullopt};
  const Key key{context.owner, job_id, name};
  const std::lock_guard lock(mutex_);
  const auto found = orders_.find(key);
  if (found != orders_.end() && is_under_way(found->second.shown.state)) return found->second.shown;
  TRY(check_room(context, job));
  Order order;
  order.context = context.for_job(job_id);
  order.settings = settings;
  order.shown.name = name;
  order.number = ++asked_;
  MovieOrder shown = order.shown;
  orders_.insert_or_assign(key, std::move(order));
  shares_.enter(context.owner);
  changed_.notify_one();
  return shown;
}

Result<std::vector<MovieOrder>> Movies::of_job(const store::RequestContext& context,
                                               const std::string& job_id) {
  std::vector<MovieOrder> movies;
  {  // before the row is read: what is made in between is then in both, and not in neither
    const std::lock_guard lock(mutex_);
    for (const auto& [key, order] : orders_)
      if (std::get<0>(key) == context.owner && std::get<1>(key) == job_id) movies.push_back(order.shown);
  }
  const store::JobRow job = TRY(store_.job(context, job_id));
  std::erase_if(movies, [&](const MovieOrder& order) { return job.results.contains(order.name); });
  for (const auto& [name, file] : job.results)
    if (is_movie(name)) movies.push_back({name, MovieState::kMade, 1, std::nullopt});
  return movies;
}

Status Movies::cancel(const store::RequestContext& context, const std::string& job_id,
                      const std::string& name) {
  const std::lock_guard lock(mutex_);
  const auto found = orders_.find({context.owner, job_id, name});
  if (found == orders_.end() || !is_under_way(found->second.shown.state)) {
    return Error{"store.not_found", "no such movie is being made", clipped(name), ErrorKind::kNotFound};
  }
  *found->second.dropped = true;
  if (found->second.shown.state == MovieState::kQueued) {
    orders_.erase(found);
    shares_.leave(context.owner);
  }
  return {};
}

/// Of the owner who has had least of the thread's time, what was asked for first.
std::optional<Movies::Key> Movies::next() const {
  std::optional<Key> best;
  std::pair<double, std::int64_t> least;
  for (const auto& [key, order] : orders_) {
    if (order.shown.state != MovieState::kQueued) continue;
    const std::pair<double, std::int64_t> stands{shares_.had(std::get<0>(key)), order.number};
    if (best && least <= stands) continue;
    best = key;
    least = stands;
  }
  return best;
}

void Movies::work() {
  ::setpriority(PRIO_PROCESS, 0, kGivesWay);  // of this thread, and of the ffmpeg that it starts
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return stopping_ || next().has_value(); });
    if (stopping_) return;
    const Key key = *next();
    Order& order = orders_.at(key);
    order.shown.state = MovieState::kMaking;
    const Order copy = order;
    lock.unlock();
    const auto before = std::chrono::steady_clock::now();
    const Status made = make(key, copy);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - before;
    lock.lock();
    shares_.charge(std::get<0>(key), took.count());
    end(key, made);
  }
}

/// REQUIRES mutex_.
void Movies::end(const Key& key, const Status& made) {
  Order& order = orders_.at(key);
  shares_.leave(std::get<0>(key));
  const bool wanted = !*order.dropped;
  if (made || !wanted) {
    orders_.erase(key);
    return;
  }
  order.context.log.warn("movie not made", made.error());
  order.shown.state = MovieState::kFailed;
  order.shown.error = made.error();
  forget_old_failures();
}

void Movies::forget_old_failures() {
  std::vector<std::pair<std::int64_t, Key>> failed;
  for (const auto& [key, order] : orders_)
    if (order.shown.state == MovieState::kFailed) failed.emplace_back(order.number, key);
  if (failed.size() <= kMostFailures) return;
  orders_.erase(std::min_element(failed.begin(), failed.end())->second);
}

Status Movies::make(const Key& key, const Order& order) {
  Status made;
  for (int tried = 0; tried < kTries; ++tried) {
    try {
      made = make_once(key, order);
    } catch (const std::exception& e) {
      made = Error{"movie.failed", std::string("the making of the movie broke off: ") + e.what(), "",
                   ErrorKind::kSystem};
    }
    if (made || *order.dropped || made.error().kind != ErrorKind::kSystem) return made;
  }
  return made;
}

Status Movies::make_once(const Key& key, const Order& order) {
  const std::string& job_id = std::get<1>(key);
  const std::string bytes = TRY(store_.result_bytes(order.context, job_id, movie::kFilmFile));
  const movie::Film film = TRY(movie::decode_film(bytes));
  const std::unique_ptr<TemporaryFolder> folder = TRY(TemporaryFolder::make(store_.scratch_folder()));
  const std::filesystem::path path = folder->path() / order.shown.name;
  RunContext context;
  context.cancel = order.dropped.get();
  context.on_progress = [&](const Progress& progress) { tell(key, progress.fraction); };
  TRY(movie::make_movie(film, order.settings, path, context));
  const std::optional<std::string> made = read_file(path);
  if (!made) return Error{"export.read", "cannot read the movie back", path.string(), ErrorKind::kInternal};
  return keep(key, order.context, *made);
}

/// The file first and its name last: a crash in between leaves no half of a movie.
Status Movies::keep(const Key& key, const store::RequestContext& context, const std::string& bytes) {
  const std::string &job_id = std::get<1>(key), &name = std::get<2>(key);
  TRY(store_.put_result(context, job_id, name, bytes));
  const Result<store::JobRow> kept = store_.change_job(context, job_id, [&](store::JobRow& row) -> Status {
    TRY(check_job(row));
    row.results[name] = {static_cast<std::int64_t>(bytes.size()), hash_of(std::string_view(bytes))};
    return {};
  });
  if (!kept) return kept.error();
  context.log.info("movie made", {{"name", name}, {"bytes", std::to_string(bytes.size())}});
  return {};
}

void Movies::tell(const Key& key, double fraction) {
  const std::lock_guard lock(mutex_);
  const auto found = orders_.find(key);
  if (found != orders_.end()) found->second.shown.fraction = fraction;
}

}  // namespace toile::jobs
