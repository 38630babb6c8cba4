#include "core/analysis/girth.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <queue>
#include <set>
#include <utility>

namespace toile::analysis {
namespace {

constexpr double kOpen = 0.01;  ///< m, from which on a sewn pair of vertices is not one

/// A triangle's piece of the cut, between two edges of the sewn cloth.
struct Segment {
  std::array<Index, 2> node{};  ///< by index into the cut's edges
  double flat = 0, worn = 0, compliance = 0;
  Vec3 middle;  ///< m
  Index panel = 0;
  int turns_inside = 0, turns_outside = 0;  ///< +1, -1 where it crosses the ray from that point, from node 0
};

struct Cut {
  std::vector<Segment> segments;
  std::vector<std::vector<Index>> at_node;  ///< segments, of each node
};

/// Axes in a plane.
struct Axes {
  Vec3 u, v;
};

Axes axes_of(Vec3 normal) {
  const Vec3 other = std::abs(normal.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 0, 1};
  const Vec3 u = normalized(cross(other, normal));
  return {u, cross(normal, u)};
}

/// How often the way from a to b passes the ray from `centre` along u: +1 counter-clockwise, -1 clockwise.
int turns(Vec3 a, Vec3 b, Vec3 centre, const Axes& axes) {
  const Vec2 p{dot(a - centre, axes.u), dot(a - centre, axes.v)};
  const Vec2 q{dot(b - centre, axes.u), dot(b - centre, axes.v)};
  if ((p.y >= 0) == (q.y >= 0)) return 0;
  const double x = p.x + (q.x - p.x) * p.y / (p.y - q.y);
  if (x <= 0) return 0;
  return q.y >= 0 ? 1 : -1;
}

/// Strain per N/m along a flat direction, its sides held. Source: the membrane of core/material/fabric.h.
double compliance_along(const material::Fabric& f, Vec2 along, Vec2 grain) {
  const double c = dot(along, grain), s = cross(along, grain);
  const double stiffness = c * c * c * c * f.stretch_warp + s * s * s * s * f.stretch_weft +
                           2 * c * c * s * s * (f.stretch_coupling + 2 * f.stretch_shear);
  return stiffness > 0 ? 1 / stiffness : 0;
}

class Cutting {
 public:
  Cutting(const drape::DrapeInput& input, const drape::DrapeResult& result, const TapePlane& plane)
      : input_(input), g_(result.garment), x_(result.positions), plane_(plane), axes_(axes_of(plane.normal)) {
    for (Index v = 0; v < g_.vertex_count(); ++v) above_.push_back(dot(x_[v] - plane.inside, plane.normal));
  }

  Cut take() {
    Cut cut;
    for (Index t = 0; t < static_cast<Index>(g_.triangles.size()); ++t) add(t, cut);
    cut.at_node.resize(nodes_.size());
    for (Index s = 0; s < static_cast<Index>(cut.segments.size()); ++s)
      for (const Index n : cut.segments[s].node) cut.at_node[n].push_back(s);
    return cut;
  }

 private:
  struct Crossing {
    Index node;
    Vec2 flat;
    Vec3 place;
  };

  Index sewn(Index v) const {
    const Index w = g_.weld[v];
    return length(x_[v] - x_[w]) < kOpen ? w : v;
  }
  bool up(Index v) const { return above_[v] >= 0; }

  Crossing crossing(Index a, Index b) {
    if (sewn(a) > sewn(b)) std::swap(a, b);
    const auto key = std::pair(sewn(a), sewn(b));
    const Index node = nodes_.try_emplace(key, static_cast<Index>(nodes_.size())).first->second;
    const double share = above_[a] / (above_[a] - above_[b]);
    const Vec3 place = x_[a] + (x_[b] - x_[a]) * share;
    if (node == static_cast<Index>(places_.size())) places_.push_back(place);
    return {node, g_.rest[a] + (g_.rest[b] - g_.rest[a]) * share, place};
  }

  void add(Index t, Cut& cut) {
    const Tri& tri = g_.triangles[t];
    std::vector<Crossing> ends;
    for (int k = 0; k < 3; ++k)
      if (up(tri[k]) != up(tri[(k + 1) % 3])) ends.push_back(crossing(tri[k], tri[(k + 1) % 3]));
    if (ends.size() != 2) return;
    Segment s;
    s.node = {ends[0].node, ends[1].node};
    s.flat = length(ends[1].flat - ends[0].flat);
    s.worn = length(ends[1].place - ends[0].place);
    s.middle = (ends[0].place + ends[1].place) * 0.5;
    s.panel = g_.panel_of_triangle[t];
    s.compliance =
        compliance_along(input_.fabrics[input_.fabric_of_panel[s.panel]],
                         normalized(ends[1].flat - ends[0].flat), input_.pattern.panels[s.panel].grain);
    // The same place for both sides of a seam, or a ray through the seam would be passed once or thrice.
    const Vec3 from = places_[s.node[0]], to = places_[s.node[1]];
    s.turns_inside = turns(from, to, plane_.inside, axes_);
    if (plane_.outside) s.turns_outside = turns(from, to, *plane_.outside, axes_);
    cut.segments.push_back(s);
  }

