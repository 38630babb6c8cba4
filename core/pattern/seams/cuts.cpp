#include "core/pattern/seams/cuts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "core/pattern/seams/armholes.h"
#include "core/pattern/seams/bodice.h"
#include "core/pattern/seams/likeness.h"
#include "core/pattern/seams/notch_cuts.h"
#include "core/pattern/seams/shapes.h"
#include "core/pattern/seams/weights.h"

namespace toile::seams {
namespace {

double difference(double a, double b) { return std::abs(a - b) / std::max(a, b); }

/// Runs of one piece that lie end to end once its darts are closed; or two that meet in a blunt corner, as a
/// sleeve's seam and the edge of its hem.
struct Line {
  std::vector<Index> runs;
  bool bent = false;                    ///< the latter
  Index before = kNone, after = kNone;  ///< runs that meet its ends
  double length = 0;
};

bool starts_dart(const SeamModel& m, Index r) {
  const SeamRun &leg = m.runs[r], &other = m.runs[leg.next];
  return other.angle > 360 - kCutWeights.dart_deg && other.angle < 360 - kCutWeights.dart_least_deg &&
         difference(leg.length, other.length) < kCutWeights.dart_ease;
}

std::vector<Line> straight_parts(const SeamModel& m) {
  std::vector<Index> before(m.runs.size(), kNone);
  for (Index r = 0; r < static_cast<Index>(m.runs.size()); ++r) before[m.runs[r].next] = r;
  const auto is_leg = [&](Index r) { return starts_dart(m, r) || starts_dart(m, before[r]); };
  std::vector<Line> lines;
  for (Index r = 0; r < static_cast<Index>(m.runs.size()); ++r) {
    if (is_leg(r) || is_leg(before[r])) continue;  // not where a line begins
    Line line;
    line.before = before[r];
    for (Index at = r;;) {
      line.runs.push_back(at);
      line.length += m.runs[at].length;
      at = m.runs[at].next;
      if (!starts_dart(m, at) || line.runs.size() > m.runs.size()) {
        line.after = at;
        break;
      }
      at = m.runs[m.runs[at].next].next;
    }
    lines.push_back(std::move(line));
  }
  for (Index r = 0; r < static_cast<Index>(m.runs.size()); ++r) {
    const SeamRun &run = m.runs[r], &next = m.runs[run.next];
    const double most =
        m.words[run.panel].kind == PieceKind::kTorso ? kCutWeights.bent_raglan_deg : kCutWeights.bent_deg;
    if (std::abs(next.angle - 180) > most || is_leg(r) || is_leg(run.next) || run.next == r) continue;
    lines.push_back({{r, run.next}, true, before[r], next.next, run.length + next.length});
  }
  return lines;
}

/// How surely the two lie end to end: one for each end at which their neighbours are alike.
int meeting_ends(const SeamModel& m, const Line& a, const Line& b) {
  const auto alike = [&](Index x, Index y) {
    return x != kNone && y != kNone && x != y &&
           difference(m.runs[x].length, m.runs[y].length) < kCutWeights.alike;
  };
  const int against = alike(a.after, b.before) + alike(a.before, b.after);
  const int along = alike(a.after, b.after) + alike(a.before, b.before);
  return std::max(against, along);
}

bool has_partner(const SeamModel& m, Index r) {
  for (Index other = 0; other < static_cast<Index>(m.runs.size()); ++other) {
    if (m.runs[other].panel == m.runs[r].panel || other == m.mirror[r]) continue;
    const bool of_hem = begins_at_hem(m, m.runs[other]) || m.runs[other].up < -kPairWeights.facing;
    if (m.runs[r].cap && !m.tailored && of_hem) continue;  // a side or a hem that is as long by chance
    if (m.runs[r].cap && !ever_meet(m.words[m.runs[r].panel].kind, m.words[m.runs[other].panel].kind))
      continue;  // or a collar
    if (difference(m.runs[other].length, m.runs[r].length) < kCutWeights.alike) return true;
  }
  return false;
}

struct Two {
  const Line* first = nullptr;
  const Line* second = nullptr;
  const Line* between = nullptr;  ///< a yoke's end
  double worth = 0;
};

/// Whether the runs are a sleeve's cap and the armholes of a front and a back.
bool is_set_in(const SeamModel& m, Index cap, Index x, Index y) {
  const auto armhole = [&](Index r) {
    return m.words[m.runs[r].panel].kind == PieceKind::kTorso &&
           m.runs[r].turn.back() < kPairWeights.twin_hollow_deg;
  };
  return m.runs[cap].cap && !m.tailored && armhole(x) && armhole(y) &&
         m.words[m.runs[x].panel].face * m.words[m.runs[y].panel].face < 0;
}

/// The end of a yoke that makes up what two armholes are short of a cap of that length, mm: the sleeve is set
/// into all three. Null where none does.
const Line* yoke_between(const SeamModel& m, const std::vector<Line>& lines, double short_of, double length) {
  const Line* best = nullptr;
  double least = kCutWeights.yoke * length;
  for (const Line& line : lines) {
    const PieceWords& words = m.words[m.runs[line.runs[0]].panel];
    const bool yoke = (words.kind == PieceKind::kOther || words.kind == PieceKind::kTorso) &&
                      words.face == 0 && !words.layer && !words.limb;
    const double off = std::abs(short_of - line.length);
    if (!yoke || line.length < kCutWeights.shortest_mm || off >= least) continue;
    least = off;
    best = &line;
  }
  return best;
}

/// Whether the run is a sleeve's and the others are of both fronts, or of both backs: no sleeve goes there.
bool is_across(const SeamModel& m, Index sleeve, Index x, Index y) {
  const PieceWords &a = m.words[m.runs[x].panel], &b = m.words[m.runs[y].panel];
  return m.words[m.runs[sleeve].panel].kind == PieceKind::kSleeve && a.kind == PieceKind::kTorso &&
         b.kind == PieceKind::kTorso && a.face * b.face > 0 &&
         (a.side * b.side < 0 || m.twin[m.runs[x].panel] == m.runs[y].panel);
}

/// The best two lines to sew run r to, that have up to `ease` less than its length.
Two best_two(const SeamModel& m, const std::vector<Line>& lines, Index r, double ease) {
  const double length = m.runs[r].length;
  const auto other_piece = [&](const Line& line) { return m.runs[line.runs[0]].panel != m.runs[r].panel; };
  Two best;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].bent || !other_piece(lines[i])) continue;
    for (std::size_t j = i + 1; j < lines.size(); ++j) {
      const double sum = lines[i].length + lines[j].length;
      const double most =
          is_set_in(m, r, lines[i].runs[0], lines[j].runs[0]) ? std::max(ease, kCutWeights.ease_cap) : ease;
      if (sum > length * (1 + std::min(kCutWeights.alike, ease)) || sum < length * (1 - most)) continue;
      // The two shoulders of one front never lie end to end.
      const bool same_piece = m.runs[lines[i].runs[0]].panel == m.runs[lines[j].runs[0]].panel;
      if (same_piece || is_across(m, r, lines[i].runs[0], lines[j].runs[0]) || lines[j].bent ||
          !other_piece(lines[j]) ||
          std::min(lines[i].length, lines[j].length) < length / kCutWeights.most_parts)
        continue;
      const Line* yoke = sum < length * (1 - ease) ? yoke_between(m, lines, length - sum, length) : nullptr;
      // A yoke that makes up the length tells as much as neighbours do: sides may be eased.
      const int ends = std::max(meeting_ends(m, lines[i], lines[j]), yoke != nullptr ? 1 : 0);
      const double off = yoke != nullptr ? 0 : difference(sum, length);
      const double worth = ends - off / std::max(most, kCutWeights.ease);
      if (ends > 0 && worth > best.worth) best = {&lines[i], &lines[j], yoke, worth};
    }
  }
  return best;
}

