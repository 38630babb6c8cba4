#include "core/pattern/seams/roles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/pattern/seams/armholes.h"
#include "core/pattern/seams/likeness.h"
#include "core/pattern/seams/shapes.h"
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

/// Stands the piece on its other end.
void turn_upside_down(SeamModel& m, Index panel) {
  m.up[panel] = -m.up[panel];
  for (SeamRun& run : m.runs)
    if (run.panel == panel) run.up = -run.up;
}

/// Sleeves whose only cap faces down stand on their heads: a grain line has no upper end, least of all where
/// the piece lies.
void stand_on_wrists(SeamModel& m, double above) {
  std::vector<int> caps(m.words.size(), 0), below(m.words.size(), 0);
  for (const SeamRun& run : m.runs) {
    caps[run.panel] += run.cap;
    below[run.panel] += run.cap && run.up < -above;
  }
  for (Index p = 0; p < static_cast<Index>(caps.size()); ++p)
    if (caps[p] == 1 && below[p] == 1) turn_upside_down(m, p);
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

/// Whether the run is a side of a narrow corner cut into the piece, as the legs of a waist's dart are.
bool is_beside_cut(const SeamModel& m, const SeamRun& run) {
  constexpr double kNarrow = 300;  // degrees of cloth
  return run.angle > kNarrow || m.runs[run.next].angle > kNarrow;
}

/// The first run after the waist that begins at `start`, its darts left out; nothing where that is none.
template <class Step>
const SeamRun* beyond_waist(const SeamModel& m, const SeamRun& start, Step step) {
  if (start.up < kPairWeights.facing) return nullptr;
  const SeamRun* run = &start;
  do run = &step(*run);
  while (run != &start && (run->up > kPairWeights.facing || is_beside_cut(m, *run)));
  return run == &start ? nullptr : run;
}

/// How long the edge is that goes from a front's hem up to the shoulder, which faces up and outwards;
/// `middle` is a part of it. mm.
double front_edge(const SeamModel& m, const SeamRun& middle) {
  const auto is_of_it = [&](const SeamRun& run) {
    return &run != &middle && faces_right(m, run) * faces_right(m, middle) > 0;
  };
  double edge = middle.length;
  for (const SeamRun* run = &m.runs[middle.next]; is_of_it(*run); run = &m.runs[run->next])
    edge += run->length;
  for (const SeamRun* run = &run_before(m, middle); is_of_it(*run); run = &run_before(m, *run))
    edge += run->length;
  return edge;
}

/// Whether a straight hem faces down between two edges that are alike, as under the arm of a short sleeve.
bool stands_on_hem(const SeamModel& m, Index panel) {
  constexpr double kAlike = 0.03, kLikeUp = 0.1, kLeast = 0.2;  // of the length; facing; of the outline
  return std::any_of(m.runs.begin(), m.runs.end(), [&](const SeamRun& hem) {
    if (hem.panel != panel || hem.up > -kPairWeights.facing_fully || !hem.straight) return false;
    const SeamRun &after = m.runs[hem.next], &before = run_before(m, hem);
    return hem.length > kLeast * m.girth[panel] && difference(after, before) < kAlike &&
           std::abs(after.up - before.up) < kLikeUp;
  });
}

/// Whether what slopes upwards on the piece goes down to its hem, as the sides of half a circle do.
bool slopes_to_hem(const SeamModel& m, Index panel) {
  return std::all_of(m.runs.begin(), m.runs.end(), [&](const SeamRun& run) {
    const bool slopes = run.up > kPairWeights.facing && bend_of(run) < kPairWeights.straight_deg;
    return run.panel != panel || !slopes || begins_at_hem(m, run);
  });
}

/// Whether the piece has a crotch and what may be its shoulders is level: trousers whose pockets are cut into
/// their sides.
bool is_level_leg(const SeamModel& m, Index panel) {
  return has_leg_crotch(m, panel) && std::none_of(m.runs.begin(), m.runs.end(), [&](const SeamRun& run) {
           return run.panel == panel && run.up > kPairWeights.facing && run.up < kPairWeights.level_up &&
                  bend_of(run) < kPairWeights.straight_deg;
         });
}

/// Where a crotch comes to the inseam.
struct CrotchEnd {
  const SeamRun* inseam;
  double turn;  ///< degrees, of the crotch as a whole
};

/// Below the middle of a front or back, a short part of a crotch may have an edge of its own.
template <class Step>
CrotchEnd crotch_end(const SeamModel& m, const SeamRun& middle, Step down) {
  constexpr double kShort = 0.35;  // of the middle's length
  const SeamRun& next = down(middle);
  const bool parted = next.length < kShort * middle.length && next.turn.back() <= 0 &&
                      faces_right(m, next) * faces_right(m, middle) > 0 && !begins_at_hem(m, next);
  if (!parted) return {&next, middle.turn.back()};
  const double corner = &m.runs[middle.next] == &next ? next.angle : middle.angle;
  return {&down(next), middle.turn.back() + next.turn.back() - std::max(0.0, corner - 180)};
}

/// Bands that would end a top below, but are far longer than its hem: a belt is tied around it. Many
/// languages have one word for both.
void tell_belts(SeamModel& m) {
  constexpr double kFarLonger = 1.2, kLevel = 0.9;
  double hem = 0;  // mm
  std::vector<double> longest(m.words.size(), 0);
  for (const SeamRun& run : m.runs) {
    const PieceWords& w = m.words[run.panel];
    if (w.kind == PieceKind::kTorso && !w.layer && run.up < -kLevel) hem += run.length;
    longest[run.panel] = std::max(longest[run.panel], run.length);
  }
  for (std::size_t p = 0; p < m.words.size(); ++p) {
    PieceWords& w = m.words[p];
    if (w.kind != PieceKind::kBand || !w.hem_band || hem == 0 || longest[p] < kFarLonger * hem) continue;
    w.kind = PieceKind::kStrap;
    w.belt = true;
    w.hem_band = false;
  }
}

/// Whether the run is the end at the neck of a sleeve's front or back, where the sleeve has both: short,
/// between the edge along the arm, which is the longest, and the slope; the wrist is at that one's other end.
bool is_top_of_half_raglan(const SeamModel& m, const SeamRun& run) {
  constexpr double kShort = 0.06, kSlope = 0.1;  // of the outline
  const PieceWords& words = m.words[run.panel];
  const bool half = words.kind == PieceKind::kSleeve && words.face != 0 &&
                    std::any_of(m.words.begin(), m.words.end(), [&](const PieceWords& w) {
                      return w.kind == PieceKind::kSleeve && w.face == -words.face;
                    });
  if (!half || run.length > kShort * m.girth[run.panel]) return false;
  const SeamRun &before = run_before(m, run), &after = m.runs[run.next];
  const bool arm_first = before.length > after.length;
  const SeamRun &arm = arm_first ? before : after, &slope = arm_first ? after : before;
  const SeamRun& wrist = arm_first ? run_before(m, arm) : m.runs[arm.next];
  const bool longest = std::none_of(m.runs.begin(), m.runs.end(), [&](const SeamRun& other) {
    return other.panel == run.panel && other.length > arm.length;
  });
  return longest && run.length < wrist.length && slope.length > kSlope * m.girth[run.panel];
}

}  // namespace

