#include "server/render/panel_make.h"

#include <algorithm>

#include "server/render/border_sides.h"

namespace toile::render {
namespace {

constexpr double kHemDepth = 0.018;        // m
constexpr double kHemShare = 0.15;         // of a piece's breadth, at most
constexpr double kLeastThickness = 1e-4;   // m
constexpr double kStitchedDown = 0.65e-3;  // m of thickness: coats, denim
constexpr double kBeside = 0.005;          // m

/// Twice area over perimeter: the width of a strip, half the side of a square.
std::vector<double> breadths(const ClothView& cloth, std::size_t panels) {
  std::vector<double> areas(panels, 0), borders(panels, 0), breadths;
  for (std::size_t t = 0; t < cloth.triangles.size(); ++t) {
    const auto [a, b, c] = cloth.triangles[t];
    const Vec3 origin = flat_place(cloth, a);
    areas[static_cast<std::size_t>(std::max(panel_of(cloth, t), 0))] +=
        0.5 * length(cross(flat_place(cloth, b) - origin, flat_place(cloth, c) - origin));
  }
  for (const BorderSide& side : border_sides(cloth))
    borders[static_cast<std::size_t>(std::max(side.panel, 0))] += side.along.back();
  for (std::size_t p = 0; p < panels; ++p) breadths.push_back(borders[p] > 0 ? 2 * areas[p] / borders[p] : 0);
  return breadths;
}

}  // namespace

std::vector<PanelMake> panel_makes(const ClothView& cloth) {
  Index last = 0;
  for (const Index panel : cloth.panel_of_triangle) last = std::max(last, panel);
  std::vector<PanelMake> makes;
  for (const double breadth : breadths(cloth, static_cast<std::size_t>(last) + 1)) {
    const std::size_t p = makes.size();
    const double thickness = static_cast<double>(look_of(cloth, static_cast<Index>(p)).thickness);
    makes.push_back({std::max(thickness, kLeastThickness), std::min(kHemDepth, kHemShare * breadth),
                     thickness >= kStitchedDown ? kBeside : 0});
  }
  return makes;
}

}  // namespace toile::render
