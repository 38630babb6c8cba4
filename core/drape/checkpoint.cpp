#include "core/drape/checkpoint.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/hash.h"
#include "core/base/state_bytes.h"
#include "core/drape/contact_values.h"

namespace toile::drape {
namespace {

constexpr std::string_view kMagic = "TOILECP\n";
constexpr std::size_t kHashDigits = 32;
constexpr std::size_t kHeader = kMagic.size() + sizeof(std::uint32_t) + kHashDigits;
/// No drape gets there; beyond it exact crossings could not be counted.
constexpr int kMostSteps = 1 << 30;       // so that counting on cannot overflow
constexpr double kLongest = 1e9;          // s
constexpr double kLongestRamp = 1;        // s, that a phase may seem to have begun before the drape
constexpr std::size_t kMostWords = 1000;  // bytes of a reason, or of a sentence

/// As its words, so that a checkpoint does not depend on the order of an enum; none are empty words.
void stop_value(StateWriter& out, const std::optional<StopReason>& stop) {
  out.value(stop ? to_string(*stop) : std::string());
}

void stop_value(StateReader& in, std::optional<StopReason>& stop) {
  std::string words;
  in.value(words);
  if (words.empty()) return;
  Result<StopReason> read = stop_reason_from(words);
  if (!read || words.size() > kMostWords) return in.refuse();
  stop = std::move(*read);
}

template <typename Archive>
void fields(Archive& a, MotionState& motion) {
  a.value(motion.phase);
  a.value(motion.played);
  a.value(motion.before);
  a.value(motion.waited);
  a.value(motion.marked);
  a.value(motion.since);
  a.value(motion.hoped);
  a.value(motion.steps);
  a.value(motion.pace);
  a.value(motion.over);
  a.value(motion.tight);
}

template <typename Archive>
void fields(Archive& a, TouchedPoint& at) {
  a.value(at.triangle);
  for (double& share : at.share) a.value(share);
}

template <typename Archive>
void fields(Archive& a, std::vector<Grip>& grips) {
  a.list(grips, 80, [&](Grip& grip) {
    a.value(grip.id);
    fields(a, grip.at);
    a.value(grip.wanted);
    a.value(grip.goal);
  });
}

template <typename Archive>
void fields(Archive& a, HandsState& hands) {
  fields(a, hands.pulls);
  fields(a, hands.pins);
  a.list(hands.log, 61, [&](Touch& touch) {
    a.value(touch.step);
    a.value(touch.kind);
    a.value(touch.id);
    fields(a, touch.at);
    a.value(touch.target);
  });
}

/// Every field in its order, for writing and for reading alike, so that the two cannot disagree.
template <typename Archive>
void fields(Archive& a, RunState& run) {
  SessionState& s = run.session;
  a.value(s.phase);
  a.value(s.began);
  a.value(s.lost);
  stop_value(a, s.stop_reason);
  a.value(s.steps);
  a.value(s.time);
  a.value(s.begun);
  a.value(s.phase_start);
  a.value(s.last_weld);
  a.value(s.slackened);
  a.value(s.joined);
  a.value(s.released);
  a.value(s.off_at_release);
  a.value(s.watch.step);
  a.value(s.watch.window_start);
  a.value(s.watch.rms);
  a.value(s.watch.max_speed);
  a.value(s.watch.ways);
  a.value(s.watch.drift);
  a.value(s.watch.usual_drift);
  a.value(s.watch.rates);
  a.value(s.watch.mark);
  a.value(s.watch.long_drift);
  a.value(s.watch.long_usual_drift);
  a.value(s.solver.positions);
  a.value(s.solver.velocities);
  contact_values(a, s.solver.contacts);
  a.value(s.solver.stopped);
  a.value(s.solver.stuck);
  a.value(s.solver.steps_near);
  a.value(s.solver.hits);
  a.value(s.solver.preloads);
  a.value(s.solver.pace.steps);
  a.value(s.solver.pace.learnt);
  a.value(s.probe.step);
  a.value(s.probe.failed);
  a.value(s.probe.from);
  fields(a, s.motion);
  fields(a, s.hands);
  a.value(s.paper.positions);
  a.value(s.paper.previous);
  a.value(s.paper.bent);
  a.value(run.at_end.cloth_body);
  a.value(run.at_end.cloth_cloth);
  a.value(run.worst.cloth_body);
  a.value(run.worst.cloth_cloth);
  a.value(run.worst_frame_step);
  a.value(run.frames_checked);
  a.value(run.resumed);
  a.value(run.recorded);
  a.value(run.start);
  a.value(run.last_start);
  a.value(run.begun_anew);
  a.value(run.from_the_pieces);
  a.value(run.tops);
  a.value(run.left_out);
  a.value(run.cpu_s);
  a.value(run.wall_s);
}

bool all_within(const std::vector<Vec3>& list, double most) {
  return std::all_of(list.begin(), list.end(), [most](const Vec3& v) {
    return std::abs(v.x) <= most && std::abs(v.y) <= most && std::abs(v.z) <= most;  // false for NaN
  });
}

bool all_speeds(const std::vector<double>& list) {
  return std::all_of(list.begin(), list.end(), [](double v) { return v >= 0 && v <= kFarthest; });
}

/// Whole windows of `vertices` ways each.
bool sound_ways(const std::vector<float>& ways, std::size_t vertices) {
  return (vertices == 0 ? ways.empty() : ways.size() % (3 * vertices) == 0) &&
         ways.size() <= 3 * vertices * (SettleState::kMostWindows - 1) &&
         std::all_of(ways.begin(), ways.end(), [](float v) { return std::abs(v) <= 2 * kFarthest; });
}

template <typename... Times>
bool all_times(Times... times) {
  return ((times >= 0 && times <= kLongest) && ...);
}

template <typename... Counts>
bool all_counts(Counts... counts) {
  return ((counts >= 0 && counts <= kMostSteps) && ...);
}

bool sound_bounds(const solver::SolverState& s) {
  const std::size_t n = s.positions.size();
  return s.stopped.size() == n && s.stuck.size() == n && s.steps_near.size() == n &&
         std::all_of(s.steps_near.begin(), s.steps_near.end(),
                     [](Index steps) { return steps >= 0 && steps <= kMostSteps; });
}

bool sound(const ProbeState& probe, std::size_t vertices) {
  return all_counts(probe.step, probe.failed) && (probe.from.empty() || probe.from.size() == vertices) &&
         all_within(probe.from, kFarthest);
}

bool sound(const MotionState& m, std::size_t vertices) {
  return m.phase <= MotionState::Phase::kOver &&
         all_times(m.played, m.before, m.waited, m.marked, m.since, m.hoped) && m.before <= m.played &&
         all_counts(m.steps, m.over) && m.pace >= 1 && m.pace <= kMostSteps &&
         (m.tight == kNone || (m.tight >= 0 && static_cast<std::size_t>(m.tight) < vertices));
}

/// Whether it is of this garment is for the Session to say.
bool sound(const HandsState& hands) {
  return std::all_of(hands.log.begin(), hands.log.end(), [](const Touch& touch) {
    return touch.kind <= TouchKind::kUnpin && touch.step >= 0 && touch.step <= kMostSteps;
  });
}

bool sound(const SessionState& s) {
  const std::size_t of_solver = s.solver.positions.size();
  const std::size_t of_paper = s.paper.positions.size(), n = of_solver + of_paper;
  return (of_solver == 0 || of_paper == 0) && s.paper.previous.size() == of_paper &&
         all_within(s.paper.positions, kFarthest) && all_within(s.paper.previous, kFarthest) &&
         all_speeds(s.paper.bent) && s.phase <= DrapePhase::kDone && s.began <= Began::kWarm &&
         (s.phase == DrapePhase::kDone) == s.stop_reason.has_value() &&
         all_counts(s.steps, s.watch.step, s.solver.hits, s.solver.pace.steps, s.slackened) &&
         all_times(s.time, s.begun, s.phase_start + kLongestRamp, s.last_weld, s.solver.pace.learnt) &&
         s.solver.velocities.size() == of_solver && sound_contacts(s.solver.contacts, of_solver) &&
         sound_bounds(s.solver) && sound(s.probe, of_solver) && sound(s.motion, of_solver) &&
         sound(s.hands) && s.watch.window_start.size() == n && s.watch.mark.size() == n &&
         sound_ways(s.watch.ways, n) && s.watch.rms.size() <= SettleState::kMostWindows &&
         s.watch.rates.size() <= SettleState::kMostWindows && all_speeds(s.watch.rates) &&
         all_speeds(s.off_at_release) && all_speeds(s.watch.rms) &&
         all_speeds({s.watch.max_speed, s.watch.drift, s.watch.usual_drift}) &&
         all_within(s.solver.positions, kFarthest) && all_within(s.solver.velocities, kFarthest) &&
         all_within(s.solver.preloads, 1) && all_within(s.watch.window_start, kFarthest) &&
         all_within(s.watch.mark, kFarthest) && s.watch.long_drift >= -1 && s.watch.long_drift <= kFarthest &&
         s.watch.long_usual_drift >= -1 && s.watch.long_usual_drift <= kFarthest;
}

bool sound(const RunState& run) {
  return all_counts(run.at_end.cloth_body, run.at_end.cloth_cloth, run.worst.cloth_body,
                    run.worst.cloth_cloth, run.worst_frame_step, run.frames_checked, run.resumed,
                    run.start) &&
         run.recorded >= -1 && run.recorded <= kMostSteps && run.begun_anew.size() <= kMostWords &&
         run.from_the_pieces.size() <= kMostWords &&
         std::all_of(run.tops.begin(), run.tops.end(),
                     [](double top) { return std::abs(top) <= kFarthest; }) &&
         all_times(run.cpu_s, run.wall_s) && sound(run.session);
}

}  // namespace

Error damaged_checkpoint() {
  return {"checkpoint.damaged", "the checkpoint is cut off or has changed; drape from the start", "",
          ErrorKind::kSystem};
}

std::string encode_checkpoint(const std::string& input_hash, RunState state) {
  StateWriter out;
  out.raw(kMagic);
  out.value(kCheckpointVersion);
  out.raw(input_hash);
  fields(out, state);
  out.raw(hash_of(std::string_view(out.bytes())));
  return out.take();
}

Result<RunState> decode_checkpoint(std::string_view bytes, const std::string& input_hash) {
  if (bytes.size() < kHeader + kHashDigits) return damaged_checkpoint();
  const std::string_view sealed = bytes.substr(0, bytes.size() - kHashDigits);
  if (hash_of(sealed) != bytes.substr(sealed.size())) return damaged_checkpoint();
  StateReader in(sealed);
  if (in.raw(kMagic.size()) != kMagic) return damaged_checkpoint();
  std::uint32_t version = 0;
  in.value(version);
  if (version != kCheckpointVersion) {
    return Error{"checkpoint.version", "the checkpoint is of another version; drape from the start", "",
                 ErrorKind::kSystem};
  }
  if (in.raw(kHashDigits) != input_hash) {
    return Error{"checkpoint.other_input", "the checkpoint is of another drape; go on with that one's input",
                 "", ErrorKind::kSystem};
  }
  RunState state;
  fields(in, state);
  if (!in.ok() || !in.at_end() || !sound(state)) return damaged_checkpoint();
  return state;
}

}  // namespace toile::drape
