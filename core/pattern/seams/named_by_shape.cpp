#include "core/pattern/seams/named_by_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

#include "core/pattern/seams/bodice.h"
#include "core/pattern/seams/likeness.h"
#include "core/pattern/seams/named_strips.h"
#include "core/pattern/seams/roles.h"
#include "core/pattern/seams/shapes.h"
#include "core/pattern/seams/weights.h"

namespace toile::seams {
namespace {

constexpr double kArmholeEase[2] = {-0.02, 0.14};  // share that a cap is longer than its armholes
constexpr double kShoulder[2] = {25, 230};         // mm
constexpr double kLeastSlope = 0.7;                // how much a shoulder faces up at least
constexpr double kSidesOfSleeve = 0.03;            // share that the edges beside a cap differ by at most
constexpr double kCapBend = 25;                    // degrees, that a cap bends at least

Index pieces(const SeamModel& m) { return static_cast<Index>(m.words.size()); }

/// Pieces of that kind, of two that mirror each other the first alone.
std::vector<Index> of_kind(const SeamModel& m, PieceKind kind) {
  std::vector<Index> found;
  for (Index p = 0; p < pieces(m); ++p) {
    const bool second = m.twin[p] != kNone && m.twin[p] < p;
    if (m.words[p].kind == kind && !m.words[p].layer && !second) found.push_back(p);
  }
  return found;
}

/// The run after it (`forwards`) or before it that is no leg of a dart.
const SeamRun& beyond_darts(const SeamModel& m, const SeamRun& from, bool forwards) {
  const auto step = [&](const SeamRun& at) -> const SeamRun& {
    return forwards ? m.runs[at.next] : run_before(m, at);
  };
  const SeamRun* at = &step(from);
  for (int darts = 0; darts < 4; ++darts) {
    const SeamRun& other = step(*at);
    const double corner = forwards ? other.angle : at->angle;
    if (corner < kPairWeights.dart_deg || !equally_long(at->length, other.length)) break;
    at = &step(other);
  }
  return *at;
}

/// A shoulder with what lies beside it.
struct Shoulder {
  const SeamRun* run = nullptr;
  const SeamRun* armhole = nullptr;
  const SeamRun* neck = nullptr;
};

/// Whether the run may be the armhole beside a shoulder: hollow, with a side beyond it that faces as it does.
bool is_armhole_before(const SeamModel& m, const SeamRun& run, const SeamRun& side) {
  constexpr double kSideUp = 0.5;
  return run.turn.back() < kPairWeights.neck_deg && std::abs(side.up) < kSideUp &&
         side.turn.back() > kPairWeights.hollow_deg && faces_right(m, side) * faces_right(m, run) > 0;
}

/// The piece's edges that may be shoulders: straight and sloping, with an armhole on one side and on the
/// other what comes up from no hem. The two slopes of a raglan sleeve lead to sides that are sewn together.
std::vector<Shoulder> shoulders_of(const SeamModel& m, Index panel) {
  constexpr double kSlopes = 0.99;
  std::vector<Shoulder> found;
  for (const Index r : runs_of(m, panel)) {
    const SeamRun& run = m.runs[r];
    const bool slopes = run.up > kLeastSlope && run.up < kSlopes && bend_of(run) < kPairWeights.straight_deg;
    if (!slopes || run.length < kShoulder[0] || run.length > kShoulder[1]) continue;
    const SeamRun &after = m.runs[run.next], &before = run_before(m, run);
    const SeamRun &side_after = beyond_darts(m, after, true), &side_before = beyond_darts(m, before, false);
    const bool last = is_armhole_before(m, after, side_after);
    const bool first = is_armhole_before(m, before, side_before);
    if (first == last && (!first || equally_long(side_after.length, side_before.length))) continue;
    // Of two hollow edges the neck leads to the middle, straight along the grain; or it is the shorter one.
    const bool told = is_middle(m, side_before) != is_middle(m, side_after);
    const bool longer = told ? is_middle(m, side_after) : before.length > after.length;
    const bool armhole_first = first && (!last || longer);
    const Shoulder one{&run, armhole_first ? &before : &after, armhole_first ? &after : &before};
    if (!begins_at_hem(m, *one.neck)) found.push_back(one);
  }
  return found;
}

/// The neck of a piece with sleeves cut on: hollow, between two edges of one length that slope down from it,
/// and not to the hem, as half a circle's do. Nothing of what has none.
const SeamRun* cut_on_neck(const SeamModel& m, Index panel) {
  constexpr double kNeck = 600, kSlopesUp = 0.75;  // mm, of half a neck at most; facing
  for (const Index r : runs_of(m, panel)) {
    const SeamRun &neck = m.runs[r], &after = m.runs[neck.next], &before = run_before(m, neck);
    const bool hollow = neck.turn.back() < kPairWeights.neck_deg && neck.up > kPairWeights.facing;
    const bool slopes = std::min(after.up, before.up) > kSlopesUp && &after != &before &&
                        equally_long(after.length, before.length) && after.length > kShoulder[1];
    if (hollow && slopes && neck.length < kNeck && !begins_at_hem(m, after) && !begins_at_hem(m, before))
      return &neck;
  }
  return nullptr;
}

/// How long the shoulders beside that neck are, mm; 0 of what has none.
double cut_on_shoulder(const SeamModel& m, Index panel) {
  const SeamRun* neck = cut_on_neck(m, panel);
  return neck == nullptr ? 0 : m.runs[neck->next].length;
}

bool share_length(const std::vector<Shoulder>& a, const std::vector<Shoulder>& b) {
  return std::any_of(a.begin(), a.end(), [&](const Shoulder& x) {
    return std::any_of(b.begin(), b.end(), [&](const Shoulder& y) {
      return difference(*x.run, *y.run) < kPairWeights.shoulder_ease;
    });
  });
}

/// How far the run goes down from its ends, mm.
double depth_of(const SeamModel& m, const SeamRun& neck, const SeamRun& shoulder) {
  const Vec2 up = m.up[neck.panel];
  double lowest = HUGE_VAL;
  for (const Vec2 p : neck.at) lowest = std::min(lowest, dot(p, up));
  return std::max(dot(shoulder.at.front(), up), dot(shoulder.at.back(), up)) - lowest;
}

/// How far the neck beside its shoulder goes down, mm; nothing where the piece has none.
std::optional<double> neck_depth(const SeamModel& m, Index panel) {
  const std::vector<Shoulder> shoulders = shoulders_of(m, panel);
  if (!shoulders.empty()) return depth_of(m, *shoulders.front().neck, *shoulders.front().run);
  const SeamRun* neck = cut_on_neck(m, panel);
  if (neck == nullptr) return std::nullopt;
  return depth_of(m, *neck, m.runs[neck->next]);
}

/// How long the hollow edge of a leg is, mm; of half the trunk it is the back's that reaches further.
double crotch_length(const SeamModel& m, Index panel) {
  double longest = 0;
  for (const Index r : runs_of(m, panel)) {
    const SeamRun& run = m.runs[r];
    if (run.turn.back() < kPairWeights.twin_hollow_deg && std::abs(run.up) < kPairWeights.facing)
      longest = std::max(longest, run.length);
  }
  return longest;
}

void set_face(SeamModel& m, Index panel, int face) {
  m.words[panel].face = face;
  if (m.twin[panel] != kNone) m.words[m.twin[panel]].face = face;
}

/// The front's neck is the lower one, the back's crotch the longer one. Two alike tell nothing.
template <class Measure>
void tell_faces(SeamModel& m, const std::vector<Index>& parts, double least, Measure measure) {
  std::vector<std::pair<double, Index>> measured;
  for (const Index p : parts)
    if (const std::optional<double> value = measure(p)) measured.push_back({*value, p});
  if (measured.size() < 2) return;
  std::sort(measured.begin(), measured.end());
  std::size_t split = 0;
  double widest = 0;
  for (std::size_t k = 1; k < measured.size(); ++k) {
    const double gap = measured[k].first - measured[k - 1].first;
    if (gap > widest) {
      widest = gap;
      split = k;
    }
  }
  if (widest < least) return;
  for (std::size_t k = 0; k < measured.size(); ++k) set_face(m, measured[k].second, k < split ? -1 : 1);
}

/// Lengths of armholes of fronts and backs, mm.
std::array<std::vector<double>, 2> armholes(const SeamModel& m) {
  std::array<std::vector<double>, 2> lengths;
  for (const Index p : of_kind(m, PieceKind::kTorso))
    for (const Shoulder& shoulder : shoulders_of(m, p))
      lengths[m.words[p].face > 0].push_back(shoulder.armhole->length);
  return lengths;
}

bool eased_onto(double cap, double armhole) {
  return cap > armhole * (1 + kArmholeEase[0]) && cap < armhole * (1 + kArmholeEase[1]);
}

/// Whether the run is a sleeve's cap: bent, as long as a front's and a back's armhole together, and between
/// two edges of one length, which are sewn to each other.
bool is_cap_of(const SeamModel& m, const SeamRun& run, const std::array<std::vector<double>, 2>& armholes) {
  const SeamRun &after = m.runs[run.next], &before = run_before(m, run);
  if (bend_of(run) < kCapBend || difference(after, before) > kSidesOfSleeve) return false;
  return std::any_of(armholes[0].begin(), armholes[0].end(), [&](double back) {
    return std::any_of(armholes[1].begin(), armholes[1].end(),
                       [&](double front) { return eased_onto(run.length, back + front); });
  });
}

/// Names sleeves; gives the length of what lies opposite the cap of the last one, mm, or 0.
double name_sleeves(SeamModel& m) {
  const std::array<std::vector<double>, 2> lengths = armholes(m);
  double wrist = 0;
  for (const SeamRun& run : m.runs) {
    PieceWords& words = m.words[run.panel];
    if (words.kind != PieceKind::kOther || words.layer || !is_cap_of(m, run, lengths)) continue;
    words.guess(PieceKind::kSleeve);
    words.limb = true;
    wrist = m.girth[run.panel] - run.length - m.runs[run.next].length - run_before(m, run).length;
  }
  return wrist;
}

/// Length of the edges of pieces of that kind that face up, or down, but for hollow ones below an arm, mm.
double ends_of(const SeamModel& m, PieceKind kind, bool up) {
  double sum = 0;
  for (const SeamRun& run : m.runs)
    if (m.words[run.panel].kind == kind && !m.words[run.panel].layer &&
        (up ? run.up > kPairWeights.facing
            : run.up < -kPairWeights.facing && run.turn.back() > kPairWeights.hollow_deg))
      sum += run.length;
  return sum;
}

/// Length around a wrist of sleeves that are cut on, where the shoulders end, mm; 0 where there are none.
double cut_on_wrist(const SeamModel& m) {
  double wrist = 0;
  for (Index p = 0; p < pieces(m); ++p)
    if (const SeamRun* neck = m.words[p].kind == PieceKind::kTorso ? cut_on_neck(m, p) : nullptr)
      wrist += m.runs[m.runs[neck->next].next].length;
  return wrist;
}

/// Pairs with a lower edge as long as half the neck, far larger than a collar, and round: hoods.
void name_hoods(SeamModel& m) {
  constexpr double kLeast = 0.85, kMost = 1.2, kLarge = 900, kRound = 40;  // times half the neck; mm; degrees
  const double half = neck_of(m) / 2;
  for (const SeamRun& run : m.runs) {
    PieceWords& words = m.words[run.panel];
    const Index twin = m.twin[run.panel];
    const bool pair = twin != kNone && twin != run.panel && m.girth[run.panel] > kLarge;
    const std::vector<Index> all = runs_of(m, run.panel);
    const bool round =
        std::any_of(all.begin(), all.end(), [&](Index r) { return bend_of(m.runs[r]) > kRound; });
    const bool fits =
        round && run.length > kLeast * half && run.length < kMost * half && run.up < -kLeastSlope;
    if (words.kind == PieceKind::kOther && !words.layer && pair && fits) words.guess(PieceKind::kHood);
  }
}

/// Whether the piece is a leg cut in one: a hem between two edges of one length, above which it narrows on
/// both sides, along the seams of front and seat, to a level waist. Sleeves narrow to less, or not to a
/// level.
bool is_whole_leg(const SeamModel& m, Index panel) {
  constexpr double kLeastWaist = 0.5, kMostWaist = 0.95;  // of the width where the legs part
  if (m.twin[panel] == kNone || m.twin[panel] == panel) return false;
  const std::vector<Index> all = runs_of(m, panel);
  return std::any_of(all.begin(), all.end(), [&](Index h) {
    const SeamRun &hem = m.runs[h], &after = m.runs[hem.next], &before = run_before(m, hem);
    if (hem.up > -kPairWeights.facing_fully || difference(after, before) > kSidesOfSleeve) return false;
    const double width = length(before.at.front() - after.at.back());
    return std::any_of(all.begin(), all.end(), [&](Index w) {
      const SeamRun& waist = m.runs[w];
      const bool level = waist.up > kPairWeights.facing_fully && bend_of(waist) < kPairWeights.straight_deg;
      const bool apart = &m.runs[waist.next] != &before && &run_before(m, waist) != &after;
      return level && apart && waist.length > kLeastWaist * width && waist.length < kMostWaist * width;
    });
  });
}

}  // namespace

bool names_nothing(const SeamModel& m) {
  using enum PieceKind;
  return std::none_of(m.words.begin(), m.words.end(), [](const PieceWords& w) {
    return w.kind == kTorso || w.kind == kSkirt || w.kind == kLegs || w.kind == kSleeve || w.kind == kHood ||
           w.face != 0 || w.flank;
  });
}

double neck_of(const SeamModel& m) {
  std::vector<const SeamRun*> necks;
  for (Index p = 0; p < pieces(m); ++p) {
    if (m.words[p].kind != PieceKind::kTorso) continue;
    for (const Shoulder& shoulder : shoulders_of(m, p))
      if (std::find(necks.begin(), necks.end(), shoulder.neck) == necks.end()) necks.push_back(shoulder.neck);
    if (const SeamRun* neck = cut_on_neck(m, p)) necks.push_back(neck);
  }
  double sum = 0;
  for (const SeamRun* neck : necks) sum += neck->length;
  return sum;
}

void name_shapes(SeamModel& m) {
  std::vector<std::vector<Shoulder>> shoulders;
  shoulders.reserve(m.words.size());
  for (Index p = 0; p < pieces(m); ++p) shoulders.push_back(shoulders_of(m, p));
  std::vector<double> cut_on;
  cut_on.reserve(m.words.size());
  for (Index p = 0; p < pieces(m); ++p) cut_on.push_back(cut_on_shoulder(m, p));
  std::vector<char> crotch;
  crotch.reserve(m.words.size());
  for (Index p = 0; p < pieces(m); ++p) crotch.push_back(shoulders[p].empty() && has_leg_crotch(m, p));
  for (Index p = 0; p < pieces(m); ++p) {
    PieceWords& words = m.words[p];
    if (words.kind != PieceKind::kOther || words.layer) continue;
    bool torso = false, legs = false;
    for (Index q = 0; q < pieces(m); ++q) {
      if (same_edges(m, p, q)) continue;
      torso = torso || share_length(shoulders[p], shoulders[q]) ||
              (cut_on[p] > 0 && equally_long(cut_on[p], cut_on[q]));
      legs = legs || (crotch[p] && crotch[q]);
    }
    if (torso) words.guess(PieceKind::kTorso);
    if (!torso && legs) {
      words.guess(PieceKind::kLegs);
      words.leg = true;
    }
  }
}

void name_by_fit(SeamModel& m) {
  constexpr double kNeck = 8, kCrotch = 15;  // mm, that a front's and a back's differ by at least
  for (Index p = 0; p < pieces(m); ++p) {
    PieceWords& words = m.words[p];
    if (words.kind != PieceKind::kOther || words.layer || !is_whole_leg(m, p)) continue;
    words.guess(PieceKind::kLegs);
    words.leg = true;
  }
  tell_faces(m, of_kind(m, PieceKind::kTorso), kNeck, [&](Index p) { return neck_depth(m, p); });
  tell_faces(m, of_kind(m, PieceKind::kLegs), kCrotch,
             [&](Index p) -> std::optional<double> { return -crotch_length(m, p); });
  const double sleeves = name_sleeves(m), wrist = sleeves > 0 ? sleeves : cut_on_wrist(m);
  name_strips(m,
              {ends_of(m, PieceKind::kLegs, true), wrist, neck_of(m), ends_of(m, PieceKind::kTorso, false)});
  name_waistband(m);
  name_hoods(m);
}

void name_lone_sleeves(SeamModel& m) {
  constexpr double kCap[2] = {250, 800}, kBlunt = 30;  // mm; degrees, where a cap has a corner at its top
  const auto any = [&](PieceKind kind) {
    return std::any_of(m.words.begin(), m.words.end(),
                       [&](const PieceWords& words) { return words.kind == kind && !words.layer; });
  };
  if (!any(PieceKind::kTorso) || any(PieceKind::kSleeve)) return;
  for (const SeamRun& first : m.runs) {
    PieceWords& words = m.words[first.panel];
    const bool pair = m.twin[first.panel] != kNone && m.twin[first.panel] != first.panel;
    if (words.kind != PieceKind::kOther || words.layer || words.face != 0 || !pair) continue;
    if (bend_of(first) < kCapBend) continue;
    const SeamRun& next = m.runs[first.next];
    const bool goes_on = bend_of(next) >= kCapBend && std::abs(next.angle - 180) < kBlunt;
    const SeamRun &last = goes_on ? next : first, &before = run_before(m, first), &after = m.runs[last.next];
    const double cap = first.length + (goes_on ? next.length : 0);
    const bool hem = &m.runs[after.next] != &before && &after != &before;
    if (!hem || cap < kCap[0] || cap > kCap[1] || difference(after, before) > kSidesOfSleeve) continue;
    words.guess(PieceKind::kSleeve);
    words.limb = true;
  }
}

}  // namespace toile::seams
