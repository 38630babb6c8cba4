#include "core/drape/pipeline.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "core/base/crew.h"
#include "core/base/stopwatch.h"
#include "core/base/text.h"
#include "core/drape/drape_session.h"
#include "core/drape/fit_start.h"
#include "core/drape/ground_level.h"
#include "core/drape/input_hash.h"
#include "core/drape/left_open.h"
#include "core/drape/paper_session.h"
#include "core/drape/worn_verdict.h"
#include "core/preflight/preflight.h"
#include "core/sewing/assembly.h"
#include "core/warm/carried_pins.h"

namespace toile::drape {

namespace {

/// Progress is told this often, in steps; a cancel is seen at every step.
constexpr int kProgressInterval = 100;

/// Crossings are looked for in so many frames at least, however soon the drape ends.
constexpr double kFewestFrames = 100;

/// Triangles of cloth that several threads find enough to do with.
constexpr std::size_t kFewestShared = 2000;

int frame_interval_of(const DrapeInput& input) {
  const DrapeSettings& s = input.settings;
  if (s.method == DrapeMethod::kPaper)
    return std::max(1, static_cast<int>(paper::kFrameTime / s.paper.time_step));
  const double shortest = std::min(shortest_drape(input), s.max_time);
  return std::clamp(static_cast<int>(shortest / s.time_step / kFewestFrames), 1,
                    std::max(1, s.frame_interval));
}

/// Threads that are worth it: a step of small cloth is over before a second one has begun.
int threads_for(const sewing::GarmentMesh& garment, const RunContext& context) {
  return garment.triangles.size() < kFewestShared ? 1 : context.threads;
}

/// Adds the times of a go to those of the run when it ends.
class GoTimer {
 public:
  explicit GoTimer(DrapeResult& result, Crew* crew = nullptr) : result_(result), crew_(crew) {}
  ~GoTimer() {
    result_.cpu_s += watch_.cpu_s() + (crew_ ? crew_->helpers_cpu_s() : 0);
    result_.wall_s += watch_.wall_s();
  }
  GoTimer(const GoTimer&) = delete;
  GoTimer& operator=(const GoTimer&) = delete;

 private:
  DrapeResult& result_;
  Crew* crew_;  ///< of this go; null where one works alone
  Stopwatch watch_;
};

/// Putting on may already have let a garment sink: where pieces were placed counts as well.
std::vector<double> tops_where_begun(const sewing::Assembly& placed, std::span<const Vec3> began) {
  std::vector<double> tops = tops_of(placed.garment, placed.positions);
  const std::vector<double> began_at = tops_of(placed.garment, began);
  for (std::size_t p = 0; p < tops.size(); ++p) tops[p] = std::max(tops[p], began_at[p]);
  return tops;
}

constexpr double kWorthTelling = 0.1;  // s, that bodies waited
constexpr std::size_t kMostId = 200;   // bytes of a seam's id within a sentence

/// Those of the input, as they stand now.
std::vector<body::Body> bodies_now(const DrapeInput& input, const Session& session) {
  std::vector<body::Body> bodies = input.bodies;
  std::vector<std::vector<Vec3>> moved = session.moved_bodies();
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (!moved[b].empty()) bodies[b].mesh.vertices = std::move(moved[b]);
    bodies[b].motion.clear();
  }
  return bodies;
}

bool any_moves(const DrapeInput& input) {
  return std::any_of(input.bodies.begin(), input.bodies.end(),
                     [](const body::Body& body) { return !body.motion.empty(); });
}

/// Why another start is tried, as it is told.
std::string why_anew(const Session& session, int start) {
  if (start != kSewnInPlace)
    return "the garment did not stay where it is worn, so that it was put on in another way and draped anew";
  const std::vector<OpenSeam> open = session.open_seams();
  const auto widest = std::max_element(open.begin(), open.end(),
                                       [](const OpenSeam& a, const OpenSeam& b) { return a.gap < b.gap; });
  const std::string what = widest == open.end() ? "the garment did not end where it is worn"
                                                : "the seam " + widest->id.substr(0, kMostId) + " stayed " +
                                                      preflight::length_text(widest->gap) + " open";
  const std::string from = session.began() == Began::kWarm ? "from how it hung before"
                                                           : "when it was sewn from where the pieces stand";
  return what + " " + from + ", so that it was put on the body and draped anew";
}

}  // namespace

DrapeRun::DrapeRun(const DrapeInput& input, FrameSink* sink)
    : given_(input), sink_(sink), frame_interval_(frame_interval_of(input)) {}

Result<std::unique_ptr<DrapeRun>> DrapeRun::start(const DrapeInput& input, const RunContext& context,
                                                  FrameSink* sink) {
  std::unique_ptr<DrapeRun> run(new DrapeRun(input, sink));
  TRY(run->prepare(context));
  Crew crew(threads_for(run->session().garment(), context));
  const GoTimer timer(run->result_, &crew);
  if (sink) sink->begin(run->result_.garment);
  run->record_frame(crew);
  return run;
}

