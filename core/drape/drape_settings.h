#pragma once

#include "core/paper/settings.h"
#include "core/solver/constraints/air.h"

namespace toile::drape {

enum class DrapeMode {
  kDrape,    ///< only the end matters: added damping brings the cloth to rest
  kDynamic,  ///< true time once it is sewn: full gravity at once, and nothing slows the cloth but air and
             ///< rubbing
};

enum class DrapeMethod {
  kToile,  ///< our own engine (core/solver): nothing goes through anything
  kPaper,  ///< that of Kim and Park 2003 (core/paper), to compare with
};

/// How to drape. Every field has a default that suits a garment.
struct DrapeSettings {
  double particle_distance = 0.015;  ///< m, wanted edge length of the triangles
  double time_step = 1.0 / 3000;     ///< s, one substep of the solver
  double gravity = 9.81;             ///< m/s², downwards
  double sew_time = 1.0;             ///< s, in which the seams close, without gravity
  double settle_speed = 0.005;       ///< m/s, RMS speed under which the cloth counts as at rest
  double max_time = 15.0;            ///< s of simulated time after which an unsettled drape ends
  int frame_interval = 50;           ///< substeps between frames that viewers see, at most
  DrapeMode mode = DrapeMode::kDrape;
  /// Begins with the garment on the body, where that can be certified (core/dressing); otherwise pieces are
  /// sewn from where they stand.
  bool dress = true;
  bool ground = true;                     ///< a person stands on ground that cloth does not go through
  bool until_settled = true;              ///< ends when the cloth is at rest; otherwise at max_time
  solver::constraints::AirDrag air = {};  ///< while draping, not while sewing
  DrapeMethod method = DrapeMethod::kToile;
  paper::PaperSettings paper = {};  ///< of kPaper, with a time step of its own
};

}  // namespace toile::drape
