#pragma once
// Buttons: a point of the cloth tied to another by a thread that may not grow longer than it is.

#include <span>

#include "core/base/types.h"
#include "core/sewing/notion_places.h"

namespace toile::solver::constraints {

/// A tie that is longer than it should be by less than this is closed, and holds.
inline constexpr double kTieClosed = 2e-3;  // m
inline constexpr double kTieSpeed = 1;      // m/s

struct PointTie {
  sewing::ClothPoint a, b;    ///< in vertices of the solver
  double start_length = 0;    ///< m, before it is drawn together
  double end_length = 0;      ///< m
  double closing_force = 1;   ///< N, the most while it is drawn together
  double holding_force = 50;  ///< N, the most once it is closed; contact is stronger than any thread
};

/// One pass: every tie is at most as long as it may be when `open` of the way (1 at the start, 0 when closed)
/// is left. A tie pulls and never pushes; what it draws comes at kTieSpeed at most.
void solve_ties(std::span<const PointTie> ties, double open, std::span<const double> w, double h,
                std::span<Vec3> x);

/// Index of the tie that is most longer than its end length, and by how much (m); kNone and 0 when none is.
struct OpenTie {
  Index tie = kNone;
  double excess = 0;
};
OpenTie widest_tie(std::span<const PointTie> ties, std::span<const Vec3> x);

}  // namespace toile::solver::constraints
