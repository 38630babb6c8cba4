#include "core/pattern/seams/roles.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/pattern/seams/likeness.h"
#include "core/pattern/seams/weights.h"

namespace toile::seams {
namespace {

/// The upper edge of a sleeve that stands: of an undersleeve it is hollow, and what bulges is the elbow.
void find_upper_cap(SeamModel& m, Index panel) {
  constexpr double kUpper = 0.5;  // facing
  Index cap = kNone;
  for (Index r = 0; r < static_cast<Index>(m.runs.size()); ++r) {
    SeamRun& run = m.runs[r];
    if (run.panel != panel) continue;
    run.cap = false;
    const auto width = [](const SeamRun& upper) { return upper.up * upper.length; };
    if (run.up > kUpper && (cap == kNone || width(run) > width(m.runs[cap]))) cap = r;
  }
  if (cap == kNone) return;
  m.runs[cap].cap = true;
  m.tailored = m.tailored || m.runs[cap].turn.back() < kPairWeights.twin_hollow_deg;
  m.upright[panel] = 1;
}

/// Whether the piece has another edge of the run's length that faces up as well: the sides of a wide skirt
/// do.
bool is_side(const SeamModel& m, Index r) {
  constexpr double kUp = 0.8;
  const SeamRun& run = m.runs[r];
  if (run.up < kUp) return false;
  return std::any_of(m.runs.begin(), m.runs.end(), [&](const SeamRun& other) {
    return other.panel == run.panel && other.edge != run.edge && other.up > kUp &&
           equally_long(other.length, run.length);
  });
}

}  // namespace

void find_caps(SeamModel& m) {
  constexpr double kBulge = 10, kAbove = 0.8;  // degrees; facing
  std::vector<double> most(m.words.size(), kBulge);
  for (const SeamRun& run : m.runs) most[run.panel] = std::max(most[run.panel], run.turn.back());
  for (SeamRun& run : m.runs) {
    run.cap = m.words[run.panel].kind == PieceKind::kSleeve && run.turn.back() >= 0.8 * most[run.panel] &&
              run.turn.back() >= kBulge;
    if (run.cap && run.up > kAbove) m.upright[run.panel] = 1;
  }
  std::vector<char> above(m.words.size(), 0);
  for (const SeamRun& run : m.runs) above[run.panel] = above[run.panel] || (run.cap && run.up > kAbove);
  if (std::none_of(above.begin(), above.end(), [](char any) { return any != 0; })) return;
  for (Index p = 0; p < static_cast<Index>(m.words.size()); ++p)
    if (m.words[p].kind == PieceKind::kSleeve && !above[p]) find_upper_cap(m, p);
}

void find_sides(SeamModel& m) {
  for (std::size_t r = 0; r < m.runs.size(); ++r) m.runs[r].side = is_side(m, static_cast<Index>(r));
}

void find_open_fronts(SeamModel& m) {
  m.opens.resize(m.words.size(), 0);
  constexpr double kLevel = 0.5, kUpright = 0.8;
  for (SeamRun& run : m.runs) {
    const Index other = run.mirror_panel;
    const PieceWords& words = m.words[run.panel];
    const bool pair = other != kNone && other != run.panel && words.face > 0 && !words.limb;
    if (!pair || run.turn.back() < kPairWeights.twin_round_deg) continue;
    const Vec2 up = m.up[run.panel];
    const bool down = dot(run.at.back() - run.at.front(), up) < 0;
    const Vec2 first = normalized(run.at[1] - run.at[0]);
    const Vec2 last = normalized(run.at[SeamRun::kSamples - 1] - run.at[SeamRun::kSamples - 2]);
    const double lower = std::abs(dot(down ? last : first, up));
    const double upper = std::abs(dot(down ? first : last, up));
    run.open_front = run.open_front || (lower < kLevel && upper > kUpright);  // or a part of one
    if (run.open_front) m.opens[run.panel] = 1;
  }
}

}  // namespace toile::seams
