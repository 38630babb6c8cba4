#pragma once
// What the cloth is measured for at each of its vertices, and the scale on which that is shown: the table
// that stills, models and files go by.

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/drape/drape_input.h"
#include "core/drape/drape_result.h"

namespace toile::analysis {

/// The numbers are written to films: they stay.
enum class MapKind : std::uint8_t { kWarp = 0, kWeft, kShear, kEase, kCurvature, kPressure };
inline constexpr std::size_t kMapKinds = 6;

struct MapTrait {
  MapKind kind;
  std::string_view word;       ///< "warp", as programs say it
  std::string_view title;      ///< "Stretch along the warp"
  std::string_view unit;       ///< of its values: "%"
  std::string_view attribute;  ///< of models: "_STRAIN_WARP"
  std::array<double, 7> ends;  ///< of scales, in the unit, rising; 0 past the last
  bool is_signed;              ///< scales run from −end, not from 0
  bool small_is_red;           ///< where cloth is near the body it is tight
};

const std::array<MapTrait, kMapKinds>& map_traits();
const MapTrait& trait_of(MapKind kind);
/// By its word. Error: "map.unknown".
Result<MapKind> map_kind_from(std::string_view word);

struct ClothMap {
  MapKind kind = MapKind::kWarp;
  std::vector<float> values;  ///< one a vertex, in the map's unit
  friend bool operator==(const ClothMap&, const ClothMap&) = default;
};

/// Distances beyond this count as this; m.
inline constexpr double kMostEase = 0.15;
/// Cloth farther from the skin presses on nothing; m.
inline constexpr double kPressing = 0.004;

/// All maps of a garment as it hangs, in the order of the table. Strains are means over a vertex's triangles;
/// ease is the distance to the nearest body, and curvature the mean of both principal ones, positive where
/// the surface bends away from its right side; pressure is Laplace's (core/analysis/cloth_pressure), 0 off
/// the skin. Without bodies there is neither ease nor pressure. Where strain is beyond its fabric's limit,
/// pressure is at least what is told.
std::vector<ClothMap> cloth_maps(const drape::DrapeInput& input, const drape::DrapeResult& result);

/// The colours of a scale from its low end on, 8-bit sRGB, from blue to red.
inline constexpr std::size_t kBands = 8;
const std::array<std::array<std::uint8_t, 3>, kBands>& band_colours();

/// The map's scale: its end is the smallest that holds nearly all of the cloth.
struct MapScale {
  MapKind kind = MapKind::kWarp;
  double low = 0, high = 1;

  /// Where among the colours a value lies: 0 in the middle of the first, kBands − 1 in that of the last, and
  /// no farther.
  double place(double value) const;
  /// Where the bands begin and the last ends, in the order of the colours.
  std::array<double, kBands + 1> bounds() const;
};
MapScale scale_of(const ClothMap& map);

}  // namespace toile::analysis
