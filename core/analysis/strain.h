#pragma once
// How far the cloth is stretched, per triangle, along its own threads.

#include <vector>

#include "core/drape/drape_input.h"
#include "core/drape/drape_result.h"

namespace toile::analysis {

/// Mean, 99th percentile and maximum of a strain's magnitude over the triangles.
struct StrainFigures {
  double mean = 0, p99 = 0, max = 0;
};

/// Of a strain along threads: of its magnitude, and of stretch and squeeze apart, as a fabric's limits speak
/// of stretch alone. Each over all triangles: one that is squeezed counts as not stretched.
struct StretchFigures : StrainFigures {
  StrainFigures tension, compression;
};

/// The images of a triangle's threads: of length 1 where they are not stretched.
struct Threads {
  Vec3 weft, warp;
};

/// One entry a triangle.
std::vector<Threads> garment_threads(const drape::DrapeInput& input, const drape::DrapeResult& result);

/// One entry a triangle. Warp and weft: length change over length; shear: cosine of the angle between the
/// threads.
struct GarmentStrain {
  std::vector<double> warp, weft, shear;
};

GarmentStrain garment_strain(const drape::DrapeInput& input, const drape::DrapeResult& result);

/// Figures of the magnitudes; zeros for no values.
StrainFigures figures_of(std::vector<double> values);
/// `values`: length change over length, positive when stretched.
StretchFigures stretch_figures_of(const std::vector<double>& values);

}  // namespace toile::analysis
