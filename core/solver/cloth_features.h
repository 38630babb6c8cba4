#pragma once
// What a garment may have besides cloth, seams and contact: air around it, buttons, elastic, creases, air
// inside, hands. All of it is derived from the input, or told (hands), and keeps no state of its own.

#include <span>
#include <vector>

#include "core/solver/constraints/air.h"
#include "core/solver/constraints/button.h"
#include "core/solver/constraints/elastic.h"
#include "core/solver/constraints/fold.h"
#include "core/solver/constraints/leash.h"
#include "core/solver/constraints/pressure.h"
#include "core/solver/constraints/shoulder_hold.h"
#include "core/solver/constraints/tether.h"

namespace toile::solver {

/// Vertices are the solver's.
struct ClothFeatures {
  constraints::AirDrag air;
  std::vector<constraints::PointTie> ties;
  std::vector<constraints::ElasticSegment> elastics;
  std::vector<constraints::FoldHinge> folds;
  std::vector<constraints::PressureChamber> chambers;
  std::vector<constraints::Tether> tethers;
  std::vector<constraints::ShoulderHold> shoulders;
  std::vector<constraints::Leash> leashes;
};

/// How far features have come in a step.
struct FeatureProgress {
  double open = 0;    ///< buttons, tethers: 1 as far as at the start, 0 closed
  double formed = 1;  ///< elastic, creases, pressure: 0 not yet there, 1 whole
  bool air = false;   ///< whether the air resists
};

/// What acts on velocities, before a step.
void push_features(const ClothFeatures& features, const FeatureProgress& progress,
                   std::span<const Tri> triangles, std::span<const double> w, double h,
                   std::span<const Vec3> x, std::vector<Vec3>& force, std::span<Vec3> v);

/// What moves positions: one pass, before stitches, contacts and bounds. `before`: where the step began;
/// `brought` is what hands on shoulders moved, for let_lie().
void solve_features(const ClothFeatures& features, const FeatureProgress& progress, std::span<const double> w,
                    double h, std::span<const Vec3> before, std::span<Vec3> x,
                    std::vector<constraints::BroughtBack>& brought);

}  // namespace toile::solver