/// Share of its length by which run r may differ from the two edges of the line, which meet in a blunt
/// corner: a raglan sleeve may be eased onto the slope and the end of the armhole below it.
double most_of_bent(const SeamModel& m, const Line& line, Index r) {
  const SeamRun &first = m.runs[line.runs[0]], &second = m.runs[line.runs[1]];
  const bool end = std::min(first.length, second.length) < kCutWeights.shortest_mm ||
                   is_armhole_end(m, first) || is_armhole_end(m, second);
  const bool raglan = m.words[m.runs[r].panel].kind == PieceKind::kSleeve && end &&
                      m.words[first.panel].kind == PieceKind::kTorso;
  if (raglan) return kCutWeights.ease_raglan;
  return std::abs(second.angle - 180) < kCutWeights.bent_deg ? kCutWeights.exact : 0;
}

/// The line with darts in it that is as long as run r: a front's side to a back's.
const Line* best_one(const SeamModel& m, const std::vector<Line>& lines, Index r) {
  const Line* best = nullptr;
  double least = kCutWeights.ease;
  for (const Line& line : lines) {
    if (line.runs.size() < 2 || m.runs[line.runs[0]].panel == m.runs[r].panel) continue;
    const double off = difference(line.length, m.runs[r].length);
    if (off < (line.bent ? std::min(least, most_of_bent(m, line, r)) : least)) {
      least = off;
      best = &line;
    }
  }
  return best;
}

