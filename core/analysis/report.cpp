#include "core/analysis/report.h"

#include <algorithm>
#include <set>

#include "core/analysis/over_limit.h"
#include "core/analysis/strain.h"
#include "core/base/hash.h"

namespace toile::analysis {

Report make_report(const drape::DrapeInput& input, const drape::DrapeResult& result) {
  Report r;
  r.name = input.name;
  r.stop_reason = result.stop_reason;
  r.cpu_s = result.cpu_s;
  r.wall_s = result.wall_s;
  r.resumed = result.resumed;
  r.steps = result.steps;
  r.simulated_s = result.simulated_time;
  r.particles = result.garment.vertex_count();
  r.sewn_particles =
      static_cast<int>(std::set<Index>(result.garment.weld.begin(), result.garment.weld.end()).size());
  r.triangles = static_cast<int>(result.garment.triangles.size());
  for (const body::Body& body : input.bodies)
    r.body_triangles += static_cast<int>(body.mesh.triangles.size());
  r.intersections = result.at_end;
  r.worst_frame = result.worst;
  r.worst_frame_step = result.worst_frame_step;
  r.frames_checked = result.frames_checked;
  r.seam_gap_max_mm = 1e3 * result.seam_gap_max;
  r.open_seams = result.open_seams;
  r.worn = result.worn;
  for (std::size_t a = 0; a < result.holds.size(); ++a) {
    const drape::HoldFigures& hold = result.holds[a];
    r.attachments.push_back({input.attachments[a].id, hold.released, hold.released_at, 1e3 * hold.off});
  }
  const GarmentStrain strain = garment_strain(input, result);
  r.warp = stretch_figures_of(strain.warp);
  r.weft = stretch_figures_of(strain.weft);
  r.shear = figures_of(strain.shear);
  r.rms_speed = result.rms_speed;
  r.max_speed = result.max_speed;
  if (!result.positions.empty()) {
    const auto [low, high] = std::minmax_element(result.positions.begin(), result.positions.end(),
                                                 [](Vec3 a, Vec3 b) { return a.y < b.y; });
    r.lowest_m = low->y;
    r.highest_m = high->y;
  }
  r.findings = result.findings;
  r.fit = fit_table(input, result);
  for (const preflight::Findings& more : {find_over_limit(input, result), find_too_tight(r.fit)})
    r.findings.insert(r.findings.end(), more.begin(), more.end());
  preflight::sort_by_severity(r.findings);
  r.hash = hash_of(result.positions);
  return r;
}

}  // namespace toile::analysis
