#include "core/drape/pipeline.h"

#include "core/base/stopwatch.h"
#include "core/drape/session.h"
#include "core/mesh/make_panel_meshes.h"
#include "core/sewing/assembly.h"

namespace toile {

namespace {

/// Progress is told this often, in steps; a cancel is seen at every step.
constexpr int kProgressInterval = 100;

/// Shows a frame to the sink and counts its crossings.
void record_frame(const DrapeSession& session, FrameSink* sink, DrapeResult& result) {
  const CrossingCount count = session.count_crossings();
  ++result.frames_checked;
  if (count.cloth_body + count.cloth_cloth > result.worst.cloth_body + result.worst.cloth_cloth) {
    result.worst = count;
    result.worst_frame_step = session.steps();
  }
  result.at_end = count;
  if (sink)
    sink->frame(
        {session.steps(), session.time(), std::string(session.progress().phase), session.positions()});
}

void run(DrapeSession& session, const DrapeInput& input, const RunContext& context, FrameSink* sink,
         DrapeResult& result) {
  record_frame(session, sink, result);
  int recorded = 0;
  while (!session.done() && !context.cancelled()) {
    session.step();
    if (session.steps() % kProgressInterval == 0) {
      const Progress p = session.progress();
      context.progress(p.phase, p.fraction);
    }
    if (session.steps() % input.settings.frame_interval == 0) {
      record_frame(session, sink, result);
      recorded = session.steps();
    }
  }
  if (recorded != session.steps()) record_frame(session, sink, result);
}

void conclude(const DrapeSession& session, const RunContext& context, DrapeResult& result) {
  result.positions = session.positions();
  result.settled = session.done() && session.settled();
  result.stop_reason = session.done() ? session.stop_reason() : context.cancelled() ? "cancelled" : "";
  result.steps = session.steps();
  result.simulated_time = session.time();
  result.rms_speed = session.rms_speed();
  result.max_speed = session.max_speed();
  result.seam_gap_max = session.seam_gap();
}

}  // namespace

Result<DrapeResult> drape(const DrapeInput& input, const RunContext& context, FrameSink* sink) {
  const Stopwatch watch;
  context.progress("mesh", 0);
  const auto meshes = make_panel_meshes(input.pattern, input.settings.particle_distance, context);
  if (!meshes) return meshes.error();

  context.progress("place", 0);
  auto assembly = assemble(*meshes, input.placements, input.attachments);
  if (!assembly) return assembly.error();
  auto session = DrapeSession::start(input, *meshes, std::move(*assembly));
  if (!session) return session.error();

  DrapeResult result;
  result.garment = (*session)->garment();
  if (sink) sink->begin(result.garment);
  run(**session, input, context, sink, result);
  conclude(**session, context, result);
  result.cpu_s = watch.cpu_s();
  result.wall_s = watch.wall_s();
  return result;
}

}  // namespace toile