/// Distances of the inner corners of the two lines (or of one), seen from the start of a run that is sewn to
/// them.
std::vector<double> places_on(const SeamModel& m, const Two& two, double length, bool second_first) {
  std::vector<double> parts;
  double sum = 0;
  std::array<const Line*, 3> order{two.second, two.between, two.first};  // outlines run against each other
  if (second_first) std::swap(order.front(), order.back());
  for (const Line* line : order) {
    if (line == nullptr) continue;
    sum += line->length;
    for (auto r = line->runs.rbegin(); r != line->runs.rend(); ++r) parts.push_back(m.runs[*r].length);
  }
  const double scale = length / sum;
  std::vector<double> places;
  double at = 0;
  for (std::size_t k = 0; k + 1 < parts.size(); ++k) places.push_back(at += parts[k] * scale);
  return places;
}

/// How much runs from one to another rise along their piece's grain, -1 to 1.
double climb(const SeamModel& m, Index first, Index last) {
  const Vec2 chord = m.runs[last].at.back() - m.runs[first].at.front();
  return dot(normalized(chord), m.up[m.runs[first].panel]);
}

/// Distances of the darts of a line, seen from the start of run r that is sewn to it. Pieces mostly lie as
/// they are worn: where both rise, lower ends meet.
std::vector<double> darts_on(const SeamModel& m, const Line& line, Index r) {
  const double length = m.runs[r].length;
  std::vector<double> places = places_on(m, {&line, nullptr, nullptr, 0}, length, false);
  const double a = climb(m, line.runs.front(), line.runs.back()), b = climb(m, r, r);
  if (std::min(std::abs(a), std::abs(b)) < kCutWeights.rising || a * b < 0) return places;
  for (double& place : places) place = length - place;
  std::reverse(places.begin(), places.end());
  return places;
}

/// Cuts run r where its mirror image is cut.
void cut_like_mirror(const SeamModel& m, Index r, std::vector<std::vector<double>>& cuts) {
  const Index twin = m.mirror[r];
  for (const double s : cuts[twin]) cuts[r].push_back(m.runs[r].length - s);
  std::reverse(cuts[r].begin(), cuts[r].end());
}

/// Whether the run is the upper edge of a sleeve that is set on without a cap, from seam to seam.
bool is_level_top(const SeamModel& m, const SeamRun& run) {
  if (m.words[run.panel].kind != PieceKind::kSleeve || !m.upright[run.panel] || run.cap) return false;
  return run.up > kPairWeights.facing && begins_at_hem(m, m.runs[run.next]) &&
         begins_at_hem(m, run_before(m, run));
}

