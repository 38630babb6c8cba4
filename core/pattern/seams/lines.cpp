#include "core/pattern/seams/lines.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/base/units.h"
#include "core/pattern/curve.h"
#include "core/pattern/seams/model.h"
#include "core/pattern/seams/weights.h"

namespace toile::seams {
namespace {

using EdgeSet = std::set<std::pair<Index, Index>>;

EdgeSet sewn_edges(const pattern::Pattern& pattern) {
  EdgeSet sewn;
  for (const pattern::Seam& seam : pattern.seams)
    for (const std::vector<pattern::SeamEdge>* side : {&seam.a, &seam.b})
      for (const pattern::SeamEdge& e : *side) sewn.insert({e.panel, e.edge});
  return sewn;
}

/// Whether the piece's lower end is a hem for certain.
bool hangs_free(PieceKind kind) {
  return kind == PieceKind::kSkirt || kind == PieceKind::kLegs || kind == PieceKind::kSleeve ||
         kind == PieceKind::kFrill;
}

/// Whether the piece's upper end may be a waist.
bool has_waist(PieceKind kind) { return kind == PieceKind::kSkirt || kind == PieceKind::kLegs; }

/// Whether the piece is of the trunk, as far as its name tells: a bodice, or a front or back of what no name
/// says.
bool is_of_trunk(const pattern::Panel& panel) {
  const PieceWords words = words_of(panel.id);
  return words.kind == PieceKind::kTorso || (words.kind == PieceKind::kOther && words.face != 0);
}

/// How much the mouth between the edges `first` and the next faces up along the grain, -1 to 1.
double mouth_up(const pattern::Panel& panel, std::size_t first) {
  const std::vector<pattern::PanelEdge>& edges = panel.outline.edges;
  const pattern::PanelEdge& in = edges[first];
  const pattern::PanelEdge& out = edges[(first + 1) % edges.size()];
  const Vec2 across = out.curves.back().p3 - in.curves.front().p0;
  return dot(normalized(-perpendicular(across)), normalized(panel.grain));
}

/// Whether the dart's mouth is in a hem.
bool is_slit(const pattern::Panel& panel, std::size_t first) {
  return mouth_up(panel, first) < kDartWeights.top && hangs_free(words_of(panel.id).kind);
}

/// Degrees between the edges' chords from the tip at which they meet: curved legs leave it at more.
double width_of(const pattern::PanelEdge& in, const pattern::PanelEdge& out) {
  const Vec2 tip = in.curves.back().p3;
  const Vec2 a = in.curves.front().p0 - tip, b = out.curves.back().p3 - tip;
  return degrees_from_radians(std::abs(std::atan2(cross(a, b), dot(a, b))));
}

/// Whether legs that are drawn of one length close a dart that is too wide to tell, has curved legs, or ends
/// in a corner of a front or back, as under the arm. What opens upwards there may be a neck.
bool is_drawn_dart(const pattern::Panel& panel, std::size_t first, double mouth) {
  const std::vector<pattern::PanelEdge>& edges = panel.outline.edges;
  const pattern::PanelEdge& in = edges[first];
  const pattern::PanelEdge& out = edges[(first + 1) % edges.size()];
  const double a = pattern::arc_length(in), b = pattern::arc_length(out);
  const double tip = 360 - corner_angle(in, out), width = width_of(in, out);
  const bool exact = std::abs(a - b) < kDartWeights.drawn * std::max(a, b);
  if (!exact || tip < kDartWeights.least_deg || tip > 180 || width > kDartWeights.drawn_most_deg)
    return false;
  return std::abs(mouth - 180) < kDartWeights.mouth_deg ||
         (is_of_trunk(panel) && mouth_up(panel, first) < kDartWeights.top);
}

/// Degrees that the outline has across the mouth of the dart with that first leg, once it is closed.
double mouth_of(const pattern::Panel& panel, std::size_t first) {
  const std::vector<pattern::PanelEdge>& edges = panel.outline.edges;
  const std::size_t n = edges.size();
  return corner_angle(edges[(first + n - 1) % n], edges[first]) +
         corner_angle(edges[(first + 1) % n], edges[(first + 2) % n]);
}

/// Whether the outline is its own mirror image about the corner after the edge `first`, by its edges'
/// lengths: a front that is drawn whole may miss the half millimetre of pattern::is_own_mirror().
bool is_mirrored_about(const pattern::Panel& panel, std::size_t first) {
  const std::vector<pattern::PanelEdge>& edges = panel.outline.edges;
  const std::size_t n = edges.size();
  for (std::size_t k = 0; k <= n / 2; ++k) {
    const double before = pattern::arc_length(edges[(first + n - k) % n]);
    const double after = pattern::arc_length(edges[(first + 1 + k) % n]);
    if (std::abs(before - after) > kDartWeights.halves * std::max(before, after)) return false;
  }
  return true;
}

/// Whether the edges `first` and the next are the V of a neck: in the middle of a whole front or back, and so
/// wide that a head may go through.
bool is_v_neck(const pattern::Panel& panel, std::size_t first) {
  if (!is_of_trunk(panel) || mouth_up(panel, first) < kDartWeights.faces_up) return false;
  const std::vector<pattern::PanelEdge>& edges = panel.outline.edges;
  const Vec2 across = edges[(first + 1) % edges.size()].curves.back().p3 - edges[first].curves.front().p0;
  return length(across) > kDartWeights.neck && is_mirrored_about(panel, first);
}

/// Whether the edges `first` and the next of the panel are a dart's legs.
bool is_closed(const pattern::Panel& panel, std::size_t first) {
  const std::vector<pattern::PanelEdge>& edges = panel.outline.edges;
  const std::size_t n = edges.size();
  const pattern::PanelEdge& in = edges[first];
  const pattern::PanelEdge& out = edges[(first + 1) % n];
  const double a = pattern::arc_length(in), b = pattern::arc_length(out);
  if (std::abs(a - b) > kDartWeights.legs * std::max(a, b) || is_v_neck(panel, first)) return false;
  const double tip = 360 - corner_angle(in, out);
  const bool waist = mouth_up(panel, first) > kDartWeights.top && has_waist(words_of(panel.id).kind);
  const double mouth = mouth_of(panel, first);
  if (is_drawn_dart(panel, first, mouth)) return true;
  if (tip < kDartWeights.least_deg || tip > (waist ? kDartWeights.most_up_deg : kDartWeights.most_deg))
    return false;
  const bool straight = waist && std::abs(mouth - 180 - tip) < kDartWeights.straight_mouth_deg;
  return straight || std::abs(mouth - 180) < kDartWeights.mouth_deg;
}

/// Lengths of the sides of what is let into other pieces, mm.
std::vector<double> sides_of_inserts(const pattern::Pattern& pattern) {
  std::vector<double> sides;
  for (const pattern::Panel& panel : pattern.panels)
    if (words_of(panel.id).kind == PieceKind::kInsert)
      for (const pattern::PanelEdge& edge : panel.outline.edges) sides.push_back(pattern::arc_length(edge));
  return sides;
}

/// First legs of the panel's darts. Slits that are as long as one of `inserts` (mm) are open for those.
std::vector<std::size_t> darts_of(const pattern::Panel& panel, Index index, const EdgeSet& sewn,
                                  const std::vector<double>& inserts) {
  const std::size_t n = panel.outline.edges.size();
  std::vector<std::size_t> darts;
  if (n < 5) return darts;
  std::vector<char> used(n, 0);
  const auto let_in = [&](std::size_t e) {
    const double leg = pattern::arc_length(panel.outline.edges[e]);
    return is_slit(panel, e) && std::any_of(inserts.begin(), inserts.end(), [&](double side) {
             return std::abs(side - leg) < kDartWeights.legs * leg;
           });
  };
  for (std::size_t e = 0; e < n; ++e) {
    const std::size_t around[] = {(e + n - 1) % n, e, (e + 1) % n, (e + 2) % n};
    const auto taken = [&](std::size_t k) { return sewn.contains({index, static_cast<Index>(k)}); };
    if (used[e] || used[around[2]] || std::any_of(std::begin(around), std::end(around), taken)) continue;
    if (used[around[0]] == 1 || used[around[3]] == 1 || !is_closed(panel, e) || let_in(e)) continue;
    darts.push_back(e);
    used[e] = used[around[2]] = 1;
  }
  return darts;
}

/// Whether edges of such pieces are parted where nothing but their program's way of drawing asks for it.
bool is_parted_freely(PieceKind kind) {
  return kind == PieceKind::kTorso || kind == PieceKind::kBand || kind == PieceKind::kSkirt ||
         kind == PieceKind::kLegs;
}

/// Whether two edges of the front are its side, parted where a dart is drawn inside the piece: no edge of the
/// pattern's other pieces is as long as one of the two.
bool is_side_at_dart(const pattern::Pattern& pattern, Index index, const pattern::PanelEdge& before,
                     const pattern::PanelEdge& after) {
  const pattern::Panel& panel = pattern.panels[index];
  const PieceWords words = words_of(panel.id);
  if (words.face <= 0 || (words.kind != PieceKind::kTorso && words.kind != PieceKind::kOther)) return false;
  if (std::abs(corner_angle(before, after) - 180) > kDartWeights.inside_deg) return false;
  const auto climbs = [&](const pattern::PanelEdge& edge) {
    const Vec2 along = normalized(edge.curves.back().p3 - edge.curves.front().p0);
    return std::abs(dot(along, normalized(panel.grain))) > kDartWeights.inside_rise;
  };
  const double a = pattern::arc_length(before), b = pattern::arc_length(after);
  if (!climbs(before) || !climbs(after) || std::min(a, b) > kDartWeights.inside_part * (a + b)) return false;
  for (const pattern::Panel& other : pattern.panels) {
    if (words_of(other.id).face == words.face) continue;
    for (const pattern::PanelEdge& edge : other.outline.edges) {
      const double there = pattern::arc_length(edge);
      for (const double here : {a, b})
        if (std::abs(there - here) < kDartWeights.halves * here) return false;
    }
  }
  return true;
}

/// Edges that go on from the one before without a corner.
std::vector<char> goes_on(const pattern::Pattern& pattern, Index index, const EdgeSet& sewn) {
  const pattern::Panel& panel = pattern.panels[index];
  const std::vector<pattern::PanelEdge>& edges = panel.outline.edges;
  const std::size_t n = edges.size();
  std::vector<char> on(n, 0);
  if (n < 2) return on;
  const bool freely = is_parted_freely(words_of(panel.id).kind);
  for (std::size_t e = 0; e < n; ++e) {
    const std::size_t before = (e + n - 1) % n;
    const bool free =
        !sewn.contains({index, static_cast<Index>(e)}) && !sewn.contains({index, static_cast<Index>(before)});
    const double a = pattern::arc_length(edges[before]), b = pattern::arc_length(edges[e]);
    const bool halves = std::abs(a - b) < kDartWeights.halves * std::max(a, b);  // a middle that is marked
    const bool smooth = std::abs(corner_angle(edges[before], edges[e]) - 180) < kDartWeights.smooth_deg;
    on[e] =
        free && ((freely && !halves && smooth) || is_side_at_dart(pattern, index, edges[before], edges[e]));
  }
  return on;
}

/// The outline's edges by lines: each begins where no edge goes on, not over a dart either.
std::vector<std::vector<Index>> lines_around(const pattern::Panel& panel,
                                             const std::vector<std::size_t>& darts, std::vector<char> on) {
  const std::size_t n = panel.outline.edges.size();
  std::vector<char> leg(n, 0);
  for (const std::size_t first : darts) {
    leg[first] = leg[(first + 1) % n] = 1;
    on[(first + 2) % n] = std::abs(mouth_of(panel, first) - 180) < kDartWeights.corner_deg;
  }
  std::vector<std::vector<Index>> lines;
  for (std::size_t e = 0; e < n; ++e) {
    if (leg[e] || on[e]) continue;
    std::vector<Index>& line = lines.emplace_back();
    std::size_t at = e;
    do {
      line.push_back(static_cast<Index>(at));
      at = (at + (leg[(at + 1) % n] ? 3 : 1)) % n;
    } while (on[at]);
  }
  return lines;
}

pattern::PanelEdge joined(const pattern::Panel& panel, const std::vector<Index>& line) {
  pattern::PanelEdge edge = panel.outline.edges[line.front()];
  for (std::size_t k = 1; k < line.size(); ++k) {
    const std::vector<pattern::CubicBezier>& more = panel.outline.edges[line[k]].curves;
    edge.curves.insert(edge.curves.end(), more.begin(), more.end());
  }
  return edge;
}

void name_lines(const pattern::Pattern& pattern, SeamLines& lines) {
  for (pattern::Seam& seam : lines.pattern.seams) {
    for (std::vector<pattern::SeamEdge>* side : {&seam.a, &seam.b}) {
      for (pattern::SeamEdge& e : *side) {
        const std::vector<std::vector<Index>>& of = lines.edges[e.panel];
        const auto outline = static_cast<Index>(pattern.panels[e.panel].outline.edges.size());
        const auto at = std::find_if(of.begin(), of.end(), [&](const std::vector<Index>& line) {
          return line.size() == 1 && line[0] == e.edge;
        });
        e.edge = e.edge >= outline ? e.edge - outline + static_cast<Index>(of.size())
                                   : static_cast<Index>(at - of.begin());
      }
    }
  }
}

}  // namespace

SeamLines lines_of(const pattern::Pattern& pattern) {
  SeamLines lines{pattern, {}, {}};
  const EdgeSet sewn = sewn_edges(pattern);
  const std::vector<double> inserts = sides_of_inserts(pattern);
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    const pattern::Panel& panel = pattern.panels[p];
    const std::size_t n = panel.outline.edges.size();
    const auto index = static_cast<Index>(p);
    std::vector<std::size_t> darts = darts_of(panel, index, sewn, inserts);
    std::vector<char> on = goes_on(pattern, index, sewn);
    if (lines_around(panel, darts, on).empty()) {  // no line has an end
      darts.clear();
      on.assign(n, 0);
    }
    for (const std::size_t first : darts)
      lines.darts.push_back(
          {index, static_cast<Index>(first), static_cast<Index>((first + 1) % n), is_slit(panel, first)});
    lines.edges.push_back(lines_around(panel, darts, on));
    pattern::Loop loop;
    for (const std::vector<Index>& line : lines.edges.back()) loop.edges.push_back(joined(panel, line));
    lines.pattern.panels[p].outline = std::move(loop);
  }
  name_lines(pattern, lines);
  return lines;
}

std::vector<pattern::SeamEdge> edges_of_line(const SeamLines& lines, const pattern::Pattern& pattern,
                                             const pattern::SeamEdge& part) {
  constexpr double kNear = 0.02, kNearMm = 3;  // a part that ends so close to a corner ends there
  const std::vector<Index>& line = lines.edges[part.panel][part.edge];
  std::vector<double> length;
  double whole = 0;
  for (const Index e : line) {
    length.push_back(pattern::arc_length(pattern.panels[part.panel].outline.edges[e]));
    whole += length.back();
  }
  std::vector<pattern::SeamEdge> edges;
  double start = 0;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const double near = std::min(kNear, kNearMm / length[k]);
    double from = std::clamp((part.from * whole - start) / length[k], 0.0, 1.0);
    double to = std::clamp((part.to * whole - start) / length[k], 0.0, 1.0);
    if (from < near) from = 0;
    if (to > 1 - near) to = 1;
    if (from < 1 - near && to > near) edges.push_back({part.panel, line[k], part.reversed, from, to});
    start += length[k];
  }
  if (part.reversed) std::reverse(edges.begin(), edges.end());
  return edges;
}

}  // namespace toile::seams