Result<std::unique_ptr<DrapeRun>> DrapeRun::resume(const DrapeInput& input, std::string_view checkpoint,
                                                   const RunContext& context, FrameSink* sink) {
  std::unique_ptr<DrapeRun> run(new DrapeRun(input, sink));
  TRY(run->restore(checkpoint, context));
  if (sink) sink->begin(run->result_.garment);
  return run;
}

Status DrapeRun::restore(std::string_view checkpoint, const RunContext& context) {
  const GoTimer timer(result_);
  DrapeStart start = TRY(prepare_start(given_, context));
  start_hash_ = input_hash(given_, start.placed);
  RunState state = TRY(decode_checkpoint(checkpoint, start_hash_));
  if (!state.left_out.empty()) {
    if (state.left_out.size() != given_.pattern.panels.size()) return damaged_checkpoint();
    DrapeInput reduced = without_panels(given_, start, state.left_out);
    start = TRY(prepare_start(reduced, context));
    reduce(std::move(state.left_out), std::move(reduced));
  }
  const bool hangs = state.session.began != Began::kPlaced;
  if (hangs) begin_on_body(start);
  TRY(begin(std::move(start), hangs));
  TRY(session_->restore(std::move(state.session)));
  start_ = state.start;
  last_start_ = state.last_start;
  begun_anew_ = std::move(state.begun_anew);
  from_the_pieces_ = std::move(state.from_the_pieces);
  if (state.tops.size() != input().pattern.panels.size()) return damaged_checkpoint();
  tops_ = std::move(state.tops);
  result_.at_end = state.at_end;
  result_.worst = state.worst;
  result_.worst_frame_step = state.worst_frame_step;
  result_.frames_checked = state.frames_checked;
  result_.cpu_s += state.cpu_s;
  result_.wall_s += state.wall_s;
  result_.resumed = state.resumed + 1;
  recorded_ = state.recorded;
  ended_badly_ = ends_badly();
  return {};
}

std::string DrapeRun::checkpoint() const {
  return encode_checkpoint(
      start_hash_, {session_->state(), result_.at_end, result_.worst, result_.worst_frame_step,
                    result_.frames_checked, result_.resumed, recorded_, start_, last_start_, begun_anew_,
                    from_the_pieces_, tops_, left_out_, result_.cpu_s, result_.wall_s});
}

Status DrapeRun::prepare(const RunContext& context) {
  const GoTimer timer(result_);
  DrapeStart start = TRY(prepare_start(given_, context));
  start_hash_ = input_hash(given_, start.placed);
  if (TRY(go_on(start))) return {};
  FittedStart fitted = fit_start(given_, start, context);
  if (context.cancelled()) return Error{"cancelled", "Putting on was cancelled.", "", ErrorKind::kCancelled};
  if (fitted.reduced) reduce(std::move(fitted.left_out), std::move(*fitted.reduced));
  last_start_ = fitted.last_start;
  if (start.dressed) start_ = start.dressed->start;
  const bool on_body = start.dressed.has_value();
  return begin(std::move(start), on_body);
}

/// Whether it goes on from the end of another drape, where the input has one; else it begins from the pieces.
Result<bool> DrapeRun::go_on(const DrapeStart& start) {
  if (!input().before) return false;
  if (input().settings.method == DrapeMethod::kPaper) {
    from_the_pieces_ = "the paper's method begins with the pieces";
    return false;
  }
  DrapeStart hung = start;
  begin_on_body(hung);
  if (preflight::first_error(hung.findings)) return false;  // of the pattern: it is told from the pieces
  TRY(begin(std::move(hung), true));
  auto& session = static_cast<DrapeSession&>(*session_);
  if (Status on = session.go_on_from(*input().before, start.meshes, person_); !on) {
    from_the_pieces_ = on.error().message + (on.error().where.empty() ? "" : " (" + on.error().where + ")");
    return false;
  }
  last_start_ = !may_put_on(input(), start);
  tops_ = tops_where_begun(start.placed, session.positions());
  TRY(pin_as_before(start.meshes));
  return true;
}

/// The first touches of the drape, and in its log as all others.
Status DrapeRun::pin_as_before(const mesh::PanelMeshes& meshes) {
  for (const warm::CarriedPin& pin : warm::carried_pins(*input().before, input().pattern, meshes)) {
    Touch touch;
    touch.kind = TouchKind::kPin;
    touch.at = {pin.triangle, pin.share};
    TRY(session_->touch(touch));
  }
  return {};
}

void DrapeRun::reduce(std::vector<bool> left_out, DrapeInput reduced) {
  left_out_ = std::move(left_out);
  reduced_ = std::move(reduced);
}

