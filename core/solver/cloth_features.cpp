#include "core/solver/cloth_features.h"

namespace toile {

void push_features(const ClothFeatures& features, const FeatureProgress& progress,
                   std::span<const Tri> triangles, std::span<const double> w, double h,
                   std::span<const Vec3> x, std::vector<Vec3>& force, std::span<Vec3> v) {
  if (progress.air) drag_cloth(features.air, triangles, w, h, x, v);
  inflate(features.chambers, progress.formed, w, h, x, force, v);
}

void solve_features(const ClothFeatures& features, const FeatureProgress& progress, std::span<const double> w,
                    double h, std::span<Vec3> x) {
  solve_folds(features.folds, progress.formed, w, h, x);
  solve_elastics(features.elastics, progress.formed, w, h, x);
  solve_ties(features.ties, progress.open, w, h, x);
  solve_tethers(features.tethers, progress.open, w, h, x);
}

}  // namespace toile
