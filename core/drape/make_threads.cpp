#include "core/drape/make_threads.h"

namespace toile::drape {

namespace {

constexpr double kPullPerMetre = 150;  // N/m, pull of all threads along a seam's length

}  // namespace

std::vector<solver::constraints::Stitch> make_stitches(const sewing::Assembly& assembly,
                                                       std::span<const Index> vertex_of,
                                                       const std::vector<bool>& lost,
                                                       double particle_distance) {
  const sewing::GarmentMesh& g = assembly.garment;
  const std::vector<double> held = sewing::seam_held_by_pairs(g);
  std::vector<solver::constraints::Stitch> stitches;
  for (std::size_t k = 0; k < g.sewn.size(); ++k) {
    const auto [i, j] = g.sewn[k];
    if (vertex_of[i] == vertex_of[j] || lost[g.seam_of_sewn[k]]) continue;
    const double seam = held[k] > 0 ? held[k] : particle_distance;
    stitches.push_back({vertex_of[i], vertex_of[j], length(assembly.positions[i] - assembly.positions[j]),
                        kPullPerMetre * seam});
  }
  return stitches;
}

std::vector<solver::constraints::HeldVertex> make_holds(const DrapeInput& input,
                                                        const sewing::Assembly& assembly,
                                                        std::span<const Index> vertex_of, Index vertex_count,
                                                        const std::vector<bool>& released) {
  struct Sum {
    Vec3 target;
    int count = 0;
    bool height_only = true;
  };
  std::vector<Sum> sums(static_cast<std::size_t>(vertex_count));
  for (std::size_t a = 0; a < input.attachments.size(); ++a) {
    if (released[a]) continue;
    for (const Index i : assembly.attached[a]) {
      Sum& sum = sums[vertex_of[i]];
      sum.target += assembly.positions[i];
      ++sum.count;
      sum.height_only &= input.attachments[a].hold == sewing::Attachment::Hold::kHeight;
    }
  }
  std::vector<solver::constraints::HeldVertex> held;
  for (std::size_t v = 0; v < sums.size(); ++v) {
    if (sums[v].count == 0) continue;
    held.push_back({static_cast<Index>(v), sums[v].height_only, sums[v].target * (1.0 / sums[v].count)});
  }
  return held;
}

}  // namespace toile::drape
