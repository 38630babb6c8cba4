#include "core/pattern/seams/upper_ends.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/pattern/seams/likeness.h"
#include "core/pattern/seams/model.h"
#include "core/pattern/seams/piece_words.h"
#include "core/pattern/seams/roles.h"
#include "core/pattern/seams/weights.h"

namespace toile::seams {
namespace {

/// Set by hand on the bodices, legs and skirts of 46 random designs of GarmentCode, odd ones too, and of 23
/// of FreeSewing in ten sizes, all drawn upright: of the former none is stood on its head, of the latter one
/// design of underwear.
struct EndWeights {
  double tells = 12;     ///< degrees of what opens upwards that tell; bodices and legs mostly have 30 to 200
  double down = 30;      ///< … downwards, with a shoulder at that end: onesies have leg openings there
  double surely = 50;    ///< … downwards, of a bodice without any
  double neck_deg = 60;  ///< how much a neck is hollow at least that tells whatever else is …
  double back_neck_deg = 35;  ///< … and where the other end is straight: a back's is shallow
  double skirt_tells = 25;    ///< … of a skirt, which may be hollow at its hem
  double wider = 1.25;        ///< times, of a hem over the upper end: skirts may narrow a little downwards
  double dart_deg = 300;      ///< degrees of cloth from which on a corner is a dart's tip
  double dart_legs = 0.05;    ///< share that a dart's legs may differ by
};
constexpr EndWeights kEndWeights;

struct HeightSpan {
  double low = HUGE_VAL, high = -HUGE_VAL;

