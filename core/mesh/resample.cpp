#include "core/mesh/resample.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/units.h"
#include "core/mesh/seam_intervals.h"
#include "core/mesh/triangulate.h"
#include "core/pattern/curve.h"

namespace toile::mesh {
namespace {

constexpr double kLeastDistance = 5e-4;    ///< m; finer cloth than any computer here drapes
constexpr double kLeastLength = 1e-6;      ///< m; a shorter edge is no edge
constexpr double kJoinToleranceMm = 1e-3;  ///< how far the ends of consecutive edges may be apart

/// A part of an edge that a seam takes: distances along the edge, m.
struct SeamStretch {
  double from = 0, to = 0;
  std::vector<double> at;  ///< of its points, rising, both ends included
  std::size_t first = 0;   ///< place of the first of them among the edge's points
};

/// An edge with the lengths that are needed to find points on it, m.
struct MeasuredEdge {
  const pattern::PanelEdge* edge = nullptr;
  std::vector<double> start;  ///< of each curve along the edge
  double length = 0;
  Index min_segments = 1;
  std::vector<SeamStretch> parts;  ///< in the order of the seams
};

using MeasuredPanel = std::vector<MeasuredEdge>;

/// One sewn part in the path of a seam's side.
struct PathEdge {
  Index panel, edge;
  std::size_t part;
  bool reversed;
  std::vector<double> at;  ///< distances of its points from its start in the path, m
};

std::string edge_name(const pattern::Panel& panel, const pattern::PanelEdge& edge) {
  return "piece " + panel.id + ", edge " + edge.id;
}

Vec2 metres(Vec2 mm) { return {metres_from_mm(mm.x), metres_from_mm(mm.y)}; }

Result<MeasuredEdge> measure(const pattern::Panel& panel, const pattern::PanelEdge& edge,
                             Index min_segments) {
  MeasuredEdge measured{&edge, {}, 0, min_segments, {}};
  for (const pattern::CubicBezier& c : edge.curves) {
    if (!is_finite(c.p0) || !is_finite(c.p1) || !is_finite(c.p2) || !is_finite(c.p3)) {
      return Error{"mesh.not_finite", "The edge has a point that is not a number.", edge_name(panel, edge)};
    }
    measured.start.push_back(measured.length);
    measured.length += metres_from_mm(pattern::arc_length(c));
  }
  if (!(measured.length > kLeastLength)) {
    return Error{"mesh.edge_without_length", "The edge has no length; remove it.", edge_name(panel, edge)};
  }
  return measured;
}

Status check_closed(const pattern::Panel& panel, const pattern::Loop& loop) {
  for (std::size_t i = 0; i < loop.edges.size(); ++i) {
    const pattern::PanelEdge& edge = loop.edges[i];
    const pattern::PanelEdge& next = loop.edges[(i + 1) % loop.edges.size()];
    if (!(length(edge.curves.back().p3 - next.curves.front().p0) <= kJoinToleranceMm)) {
      return Error{"mesh.outline_open", "The edge does not end where edge " + next.id + " starts.",
                   edge_name(panel, edge)};
    }
  }
  return {};
}

Result<MeasuredPanel> measure(const pattern::Panel& panel) {
  MeasuredPanel measured;
  const auto measure_loop = [&](const pattern::Loop& loop) -> Status {
    const Index least = loop.edges.size() == 1 ? 3 : loop.edges.size() == 2 ? 2 : 1;
    for (const pattern::PanelEdge& edge : loop.edges) {
      MeasuredEdge m = TRY(measure(panel, edge, least));
      measured.push_back(std::move(m));
    }
    return check_closed(panel, loop);
  };
  TRY(measure_loop(panel.outline));
  for (const pattern::Loop& hole : panel.holes) TRY(measure_loop(hole));
  return measured;
}

/// The point at `s` metres from the edge's start; its ends exactly.
Vec2 point_on(const MeasuredEdge& m, double s) {
  if (s <= 0) return metres(m.edge->curves.front().p0);
  if (s >= m.length) return metres(m.edge->curves.back().p3);
  const auto k = std::upper_bound(m.start.begin(), m.start.end(), s) - m.start.begin() - 1;
  const pattern::CubicBezier& curve = m.edge->curves[k];
  return metres(
      pattern::evaluate(curve, pattern::parameter_at_length(curve, mm_from_metres(s - m.start[k]))));
}

/// Distances of n + 1 evenly spaced points from `from` to `to`, appended without the first if there are some.
void append_even(double from, double to, Index n, std::vector<double>& at) {
  for (Index k = at.empty() ? 0 : 1; k <= n; ++k) at.push_back(k == n ? to : from + (to - from) * k / n);
}

std::vector<Vec2> points_at(const MeasuredEdge& m, const std::vector<double>& at) {
  std::vector<Vec2> points;
  points.reserve(at.size());
  for (std::size_t i = 0; i < at.size(); ++i)
    points.push_back(point_on(m, i + 1 == at.size() ? m.length : at[i]));
  return points;
}

/// A side of a seam in the making.
struct Side {
  std::vector<PathEdge> path;
  std::vector<double> breaks{0};  ///< m, corners along the path, ends included
  std::size_t current = 0;        ///< edge of the path that the next interval lies on
};

/// Adds the part that the seam takes of an edge; its place among the edge's parts.
Result<std::size_t> take_part(MeasuredEdge& m, const pattern::SeamEdge& e, const pattern::Panel& panel,
                              const std::string& where) {
  if (!(e.from >= 0 && e.to <= 1 && (e.to - e.from) * m.length > kLeastLength)) {
    return Error{"mesh.seam_edge", "The seam takes an empty part of " + edge_name(panel, *m.edge) + ".",
                 where};
  }
  const SeamStretch part{e.from * m.length, e.to == 1 ? m.length : e.to * m.length, {}, 0};
  for (const SeamStretch& other : m.parts) {
    if (std::min(part.to, other.to) - std::max(part.from, other.from) <= kLeastLength) continue;
    return Error{"mesh.seam_edge", "The seam takes " + edge_name(panel, *m.edge) + ", which is sewn already.",
                 where};
  }
  m.parts.push_back(part);
  return m.parts.size() - 1;
}

Result<Side> side_of(const pattern::Pattern& pattern, std::vector<MeasuredPanel>& panels,
                     const pattern::Seam& seam, const std::vector<pattern::SeamEdge>& edges, bool backwards) {
  const std::string where = "seam " + seam.id;
  if (edges.empty()) return Error{"mesh.seam_edge", "A side of the seam has no edges.", where};
  Side side;
  for (const pattern::SeamEdge& e : edges) {
    const bool exists = e.panel >= 0 && e.panel < static_cast<Index>(panels.size()) && e.edge >= 0 &&
                        e.edge < static_cast<Index>(panels[e.panel].size());
    if (!exists) return Error{"mesh.seam_edge", "The seam names an edge that does not exist.", where};
    const std::size_t part = TRY(take_part(panels[e.panel][e.edge], e, pattern.panels[e.panel], where));
    side.path.push_back({e.panel, e.edge, part, e.reversed != backwards, {}});
  }
  if (backwards) std::reverse(side.path.begin(), side.path.end());
  for (const PathEdge& e : side.path) {
    const SeamStretch& part = panels[e.panel][e.edge].parts[e.part];
    side.breaks.push_back(side.breaks.back() + (part.to - part.from));
  }
  return side;
}

/// Segments that the edges on both sides of an interval ask for at least.
Index min_segments(const Side& side, const std::vector<MeasuredPanel>& panels) {
  const PathEdge& e = side.path[side.current];
  return panels[e.panel][e.edge].min_segments;
}

/// Adds the interval's points to the side's current edge; says how many points lie before it there.
std::size_t add_interval(Side& side, double from, double to, Index segments) {
  PathEdge& e = side.path[side.current];
  const double origin = side.breaks[side.current];
  const std::size_t before = e.at.empty() ? 0 : e.at.size() - 1;
  append_even(from - origin, to - origin, segments, e.at);
  return before;
}

/// The points of the path along the edges themselves, in the outline's own direction.
void store_side(const Side& side, std::vector<MeasuredPanel>& panels) {
  for (const PathEdge& e : side.path) {
    SeamStretch& part = panels[e.panel][e.edge].parts[e.part];
    part.at = e.at;
    if (e.reversed) std::reverse(part.at.begin(), part.at.end());
    for (double& s : part.at) s = e.reversed ? part.to - s : part.from + s;
    part.at.front() = part.from;
    part.at.back() = part.to;
  }
}

/// Stretches of both sides that are cut alike.
struct Run {
  std::size_t edge_a, first_a, edge_b, first_b;
  Index segments;
};

/// A seam whose points are known on each part; their places on the whole edges are known in the end.
struct CutSeam {
  Side a, b;
  std::vector<Run> runs;
};

/// What the panels on both sides of a seam ask for: the finest.
double spacing_of(const pattern::Pattern& pattern, const pattern::Seam& seam, double usual) {
  double finest = pattern::spacing_on(pattern.panels[seam.a.front().panel], usual);
  for (const auto* side : {&seam.a, &seam.b}) {
    for (const pattern::SeamEdge& e : *side)
      finest = std::min(finest, pattern::spacing_on(pattern.panels[e.panel], usual));
  }
  return finest;
}

CutSeam cut_seam(Side a, Side b, std::vector<MeasuredPanel>& panels, double particle_distance) {
  std::vector<Run> runs;
  for (const SeamInterval& interval : seam_intervals(a.breaks, b.breaks, particle_distance)) {
    const Index n = std::max({interval.segments, min_segments(a, panels), min_segments(b, panels)});
    Run run{a.current, 0, b.current, 0, n};
    run.first_a = add_interval(a, interval.a0, interval.a1, n);
    run.first_b = add_interval(b, interval.b0, interval.b1, n);
    if (interval.a1 == a.breaks[a.current + 1]) ++a.current;
    if (interval.b1 == b.breaks[b.current + 1]) ++b.current;
    runs.push_back(run);
  }
  store_side(a, panels);
  store_side(b, panels);
  return {std::move(a), std::move(b), std::move(runs)};
}

/// Point k of the path edge, counted in the outline's direction from the edge's start.
EdgeSample sample_of(const PathEdge& e, std::size_t k, const std::vector<MeasuredPanel>& panels) {
  const SeamStretch& part = panels[e.panel][e.edge].parts[e.part];
  return {e.panel, e.edge, static_cast<Index>(part.first + (e.reversed ? e.at.size() - 1 - k : k))};
}

SampledSeam sampled_seam(const CutSeam& cut, const std::vector<MeasuredPanel>& panels) {
  SampledSeam seam{{}, cut.a.breaks.back(), cut.b.breaks.back()};
  for (const Run& r : cut.runs) {
    for (Index k = 0; k <= r.segments; ++k) {
      seam.pairs.push_back({sample_of(cut.a.path[r.edge_a], r.first_a + k, panels),
                            sample_of(cut.b.path[r.edge_b], r.first_b + k, panels)});
    }
  }
  return seam;
}

/// All points of an edge: those of its sewn parts, and evenly between them.
std::vector<double> points_of(MeasuredEdge& m, double particle_distance) {
  std::vector<double> at;
  const auto fill = [&](double to) {
    const double from = at.empty() ? 0 : at.back();
    if (to - from <= kLeastLength) return;
    append_even(from, to, std::max(m.min_segments, segment_count(to - from, particle_distance)), at);
  };
  std::vector<SeamStretch*> parts;
  for (SeamStretch& part : m.parts) parts.push_back(&part);
  std::sort(parts.begin(), parts.end(),
            [](const SeamStretch* x, const SeamStretch* y) { return x->from < y->from; });
  for (SeamStretch* part : parts) {
    fill(part->from);
    part->first = at.empty() ? 0 : at.size() - 1;
    at.insert(at.end(), part->at.begin() + (at.empty() ? 0 : 1), part->at.end());
  }
  fill(m.length);
  return at;
}

Result<std::vector<MeasuredPanel>> measure(const pattern::Pattern& pattern, double particle_distance) {
  std::vector<MeasuredPanel> panels;
  double total = 0;
  for (const pattern::Panel& panel : pattern.panels) {
    MeasuredPanel measured = TRY(measure(panel));
    const double spacing = pattern::spacing_on(panel, particle_distance);
    if (!(spacing >= kLeastDistance && std::isfinite(spacing))) {
      return Error{"mesh.particle_distance", "The particle distance must be at least 0.5 mm.",
                   panel.spacing > 0 ? "piece " + panel.id : ""};
    }
    for (const MeasuredEdge& m : measured) total += m.length / spacing;
    panels.push_back(std::move(measured));
  }
  if (!(total <= kMaxParticles)) {
    return Error{
        "mesh.too_many_particles",
        "The outlines alone would have over half a million particles; choose a larger particle distance.",
        ""};
  }
  return panels;
}

}  // namespace

Result<SampledPattern> resample(const pattern::Pattern& pattern, double particle_distance) {
  std::vector<MeasuredPanel> measured = TRY(measure(pattern, particle_distance));
  std::vector<MeasuredPanel>& panels = measured;
  SampledPattern sampled;
  for (const MeasuredPanel& panel : panels) sampled.edges.emplace_back(panel.size());
  std::vector<CutSeam> cuts;
  for (const pattern::Seam& seam : pattern.seams) {
    Side a = TRY(side_of(pattern, panels, seam, seam.a, false));
    Side b = TRY(side_of(pattern, panels, seam, seam.b, !seam.same_direction));
    cuts.push_back(
        cut_seam(std::move(a), std::move(b), panels, spacing_of(pattern, seam, particle_distance)));
  }
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const double spacing = pattern::spacing_on(pattern.panels[p], particle_distance);
    for (std::size_t e = 0; e < panels[p].size(); ++e)
      sampled.edges[p][e] = points_at(panels[p][e], points_of(panels[p][e], spacing));
  }
  for (const CutSeam& cut : cuts) sampled.seams.push_back(sampled_seam(cut, panels));
  return sampled;
}

}  // namespace toile::mesh
