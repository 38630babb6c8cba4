#include "core/analysis/cloth_map.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/analysis/cloth_pressure.h"
#include "core/analysis/skin_distance.h"
#include "core/analysis/strain.h"
#include "core/analysis/surface_curvature.h"
#include "core/base/rounded.h"
#include "core/base/units.h"

namespace toile::analysis {
namespace {

/// So much of the cloth lies within the scale.
constexpr double kWithin = 0.98;
/// Of values: sines differ between processors in their last bit, and the same input must give the same bytes.
constexpr int kDecimals = 3;

std::vector<double> means_at_vertices(const sewing::GarmentMesh& g, std::span<const double> of_triangle) {
  std::vector<double> sums(g.rest.size(), 0);
  std::vector<int> counts(g.rest.size(), 0);
  for (std::size_t t = 0; t < g.triangles.size(); ++t) {
    for (const Index v : g.triangles[t]) {
      sums[v] += of_triangle[t];
      ++counts[v];
    }
  }
  for (std::size_t v = 0; v < sums.size(); ++v) sums[v] /= std::max(1, counts[v]);
  return sums;
}

ClothMap scaled(MapKind kind, const std::vector<double>& values, double in_unit) {
  ClothMap map{kind, {}};
  map.values.reserve(values.size());
  for (const double value : values)
    map.values.push_back(static_cast<float>(rounded(value * in_unit, kDecimals)));
  return map;
}

/// The angle that is missing between the threads, degrees.
std::vector<double> shear_angles(const std::vector<double>& cosines) {
  std::vector<double> out;
  out.reserve(cosines.size());
  for (const double c : cosines)
    out.push_back(degrees_from_radians(std::abs(std::asin(std::clamp(c, -1.0, 1.0)))));
  return out;
}

std::vector<double> mean_curvatures(const std::vector<SymmetricTensor>& curvature) {
  std::vector<double> out;
  out.reserve(curvature.size());
  for (const SymmetricTensor& k : curvature) out.push_back(0.5 * k.trace());
  return out;
}

/// Pa at each vertex.
std::vector<double> pressures(const drape::DrapeInput& input, const drape::DrapeResult& result,
                              const GarmentStrain& strain, const std::vector<SymmetricTensor>& curvature,
                              const std::vector<double>& ease) {
  const sewing::GarmentMesh& g = result.garment;
  const std::vector<Threads> threads = garment_threads(input, result);
  std::vector<SymmetricTensor> tensions;
  tensions.reserve(threads.size());
  for (std::size_t t = 0; t < threads.size(); ++t) {
    const Index fabric = input.fabric_of_panel[static_cast<std::size_t>(g.panel_of_triangle[t])];
    const ThreadStrain strained{strain.warp[t], strain.weft[t],
                                std::asin(std::clamp(strain.shear[t], -1.0, 1.0))};
    tensions.push_back(cloth_tension(input.fabrics[static_cast<std::size_t>(fabric)], strained,
                                     normalized(threads[t].warp), normalized(threads[t].weft)));
  }
  const std::vector<SymmetricTensor> tension = spread(g, tensions, triangle_areas(g, result.positions));
  std::vector<double> out(g.rest.size(), 0);
  for (std::size_t v = 0; v < out.size(); ++v)
    if (ease[v] < kPressing) out[v] = laplace_pressure(tension[v], curvature[v]);
  return out;
}

}  // namespace

const std::array<MapTrait, kMapKinds>& map_traits() {
  using enum MapKind;
  static constexpr std::array<MapTrait, kMapKinds> kTraits{{
      {kWarp, "warp", "Stretch along the warp", "%", "_STRAIN_WARP", {1, 2, 4, 8, 20, 40}, true, false},
      {kWeft, "weft", "Stretch along the weft", "%", "_STRAIN_WEFT", {1, 2, 4, 8, 20, 40}, true, false},
      {kShear, "shear", "Shear of the threads", "°", "_SHEAR", {2, 4, 8, 16, 40}, false, false},
      {kEase, "ease", "Ease to the skin", "mm", "_EASE", {8, 16, 40, 80, 160}, false, true},
      {kCurvature, "curvature", "Mean curvature", "1/m", "_CURVATURE", {4, 8, 20, 40, 80, 200}, true, false},
      {kPressure,
       "pressure",
       "Pressure on the skin",
       "kPa",
       "_PRESSURE",
       {0.2, 0.4, 0.8, 2, 4, 8, 20},
       false,
       false},
  }};
  return kTraits;
}

const MapTrait& trait_of(MapKind kind) { return map_traits()[static_cast<std::size_t>(kind)]; }

Result<MapKind> map_kind_from(std::string_view word) {
  std::string known;
  for (const MapTrait& trait : map_traits()) {
    if (trait.word == word) return trait.kind;
    known += (known.empty() ? "" : ", ") + std::string(trait.word);
  }
  return Error{"map.unknown", "there is no such map; there are " + known, std::string(word)};
}

std::vector<ClothMap> cloth_maps(const drape::DrapeInput& input, const drape::DrapeResult& result) {
  const sewing::GarmentMesh& g = result.garment;
  const GarmentStrain strain = garment_strain(input, result);
  const std::vector<SymmetricTensor> curvature = surface_curvature(g, result.positions);
  std::vector<ClothMap> maps;
  maps.push_back(scaled(MapKind::kWarp, means_at_vertices(g, strain.warp), 100));
  maps.push_back(scaled(MapKind::kWeft, means_at_vertices(g, strain.weft), 100));
  maps.push_back(scaled(MapKind::kShear, means_at_vertices(g, shear_angles(strain.shear)), 1));
  if (!result.bodies.empty()) {
    const std::vector<double> ease = skin_distances(result.bodies, result.positions, kMostEase);
    maps.push_back(scaled(MapKind::kEase, ease, mm_from_metres(1)));
    maps.push_back(scaled(MapKind::kCurvature, mean_curvatures(curvature), 1));
    maps.push_back(scaled(MapKind::kPressure, pressures(input, result, strain, curvature, ease), 1e-3));
  } else {
    maps.push_back(scaled(MapKind::kCurvature, mean_curvatures(curvature), 1));
  }
  return maps;
}

const std::array<std::array<std::uint8_t, 3>, kBands>& band_colours() {
  static constexpr std::array<std::array<std::uint8_t, 3>, kBands> kColours{{{0x2b, 0x4e, 0xa2},
                                                                             {0x4c, 0x86, 0xc8},
                                                                             {0x8e, 0xc1, 0xe2},
                                                                             {0xcf, 0xe5, 0xef},
                                                                             {0xf8, 0xe4, 0xbd},
                                                                             {0xf6, 0xb4, 0x75},
                                                                             {0xe2, 0x6d, 0x49},
                                                                             {0xb6, 0x26, 0x2c}}};
  return kColours;
}

double MapScale::place(double value) const {
  const double within = std::clamp(kBands * (value - low) / (high - low) - 0.5, 0.0, kBands - 1.0);
  return trait_of(kind).small_is_red ? kBands - 1 - within : within;
}

std::array<double, kBands + 1> MapScale::bounds() const {
  std::array<double, kBands + 1> out{};
  for (std::size_t i = 0; i <= kBands; ++i) out[i] = low + (high - low) * static_cast<double>(i) / kBands;
  if (trait_of(kind).small_is_red) std::reverse(out.begin(), out.end());
  return out;
}

MapScale scale_of(const ClothMap& map) {
  std::vector<float> sizes;
  for (const float value : map.values) sizes.push_back(std::abs(value));
  std::sort(sizes.begin(), sizes.end());
  const auto at = static_cast<std::size_t>(kWithin * static_cast<double>(sizes.size()));
  const double most = sizes.empty() ? 0 : sizes[std::min(at, sizes.size() - 1)];
  const MapTrait& trait = trait_of(map.kind);
  double end = 0;
  for (const double wider : trait.ends)
    if (wider > 0 && (end == 0 || end < most)) end = wider;
  return {map.kind, trait.is_signed ? -end : 0, end};
}

}  // namespace toile::analysis
