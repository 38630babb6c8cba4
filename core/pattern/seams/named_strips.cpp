#include "core/pattern/seams/named_strips.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include "core/pattern/seams/likeness.h"
#include "core/pattern/seams/shapes.h"
#include "core/pattern/seams/weights.h"

namespace toile::seams {
namespace {

Index panels_of(const SeamModel& m) { return static_cast<Index>(m.words.size()); }

/// Length of the long sides of a strip that is that many times as long as wide, mm; 0 of what is none.
double strip_length(const SeamModel& m, Index panel, double slim) {
  constexpr double kAlike = 0.1;  // share: ends may be mitred
  const std::vector<Index> runs = runs_of(m, panel);
  if (runs.size() != 4) return 0;
  const auto run = [&](std::size_t k) -> const SeamRun& { return m.runs[runs[k]]; };
  const std::size_t k = run(0).length > run(1).length ? 0 : 1;
  const bool even = difference(run(k), run(k + 2)) < kAlike && bend_of(run(k)) < kPairWeights.straight_deg;
  return even && run(k).length > slim * run(1 - k).length ? run(k).length : 0;
}

/// Stands a strip on one of its long sides, as it goes around a body.
void stand_along(SeamModel& m, Index panel) {
  const std::vector<Index> runs = runs_of(m, panel);
  const SeamRun& first = m.runs[runs[0]];
  const SeamRun& side = first.length > m.runs[runs[1]].length ? first : m.runs[runs[1]];
  const Vec2 across = perpendicular(normalized(chord(side)));
  m.up[panel] = dot(across, m.up[panel]) < 0 ? -across : across;
  for (const Index r : runs) m.runs[r].up = dot(normalized(-perpendicular(chord(m.runs[r]))), m.up[panel]);
}

/// Pieces in pairs that end level above and below are the skirt of a waistband: its tiers, the narrowest
/// above.
void name_tiers(SeamModel& m) {
  constexpr double kSame = 0.01;  // share
  std::vector<std::pair<double, Index>> tiers;
  for (const SeamRun& run : m.runs) {
    const PieceWords& words = m.words[run.panel];
    const Index twin = m.twin[run.panel];
    const bool pair = twin != kNone && twin != run.panel;
    if (words.kind == PieceKind::kOther && !words.layer && pair && run.up > kPairWeights.facing_fully)
      tiers.emplace_back(run.length, run.panel);
  }
  std::sort(tiers.begin(), tiers.end());
  int level = -1;
  double last = 0;
  for (const auto& [length, panel] : tiers) {
    level += length > (1 + kSame) * last ? 1 : 0;
    last = length;
    m.words[panel].guess(PieceKind::kSkirt);
    m.level[panel] = level;
  }
}

/// Of several waistbands of trousers those that fit the waist less well than another lie in that one, as an
/// elastic does; halves of one fit alike.
void tell_elastics(SeamModel& m, double waist) {
  constexpr double kMuch = 0.05;  // of the waist, that one fits it less well by
  std::vector<std::pair<double, Index>> bands;
  for (Index p = 0; p < panels_of(m); ++p) {
    const double length = strip_length(m, p, 0);
    if (m.words[p].kind == PieceKind::kBand && m.words[p].guessed && length > 0)
      bands.emplace_back(std::abs(length - waist), p);
  }
  std::sort(bands.begin(), bands.end());
  for (std::size_t k = 1; k < bands.size(); ++k)
    m.words[bands[k].second].layer = bands[k].first > bands[0].first + kMuch * waist;
}

}  // namespace

void name_strips(SeamModel& m, const StripPlaces& around) {
  using enum PieceKind;
  constexpr double kSlim = 2.5, kCuffSlim = 1.4;  // times as long as wide; a rib is folded
  struct Place {
    double length;       // mm, of what the strip goes around
    double least, most;  // times that
    PieceKind kind;
  };
  const Place places[] = {{around.waist, 0.75, 1.2, kBand},
                          {around.wrist, 0.45, 1.05, kCuff},
                          {around.neck, 0.65, 1.05, kCollar},
                          {around.hem, 0.6, 1.05, kBand}};
  for (Index p = 0; p < panels_of(m); ++p) {
    PieceWords& words = m.words[p];
    const double length = strip_length(m, p, kCuffSlim);
    if (length == 0 || words.kind != kOther || words.layer) continue;
    const bool two = std::any_of(m.words.begin(), m.words.end(), [&](const PieceWords& other) {
      const auto q = static_cast<Index>(&other - m.words.data());
      return q != p && same_edges(m, p, q);
    });
    for (const Place& place : places) {
      if (place.length == 0 || (place.kind == kCuff && !two) || (place.kind == kCollar && two)) continue;
      if (place.kind != kCuff && strip_length(m, p, kSlim) == 0) continue;
      const double halves = two && place.kind == kBand ? 2 : 1;
      if (halves * length < place.least * place.length || halves * length > place.most * place.length)
        continue;
      words.guess(place.kind);
      stand_along(m, p);
      words.limb = place.kind == kCuff;
      words.stand = place.kind == kCollar;
      break;
    }
  }
  if (around.waist > 0) tell_elastics(m, around.waist);
}

void name_lone_neckband(SeamModel& m, double neck) {
  using enum PieceKind;
  constexpr double kSlim = 6, kOfNeck[2] = {0.75, 1.02};  // times as long as wide; as the neck, of knits
  const bool other = std::any_of(m.words.begin(), m.words.end(),
                                 [](const PieceWords& w) { return is_neck(w.kind) && !w.layer; });
  if (other || neck == 0) return;
  std::vector<Index> fits;
  for (Index p = 0; p < panels_of(m); ++p) {
    const PieceWords& words = m.words[p];
    const double ratio = strip_length(m, p, kSlim) / neck;
    const bool told = words.kind != kOther || words.layer || words.hem_band || words.face != 0;
    if (!told && ratio > kOfNeck[0] && ratio < kOfNeck[1]) fits.push_back(p);
  }
  if (fits.size() != 1) return;
  m.words[fits.front()].guess(kCollar);
  m.words[fits.front()].stand = true;
  stand_along(m, fits.front());
}

void name_waistband(SeamModel& m) {
  using enum PieceKind;
  constexpr double kSlim = 6, kAsLong = 0.03;  // times as long as wide; share
  const bool other = std::any_of(m.words.begin(), m.words.end(),
                                 [](const PieceWords& w) { return w.kind != kOther && w.kind != kBand; });
  if (other) return;
  for (Index p = 0; p < panels_of(m); ++p) {
    const double length = strip_length(m, p, kSlim);
    if (length == 0 || m.words[p].layer || m.words[p].kind != kOther) continue;
    const bool fits = std::any_of(m.runs.begin(), m.runs.end(), [&](const SeamRun& run) {
      const Index twin = m.twin[run.panel];
      return twin != kNone && twin != run.panel && run.panel != p && run.up > kPairWeights.facing_fully &&
             std::abs(2 * run.length - length) < kAsLong * length;
    });
    if (!fits) continue;
    m.words[p].guess(kBand);
    stand_along(m, p);
    name_tiers(m);
    return;
  }
}

}  // namespace toile::seams
