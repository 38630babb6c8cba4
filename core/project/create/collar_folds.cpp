#include "core/project/create/collar_folds.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/pattern/curve.h"
#include "core/pattern/seams/model.h"
#include "core/pattern/seams/piece_language.h"

namespace toile::create {
namespace {

// All of these are ours, chosen by pictures of twelve collars among tests/data/drawings, and scored on no
// others.
constexpr double kAngle = 170;      // degrees
constexpr double kStiffness = 100;  // mN·m per radian and metre, as the jacket's roll lines have
constexpr double kNarrowest = 30;   // mm; less is a piping or an edge that stands
constexpr double kLiesFlat = 1.25;  // times as long as the neck is a flat collar's outer edge
// A collar of one piece stands up to here, turns down where it is shaped to or placket and breadth tell so,
// mm, and its stand is this share of its breadth.
constexpr double kTooBroad = 55, kNeverStands = 75, kShaped = 1.03, kStand = 0.4;
constexpr int kPoints = 12;  // of the line along which it turns

/// How a piece is sewn that has one seam only: its edges, one after the other, and the piece at the other
/// side.
struct SewnOn {
  std::vector<Index> edges;
  Index to = kNone;
};

bool is_collar(const seams::SeamModel& m, Index panel) {
  return m.words[panel].kind == seams::PieceKind::kCollar;
}

/// Nothing where the piece is sewn to itself, or to a stand and to the neck as well.
std::optional<SewnOn> sewn_on(const pattern::Pattern& pattern, const seams::SeamModel& m, Index panel) {
  SewnOn sewn;
  for (const pattern::Seam& seam : pattern.seams) {
    for (const auto& [mine, theirs] : {std::pair{&seam.a, &seam.b}, std::pair{&seam.b, &seam.a}}) {
      for (const pattern::SeamEdge& e : *mine) {
        if (e.panel != panel) continue;
        const Index to = theirs->front().panel;
        if (to == panel || (sewn.to != kNone && is_collar(m, sewn.to) != is_collar(m, to)))
          return std::nullopt;
        if (!std::count(sewn.edges.begin(), sewn.edges.end(), e.edge)) sewn.edges.push_back(e.edge);
        sewn.to = to;
      }
    }
  }
  if (sewn.edges.empty()) return std::nullopt;
  // In the outline's order, from the edge that none of them comes before.
  const auto count = static_cast<Index>(pattern.panels[panel].outline.edges.size());
  const auto has = [&](Index e) { return std::count(sewn.edges.begin(), sewn.edges.end(), e) > 0; };
  std::vector<Index> row;
  for (const Index e : sewn.edges)
    if (!has((e + count - 1) % count)) row.push_back(e);
  if (row.size() != 1) return std::nullopt;
  while (has((row.back() + 1) % count)) row.push_back((row.back() + 1) % count);
  sewn.edges = std::move(row);
  return sewn;
}

/// The sewn side as a line through points (mm), in the outline's direction.
std::vector<Vec2> sewn_line(const pattern::Panel& panel, const SewnOn& sewn) {
  std::vector<Vec2> line;
  for (const Index e : sewn.edges)
    for (const Vec2 p : pattern::flatten(panel.outline.edges[e], 0.1))
      if (line.empty() || length(p - line.back()) > 1e-6) line.push_back(p);
  return line;
}

double length_of(const std::vector<Vec2>& line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += length(line[i] - line[i - 1]);
  return sum;
}

/// mm, of the point from the line.
double distance_from(const std::vector<Vec2>& line, Vec2 p) {
  double least = HUGE_VAL;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec2 way = line[i] - line[i - 1];
    const double t = std::clamp(dot(p - line[i - 1], way) / std::max(1e-12, dot(way, way)), 0.0, 1.0);
    least = std::min(least, length(line[i - 1] + way * t - p));
  }
  return least;
}

/// A collar as it is sewn.
struct Collar {
  std::vector<Vec2> neck, outline;  ///< mm; the sewn side, and all of it
  double breadth = 0;               ///< mm, the farthest that it reaches from there
  double spread = 1;                ///< times as long as the sewn side is the one across from it
};

Collar collar_of(const pattern::Panel& panel, const SewnOn& sewn) {
  Collar collar{sewn_line(panel, sewn), pattern::flatten(panel.outline, 0.1), 0, 1};
  for (const Vec2 p : collar.outline)
    collar.breadth = std::max(collar.breadth, distance_from(collar.neck, p));
  const double neck = length_of(collar.neck);
  const double around = length_of(collar.outline) + length(collar.outline.front() - collar.outline.back());
  collar.spread = (around - neck - 2 * collar.breadth) / std::max(1.0, neck);
  return collar;
}

/// Any placket tells of buttons, also a sleeve's: a zip would make the collar stand.
bool has_placket(const pattern::Pattern& pattern) {
  return std::any_of(pattern.panels.begin(), pattern.panels.end(), [](const pattern::Panel& panel) {
    const std::vector<std::string> words = seams::words_of_piece(panel.id);
    return std::count(words.begin(), words.end(), "placket") > 0;
  });
}

/// Where the outline leaves the neck at one end of it, first at that distance (mm) from it.
std::optional<Vec2> end_at(const Collar& collar, Vec2 end, bool forwards, double distance) {
  const std::vector<Vec2>& o = collar.outline;
  const auto at = [&](std::size_t k) { return o[(forwards ? k : 2 * o.size() - k) % o.size()]; };
  std::size_t begin = 0;
  for (std::size_t k = 0; k < o.size(); ++k)
    if (length(at(k) - end) < length(at(begin) - end)) begin = k;
  for (std::size_t k = begin; k < begin + o.size(); ++k) {
    const Vec2 p = at(k), q = at(k + 1);
    const double a = distance_from(collar.neck, p), b = distance_from(collar.neck, q);
    if (a <= distance && b > distance) return p + (q - p) * ((distance - a) / (b - a));
  }
  return std::nullopt;
}

/// The line at a distance (mm) from the neck, from end to end of the collar.
std::optional<project::ProjectLine> line_along(const Collar& collar, double distance) {
  const std::optional<Vec2> first = end_at(collar, collar.neck.front(), false, distance);
  const std::optional<Vec2> last = end_at(collar, collar.neck.back(), true, distance);
  if (!first || !last) return std::nullopt;
  project::ProjectLine line{"roll", {*first}};
  const double whole = length_of(collar.neck);
  double gone = 0;
  int next = 1;
  for (std::size_t i = 1; i < collar.neck.size(); ++i) {
    const Vec2 way = collar.neck[i] - collar.neck[i - 1];
    const Vec2 inwards = perpendicular(normalized(way));  // the piece lies to the left
    for (; next < kPoints && next * whole <= (gone + length(way)) * kPoints; ++next)
      line.points.push_back(collar.neck[i - 1] + normalized(way) * (next * whole / kPoints - gone) +
                            inwards * distance);
    gone += length(way);
  }
  line.points.push_back(*last);
  return line;
}

/// 1 where the side that is up in the flat piece is worn outside, as the largest piece's is; -1 where it is
/// inside.
int outside_of(const pattern::Pattern& pattern, Index panel) {
  const auto area = [&](Index p) { return std::abs(pattern::signed_area(pattern.panels[p].outline)); };
  Index largest = 0;
  for (Index p = 1; p < static_cast<Index>(pattern.panels.size()); ++p)
    if (area(p) > area(largest)) largest = p;
  std::vector<int> side(pattern.panels.size(), 0);
  side[largest] = 1;
  std::vector<Index> open{largest};
  while (!open.empty()) {
    const Index p = open.back();
    open.pop_back();
    for (const pattern::Seam& seam : pattern.seams) {
      const Index a = seam.a.front().panel, b = seam.b.front().panel;
      if (a != p && b != p) continue;
      const Index other = a == p ? b : a;
      if (side[other] != 0) continue;
      side[other] = side[p] * pattern::side_sign(seam);
      open.push_back(other);
    }
  }
  return side[panel] < 0 ? -1 : 1;
}

}  // namespace

