#include "core/mesh/morton.h"

#include <algorithm>
#include <utility>

namespace toile::mesh {
namespace {

/// Bit i of x to bit 2i.
std::uint64_t spread(std::uint64_t x) {
  x &= 0xffffffffu;
  x = (x | x << 16) & 0x0000ffff0000ffffu;
  x = (x | x << 8) & 0x00ff00ff00ff00ffu;
  x = (x | x << 4) & 0x0f0f0f0f0f0f0f0fu;
  x = (x | x << 2) & 0x3333333333333333u;
  return (x | x << 1) & 0x5555555555555555u;
}

}  // namespace

std::uint64_t morton_code(const GridPoint& p) {
  return spread(static_cast<std::uint64_t>(p.x)) | spread(static_cast<std::uint64_t>(p.y)) << 1;
}

std::vector<Index> morton_order(std::span<const GridPoint> points, Index count) {
  std::vector<std::pair<std::uint64_t, Index>> keys(count);
  for (Index i = 0; i < count; ++i) keys[i] = {morton_code(points[i]), i};
  std::sort(keys.begin(), keys.end());
  std::vector<Index> order(count);
  for (Index i = 0; i < count; ++i) order[i] = keys[i].second;
  return order;
}

}  // namespace toile::mesh