/// Where a bodice's side that goes up to the shoulder ends and the arm comes out, from the run's start; −1
/// for other runs. The sleeve tells, else the upper notch.
double arm_begins(const SeamModel& m, const SeamRun& run, const SeamRun* sleeve) {
  const PieceWords& words = m.words[run.panel];
  if (words.kind != PieceKind::kTorso || words.face == 0 || !begins_at_hem(m, run) || !meets_shoulder(m, run))
    return -1;
  const bool rises = dot(run.at.back() - run.at.front(), m.up[run.panel]) > 0;
  const auto fits = [&](double depth) {
    return depth > kCutWeights.arm_least_mm && depth < kCutWeights.arm_most * run.length;
  };
  const auto place = [&](double depth) { return rises ? run.length - depth : depth; };
  double depth = sleeve == nullptr ? 0 : sleeve->length / 2;
  for (const double notch : run.notches) {
    const double there = rises ? run.length - notch : notch;
    const bool closer = sleeve == nullptr ? depth == 0 || there < depth
                                          : std::abs(there - sleeve->length / 2) < kCutWeights.arm_notch_mm;
    if (fits(there) && closer) depth = there;
  }
  return fits(depth) ? place(depth) : -1;
}

/// Cuts the upper edge of a waistband where the sides of the bib come to lie that stands on its middle.
void cut_for_bibs(const SeamModel& m, std::vector<std::vector<double>>& cuts) {
  for (const SeamRun& bib : m.runs) {
    const PieceWords& words = m.words[bib.panel];
    if (!words.bib || words.layer || bib.up > -kPairWeights.facing_fully) continue;
    for (std::size_t r = 0; r < m.runs.size(); ++r) {
      const SeamRun& run = m.runs[r];
      const PieceWords& band = m.words[run.panel];
      const double beside = (run.length - bib.length) / 2;
      if (band.kind != PieceKind::kBand || band.layer || band.face * words.face < 0) continue;
      if (run.up < kPairWeights.facing_fully || beside < kCutWeights.alike * run.length) continue;
      cuts[r] = {beside, run.length - beside};
    }
  }
}

/// Cuts sides that go up to the shoulder where the arm comes out, and the sleeves there at the shoulder. What
/// they are cut for is known, as at a notch.
void cut_for_arms(SeamModel& m, std::vector<std::vector<double>>& cuts) {
  const auto top =
      std::find_if(m.runs.begin(), m.runs.end(), [&](const SeamRun& run) { return is_level_top(m, run); });
  const SeamRun* sleeve = top == m.runs.end() ? nullptr : &*top;
  const auto cut = [&](std::size_t r, double at) {
    cuts[r] = {at};
    std::vector<double>& notches = m.runs[r].notches;
    if (std::find(notches.begin(), notches.end(), at) == notches.end()) notches.push_back(at);
    std::sort(notches.begin(), notches.end());
  };
  std::vector<std::pair<std::size_t, double>> places;
  for (std::size_t r = 0; r < cuts.size(); ++r)
    if (const double at = arm_begins(m, m.runs[r], sleeve); at >= 0) places.push_back({r, at});
  if (places.empty()) return;
  for (std::size_t r = 0; sleeve != nullptr && r < cuts.size(); ++r) {
    const SeamRun& run = m.runs[r];
    if (is_level_top(m, run) && equally_long(run.length, sleeve->length))
      places.push_back({r, run.length / 2});
  }
  for (const auto& [r, at] : places) cut(r, at);
}

}  // namespace

bool is_half(const SeamModel& m, Index p) {
  if (m.twin[p] != kNone && m.twin[p] != p) return true;
  const PieceWords& here = m.words[p];
  return here.side != 0 && std::any_of(m.words.begin(), m.words.end(), [&](const PieceWords& other) {
           return other.side == -here.side && other.kind == here.kind && other.face == here.face;
         });
}