bool is_leg_crotch(const SeamModel& m, const SeamRun& run) {
  if (std::abs(run.up) > kPairWeights.facing) return false;
  const auto forwards = [&](const SeamRun& at) -> const SeamRun& { return m.runs[at.next]; };
  const auto backwards = [&](const SeamRun& at) -> const SeamRun& { return run_before(m, at); };
  const auto is_outer = [&](const SeamRun* side, auto step) {
    const auto goes_on = [&] {
      return faces_right(m, *side) * faces_right(m, run) < 0 && side->turn.back() > kPairWeights.hollow_deg;
    };
    while (side != nullptr && goes_on() && !begins_at_hem(m, *side))
      side = &step(*side);  // parted at a pocket
    return side != nullptr && goes_on();
  };
  const auto between_inseam_and_waist = [&](auto down, auto up) {
    const CrotchEnd end = crotch_end(m, run, down);
    return end.turn <= kPairWeights.twin_hollow_deg && begins_at_hem(m, *end.inseam) &&
           is_outer(beyond_waist(m, up(run), up), up);
  };
  return between_inseam_and_waist(backwards, forwards) || between_inseam_and_waist(forwards, backwards);
}

bool has_leg_crotch(const SeamModel& m, Index panel) {
  return std::any_of(m.runs.begin(), m.runs.end(),
                     [&](const SeamRun& run) { return run.panel == panel && is_leg_crotch(m, run); });
}