Status DrapeRun::begin(DrapeStart start, bool on_body) {
  if (auto refused = preflight::first_error(start.findings)) return *refused;
  result_.findings = std::move(start.findings);
  const std::optional<double> ground = ground_under(input(), start, on_body);
  tell_low_ground(start, ground, result_.findings);
  person_ = start.person;
  std::optional<std::vector<Vec3>> dressed;
  if (start.dressed) dressed = std::move(start.dressed->positions);
  facing_left_open_ = facing_of_left_open(input(), start.meshes, start.placed.garment);
  tops_ = tops_where_begun(start.placed, dressed ? *dressed : start.assembly.positions);
  if (input().settings.method == DrapeMethod::kPaper) {
    session_ = PaperSession::start(input(), start.meshes, std::move(start.assembly), dressed, ground);
    tell_left_out_by_paper();
  } else {
    session_ = DrapeSession::start(input(), start.meshes, std::move(start.assembly), dressed, ground);
  }
  result_.garment = session_->garment();
  pieces_ = warm::flat_pieces(input().pattern, start.meshes);
  return {};
}

void DrapeRun::tell_left_out_by_paper() {
  const std::string kinds = left_out_by_paper(input());
  if (kinds.empty()) return;
  result_.findings.push_back(preflight::found(
      preflight::FindingKind::kMethodWithout,
      "the paper's method knows nothing of " + kinds + "; the garment is draped without", {}, {}));
}

/// Whether another start may do better: seams do not close, or the garment is not where it is worn.
bool DrapeRun::ends_badly() const {
  if (last_start_ || !session_->may_begin_anew()) return false;
  if (!session_->done()) return session_->lost_seams();
  const std::vector<OpenSeam> open = session_->open_seams();
  if (!open.empty() || session_->stop_reason()->kind == Stop::kNotFinite) return true;
  const std::vector<body::Body> bodies = bodies_now(input(), *session_);
  const WornVerdict verdict =
      judge_worn(input(), any_moves(input()) ? dressing::find_person(bodies) : person_, result_.garment,
                 session_->positions(), tops_, open);
  const auto told = [&](preflight::FindingKind kind) {
    return std::any_of(verdict.findings.begin(), verdict.findings.end(),
                       [&](const preflight::Finding& f) { return f.kind == kind; });
  };
  // What is too wide falls from any start.
  // Threads between pieces that stand low close below the shoulders; putting on begins above them.
  const bool below = start_ == kSewnInPlace && told(preflight::FindingKind::kOffShoulder);
  const bool amiss = below || told(preflight::FindingKind::kRingOff) ||
                     told(preflight::FindingKind::kElsewhere) || told(preflight::FindingKind::kNeckShut);
  return amiss && !told(preflight::FindingKind::kOnGround);
}

/// From the next start that is certified, where there is one, and only once; else it goes on as it is. What a
/// cancel breaks off is done by the next go.
void DrapeRun::begin_anew(const RunContext& context) {
  auto start = prepare_start(input(), context);
  std::optional<PutOn> on;
  if (start) on = put_on_after(start_, input(), *start, context).on;
  if (context.cancelled()) return;
  ended_badly_ = false;
  last_start_ = true;
  if (!on) return;
  begun_anew_ = why_anew(*session_, start_);
  start_ = on->start;
  tops_ = tops_where_begun(start->placed, on->positions);
  session_->begin_anew(on->positions, ground_under(input(), *start, true));
  std::erase_if(result_.findings, [](const preflight::Finding& f) {
    return f.kind == preflight::FindingKind::kBelowFloor;  // the ground is the floor now
  });
}

/// Shows a frame to the sink and counts its crossings.
void DrapeRun::record_frame(Crew& crew) {
  const CrossingCount count = session_->count_crossings(crew);
  ++result_.frames_checked;
  if (count.cloth_body + count.cloth_cloth > result_.worst.cloth_body + result_.worst.cloth_cloth) {
    result_.worst = count;
    result_.worst_frame_step = session_->steps();
  }
  result_.at_end = count;
  recorded_ = session_->steps();
  if (sink_) {
    sink_->frame({session_->steps(), session_->time(), std::string(session_->progress().phase),
                  session_->positions(), session_->motion().played});
  }
}

int DrapeRun::advance(int max_steps, const RunContext& context) {
  Crew crew(threads_for(session_->garment(), context));
  const GoTimer timer(result_, &crew);
  int taken = 0;
  while (taken < max_steps && !done() && !context.cancelled()) {
    if (ended_badly_) {
      begin_anew(context);
      continue;
    }
    touch_again();
    session_->step(crew);
    ++taken;
    if (session_->done() || session_->lost_seams()) ended_badly_ = ends_badly();
    if (session_->steps() % kProgressInterval == 0) {
      const Progress p = session_->progress();
      context.progress(p.phase, p.fraction);
    }
    if (session_->steps() % frame_interval_ == 0 || session_->just_welded()) record_frame(crew);
  }
  return taken;
}

