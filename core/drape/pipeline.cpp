#include "core/drape/pipeline.h"

#include <algorithm>
#include <limits>

#include "core/base/stopwatch.h"
#include "core/drape/input_hash.h"
#include "core/dressing/certificate.h"
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

constexpr double kOffGround = 1.5e-3;  // m, that cloth starts above the ground at least
constexpr double kDropped = 0.01;      // m above the ground: what lies there all around has fallen

/// The floor that the person stands on, where all of the cloth starts above it.
std::optional<double> ground_under(const DrapeInput& input, const DrapeStart& start) {
  if (!input.settings.ground || !start.person) return std::nullopt;
  const double floor = start.person->figure.floor;
  const std::vector<Vec3>& x = start.dressed ? *start.dressed : start.assembly.positions;
  const bool above = std::all_of(x.begin(), x.end(), [&](Vec3 p) { return p.y > floor + kOffGround; });
  return above ? std::optional(floor) : std::nullopt;
}

preflight::Concerns pieces_of(const DrapeInput& input, const sewing::GarmentMesh& garment,
                              const std::vector<Index>& ring) {
  preflight::Concerns pieces;
  for (const Index v : ring) {
    preflight::Concern piece = preflight::piece_named(input.pattern.panels[garment.panel_of_vertex[v]].id);
    if (std::find(pieces.begin(), pieces.end(), piece) == pieces.end()) pieces.push_back(std::move(piece));
  }
  return pieces;
}

/// Whether the garment ended where it is worn: rings around limbs, and not all on the ground.
void judge_worn(const DrapeInput& input, const std::optional<dressing::Person>& person, DrapeResult& result) {
  if (!person || result.garment.sewn.empty()) return;
  const bool whole =
      result.open_seams.empty() && std::all_of(input.left_out.begin(), input.left_out.end(),
                                               [](const LeftOut& piece) { return piece.layer; });
  result.worn = whole ? Worn::kYes : Worn::kPartly;
  const auto add = [&](preflight::FindingKind kind, std::string message, preflight::Concerns about, Vec3 at) {
    result.findings.push_back(preflight::found(kind, std::move(message), std::move(about), at));
    result.worn = Worn::kNo;
  };
  const dressing::Skeleton skeleton = dressing::skeleton_of(person->figure);
  for (const dressing::WornRing& ring : dressing::worn_rings(result.garment, result.positions, skeleton)) {
    if (ring.right) continue;
    add(preflight::FindingKind::kRingOff,
        "the ring of " + preflight::length_text(ring.girth) + " ended around no part of the body",
        pieces_of(input, result.garment, ring.vertices), result.positions[ring.vertices.front()]);
  }
  const auto highest = std::max_element(result.positions.begin(), result.positions.end(),
                                        [](Vec3 a, Vec3 b) { return a.y < b.y; });
  if (highest->y < person->figure.leg[0].ankle.y + kDropped)
    add(preflight::FindingKind::kOnGround, "the garment has fallen to the ground", {}, *highest);
  preflight::sort_by_severity(result.findings);
}

}  // namespace

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
  TRY(run->restore(checkpoint, context));
  return run;
}

Status DrapeRun::restore(std::string_view checkpoint, const RunContext& context) {
  const GoTimer timer(result_);
  DrapeStart start = TRY(prepare_start(input_, context));
  RunState state = TRY(decode_checkpoint(checkpoint, input_hash(input_, start.placed)));
  if (state.session.dressed) begin_on_body(start);
  TRY(begin(std::move(start)));
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
      start_hash_, {session_->state(), result_.at_end, result_.worst, result_.worst_frame_step,
                    result_.frames_checked, result_.resumed, recorded_, result_.cpu_s, result_.wall_s});
}

Status DrapeRun::prepare(const RunContext& context) {
  const GoTimer timer(result_);
  DrapeStart start = TRY(prepare_start(input_, context));
  dress_start(input_, start, context);
  return begin(std::move(start));
}

Status DrapeRun::begin(DrapeStart start) {
  if (auto refused = preflight::first_error(start.findings)) return *refused;
  start_hash_ = input_hash(input_, start.placed);
  result_.findings = std::move(start.findings);
  const std::optional<double> ground = ground_under(input_, start);
  person_ = start.person;
  session_ = DrapeSession::start(input_, start.meshes, std::move(start.assembly), start.dressed, ground);
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
  result.open_seams = session_->open_seams();
  judge_worn(input_, person_, result);
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
