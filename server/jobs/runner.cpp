#include "server/jobs/runner.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <new>
#include <utility>

#include "core/analysis/report.h"
#include "core/base/text.h"
#include "core/base/units.h"
#include "core/base/write_file.h"
#include "core/exports/write_report.h"
#include "server/jobs/input.h"
#include "server/jobs/kept_drape.h"
#include "server/jobs/results.h"
#include "server/movie/film_codec.h"

namespace toile::jobs {
namespace {

using Clock = std::chrono::steady_clock;

constexpr auto kTellEvery = std::chrono::milliseconds(100);
/// A slice is about this long, so that slow drapes tell how far they are as often as quick ones.
constexpr double kSlice = 50;  // ms

Clock::time_point later(std::chrono::duration<double> by) {
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(by);
}

RunEnd failed(const Error& error) {
  RunEnd end;
  end.code = error.code;
  end.reason = error.message;
  end.where = error.where;
  return end;
}

/// What stills are drawn from and where they go. The drawing thread may hold it longer than the run lives.
struct Delivery {
  std::shared_ptr<const drape::DrapeInput> input;
  std::shared_ptr<const drape::DrapeResult> result;
  image::Textures textures;
  std::unique_ptr<TemporaryFolder> folder;
};

Status draw(const RunPlace& place, const RunControl& control, std::shared_ptr<const Delivery> delivery,
            const Log& log) {
  const auto drawing = [delivery = std::move(delivery), width = place.still_width,
                        height = place.still_height](render::Stills& stills,
                                                     const RunContext& context) -> Status {
    const std::filesystem::path& path = delivery->folder->path();
    TRY(write_stills(stills, *delivery->input, *delivery->result, delivery->textures, path, width, height,
                     context));
    return write_thumbnail(stills, *delivery->input, *delivery->result, delivery->textures, path);
  };
  return place.renderer->draw(drawing, control.abandon, log);
}

}  // namespace

JobRun::JobRun(const RunPlace& place, store::RequestContext context, std::string job_id, std::uint32_t epoch)
    : place_(place), context_(std::move(context)), job_id_(std::move(job_id)), epoch_(epoch) {
  progress_.state = store::JobState::kRunning;
}

std::optional<RunEnd> JobRun::go_on(const RunControl& control) {
  work_ = WorkClock();  // another thread's than the last
  std::optional<RunEnd> end = caught(control);
  account(control);
  return end;
}

void JobRun::account(const RunControl& control) {
  const double seconds = work_.lap();
  if (progress_.phase == kStillsPhase) return;  // a thread that waits; add_stills looks at the clock
  worked_s_ += seconds;
  control.on_worked(progress_.phase.empty() ? "mesh" : progress_.phase, seconds);
}

Status JobRun::check_limits() const {
  return check_work(place_.limits, worked_s_, run_ ? run_->session().steps() : 0);
}

std::optional<RunEnd> JobRun::caught(const RunControl& control) {
  try {
    return through_all_stages(control);
  } catch (const std::bad_alloc&) {
    context_.log.error("drape ran out of memory", {{"phase", progress_.phase}});
    return failed({"internal.memory",
                   "there was not enough memory for this drape; a larger particle distance needs less", "",
                   ErrorKind::kInternal});
  } catch (const std::exception& e) {
    context_.log.error("drape threw", {{"phase", progress_.phase}, {"what", e.what()}});
    return failed(
        {"internal.exception", std::string("the drape broke off: ") + e.what(), "", ErrorKind::kInternal});
  } catch (...) {
    context_.log.error("drape threw what is no exception", {{"phase", progress_.phase}});
    return failed({"internal.unknown", "the drape broke off for a reason that it did not name", "",
                   ErrorKind::kInternal});
  }
}

std::optional<RunEnd> JobRun::through_all_stages(const RunControl& control) {
  const auto interrupted = [&] { return control.interrupt->load(std::memory_order_relaxed); };
  if (!run_ && !result_) {
    if (interrupted()) return std::nullopt;
    if (const Status begun = begin(control); !begun) {
      if (begun.error().kind == ErrorKind::kCancelled) return std::nullopt;
      return failed(begun.error());
    }
  }
  if (run_) {
    const Status draped = drape_on(control);
    if (!draped) return failed(draped.error());
    if (aside_ || !run_->done()) return std::nullopt;
    control.hands->close();
    result_ = std::make_shared<const drape::DrapeResult>(run_->conclude());
    read_figures();
    run_.reset();  // the solver's memory is not needed for the rest
  }
  const Result<RunEnd> end = deliver(control);
  if (end) return *end;
  if (end.error().kind == ErrorKind::kCancelled) return std::nullopt;
  return failed(end.error());
}

RunContext JobRun::context_of(const RunControl& control) {
  RunContext context;
  context.cancel = control.interrupt;
  context.threads = control.threads();
  return context;
}

/// Of one that was put aside nothing is told but where it goes on: its viewers have its triangles, and its
/// hands are still on it.
Status JobRun::begin(const RunControl& control) {
  if (!aside_) tell(control, "mesh", 0);
  TRY(read_input());
  const double worked = worked_s_;
  RunContext context = context_of(control);
  context.on_progress = [&](const Progress& p) {
    if (aside_) return;
    if (p.phase == "dress") return tell(control, p.phase, p.fraction);
    tell(control, "mesh", p.phase == "mesh" ? p.fraction : 1);
  };
  std::unique_ptr<drape::DrapeRun> run = TRY(start_or_resume(context));
  run_ = std::move(run);
  input_ = run_->reduced() ? std::make_shared<const drape::DrapeInput>(run_->input()) : whole_;
  const drape::Session& session = run_->session();
  checkpoint_step_ = session.steps();
  next_checkpoint_ = later(place_.checkpoint_every);
  if (std::exchange(aside_, false)) {
    account(control);
    loads_in_s_ = worked_s_ - worked;
    return {};
  }
  let_go_of_all();
  progress_.first_step = session.steps();
  stream_.emplace(*place_.publisher, job_id_, epoch_, *input_, session.garment(), session.start_positions());
  stream_->show(session.steps(), session.time(), session.positions());
  return {};
}

Status JobRun::read_input() {
  if (!whole_) {
    const store::JobRow row = TRY(place_.documents->store().job(context_, job_id_));
    if (!aside_) worked_s_ = static_cast<double>(row.worked_ms) / 1000;
    pictures_ = row.pictures;
    drape::DrapeInput input = TRY(drape_input_of(*place_.documents, context_, row.document, row.files));
    whole_ = std::make_shared<const drape::DrapeInput>(std::move(input));
  }
  if (whole_->settings.method == drape::DrapeMethod::kPaper) {
    const double steps = paper::kFrameTime / whole_->settings.paper.time_step;
    place_.stream_interval = std::max(1, static_cast<int>(steps));
  }
  return {};
}

/// From the newest checkpoint; one that is of no use (damaged, of another version) costs the time that it
/// would have saved and nothing else.
Result<std::unique_ptr<drape::DrapeRun>> JobRun::start_or_resume(const RunContext& context) {
  if (const auto kept = place_.documents->store().checkpoint(context_, job_id_)) {
    auto run = resume(kept->bytes, context);
    if (run || run.error().kind != ErrorKind::kSystem) return run;
    context_.log.warn("checkpoint of no use; the drape starts anew", run.error());
  }
  recorder_.emplace();
  return drape::DrapeRun::start(*whole_, context, &*recorder_);
}

Result<std::unique_ptr<drape::DrapeRun>> JobRun::resume(std::string_view bytes, const RunContext& context) {
  const KeptDrape kept = TRY(decode_kept(bytes));
  Result<movie::Motion> motion = movie::decode_motion(kept.motion);
  recorder_.emplace(movie::MotionLimits{}, motion ? std::move(*motion) : movie::Motion{});
  return drape::DrapeRun::resume(*whole_, kept.checkpoint, context, &*recorder_);
}

/// A store that takes none (its disk is full) is no reason to stop. Keeping takes at most a twentieth of the
/// time.
void JobRun::keep_checkpoint(const RunControl& control) {
  if (checkpoint_step_ == run_->session().steps()) return;
  const Clock::time_point before = Clock::now();
  if (put_checkpoint() && !run_->done()) control.on_kept();  // the end is told when it is in the store
  const std::chrono::duration<double> took = Clock::now() - before;
  next_checkpoint_ = later(std::max(place_.checkpoint_every, 20 * took));
}

bool JobRun::put_checkpoint(bool with_shape) {
  KeptDrape drape{movie::encode_motion(recorder_->motion()), run_->checkpoint(), ""};
  if (with_shape) drape.shape = shape_in_memory();
  const std::string bytes = encode_kept(drape);
  const Status kept = place_.documents->store().put_checkpoint(context_, job_id_, bytes);
  if (kept) {
    checkpoint_step_ = run_->session().steps();
  } else {
    context_.log.warn("checkpoint not kept", kept.error());
  }
  return kept.ok();
}

/// Frees what the store has of it. False: the store does not take it, and is not asked again for a while.
bool JobRun::put_aside(const RunControl& control) {
  if (Clock::now() < next_aside_) return false;
  if (!put_checkpoint(true)) {
    next_aside_ = later(place_.checkpoint_every);
    return false;
  }
  tell_where_it_stands(control);
  run_.reset();  // before what it refers to
  recorder_.reset();
  input_.reset();
  whole_.reset();
  aside_ = true;
  return true;
}

void JobRun::keep_where_it_stands() {
  if (run_ && checkpoint_step_ != run_->session().steps()) put_checkpoint();
}

Status JobRun::drape_on(const RunControl& control) {
  while (!run_->done() && !control.interrupt->load(std::memory_order_relaxed)) {
    take_touches(*control.hands);
    if (control.shape->is_asked()) control.shape->answer(shape_in_memory());
    advance_slice(control);
    account(control);
    TRY(check_limits());
    // What it has done since its last checkpoint waits with it in memory.
    const bool framed = run_->session().steps() % place_.stream_interval == 0;
    if (!run_->done() && !control.one_frame) {
      const MakeRoom room = control.make_room();
      if (room == MakeRoom::kInMemory || (room == MakeRoom::kAside && put_aside(control))) return {};
    }
    if (control.one_frame && framed) break;
    if (Clock::now() >= next_checkpoint_) keep_checkpoint(control);
  }
  if (!run_->done()) tell_where_it_stands(control);
  // The end as well: a crash among models and pictures must cost no step.
  if (control.worth_keeping()) keep_checkpoint(control);
  const drape::Session& session = run_->session();
  if (run_->done() && stream_->step() != session.steps()) {
    stream_->show(session.steps(), session.time(), session.positions());
  }
  return {};
}

/// To the next streamed frame, or as far as the time of a slice goes.
void JobRun::advance_slice(const RunControl& control) {
  const drape::Session& session = run_->session();
  const int to_frame = place_.stream_interval - session.steps() % place_.stream_interval;
  const double affordable = kSlice / std::max(1e-3, progress_.step_ms);
  const int steps = std::clamp(static_cast<int>(std::min(affordable, 1e6)), 1, to_frame);
  const Clock::time_point before = Clock::now();
  RunContext context = context_of(control);
  context.on_progress = [&](const Progress& p) {  // it may begin anew; the session tells of all else
    if (p.phase == "dress") tell(control, p.phase, p.fraction);
  };
  const int taken = run_->advance(steps, context);
  if (taken > 0) {
    progress_.step_ms = std::chrono::duration<double, std::milli>(Clock::now() - before).count() / taken;
  }
  if (session.steps() % place_.stream_interval == 0 && stream_->step() != session.steps()) {
    stream_->show(session.steps(), session.time(), session.positions());
  }
  const Progress p = session.progress();
  tell(control, p.phase, p.fraction);
}

void JobRun::read_figures() {
  if (!run_) return;
  const drape::Session& session = run_->session();
  progress_.step = session.steps();
  progress_.simulated_s = session.time();
  progress_.rms_speed = session.rms_speed();
  progress_.seam_gap_mm = mm_from_metres(session.seam_gap());
  progress_.cloth_body = run_->crossings().cloth_body;
  progress_.cloth_cloth = run_->crossings().cloth_cloth;
  // What has ended is held by nobody, though a hand was on it to the last.
  progress_.pulls = session.stop_reason() ? 0 : static_cast<int>(session.hands().pulls.size());
  progress_.pins.clear();
  for (const drape::Grip& pin : session.hands().pins) progress_.pins.push_back({pin.id, pin.goal});
}

/// A new phase is told at once, the same again only after a while.
void JobRun::tell(const RunControl& control, std::string_view phase, double fraction) {
  const Clock::time_point now = Clock::now();
  if (phase == progress_.phase && now - told_ < kTellEvery) return;
  told_ = now;
  account(control);
  if (phase != progress_.phase) {
    context_.log.debug("phase", {{"phase", std::string(phase)}, {"worked_s", fixed_text(worked_s_, 3)}});
  }
  progress_.phase = phase;
  progress_.fraction = fraction;
  read_figures();
  control.on_progress(progress_);
}

Result<image::Textures> JobRun::read_pictures() {
  const store::JobRow row = TRY(place_.documents->store().job(context_, job_id_));
  return textures_of(*place_.documents, context_, row.document, row.files, input_->pattern);
}

/// The drape is worth keeping without them.
void JobRun::read_pictures_into(RunEnd& end) {
  Result<image::Textures> textures = read_pictures();
  if (textures) {
    textures_ = std::move(*textures);
    return;
  }
  context_.log.warn("pictures on pieces not read", textures.error());
  fall_short(end, "pictures.not_read",
             "it is shown without the pictures on its pieces: " + textures.error().message);
}

/// Models and report into the store.
Result<RunEnd> JobRun::deliver_models() {
  store::Store& store = place_.documents->store();
  const std::unique_ptr<TemporaryFolder> folder = TRY(TemporaryFolder::make(store.scratch_folder()));
  RunEnd end = verdict_on(*input_, *result_);
  end.touched = !result_->touches.empty();
  end.report = exports::report_json(analysis::make_report(*input_, *result_));
  read_pictures_into(end);
  TRY(write_models(*input_, *result_, textures_, folder->path(), true));
  TRY(write_film(*input_, *result_, textures_, recorder_->motion(), folder->path()));
  const store::JobRow row = TRY(store.job(context_, job_id_));
  manifest::Manifest manifest = TRY(inputs_of(*place_.documents, context_, row));
  manifest.made_by = manifest::this_program(place_.engine);
  TRY(write_manifest(std::move(manifest), *result_, folder->path(), true));
  TRY(write_file(folder->path() / "report.json", end.report));
  auto results = TRY(keep_results(store, context_, job_id_, folder->path()));
  end.results = std::move(results);
  return end;
}

Status JobRun::add_stills(const RunControl& control, RunEnd& end) {
  store::Store& store = place_.documents->store();
  auto delivery = std::make_shared<Delivery>();
  delivery->input = input_;
  delivery->result = result_;
  delivery->textures = textures_;
  std::unique_ptr<TemporaryFolder> folder = TRY(TemporaryFolder::make(store.scratch_folder()));
  delivery->folder = std::move(folder);
  Status drawn = draw(place_, control, delivery, context_.log);
  if (!drawn && drawn.error().kind == ErrorKind::kCancelled) return drawn;
  if (!drawn) {
    context_.log.warn("stills not drawn", drawn.error());
    fall_short(end, "stills.not_drawn", "there are no pictures of it: " + drawn.error().message);
  }
  end.results.merge(TRY(keep_results(store, context_, job_id_, delivery->folder->path())));
  return {};
}

/// Results first: the state that names them is written by whoever is told.
Result<RunEnd> JobRun::deliver(const RunControl& control) {
  if (!end_) {
    RunEnd end = TRY(deliver_models());
    if (!pictures_) return end;
    TRY(control.on_draped(end));
    end_ = std::move(end);
  }
  tell(control, kStillsPhase, 0);
  RunEnd whole = *end_;
  const Clock::time_point before = Clock::now();
  Status added = add_stills(control, whole);
  control.on_worked(kStillsPhase, std::chrono::duration<double>(Clock::now() - before).count());
  if (!added) {
    if (added.error().kind == ErrorKind::kCancelled) return added.error();
    context_.log.warn("stills not kept", added.error());
    whole = *end_;
    fall_short(whole, "stills.not_kept", "its pictures could not be kept: " + added.error().message);
  }
  tell(control, kStillsPhase, 1);
  return whole;
}

}  // namespace toile::jobs