/// Such a seam is open as one that did not close is: the drape is a result in part.
void DrapeRun::tell_what_is_left_open(DrapeResult& result) const {
  for (OpenSeam& seam : gaps_left_open(input(), facing_left_open_, result.positions)) {
    if (result.settled()) result.stop_reason = StopReason{Stop::kOpenSeam, seam.id, seam.gap};
    result.open_seams.push_back(std::move(seam));
  }
}

/// What the bodies' motion came to, where it did not go as told.
void DrapeRun::tell_motion(DrapeResult& result) const {
  using preflight::FindingKind;
  const MotionFigures motion = session_->motion();
  const auto tenths = [](double s) { return fixed_text(s, 1) + " s"; };
  if (motion.whole) {
    if (motion.waited < kWorthTelling) return;
    result.findings.push_back(preflight::found(
        FindingKind::kBodyWaited,
        "the body waited " + tenths(motion.waited) + " for cloth that was in its way", {}, {}));
    return;
  }
  if (!session_->done()) return;  // it was going to
  const int percent = static_cast<int>(100 * motion.share);
  std::string message = "the body stopped after " + std::to_string(percent) +
                        " % of its motion, since the cloth could not give way any more";
  preflight::Concerns about;
  if (motion.panel != kNone) {
    message += ": there it still had " + preflight::length_text(motion.way_left) +
               " to go; a wider piece, a softer fabric or less motion lets it through";
    about.push_back(
        preflight::piece_named(input().pattern.panels[static_cast<std::size_t>(motion.panel)].id));
  }
  result.findings.push_back(
      preflight::found(FindingKind::kBodyStopped, std::move(message), std::move(about), motion.place));
}

/// The cloth itself would slide off: a person who wears it will want to know.
void DrapeRun::tell_held(DrapeResult& result) const {
  const std::array<bool, 2> held = session_->held_on_shoulders();
  for (const std::size_t side : {measure::kWearersLeft, measure::kWearersRight}) {
    if (!person_ || !held.at(side)) continue;
    result.findings.push_back(preflight::found(preflight::FindingKind::kHeldOn,
                                               std::string("the garment would slide off the ") +
                                                   (side == measure::kWearersLeft ? "left" : "right") +
                                                   " shoulder and is held there; a narrower neck, a shorter "
                                                   "shoulder seam or more friction keeps it on",
                                               {}, person_->figure.shoulder.at(side)));
  }
}

DrapeResult DrapeRun::conclude() {
  {
    Crew alone;
    const GoTimer timer(result_);
    if (recorded_ != session_->steps()) record_frame(alone);
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
  tell_what_is_left_open(result);
  result.bodies = bodies_now(input(), *session_);
  WornVerdict verdict =
      judge_worn(input(), any_moves(input()) ? dressing::find_person(result.bodies) : person_, result.garment,
                 result.positions, tops_, result.open_seams);
  tell_motion(result);
  tell_held(result);
  result.worn = verdict.worn;
  std::move(verdict.findings.begin(), verdict.findings.end(), std::back_inserter(result.findings));
  if (session_->began() == Began::kWarm)
    result.findings.push_back(preflight::found(preflight::FindingKind::kGoesOn,
                                               "the drape went on from how the garment hung before", {}, {}));
  if (!from_the_pieces_.empty())
    result.findings.push_back(preflight::found(
        preflight::FindingKind::kFromThePieces,
        "the garment was draped from its pieces, not from how it hung before: " + from_the_pieces_, {}, {}));
  if (!begun_anew_.empty())
    result.findings.push_back(preflight::found(preflight::FindingKind::kBegunAnew, begun_anew_, {}, {}));
  result.touches = session_->hands().log;
  tell_touches(result);
  preflight::sort_by_severity(result.findings);
  result.holds = session_->holds();
  result.hung = hung();
  return result;
}

warm::HungGarment DrapeRun::hung() const {
  warm::HungGarment hung = pieces_;
  const sewing::GarmentMesh& garment = session_->garment();
  warm::hang(garment, session_->positions(), session_->state().solver.preloads, hung);
  for (const Grip& pin : session_->hands().pins) {
    const auto triangle = static_cast<std::size_t>(pin.at.triangle);
    Vec2 flat;
    for (std::size_t k = 0; k < 3; ++k)
      flat = flat + garment.rest[garment.triangles[triangle][k]] * pin.at.share[k];
    const auto panel = static_cast<std::size_t>(garment.panel_of_triangle[triangle]);
    hung.pins.push_back({input().pattern.panels[panel].id, flat});
  }
  return hung;
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