  const drape::DrapeInput& input_;
  const sewing::GarmentMesh& g_;
  const std::vector<Vec3>& x_;
  TapePlane plane_;
  Axes axes_;
  std::vector<double> above_;  // m, of each vertex
  std::map<std::pair<Index, Index>, Index> nodes_;
  std::vector<Vec3> places_;  // m, of the nodes
};

/// Where a way has come to: a node, and how often it went around either point so far. Cloth that folds back
/// may pass a ray several times, so that counts go beyond one on the way.
constexpr int kMostTurns = 2, kTurnCounts = 2 * kMostTurns + 1;
struct State {
  Index node = 0;
  int inside = 0, outside = 0;
};

/// Shortest ways by their flat length (Dijkstra), over nodes times turns.
class Ways {
 public:
  explicit Ways(const Cut& cut)
      : cut_(cut),
        length_(cut.at_node.size() * kTurnCounts * kTurnCounts),
        by_(length_.size()),
        from_(length_.size()) {}

  /// m, from the node around `inside` once and back; infinity where there is none within `most`.
  double around(Index node, double most) {
    std::fill(length_.begin(), length_.end(), kFar);
    const State goal{node, 1, 0};
    relax({node, 0, 0}, 0, kNone, kNone);
    while (!queue_.empty()) {
      const auto [so_far, at] = queue_.top();
      queue_.pop();
      if (so_far > length_[at]) continue;
      if (so_far >= most) break;
      if (at == index_of(goal)) {
        queue_ = {};
        return so_far;
      }
      leave(at, so_far);
    }
    queue_ = {};
    return kFar;
  }

  /// The segments of the way that around() found.
  std::vector<Index> way(Index node) const {
    std::vector<Index> out;
    for (std::size_t at = index_of({node, 1, 0}); by_[at] != kNone; at = static_cast<std::size_t>(from_[at]))
      out.push_back(by_[at]);
    return out;
  }

  static constexpr double kFar = std::numeric_limits<double>::infinity();

 private:
  static std::size_t index_of(State s) {
    return (static_cast<std::size_t>(s.node) * kTurnCounts +
            static_cast<std::size_t>(s.inside + kMostTurns)) *
               kTurnCounts +
           static_cast<std::size_t>(s.outside + kMostTurns);
  }
  static State state_of(std::size_t at) {
    const auto turns = static_cast<int>(at % (kTurnCounts * kTurnCounts));
    return {static_cast<Index>(at / (kTurnCounts * kTurnCounts)), turns / kTurnCounts - kMostTurns,
            turns % kTurnCounts - kMostTurns};
  }

  void leave(std::size_t at, double so_far) {
    const State here = state_of(at);
    for (const Index s : cut_.at_node[here.node]) {
      const Segment& segment = cut_.segments[s];
      const int side = segment.node[0] == here.node ? 0 : 1, sign = side == 0 ? 1 : -1;
      relax({segment.node[1 - side], here.inside + sign * segment.turns_inside,
             here.outside + sign * segment.turns_outside},
            so_far + segment.flat, s, static_cast<Index>(at));
    }
  }

  void relax(State to, double total, Index by, Index from) {
    if (std::abs(to.inside) > kMostTurns || std::abs(to.outside) > kMostTurns) return;
    const std::size_t at = index_of(to);
    if (total >= length_[at]) return;
    length_[at] = total;
    by_[at] = by;
    from_[at] = from;
    queue_.push({total, at});
  }

  const Cut& cut_;
  std::vector<double> length_;
  std::vector<Index> by_, from_;  // segment and state that the best way came by
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

GarmentGirth girth_of(const Cut& cut, const std::vector<Index>& way) {
  GarmentGirth girth;
  std::set<Index> panels;
  for (const Index s : way) {
    const Segment& segment = cut.segments[s];
    girth.flat += segment.flat;
    girth.worn += segment.worn;
    girth.compliance += segment.compliance * segment.flat;
    girth.way.push_back(segment.middle);
    panels.insert(segment.panel);
  }
  girth.compliance /= girth.flat;
  girth.panels.assign(panels.begin(), panels.end());
  return girth;
}

}  // namespace

std::optional<GarmentGirth> girth_around(const drape::DrapeInput& input, const drape::DrapeResult& result,
                                         const TapePlane& plane) {
  const Cut cut = Cutting(input, result, plane).take();
  Ways ways(cut);
  double least = Ways::kFar;
  std::vector<Index> best;
  for (const Segment& segment : cut.segments) {
    if (segment.turns_inside == 0) continue;  // a way around passes the ray somewhere
    const double total = ways.around(segment.node[0], least);
    if (total >= least) continue;
    least = total;
    best = ways.way(segment.node[0]);
  }
  if (best.empty()) return std::nullopt;
  return girth_of(cut, best);
}

}  // namespace toile::analysis
