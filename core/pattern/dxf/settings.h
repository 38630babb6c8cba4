#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "core/pattern/dxf/layers.h"

namespace toile::dxf {

struct DxfSettings {
  /// Millimetres per drawing unit. Unset: decided by what the file says and by the size of its pieces.
  std::optional<double> mm_per_unit;
  /// Which size of a graded file to take. Unset: its sample size.
  std::optional<std::string> size;
  /// What layers stand for where their numbers and names say it wrong. Each must be in the file.
  DxfLayerMap layers = {};
  double chain_tolerance_mm = 0.1;  ///< ends of lines this close are joined
  double arc_tolerance_mm =
      0.02;  ///< arcs become chords that stay this close (and at most 5 mm or 7.5° each)

  // Limits against files that would eat the machine; beyond them reading stops with dxf.too_large.
  std::size_t max_bytes = std::size_t{64} << 20;
  std::size_t max_entities = 1'000'000;
  std::size_t max_vertices = 1'000'000;    ///< in the file, all sizes
  std::size_t max_drawn_points = 200'000;  ///< of the size taken, once arcs are drawn out
  std::size_t max_loops = 2'000;
  double max_coordinate_mm = 1e6;  ///< a kilometre
};

}  // namespace toile::dxf