  void take(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
  /// −1 at the low end, 1 at the high one.
  double place(double x) const { return high > low ? (2 * x - low - high) / (high - low) : 0; }
};

HeightSpan along_grain(const SeamModel& m, const std::vector<Index>& runs, Vec2 grain) {
  HeightSpan span;
  for (const Index r : runs)
    for (const Vec2 at : m.runs[r].at) span.take(dot(at, grain));
  return span;
}

/// Whether the corner at the run's start is a dart's tip: between edges of one length.
bool is_dart(const SeamModel& m, const SeamRun& run) {
  const double before = run_before(m, run).length;
  return std::abs(before - run.length) < kEndWeights.dart_legs * run.length;
}

/// How far what is hollow opens along the grain, and what bulges does so against it, degrees: a bit of a
/// curve counts by how much its outside faces that way.
struct Opening {
  double hollow = 0, bulge = 0;
};

Opening opening_of(const SeamModel& m, const std::vector<Index>& runs, Vec2 grain) {
  Opening opening;
  const auto take = [&](double turn, Vec2 along) {  // degrees; the outline's direction there
    const double faces = dot(normalized(-perpendicular(along)), grain);
    if (turn < 0)
      opening.hollow -= turn * faces;
    else
      opening.bulge -= turn * faces;
  };
  for (const Index r : runs) {
    const SeamRun& run = m.runs[r];
    for (std::size_t k = 1; k < run.turn.size(); ++k)
      take(run.turn[k] - run.turn[k - 1], run.at[k + 1] - run.at[k - 1]);
    const SeamRun& before = run_before(m, run);
    const Vec2 in = normalized(before.at.back() - before.at[SeamRun::kSamples - 2]);
    const Vec2 out = normalized(run.at[1] - run.at[0]);
    if (run.angle > 180 && run.angle < kEndWeights.dart_deg && !is_dart(m, run))
      take(180 - run.angle, in + out);
  }
  return opening;
}

/// How much wider the end at the grain's tail is than the one at its head: times.
double widening(const SeamModel& m, const std::vector<Index>& runs, Vec2 grain) {
  constexpr double kEnd = 0.5;  // of the height's half
  const HeightSpan span = along_grain(m, runs, grain);
  HeightSpan head, tail;
  for (const Index r : runs) {
    const SeamRun& run = m.runs[r];
    for (const Vec2 at : {run.at.front(), run.at.back()}) {
      const double place = span.place(dot(at, grain));
      if (std::abs(place) > kEnd) (place > 0 ? head : tail).take(cross(grain, at));
    }
  }
  return head.high > head.low && tail.high > tail.low ? (tail.high - tail.low) / (head.high - head.low) : 1;
}

/// Whether a piece is a brief's: with a short end in its middle that two leg openings leave.
bool has_forks(const SeamModel& m) {
  return std::any_of(m.runs.begin(), m.runs.end(), [&](const SeamRun& run) {
    return run.mirror_panel == run.panel && run.mirror_edge == run.edge &&
           run.length < kPairWeights.crotch * m.girth[run.panel] && lies_between_hollows(m, run);
  });
}

/// +1 where a neck in the middle of a whole front or back faces along the grain, −1 where it faces against
/// it: sides that run into sleeves cut on are hollow as well, and open downwards. 0: there is none, or one at
/// either end.
int told_by_neck(const SeamModel& m, const std::vector<Index>& runs) {
  constexpr double kFaces = 0.9;
  double up = 0, down = 0;  // degrees that the middle's ends are hollow by
  bool straight = false;
  for (const Index r : runs) {
    const SeamRun& run = m.runs[r];
    const bool in_middle = run.mirror_panel == run.panel && run.mirror_edge == run.edge;
    if (!in_middle || std::abs(run.up) < kFaces) continue;
    straight = straight || run.straight;
    double& end = run.up > 0 ? up : down;
    end = std::max(end, -run.turn.back());
  }
  const double least = straight ? kEndWeights.back_neck_deg : kEndWeights.neck_deg;
  return (up > least) - (down > least);
}

/// +1 where the grain points upwards, −1 where it points down, 0 where the shape does not tell. `turned`: the
/// model of all pieces on their heads.
int told_by_shape(const SeamModel& m, const SeamModel& turned, Index panel, Vec2 grain) {
  using enum PieceKind;
  const PieceWords& words = m.words[panel];
  const bool trunk = words.kind == kTorso || words.kind == kLegs || words.kind == kSkirt ||
                     (words.kind == kOther && (words.face != 0 || words.flank));
  if ((!trunk && words.kind != kHood) || words.layer || words.yoke || words.limb) return 0;
  const std::vector<Index> runs = runs_of(m, panel);
  const Opening opening = opening_of(m, runs, grain);
  const auto sense = [](double up, double least) { return up > least ? 1 : up < -least ? -1 : 0; };
  const int wider = sense(std::log(widening(m, runs, grain)), std::log(kEndWeights.wider));
  if (words.kind == kHood) return sense(-opening.bulge, kEndWeights.tells);  // its back and top are round
  if (words.kind != kSkirt) {
    // These are known only where the piece stands as it is worn.
    const int crotch = has_leg_crotch(m, panel) - has_leg_crotch(turned, panel);
    const int part = crotch != 0 ? crotch : has_shoulder(m, panel) - has_shoulder(turned, panel);
    if (const int neck = told_by_neck(m, runs); neck != 0 && words.kind != kLegs) return neck;
    if ((words.kind != kTorso || words.guessed) && has_forks(m))
      return 0;  // what is hollow may be for the legs
    if (part > 0 || opening.hollow > kEndWeights.tells) return part < 0 ? 0 : 1;
    const bool down = part < 0 && opening.hollow < -(crotch < 0 ? kEndWeights.tells : kEndWeights.down);
    if (down || (words.kind == kTorso && opening.hollow < -kEndWeights.surely)) return -1;
    return words.kind == kTorso && part == 0 && opening.hollow > -kEndWeights.tells ? wider : 0;
  }
  const int open = sense(opening.hollow + opening.bulge, kEndWeights.skirt_tells);
  return open * wider < 0 ? 0 : open + wider;
}

}  // namespace

std::vector<Vec2> grains_upwards(const std::vector<pattern::Panel>& panels) {
  constexpr double kAlike = 0.9;  // cosine
  pattern::Pattern pattern;
  pattern.panels = panels;
  const SeamModel m = make_seam_model(pattern);
  for (pattern::Panel& panel : pattern.panels) panel.grain = -panel.grain;
  const SeamModel turned = make_seam_model(pattern);
  std::vector<Vec2> grains;
  std::vector<int> told;
  for (Index p = 0; p < static_cast<Index>(panels.size()); ++p) {
    grains.push_back(normalized(panels[p].grain));
    told.push_back(told_by_shape(m, turned, p, grains.back()));
  }
  std::vector<Vec2> up = grains;
  for (std::size_t p = 0; p < grains.size(); ++p) {
    int sense = told[p];
    bool agree = true;
    for (std::size_t q = 0; q < grains.size() && told[p] == 0; ++q) {
      const double along = dot(grains[p], grains[q]);
      if (told[q] == 0 || std::abs(along) < kAlike) continue;
      const int there = along > 0 ? told[q] : -told[q];
      agree = agree && sense * there >= 0;
      sense = there;
    }
    if (agree && sense < 0) up[p] = -grains[p];
  }
  return up;
}

}  // namespace toile::seams
