#pragma once
// Runs a task on the core: draped to rest, or three seconds of true motion; then the test of rest.

#include <string>
#include <vector>

#include "tests/bench/peer_task.h"

namespace toile::peers {

struct RunSettings {
  bool dynamic = false;        ///< true motion: gravity from the start, no damping, to kDynamicTime
  double time_step = 0;        ///< s; 0: from the mesh, time_step_for
  double bend_factor = 1;      ///< on the bench fabric's rigidity
  double stretch_factor = 1;   ///< on its membrane's stiffness
  double friction = 0.3;       ///< Coulomb, on body and cloth
  double settle_speed = 5e-3;  ///< m/s RMS at which a drape ends
  double viscosity = 20;       ///< 1/s, of the cloth's inner friction
  bool trace = false;          ///< a line on stderr every 50 ms
};

/// The bench fabric under these settings.
material::Fabric fabric_of(const RunSettings& settings);
/// A substep in which a wave of the cloth's own stiffness goes the same share of an edge on every mesh.
double time_step_for(const geometry::TriangleMesh& cloth);

/// The worst of all frames looked at.
struct WorstFrame {
  int frames = 0;
  int body_crossings = 0, self_crossings = 0;  ///< most in one frame
};

/// One second of true motion from the final positions, at zero velocity, without damping.
struct RestTest {
  double moved_share = 0;               ///< of the vertices, further than 5 mm
  double largest_move = 0;              ///< m
  double rms_speed = 0, max_speed = 0;  ///< m/s, over its last 0.04 s
  std::vector<Vec3> before, end;        ///< 0.04 s before its end, and there
  bool passes() const { return moved_share <= 0.01 && largest_move <= 0.02; }
};

struct PeerEnd {
  std::vector<Vec3> final_positions;  ///< in the run's own order, as all positions here
  std::vector<Vec3> most_contact;     ///< the frame in which bounds held the most vertices
  int most_bounded = 0;               ///< how many, in its last step
  std::string stop_reason;            ///< "settled", "time", "open seam", "not finite"
  double time_step = 0;
  int steps = 0;
  double rest_at = -1;           ///< s, simulated; −1: not at rest
  double cpu_s = 0, wall_s = 0;  ///< from the parsed task to the final positions, without the checks
  double weld_gap = 0;           ///< m, the largest at the weld
  double final_gap = 0;          ///< m, at the end
  long detections = 0, measured = 0, bounded = 0;
  WorstFrame worst;
  RestTest rest;
};

PeerEnd run_task(const PeerTask& task, const RunSettings& settings);

}  // namespace toile::peers
