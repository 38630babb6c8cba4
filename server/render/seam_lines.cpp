#include "server/render/seam_lines.h"

#include <algorithm>

namespace toile::render {
namespace {

constexpr double kReach = 0.05;  // m; lines are drawn within 3 cm of a border
constexpr double kEdges = 2.5;   // longest edges of a border: on coarse cloth a triangle reaches farther
/// A triangle blends the kinds at its corners: between a seam and a hem nothing must look open.
constexpr float kOpenSeam = -1, kSeam = 0, kHem = 2;

/// Share of the way from a to b at which the line comes nearest to p.
double nearest_share(Vec3 p, Vec3 a, Vec3 b) {
  const Vec3 edge = b - a;
  const double square = dot(edge, edge);
  return square > 0 ? std::clamp(dot(p - a, edge) / square, 0.0, 1.0) : 0;
}

}  // namespace

LineMeasure::LineMeasure(const ClothView& cloth) : cloth_(cloth) {
  double longest = 0;
  for (BorderSide& border : border_sides(cloth)) {
    Side side{std::move(border), {}, {}};
    for (const Index v : side.border.vertices) {
      side.places.push_back(flat_place(cloth, v));
      side.box.add(side.places.back());
    }
    for (std::size_t i = 1; i < side.places.size(); ++i)
      longest = std::max(longest, length(side.places[i] - side.places[i - 1]));
    const auto panel = static_cast<std::size_t>(std::max(side.border.panel, 0));
    if (sides_.size() <= panel) sides_.resize(panel + 1);
    sides_[panel].push_back(std::move(side));
  }
  reach_ = std::max(kReach, kEdges * longest);
  for (std::vector<Side>& sides : sides_)
    for (Side& side : sides) side.box = side.box.grown(reach_);
}

VertexLines LineMeasure::at(Index vertex, Index panel) const {
  VertexLines lines;
  lines.distance.fill(kFarFromLine);
  lines.along.fill(0);
  lines.kind.fill(kSeam);
  const auto own = static_cast<std::size_t>(std::max(panel, 0));
  if (own >= sides_.size()) return lines;
  const Vec3 place = flat_place(cloth_, vertex);
  for (const Side& side : sides_[own]) measure(side, place, lines);
  return lines;
}

void LineMeasure::measure(const Side& side, Vec3 place, VertexLines& lines) const {
  if (!side.box.contains(place)) return;
  const auto slot = static_cast<std::size_t>(side.border.slot);
  for (std::size_t i = 0; i + 1 < side.places.size(); ++i) {
    const Vec3 a = side.places[i], b = side.places[i + 1];
    const double share = nearest_share(place, a, b);
    const auto away = static_cast<float>(length(place - (a + (b - a) * share)));
    if (away >= lines.distance[slot]) continue;
    const double from = side.border.along[i];
    lines.distance[slot] = away;
    lines.along[slot] = static_cast<float>(from + share * (side.border.along[i + 1] - from));
    lines.kind[slot] = !side.border.sewn ? kHem : side.border.open[i] ? kOpenSeam : kSeam;
  }
}

}  // namespace toile::render
