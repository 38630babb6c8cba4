#include "core/drape/pipeline.h"

#include <algorithm>
#include <limits>

#include "core/base/stopwatch.h"
#include "core/mesh/make_panel_meshes.h"
#include "core/preflight/preflight.h"
#include "core/sewing/assembly.h"

namespace toile::drape {

namespace {

/// Progress is told this often, in steps; a cancel is seen at every step.
constexpr int kProgressInterval = 100;

/// Crossings are looked for in so many frames at least, however soon the drape ends.
constexpr double kFewestFrames = 100;

int frame_interval_of(const DrapeInput& input) {
  const DrapeSettings& s = input.settings;
  const double shortest = std::min(shortest_drape(input), s.max_time);
  return std::clamp(static_cast<int>(shortest / s.time_step / kFewestFrames), 1,
                    std::max(1, s.frame_interval));
}

/// Adds the times of a go to those of the run when it ends.
class GoTimer {
 public:
  explicit GoTimer(DrapeResult& result) : result_(result) {}
  ~GoTimer() {
    result_.cpu_s += watch_.cpu_s();
    result_.wall_s += watch_.wall_s();
  }
  GoTimer(const GoTimer&) = delete;
  GoTimer& operator=(const GoTimer&) = delete;

 private:
  DrapeResult& result_;
  Stopwatch watch_;
};

}  // namespace

Result<DrapeStart> prepare_start(const DrapeInput& input, const RunContext& context) {
  context.progress("mesh", 0);
  auto meshes = TRY(mesh::make_panel_meshes(input.pattern, input.settings.particle_distance, context));
  context.progress("place", 0);
  auto assembly = TRY(sewing::assemble(meshes, input.placements, input.attachments, input.notions));
  DrapeStart start{std::move(meshes), std::move(assembly), {}};
  start.findings = preflight::run_preflight(
      {input.pattern, start.meshes, input.bodies, input.settings.particle_distance}, start.assembly);
  return start;
}

DrapeRun::DrapeRun(const DrapeInput& input, FrameSink* sink)
    : input_(input), sink_(sink), frame_interval_(frame_interval_of(input)) {}

Result<std::unique_ptr<DrapeRun>> DrapeRun::start(const DrapeInput& input, const RunContext& context,
                                                  FrameSink* sink) {
  std::unique_ptr<DrapeRun> run(new DrapeRun(input, sink));
  TRY(run->prepare(context));
  const GoTimer timer(run->result_);
  run->record_frame();
  return run;
}

Result<std::unique_ptr<DrapeRun>> DrapeRun::resume(const DrapeInput& input, std::string_view checkpoint,
                                                   const RunContext& context, FrameSink* sink) {
  std::unique_ptr<DrapeRun> run(new DrapeRun(input, sink));
  TRY(run->prepare(context));
  TRY(run->restore(checkpoint));
  return run;
}

Status DrapeRun::restore(std::string_view checkpoint) {
  const GoTimer timer(result_);
  RunState state = TRY(decode_checkpoint(checkpoint, session_->start_hash()));
  TRY(session_->restore(std::move(state.session)));
  result_.at_end = state.at_end;
  result_.worst = state.worst;
  result_.worst_frame_step = state.worst_frame_step;
  result_.frames_checked = state.frames_checked;
  result_.cpu_s += state.cpu_s;
  result_.wall_s += state.wall_s;
  result_.resumed = state.resumed + 1;
  recorded_ = state.recorded;
  return {};
}

std::string DrapeRun::checkpoint() const {
  return encode_checkpoint(
      session_->start_hash(),
      {session_->state(), result_.at_end, result_.worst, result_.worst_frame_step, result_.frames_checked,
       result_.resumed, recorded_, result_.cpu_s, result_.wall_s});
}

Status DrapeRun::prepare(const RunContext& context) {
  const GoTimer timer(result_);
  auto start = TRY(prepare_start(input_, context));
  if (auto refused = preflight::first_error(start.findings)) return *refused;
  result_.findings = std::move(start.findings);
  session_ = DrapeSession::start(input_, start.meshes, std::move(start.assembly));
  result_.garment = session_->garment();
  if (sink_) sink_->begin(result_.garment);
  return {};
}

/// Shows a frame to the sink and counts its crossings.
void DrapeRun::record_frame() {
  const CrossingCount count = session_->count_crossings();
  ++result_.frames_checked;
  if (count.cloth_body + count.cloth_cloth > result_.worst.cloth_body + result_.worst.cloth_cloth) {
    result_.worst = count;
    result_.worst_frame_step = session_->steps();
  }
  result_.at_end = count;
  recorded_ = session_->steps();
  if (sink_) {
    sink_->frame({session_->steps(), session_->time(), std::string(session_->progress().phase),
                  session_->positions()});
  }
}

int DrapeRun::advance(int max_steps, const RunContext& context) {
  const GoTimer timer(result_);
  int taken = 0;
  while (taken < max_steps && !session_->done() && !context.cancelled()) {
    session_->step();
    ++taken;
    if (session_->steps() % kProgressInterval == 0) {
      const Progress p = session_->progress();
      context.progress(p.phase, p.fraction);
    }
    if (session_->steps() % frame_interval_ == 0 || session_->just_welded()) record_frame();
  }
  return taken;
}

DrapeResult DrapeRun::conclude() {
  {
    const GoTimer timer(result_);
    if (recorded_ != session_->steps()) record_frame();
  }
  DrapeResult result = result_;
  result.positions = session_->positions();
  result.stop_reason = session_->stop_reason().value_or(StopReason{Stop::kCancelled, "", 0});
  result.steps = session_->steps();
  result.simulated_time = session_->time();
  result.rms_speed = session_->rms_speed();
  result.max_speed = session_->max_speed();
  result.seam_gap_max = session_->seam_gap();
  result.holds = session_->holds();
  return result;
}

Result<DrapeResult> drape(const DrapeInput& input, const RunContext& context, FrameSink* sink) {
  const auto run = DrapeRun::start(input, context, sink);
  if (!run) {
    if (run.error().kind != ErrorKind::kCancelled) return run.error();
    return DrapeResult{};  // no cloth, and stop_reason says kCancelled
  }
  (*run)->advance(std::numeric_limits<int>::max(), context);
  return (*run)->conclude();
}

}  // namespace toile::drape
