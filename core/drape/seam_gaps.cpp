#include "core/drape/seam_gaps.h"

#include <algorithm>

namespace toile::drape {

std::vector<double> pair_gaps(const sewing::GarmentMesh& garment, std::span<const Vec3> x) {
  std::vector<double> gaps;
  gaps.reserve(garment.sewn.size());
  for (const auto& [i, j] : garment.sewn) gaps.push_back(length(x[i] - x[j]));
  return gaps;
}

double largest_gap(const std::vector<double>& gaps) {
  double widest = 0;
  for (const double gap : gaps) widest = std::max(widest, gap);
  return widest;
}

std::vector<OpenSeam> seams_open(const DrapeInput& input, const sewing::GarmentMesh& garment,
                                 const std::vector<double>& gaps) {
  std::vector<double> of_seam(input.pattern.seams.size(), 0);
  for (std::size_t k = 0; k < gaps.size(); ++k) {
    double& gap = of_seam[garment.seam_of_sewn[k]];
    gap = std::max(gap, gaps[k]);
  }
  std::vector<OpenSeam> open;
  for (std::size_t s = 0; s < of_seam.size(); ++s)
    if (of_seam[s] > kSeamTolerance) open.push_back({input.pattern.seams[s].id, of_seam[s]});
  return open;
}

std::string widest_seam(const DrapeInput& input, const sewing::GarmentMesh& garment,
                        const std::vector<double>& gaps) {
  if (gaps.empty()) return "";
  const auto widest = std::max_element(gaps.begin(), gaps.end()) - gaps.begin();
  return input.pattern.seams[garment.seam_of_sewn[static_cast<std::size_t>(widest)]].id;
}

}  // namespace toile::drape
