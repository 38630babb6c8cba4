#include "core/solver/cloth_features.h"

namespace toile::solver {

void push_features(const ClothFeatures& features, const FeatureProgress& progress,
                   std::span<const Tri> triangles, std::span<const double> w, double h,
                   std::span<const Vec3> x, std::vector<Vec3>& force, std::span<Vec3> v) {
  if (progress.air) constraints::drag_cloth(features.air, triangles, w, h, x, v);
  constraints::inflate(features.chambers, progress.formed, w, h, x, force, v);
}

void solve_features(const ClothFeatures& features, const FeatureProgress& progress, std::span<const double> w,
                    double h, std::span<const Vec3> before, std::span<Vec3> x,
                    std::vector<constraints::BroughtBack>& brought) {
  brought.clear();
  constraints::solve_folds(features.folds, progress.formed, w, h, x);
  constraints::solve_elastics(features.elastics, progress.formed, w, h, x);
  constraints::solve_ties(features.ties, progress.open, w, h, x);
  constraints::solve_tethers(features.tethers, progress.open, w, h, x);
  constraints::solve_shoulder_holds(features.shoulders, w, h, before, x, brought);
  constraints::solve_leashes(features.leashes, w, h, x);
}

}  // namespace toile::solver
