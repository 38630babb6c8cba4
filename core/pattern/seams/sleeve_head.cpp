#include "core/pattern/seams/sleeve_head.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/pattern/curve.h"

namespace toile::seams {
namespace {

constexpr double kMarked = 20;   // mm along the edge, within which a notch marks the highest point
constexpr double kSnap = 4;      // mm: parts of edges are no shorter
constexpr double kUneven = 1.2;  // the front part of a head is longer than the back part by this at least

/// A part of an edge in the order in which a ring is walked.
struct Part {
  pattern::SeamEdge edge;
  bool backwards = false;  ///< against the outline
  double length = 0;       ///< mm
};

/// All around an armhole or a sleeve.
using Ring = std::vector<Part>;

const pattern::PanelEdge& edge_of(const pattern::Pattern& pattern, const pattern::SeamEdge& e) {
  return *pattern::edges_of(pattern.panels[e.panel])[e.edge];
}

/// A side of a seam as side a meets it.
Ring ring_of(const pattern::Pattern& pattern, const std::vector<pattern::SeamEdge>& side, bool against) {
  Ring ring;
  for (const pattern::SeamEdge& e : side)
    ring.push_back({e, e.reversed != against, (e.to - e.from) * pattern::arc_length(edge_of(pattern, e))});
  if (against) std::reverse(ring.begin(), ring.end());
  return ring;
}

std::vector<pattern::SeamEdge> side_of(Ring ring, bool against) {
  if (against) std::reverse(ring.begin(), ring.end());
  std::vector<pattern::SeamEdge> side;
  for (const Part& part : ring) {
    side.push_back(part.edge);
    side.back().reversed = part.backwards != against;
  }
  return side;
}

double length_of(const Ring& ring) {
  double sum = 0;
  for (const Part& part : ring) sum += part.length;
  return sum;
}

Vec2 place_on(const pattern::Pattern& pattern, const Part& part, double s) {
  const pattern::PanelEdge& edge = edge_of(pattern, part.edge);
  const double whole = pattern::arc_length(edge);
  return pattern::point_at_length(edge,
                                  part.backwards ? part.edge.to * whole - s : part.edge.from * whole + s);
}

double height(const pattern::Pattern& pattern, const SeamModel& m, const Part& part, double s) {
  return dot(place_on(pattern, part, s), m.up[part.edge.panel]);
}

/// Distances from the part's start a millimetre apart, both ends included.
std::vector<double> millimetres(const Part& part) {
  std::vector<double> places;
  for (double s = 0; s < part.length; ++s) places.push_back(s);
  places.push_back(part.length);
  return places;
}

/// Where a sleeve's head is highest, and where the piece that it is on ends on either side, mm from the
/// ring's start; the ends may lie beyond the ring's.
struct Head {
  double crown = 0, from = 0, to = 0;
  bool back_last() const { return to - crown < crown - from; }
  /// Whether it is so uneven that it tells front from back.
  bool tells_back() const {
    const auto [less, more] = std::minmax({crown - from, to - crown});
    return more > kUneven * less;
  }
};

/// The notch near a place of a part, or that place.
double marked(const pattern::Pattern& pattern, const Part& part, double s) {
  double best = s, nearest = kMarked;
  for (const double here : millimetres(part)) {
    if (std::abs(here - s) >= nearest) continue;
    const Vec2 p = place_on(pattern, part, here);
    const std::vector<pattern::Notch>& notches = pattern.panels[part.edge.panel].notches;
    if (std::none_of(notches.begin(), notches.end(),
                     [&](const pattern::Notch& notch) { return length(notch.at - p) < 1; }))
      continue;
    nearest = std::abs(here - s);
    best = here;
  }
  return best;
}

/// Whether the part lies at the upper end of its piece: then that stands upright, whether the drawing says so
/// or not.
bool lies_on_top(const pattern::Pattern& pattern, const SeamModel& m, const Part& part) {
  constexpr double kUpper = 0.7;  // of the piece's height
  const Index panel = part.edge.panel;
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const SeamRun& run : m.runs) {
    if (run.panel != panel) continue;
    for (const Vec2& at : run.at) {
      low = std::min(low, dot(at, m.up[panel]));
      high = std::max(high, dot(at, m.up[panel]));
    }
  }
  const std::vector<double> places = millimetres(part);
  double sum = 0;
  for (const double s : places) sum += height(pattern, m, part, s);
  return sum / static_cast<double>(places.size()) > low + kUpper * (high - low);
}

/// The height of the higher end of what the ring has of the part's piece: pieces are drawn at any height, so
/// that only what rises above its own ends is the head.
double higher_end(const pattern::Pattern& pattern, const SeamModel& m, const Ring& sleeve, Index panel) {
  double end = -HUGE_VAL;
  for (std::size_t i = 0; i < sleeve.size(); ++i) {
    const Part &here = sleeve[i], &next = sleeve[(i + 1) % sleeve.size()];
    if (here.edge.panel == next.edge.panel) continue;
    if (here.edge.panel == panel) end = std::max(end, height(pattern, m, here, here.length));
    if (next.edge.panel == panel) end = std::max(end, height(pattern, m, next, 0));
  }
  return end;
}

std::optional<Head> head_of(const pattern::Pattern& pattern, const SeamModel& m, const Ring& sleeve) {
  double start = 0, highest = -HUGE_VAL;
  std::size_t on = 0;
  Head head;
  for (std::size_t i = 0; i < sleeve.size(); start += sleeve[i].length, ++i) {
    const Index panel = sleeve[i].edge.panel;
    const bool upright = m.upright[panel] || lies_on_top(pattern, m, sleeve[i]);
    if (m.words[panel].kind != PieceKind::kSleeve || !upright) return std::nullopt;
    const double end = higher_end(pattern, m, sleeve, panel);
    for (const double s : millimetres(sleeve[i])) {
      const double h = height(pattern, m, sleeve[i], s) - end;
      if (h <= highest) continue;
      highest = h;
      on = i;
      head = {start + s, start, start + sleeve[i].length};
    }
  }
  head.crown = head.from + marked(pattern, sleeve[on], head.crown - head.from);
  const Index panel = sleeve[on].edge.panel;
  const std::size_t n = sleeve.size();
  std::size_t parts = 1;
  for (std::size_t k = (on + 1) % n; parts < n && sleeve[k].edge.panel == panel; k = (k + 1) % n, ++parts)
    head.to += sleeve[k].length;
  for (std::size_t k = (on + n - 1) % n; parts < n && sleeve[k].edge.panel == panel;
       k = (k + n - 1) % n, ++parts)
    head.from -= sleeve[k].length;
  if (parts == n) return std::nullopt;  // of one piece
  return head.from < head.crown && head.crown < head.to ? std::optional(head) : std::nullopt;
}

/// Where an armhole comes to the shoulder, mm from the ring's start, and whether its back comes after that.
struct Shoulder {
  double at = 0;
  bool back_after = false;
};

std::optional<Shoulder> shoulder_of(const pattern::Pattern& pattern, const SeamModel& m,
                                    const Ring& armhole) {
  std::optional<Shoulder> shoulder;
  double at = 0;
  for (std::size_t i = 0; i < armhole.size(); ++i) {
    at += armhole[i].length;
    const Part &here = armhole[i], &next = armhole[(i + 1) % armhole.size()];
    if (m.words[here.edge.panel].kind != PieceKind::kTorso) return std::nullopt;
    if (m.words[here.edge.panel].face * m.words[next.edge.panel].face >= 0) continue;
    const bool up = height(pattern, m, here, here.length) > height(pattern, m, here, 0) &&
                    height(pattern, m, next, 0) > height(pattern, m, next, next.length);
    if (!up) continue;  // the side seam
    if (shoulder) return std::nullopt;
    shoulder = Shoulder{at, m.words[next.edge.panel].face < 0};
  }
  return shoulder;
}

/// The ring from another start, mm from its own, where a part may be cut in two.
Ring begun_at(const Ring& ring, double start) {
  const double all = length_of(ring);
  start -= all * std::floor(start / all);
  Ring before, after;
  double at = 0;
  for (const Part& part : ring) {
    double cut = std::clamp(start - at, 0.0, part.length);
    if (cut < kSnap) cut = 0;
    if (cut > part.length - kSnap) cut = part.length;
    Part first = part, second = part;
    const double share = (part.edge.to - part.edge.from) * cut / part.length;
    first.length = cut;
    second.length = part.length - cut;
    if (part.backwards) {
      first.edge.from = second.edge.to = part.edge.to - share;
    } else {
      first.edge.to = second.edge.from = part.edge.from + share;
    }
    if (first.length > 0) before.push_back(first);
    if (second.length > 0) after.push_back(second);
    at += part.length;
  }
  after.insert(after.end(), before.begin(), before.end());
  return after;
}

/// A sleeve in an armhole. The armhole may be side a or side b of the seam.
struct Setting {
  Index proposal = kNone;
  bool armhole_is_a = true;
  Ring armhole, sleeve;  ///< in the order of the armhole
  Shoulder shoulder;
  Head head;
  bool at_its_arm() const { return !head.tells_back() || head.back_last() == shoulder.back_after; }
};

std::optional<Setting> setting_of(const pattern::Pattern& pattern, const SeamModel& m, Index number,
                                  const SeamProposal& p, bool armhole_is_a) {
  const auto& [armhole, sleeve] = armhole_is_a ? std::tie(p.seam.a, p.seam.b) : std::tie(p.seam.b, p.seam.a);
  Setting s{number,
            armhole_is_a,
            ring_of(pattern, armhole, false),
            ring_of(pattern, sleeve, !p.seam.same_direction),
            {},
            {}};
  const auto shoulder = shoulder_of(pattern, m, s.armhole);
  const auto head = shoulder ? head_of(pattern, m, s.sleeve) : std::nullopt;
  if (!head) return std::nullopt;
  s.shoulder = *shoulder;
  s.head = *head;
  return s;
}

void set_in(const Setting& s, SeamProposal& p) {
  const double scale = length_of(s.sleeve) / length_of(s.armhole);
  const Ring turned = begun_at(s.sleeve, s.head.crown - s.shoulder.at * scale);
  (s.armhole_is_a ? p.seam.b : p.seam.a) = side_of(turned, !p.seam.same_direction);
  (s.armhole_is_a ? p.length_b : p.length_a) = length_of(turned);
}

/// Whether each part of x has its mirror image in y; a back on the fold has both in one piece.
bool are_twins(const SeamModel& m, const Ring& x, const Ring& y) {
  const auto mirrored = [&](const pattern::SeamEdge& a, const pattern::SeamEdge& b) {
    return m.twin[a.panel] == b.panel && (a.panel != b.panel || a.edge != b.edge);
  };
  return x.size() == y.size() && x.front().backwards == y.front().backwards &&
         std::all_of(x.begin(), x.end(), [&](const Part& part) {
           return std::any_of(y.begin(), y.end(),
                              [&](const Part& other) { return mirrored(part.edge, other.edge); });
         });
}

}  // namespace

void set_in_sleeves(const pattern::Pattern& pattern, const SeamModel& model, const std::vector<Index>& rings,
                    std::vector<SeamProposal>& proposals) {
  std::vector<Setting> settings;
  for (const Index r : rings) {
    std::optional<Setting> s = setting_of(pattern, model, r, proposals[r], true);
    if (!s) s = setting_of(pattern, model, r, proposals[r], false);
    if (s) settings.push_back(std::move(*s));
  }
  for (std::size_t i = 0; i < settings.size(); ++i)
    for (std::size_t j = i + 1; j < settings.size(); ++j) {
      Setting &x = settings[i], &y = settings[j];
      const bool pair = are_twins(model, x.armhole, y.armhole) && are_twins(model, x.sleeve, y.sleeve);
      if (!pair || x.at_its_arm() || y.at_its_arm()) continue;
      std::swap(x.sleeve, y.sleeve);
      std::swap(x.head, y.head);
    }
  for (const Setting& s : settings)
    if (s.at_its_arm()) set_in(s, proposals[s.proposal]);
}

}  // namespace toile::seams