std::vector<CollarFold> collar_folds(const pattern::Pattern& pattern) {
  const seams::SeamModel m = seams::make_seam_model(pattern);
  std::vector<CollarFold> folds;
  for (Index p = 0; p < static_cast<Index>(pattern.panels.size()); ++p) {
    if (!is_collar(m, p) || m.words[p].layer) continue;
    const std::optional<SewnOn> sewn = sewn_on(pattern, m, p);
    if (!sewn) continue;
    const pattern::Panel& panel = pattern.panels[p];
    const Collar collar = collar_of(panel, *sewn);
    CollarFold found{
        p, {"turned_" + panel.id, panel.id, {}, -kAngle * outside_of(pattern, p), kStiffness}, {}, kNone};
    if (m.words[p].stand && collar.breadth < kNeverStands) continue;
    const bool on_stand = is_collar(m, sewn->to);
    if (on_stand) found.stand = sewn->to;
    const bool shaped = collar.spread >= kShaped || collar.breadth >= kNeverStands || has_placket(pattern);
    if (collar.breadth >= kNarrowest && (on_stand || collar.spread > kLiesFlat)) {
      for (const Index e : sewn->edges) found.fold.lines.push_back(panel.outline.edges[e].id);
    } else if (collar.breadth >= kTooBroad && shaped) {
      const auto line = line_along(collar, kStand * collar.breadth);
      if (!line) continue;
      found.fold.lines = {line->id};
      found.lines = {*line};
    } else {
      continue;
    }
    folds.push_back(std::move(found));
  }
  return folds;
}

}  // namespace toile::create