void name_trunk(SeamModel& m) {
  using enum PieceKind;
  std::vector<PieceWords>& words = m.words;
  const auto any = [&](std::initializer_list<PieceKind> kinds) {
    return std::any_of(words.begin(), words.end(), [&](const PieceWords& w) {
      return std::find(kinds.begin(), kinds.end(), w.kind) != kinds.end();
    });
  };
  const auto unnamed = [](const PieceWords& w) { return w.kind == kOther && !w.limb && !w.layer; };
  const bool covered = any({kTorso, kSkirt, kLegs}), banded = any({kBand});
  bool top = any({kSleeve, kCollar, kHood}) ||
             std::any_of(words.begin(), words.end(), [](const PieceWords& w) { return w.over_shoulder; });
  for (Index p = 0; p < static_cast<Index>(words.size()); ++p) {
    const bool armhole = words[p].flank && has_leg_crotch(m, p);  // as hollow as a crotch, below a shoulder
    if (!unnamed(words[p]) || words[p].face == 0 || (!armhole && !has_shoulder(m, p))) continue;
    if (banded && (slopes_to_hem(m, p) || is_level_leg(m, p))) continue;
    words[p].guess(kTorso);
    top = true;
  }
  if (!top || covered) return;
  for (PieceWords& w : words) {
    if (!unnamed(w) || (w.face == 0 && !w.flank)) continue;
    w.guess(kTorso);
  }
}

void name_hem_bands(SeamModel& m) {
  const auto any = [&](PieceKind kind) {
    return std::any_of(m.words.begin(), m.words.end(), [&](const PieceWords& w) { return w.kind == kind; });
  };
  if (!any(PieceKind::kTorso) || any(PieceKind::kSkirt) || any(PieceKind::kLegs)) return;
  for (PieceWords& w : m.words)
    if (w.hem_band) w.kind = PieceKind::kBand;
  tell_belts(m);
}

void name_leg_cuffs(SeamModel& m) {
  const auto any = [&](auto is) { return std::any_of(m.words.begin(), m.words.end(), is); };
  using enum PieceKind;
  if (any([](const PieceWords& w) { return w.kind == kSleeve || w.kind == kTorso; })) return;
  if (!any([](const PieceWords& w) { return w.kind == kLegs; })) return;
  for (PieceWords& w : m.words) w.leg = w.leg || w.kind == kCuff;
}

void name_legs(SeamModel& m) {
  using enum PieceKind;
  // Ankles have cuffs as well.
  const bool other_kinds = std::any_of(m.words.begin(), m.words.end(), [](const PieceWords& w) {
    return w.kind != kOther && w.kind != kBand && w.kind != kStrap && w.kind != kCuff && !w.layer;
  });
  if (other_kinds) return;
  std::vector<Index> legs;
  bool front = false, back = false;
  for (const SeamRun& run : m.runs) {
    const PieceWords& words = m.words[run.panel];
    const Index twin = m.twin[run.panel];
    const bool named = words.kind != kOther || words.flank;  // the side of a bodice, then
    if (words.face == 0 || words.layer || named || twin == run.panel) continue;
    if ((twin == kNone && words.side == 0) || !is_leg_crotch(m, run)) continue;
    legs.push_back(run.panel);
    (words.face > 0 ? front : back) = true;
  }
  if (!front || !back) return;
  for (const Index p : legs) {
    m.words[p].guess(kLegs);
    m.words[p].leg = true;
  }
}

void find_crotch_sides(SeamModel& m) {
  std::vector<std::array<bool, 2>> crotch(m.words.size());  // that faces left, right
  // A leg that is for front and back, and has a mirror image, has a crotch at either side.
  const auto is_whole = [&](Index p) {
    return m.words[p].kind == PieceKind::kLegs && m.words[p].face == 0 && m.twin[p] != kNone &&
           m.twin[p] != p;
  };
  for (const SeamRun& run : m.runs)
    if (m.words[run.panel].leg && !is_whole(run.panel) && is_leg_crotch(m, run))
      crotch[run.panel][faces_right(m, run) > 0] = true;
  m.crotch_side.clear();
  for (const std::array<bool, 2>& sides : crotch)
    m.crotch_side.push_back(static_cast<int>(sides[1]) - static_cast<int>(sides[0]));
}

void name_skirts(SeamModel& m) {
  const auto any = [&](auto is) { return std::any_of(m.words.begin(), m.words.end(), is); };
  using enum PieceKind;
  const auto is_cloth = [](const PieceWords& w) { return w.kind == kOther && !w.layer && !w.limb; };
  if (any([&](const PieceWords& w) {
        return !w.layer && w.kind != kOther && w.kind != kBand && !is_tied(w);
      }))
    return;
  if (!any([](const PieceWords& w) { return w.kind == kBand && !w.hem_band; })) return;
  if (any([&](const PieceWords& w) { return is_cloth(w) && w.face == 0; })) return;
  for (Index p = 0; p < static_cast<Index>(m.words.size()); ++p)
    if (has_leg_crotch(m, p)) return;
  for (PieceWords& w : m.words)
    if (is_cloth(w)) {
      w.guess(kSkirt);
    }
}

