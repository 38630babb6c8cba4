#pragma once
// How far the garment's seams are open, by whatever method it is draped.

#include <span>
#include <string>
#include <vector>

#include "core/drape/drape_input.h"
#include "core/drape/drape_result.h"
#include "core/sewing/garment_mesh.h"

namespace toile::drape {

/// A seam is open when its sides are further apart than this.
inline constexpr double kSeamTolerance = 0.5e-3;  // m

/// m, of each sewn pair; `x`: m, of the garment's vertices.
std::vector<double> pair_gaps(const sewing::GarmentMesh& garment, std::span<const Vec3> x);
/// m, the largest; 0 without any.
double largest_gap(const std::vector<double>& gaps);
/// Those that are open, in the order of the pattern, by the gaps of all pairs.
std::vector<OpenSeam> seams_open(const DrapeInput& input, const sewing::GarmentMesh& garment,
                                 const std::vector<double>& gaps);
/// The id of the seam with the largest gap; empty where nothing is sewn.
std::string widest_seam(const DrapeInput& input, const sewing::GarmentMesh& garment,
                        const std::vector<double>& gaps);

}  // namespace toile::drape
