#pragma once

#include <string>

#include "core/analysis/fit.h"
#include "core/analysis/strain.h"
#include "core/drape/drape_input.h"
#include "core/drape/drape_result.h"
#include "core/drape/stop_reason.h"

namespace toile::analysis {

/// What an attachment did.
struct AttachmentFigures {
  std::string id;
  bool released = false;
  double released_s = 0;  ///< s of simulated time; 0 while it holds
  double off_mm = 0;      ///< mm from where it should be, at most: when released, or else at the end
};

/// The numbers of a drape, as report.json gives them.
struct Report {
  std::string name;
  drape::StopReason stop_reason;
  double cpu_s = 0, wall_s = 0;
  int resumed = 0;  ///< how often the drape went on from a checkpoint
  int steps = 0;
  double simulated_s = 0;
  int particles = 0;       ///< of the flat pieces
  int sewn_particles = 0;  ///< of the garment: what is sewn together counts once
  int triangles = 0;
  int body_triangles = 0;
  drape::CrossingCount intersections;  ///< at the end
  drape::CrossingCount worst_frame;
  int worst_frame_step = 0;
  int frames_checked = 0;
  double seam_gap_max_mm = 0;
  std::vector<drape::OpenSeam> open_seams;
  drape::Worn worn = drape::Worn::kNobody;
  std::vector<AttachmentFigures> attachments;
  StretchFigures warp, weft;
  StrainFigures shear;
  std::vector<FitLine> fit;             ///< of whoever wears it
  double rms_speed = 0, max_speed = 0;  ///< m/s
  double lowest_m = 0, highest_m = 0;   ///< of the cloth
  preflight::Findings findings;         ///< of the start and the end, worst first
  std::string hash;                     ///< of the final positions

  bool settled() const { return stop_reason.kind == drape::Stop::kSettled; }
};

Report make_report(const drape::DrapeInput& input, const drape::DrapeResult& result);

}  // namespace toile::analysis