void find_banded_fronts(SeamModel& m) {
  constexpr double kSame = 0.035, kStrip = 0.35;  // of the length; of the outline
  double neck = 0;                                // of the back, mm
  for (const SeamRun& run : m.runs) {
    const PieceWords& words = m.words[run.panel];
    const bool whole = m.twin[run.panel] == run.panel && run.mirror_edge == run.edge;
    if (words.kind == PieceKind::kTorso && words.face < 0 && whole && run.up > kPairWeights.facing)
      neck = run.length;
  }
  for (const SeamRun& middle : m.runs) {
    const Index panel = middle.panel, twin = m.twin[panel];
    const PieceWords& words = m.words[panel];
    if (words.kind != PieceKind::kTorso || words.face <= 0 || twin == kNone || twin == panel) continue;
    if (!is_middle(m, middle) || !begins_at_hem(m, middle) || m.opens[panel]) continue;
    const double whole = 2 * front_edge(m, middle) + neck;
    const auto band = std::find_if(m.runs.begin(), m.runs.end(), [&](const SeamRun& run) {
      const bool strip = run.length > kStrip * m.girth[run.panel];
      const double length = m.twin[run.panel] == run.panel ? whole : whole / 2;
      return run.panel != panel && strip && std::abs(run.length - length) < kSame * length;
    });
    if (neck == 0 || band == m.runs.end()) continue;
    m.opens[panel] = m.opens[twin] = 1;
    PieceWords& strip = m.words[band->panel];
    if (strip.kind == PieceKind::kOther) strip.kind = PieceKind::kCollar;
  }
}

void find_caps(SeamModel& m) {
  constexpr double kBulge = 10, kAbove = 0.8;  // degrees; facing
  std::vector<double> most(m.words.size(), kBulge);
  for (const SeamRun& run : m.runs) most[run.panel] = std::max(most[run.panel], run.turn.back());
  for (SeamRun& run : m.runs) {
    run.cap = m.words[run.panel].kind == PieceKind::kSleeve && run.turn.back() >= 0.8 * most[run.panel] &&
              run.turn.back() >= kBulge;
  }
  stand_on_wrists(m, kAbove);
  for (const SeamRun& run : m.runs)
    if (run.cap && run.up > kAbove) m.upright[run.panel] = 1;
  std::vector<char> above(m.words.size(), 0);
  for (const SeamRun& run : m.runs) above[run.panel] = above[run.panel] || (run.cap && run.up > kAbove);
  if (std::none_of(above.begin(), above.end(), [](char any) { return any != 0; })) return;
  const auto has_part = [&](int part) {
    return std::any_of(m.words.begin(), m.words.end(),
                       [&](const PieceWords& w) { return !w.layer && w.sleeve_part == part; });
  };
  m.tailored = m.tailored || (has_part(1) && has_part(-1));
  for (Index p = 0; p < static_cast<Index>(m.words.size()); ++p)
    if (m.words[p].kind == PieceKind::kSleeve && !above[p]) find_upper_cap(m, p);
}

void find_standing_sleeves(SeamModel& m) {
  // Of the grain; facing, below that of a raglan's slopes; of the outline; of the length.
  constexpr double kRise = 0.85, kSlope = 0.4, kLeast = 0.1, kAlike = 0.03;
  for (Index p = 0; p < static_cast<Index>(m.words.size()); ++p) {
    if (m.words[p].kind != PieceKind::kSleeve || m.upright[p]) continue;
    const SeamRun* longest[2] = {nullptr, nullptr};  // that face left, right
    for (const SeamRun& run : m.runs) {
      if (run.panel != p || rise(m, run) < kRise || run.up > kSlope || run.length < kLeast * m.girth[p])
        continue;
      const SeamRun*& there = longest[faces_right(m, run) > 0];
      if (there == nullptr || run.length > there->length) there = &run;
    }
    m.upright[p] =
        (longest[0] != nullptr && longest[1] != nullptr && difference(*longest[0], *longest[1]) < kAlike) ||
        stands_on_hem(m, p);
  }
}

void find_raglan_sleeves(SeamModel& m) {
  for (SeamRun& run : m.runs) {
    run.raglan_top = m.words[run.panel].kind == PieceKind::kSleeve && m.upright[run.panel] && !run.cap &&
                     run.up > kPairWeights.facing && run.length < kPairWeights.crotch * m.girth[run.panel];
    m.raglan = m.raglan || (run.raglan_top && is_raglan_slope(m, run_before(m, run), run) &&
                            is_raglan_slope(m, m.runs[run.next], run));
    if (is_top_of_half_raglan(m, run)) run.raglan_top = m.raglan = true;
  }
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
