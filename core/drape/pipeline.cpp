#include "core/drape/pipeline.h"

#include <limits>

#include "core/base/stopwatch.h"
#include "core/mesh/make_panel_meshes.h"
#include "core/sewing/assembly.h"

namespace toile {

namespace {

/// Progress is told this often, in steps; a cancel is seen at every step.
constexpr int kProgressInterval = 100;

/// Adds the times of a go to those of the run when it ends.
class GoTimer {
 public:
  explicit GoTimer(DrapeResult& result) : result_(result) {}
  ~GoTimer() { result_.cpu_s += watch_.cpu_s(), result_.wall_s += watch_.wall_s(); }
  GoTimer(const GoTimer&) = delete;
  GoTimer& operator=(const GoTimer&) = delete;

 private:
  DrapeResult& result_;
  Stopwatch watch_;
};

}  // namespace

Result<std::unique_ptr<DrapeRun>> DrapeRun::start(const DrapeInput& input, const RunContext& context,
                                                  FrameSink* sink) {
  std::unique_ptr<DrapeRun> run(new DrapeRun(input, sink));
  if (const Status prepared = run->prepare(context); !prepared) return prepared.error();
  return run;
}

Status DrapeRun::prepare(const RunContext& context) {
  const GoTimer timer(result_);
  context.progress("mesh", 0);
  const auto meshes = make_panel_meshes(input_.pattern, input_.settings.particle_distance, context);
  if (!meshes) return meshes.error();

  context.progress("place", 0);
  auto assembly = assemble(*meshes, input_.placements, input_.attachments);
  if (!assembly) return assembly.error();
  auto session = DrapeSession::start(input_, *meshes, std::move(*assembly));
  if (!session) return session.error();

  session_ = std::move(*session);
  result_.garment = session_->garment();
  if (sink_) sink_->begin(result_.garment);
  record_frame();
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
    if (session_->steps() % input_.settings.frame_interval == 0) record_frame();
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
  result.settled = session_->done() && session_->settled();
  result.stop_reason = session_->done() ? session_->stop_reason() : "cancelled";
  result.steps = session_->steps();
  result.simulated_time = session_->time();
  result.rms_speed = session_->rms_speed();
  result.max_speed = session_->max_speed();
  result.seam_gap_max = session_->seam_gap();
  return result;
}

Result<DrapeResult> drape(const DrapeInput& input, const RunContext& context, FrameSink* sink) {
  const auto run = DrapeRun::start(input, context, sink);
  if (!run) {
    if (run.error().code != "cancelled") return run.error();
    DrapeResult nothing;
    nothing.stop_reason = "cancelled";
    return nothing;
  }
  (*run)->advance(std::numeric_limits<int>::max(), context);
  return (*run)->conclude();
}

}  // namespace toile