bool goes_all_around(const SeamModel& m, Index band) {
  const PieceWords& words = m.words[band];
  const bool cuff = words.kind == PieceKind::kCuff;  // it may be of one side and goes around its limb
  if ((words.kind != PieceKind::kBand && !cuff) || words.face != 0 || (words.side != 0 && !cuff))
    return false;
  bool front = false, back = false;
  for (Index q = 0; q < static_cast<Index>(m.words.size()); ++q) {
    if (m.words[q].layer || (hangs_from(m, band, q) <= 0 && hangs_from(m, q, band) <= 0)) continue;
    front = front || m.words[q].face > 0;
    back = back || m.words[q].face < 0;
  }
  return front && back;
}

bool meets_halves(const SeamModel& m, Index r) {
  const SeamRun& run = m.runs[r];
  if (run.side || is_half(m, run.panel) || goes_all_around(m, run.panel)) return false;
  if (m.twin[run.panel] != kNone && m.mirror[r] != r) return false;
  for (Index q = 0; q < static_cast<Index>(m.twin.size()); ++q) {
    if (!is_half(m, q) || m.words[q].face * m.words[run.panel].face < 0) continue;
    if (run.up > kCutWeights.level && hangs_from(m, run.panel, q) > 0) return true;
    if (run.up < -kCutWeights.level && hangs_from(m, q, run.panel) > 0) return true;
  }
  return false;
}

SeamModel with_likely_cuts(const pattern::Pattern& pattern, SeamModel model, CutKind kind) {
  std::vector<std::vector<double>> cuts(model.runs.size());
  const std::vector<Line> lines = straight_parts(model);
  if (kind == CutKind::kNotches) cuts = notch_cuts(model);
  // Notches on what is exactly as long as two edges that lie end to end only help to sew it.
  for (Index r = 0; r < static_cast<Index>(cuts.size()); ++r)
    if (!cuts[r].empty() && best_two(model, lines, r, kCutWeights.exact).first != nullptr) cuts[r].clear();
  cut_for_arms(model, cuts);
  cut_for_bibs(model, cuts);
  const SeamModel whole = model;
  const Index count = static_cast<Index>(whole.runs.size());
  std::vector<char> met(whole.runs.size(), 0);  // parts of a line with darts that has found its partner
  for (Index r = 0; r < count; ++r)
    if (cuts[r].empty() && meets_halves(whole, r)) cuts[r] = {whole.runs[r].length / 2};
  for (const bool darts : {true, false}) {
    for (Index r = 0; r < count; ++r) {
      if (whole.runs[r].length < kCutWeights.shortest_mm || !cuts[r].empty() || met[r] ||
          has_partner(whole, r))
        continue;
      const Index twin = whole.mirror[r];
      if (twin != kNone && twin < r && !cuts[twin].empty()) {
        cut_like_mirror(whole, r, cuts);
        continue;
      }
      const bool exact =
          kind == CutKind::kExactFirst || kind == CutKind::kExactSecond || kind == CutKind::kNotches;
      const Two two = best_two(whole, lines, r, exact && !darts ? kCutWeights.exact : kCutWeights.ease);
      if (darts) {
        const Line* one = best_one(whole, lines, r);
        if (one == nullptr || two.worth >= 2) continue;
        cuts[r] = darts_on(whole, *one, r);
        for (const Index part : one->runs) {
          met[part] = 1;
          if (whole.mirror[part] != kNone) met[whole.mirror[part]] = 1;
        }
      } else if (two.first != nullptr && kind != CutKind::kDarts) {
        cuts[r] = places_on(whole, two, whole.runs[r].length,
                            kind == CutKind::kSecondFirst || kind == CutKind::kExactSecond);
      }
    }
  }
  for (Index r = 0; r < count; ++r)
    if (!cuts[r].empty() && !met[r]) model = with_cuts(pattern, std::move(model), r, cuts[r]);
  return model;
}

}  // namespace toile::seams
