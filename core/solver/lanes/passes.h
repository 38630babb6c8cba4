#pragma once
// The two sweeps that every step makes over all triangles: membrane and bending, a pack of triangles at a
// time.

#include <array>
#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/solver/cloth_model.h"
#include "core/solver/constraints/preload.h"
#include "core/solver/lanes/lanes.h"

namespace toile {
class Crew;
}

namespace toile::solver::lanes {

/// Copies of positions that lanes load and store, followed by the points of lanes without a triangle; and
/// back.
void spread(std::span<const Vec3> x, std::vector<LanePoint>& points, Crew& crew);
void collect(std::span<const LanePoint> points, std::span<Vec3> x, Crew& crew);

class MembranePass {
 public:
  explicit MembranePass(const ClothModel& model);

  /// Fits it to inverse masses `w` (1/kg) and substep `h` (s); needed first, and when either changes.
  void prepare(std::span<const double> w, double h);
  /// One Gauss-Seidel pass over positions x (m).
  /// One that takes note can be learnt from.
  void solve(std::span<LanePoint> x, bool takes_note, Crew& crew,
             const LaneKernels& kernels = lane_kernels());
  /// Learns from the pass that took note last: `x` (m) is where its step ended, `share` and `at_last` as for
  /// learn_preloads.
  void learn(std::span<const Vec3> x, double share, bool at_last = false);
  /// See constraints::give_way.
  void give_way(std::span<const Vec3> x, const constraints::MayGive& may);

  /// One Vec3 a triangle.
  const std::vector<Vec3>& preloads() const { return preloads_; }
  void set_preloads(std::vector<Vec3> preloads);
  /// Takes the shape at x (m) for the one without stress.
  void rest_at(std::span<const Vec3> x) { set_preloads(constraints::preloads_at_rest(triangles_, x)); }

 private:
  void lay_out_preloads();

  std::vector<constraints::MembraneTriangle> triangles_;
  std::vector<Vec3> preloads_;
  std::vector<PreloadPack> preload_packs_;
  std::vector<double> w_;
  double h_ = 0;
  PackPlan plan_;
  std::vector<MembranePack> packs_;
  std::vector<LimitPack> limits_;
};

class BendPass {
 public:
  explicit BendPass(const ClothModel& model);

  void prepare(std::span<const double> w, double h);
  void solve(std::span<LanePoint> x, Crew& crew, const LaneKernels& kernels = lane_kernels()) const;

 private:
  std::vector<constraints::BendTriangle> triangles_;
  PackPlan plan_;
  std::vector<BendPack> packs_;
};

}  // namespace toile::solver::lanes
