#include "core/pattern/dxf/found.h"

#include <algorithm>

#include "core/geometry/polygon2.h"

namespace toile::dxf {
namespace {

/// The smallest piece whose box holds the line's.
std::size_t smallest_around(const std::vector<DxfPlaced>& placed, const Aabb2& box, bool or_within) {
  std::size_t best = placed.size();
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const Aabb2& around = placed[i].border().box;
    const bool inside = around.grown(kBoxSlack).contains(box);
    if (!inside && !(or_within && same_place(around, box))) continue;
    if (best == placed.size() || placed[i].loop->area < placed[best].loop->area) best = i;
  }
  return best;
}

/// Share of the line's length that lies in the loop, by places at even distances.
double share_within(const std::vector<Vec2>& line, const DxfLoop& loop) {
  constexpr int kPlaces = 40;
  if (!none_above(bounding_box(line).low, loop.box.high) ||
      !none_above(loop.box.low, bounding_box(line).high))
    return 0;
  const double step = geometry::polyline_length(line) / kPlaces;
  double next = step / 2, walked = 0;
  int inside = 0, asked = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double l = length(line[i + 1] - line[i]);
    for (; l > 0 && next <= walked + l && asked < kPlaces; next += step, ++asked)
      inside +=
          geometry::contains(loop.chain->points, line[i] + (line[i + 1] - line[i]) * ((next - walked) / l))
              ? 1
              : 0;
    walked += l;
  }
  return double(inside) / kPlaces;
}

/// The piece whose box is nearest to the line's middle.
std::size_t nearest_to(const std::vector<DxfPlaced>& placed, Vec2 middle) {
  const auto off = [&](const DxfPlaced& p) { return geometry::distance(p.border().box, middle); };
  return std::size_t(
      std::min_element(placed.begin(), placed.end(),
                       [&](const DxfPlaced& a, const DxfPlaced& b) { return off(a) < off(b); }) -
      placed.begin());
}

}  // namespace

std::size_t owner_of(const DxfPieces& pieces, const std::vector<Vec2>& line, DxfReach reach) {
  constexpr double kMost = 0.5;
  const std::vector<DxfPlaced>& placed = pieces.placed;
  const Aabb2 box = bounding_box(line);
  const std::size_t around = smallest_around(placed, box, reach == DxfReach::kAround);
  if (around < placed.size() || reach == DxfReach::kAround) return around;
  std::size_t best = placed.size();
  double most = reach == DxfReach::kCrossing ? 0 : kMost;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const double share = share_within(line, placed[i].border());
    if (share <= most) continue;
    most = share;
    best = i;
  }
  if (best < placed.size() || reach != DxfReach::kCrossing || !pieces.is_block) return best;
  return nearest_to(placed, box.middle());
}

void tell(DxfNotes& notes, const DxfChain& chain, DxfFate fate, const std::string& reason, int piece) {
  for (const std::size_t entity : chain.entities) notes.mark(entity, fate, reason, piece);
}

}  // namespace toile::dxf
