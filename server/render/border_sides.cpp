#include "server/render/border_sides.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace toile::render {
namespace {

constexpr double kCorner = 0.80;  // cosine of the turn (37°) at which a border has a corner
constexpr double kOpen = 2e-3;    // m that the sides of a seam are apart that did not close

using Edge = std::pair<Index, Index>;
Edge edge_key(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

/// An edge that one triangle has alone, in that triangle's direction.
struct BorderEdge {
  Index from = 0, to = 0, panel = 0;
  bool sewn = false, open = false, taken = false;
};

std::vector<BorderEdge> lone_edges(const ClothView& cloth) {
  std::vector<std::pair<Edge, BorderEdge>> all;
  all.reserve(3 * cloth.triangles.size());
  for (std::size_t t = 0; t < cloth.triangles.size(); ++t) {
    const Tri& tri = cloth.triangles[t];
    for (int i = 0; i < 3; ++i) {
      const Index a = tri[i], b = tri[(i + 1) % 3];
      all.push_back({edge_key(a, b), {a, b, panel_of(cloth, t)}});
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<BorderEdge> lone;
  for (std::size_t i = 0, end = 0; i < all.size(); i = end) {
    end = i + 1;
    while (end < all.size() && all[end].first == all[i].first) ++end;
    if (end == i + 1) lone.push_back(all[i].second);
  }
  return lone;
}

/// An edge is sewn where another lies on it once both are welded.
void mark_sewn(const ClothView& cloth, std::vector<BorderEdge>& edges) {
  if (cloth.weld.empty()) return;
  const auto joint = [&](const BorderEdge& e) { return edge_key(cloth.weld[e.from], cloth.weld[e.to]); };
  std::vector<Edge> joints;
  joints.reserve(edges.size());
  for (const BorderEdge& e : edges) joints.push_back(joint(e));
  std::sort(joints.begin(), joints.end());
  const auto apart = [&](Index v) {
    return length(cloth.positions[v] - cloth.positions[cloth.weld[v]]) > kOpen;
  };
  std::vector<char> open(cloth.positions.size(), 0);
  for (const BorderEdge& e : edges)
    if (apart(e.from)) open[e.from] = open[cloth.weld[e.from]] = 1;
  for (BorderEdge& e : edges) {
    const auto [first, last] = std::equal_range(joints.begin(), joints.end(), joint(e));
    e.sewn = last - first > 1;
    e.open = e.sewn && open[e.from] && open[e.to];
  }
}

/// Edges in loops, each loop's edges in order.
std::vector<std::vector<BorderEdge>> loops_of(std::vector<BorderEdge> edges) {
  std::multimap<std::pair<Index, Index>, std::size_t> from;  // by panel and vertex
  for (std::size_t e = 0; e < edges.size(); ++e) from.emplace(std::pair{edges[e].panel, edges[e].from}, e);
  const auto next = [&](const BorderEdge& edge) {
    const auto [first, last] = from.equal_range({edge.panel, edge.to});
    const auto free = std::find_if(first, last, [&](const auto& at) { return !edges[at.second].taken; });
    return free == last ? edges.size() : free->second;
  };
  std::vector<std::vector<BorderEdge>> loops;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges[e].taken) continue;
    loops.emplace_back();
    for (std::size_t at = e; at != edges.size(); at = next(edges[at])) {
      edges[at].taken = true;
      loops.back().push_back(edges[at]);
    }
  }
  return loops;
}

class SideCutter {
 public:
  explicit SideCutter(const ClothView& cloth) : cloth_(cloth) {}

  void cut(std::vector<BorderEdge> loop) {
    const auto corner = [&](std::size_t i) {
      return is_corner(loop[(i + loop.size() - 1) % loop.size()], loop[i]);
    };
    std::size_t first = 0;
    while (first < loop.size() && !corner(first)) ++first;
    if (first == loop.size()) first = 0;
    std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(first), loop.end());
    const std::size_t before = sides_.size();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (i == 0 || is_corner(loop[i - 1], loop[i])) begin(loop[i], before);
      add(loop[i]);
    }
    if (sides_.size() > before + 1) part_ends(before);
  }

  std::vector<BorderSide> take() { return std::move(sides_); }

 private:
  bool is_corner(const BorderEdge& in, const BorderEdge& out) const {
    if (in.to != out.from || in.sewn != out.sewn) return true;
    const Vec3 a = flat_place(cloth_, in.to) - flat_place(cloth_, in.from);
    const Vec3 b = flat_place(cloth_, out.to) - flat_place(cloth_, out.from);
    return dot(a, b) < kCorner * length(a) * length(b);
  }

  void begin(const BorderEdge& edge, std::size_t loop_begin) {
    const bool first = sides_.size() == loop_begin;
    const int slot = first ? 0 : (sides_.back().slot + 1) % kBorderSlots;
    sides_.push_back({edge.panel, edge.sewn, slot, {edge.from}, {0}, {}});
  }

  void add(const BorderEdge& edge) {
    BorderSide& side = sides_.back();
    side.along.push_back(side.along.back() +
                         length(flat_place(cloth_, edge.to) - flat_place(cloth_, edge.from)));
    side.vertices.push_back(edge.to);
    side.open.push_back(edge.open ? 1 : 0);
  }

  /// The last side of a loop meets the first.
  void part_ends(std::size_t loop_begin) {
    BorderSide& last = sides_.back();
    if (last.slot == sides_[loop_begin].slot) last.slot = (last.slot + 2) % kBorderSlots;
  }

  const ClothView& cloth_;
  std::vector<BorderSide> sides_;
};

}  // namespace

Index panel_of(const ClothView& cloth, std::size_t triangle) {
  return cloth.panel_of_triangle.empty() ? 0 : cloth.panel_of_triangle[triangle];
}

Vec3 flat_place(const ClothView& cloth, Index vertex) {
  if (cloth.rest.empty()) return cloth.positions[vertex];
  return {cloth.rest[vertex].x, cloth.rest[vertex].y, 0};
}

std::vector<BorderSide> border_sides(const ClothView& cloth) {
  std::vector<BorderEdge> edges = lone_edges(cloth);
  mark_sewn(cloth, edges);
  SideCutter cutter(cloth);
  for (std::vector<BorderEdge>& loop : loops_of(std::move(edges))) cutter.cut(std::move(loop));
  return cutter.take();
}

}  // namespace toile::render
