#include "core/solver/lanes/lanes.h"

#include <algorithm>

namespace toile::solver::lanes {

namespace {

/// Least compliance / h² of a direction, as a share of its mobility: a system that rounding cannot turn over.
/// One pass a step never makes cloth that hard.
constexpr double kLeastSoft = 1e-5;

float single(double value) { return static_cast<float>(value); }

/// What the mobility along weft, warp and shear is about, 1/(kg m²).
double mobility_of(const constraints::MembraneTriangle& t, std::span<const double> w) {
  double steep = 0;
  for (const double b : t.b) steep += b * b;
  const double most = std::max({w[t.v[0]], w[t.v[1]], w[t.v[2]]});
  return steep * (most > 0 ? most : 1);
}

}  // namespace

double lane_unit(const constraints::MembraneTriangle& t, std::span<const double> w) {
  return 1 / mobility_of(t, w);
}

std::vector<MembranePack> pack_membrane(std::span<const constraints::MembraneTriangle> triangles,
                                        const PackPlan& plan, std::span<const double> w, double h) {
  const std::vector<LaneGroup>& groups = plan.groups;
  std::vector<MembranePack> packs(groups.size());
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const Index nobody = static_cast<Index>(w.size()) + plan.side[g];
    MembranePack& p = packs[g];
    for (int lane = 0; lane < kLanes; ++lane) {
      const bool used = groups[g][lane] != kNone;
      const constraints::MembraneTriangle& t = triangles[used ? groups[g][lane] : groups[g][0]];
      const double unit = 1 / mobility_of(t, w);
      for (int i = 0; i < 3; ++i) {
        p.v[i][lane] = offset_of(used ? t.v[i] : nobody);
        p.w[i].at[lane] = used ? single(w[t.v[i]] * unit) : 0;
      }
      for (int i = 0; i < 4; ++i) {
        const double soft = t.compliance[i] * unit / (h * h);
        p.b[i].at[lane] = single(t.b[i]);
        p.soft[i].at[lane] = single(i == 2 ? soft : std::max(soft, kLeastSoft));
      }
      p.share.at[lane] = single(t.share);
      p.buckling.at[lane] = single(t.buckling * h * h / unit);
    }
  }
  return packs;
}

std::vector<LimitPack> pack_limits(std::span<const constraints::MembraneTriangle> triangles,
                                   const PackPlan& plan, std::span<const double> w) {
  const bool any =
      std::any_of(triangles.begin(), triangles.end(), [](const constraints::MembraneTriangle& t) {
        return std::max({t.stop[0], t.stop[1], t.stop[2]}) > 0;
      });
  const std::vector<LaneGroup>& groups = plan.groups;
  std::vector<LimitPack> packs(any ? groups.size() : 0);
  for (std::size_t g = 0; g < packs.size(); ++g) {
    for (int lane = 0; lane < kLanes; ++lane) {
      const constraints::MembraneTriangle& t =
          triangles[groups[g][lane] == kNone ? groups[g][0] : groups[g][lane]];
      const double unit = mobility_of(t, w);
      for (int k = 0; k < 3; ++k) {
        packs[g].limit[k].at[lane] = single(t.limit[k]);
        packs[g].stop[k].at[lane] = single(t.stop[k] * unit);
      }
    }
  }
  return packs;
}

std::vector<BendPack> pack_bending(std::span<const constraints::BendTriangle> triangles, const PackPlan& plan,
                                   std::span<const double> w) {
  const std::vector<LaneGroup>& groups = plan.groups;
  std::vector<BendPack> packs(groups.size());
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const Index nobody = static_cast<Index>(w.size()) + plan.side[g];
    BendPack& p = packs[g];
    for (int lane = 0; lane < kLanes; ++lane) {
      const bool used = groups[g][lane] != kNone;
      const constraints::BendTriangle& t = triangles[used ? groups[g][lane] : groups[g][0]];
      for (int i = 0; i < 6; ++i) {
        const Index v = t.v[i] == kNone ? t.v[0] : t.v[i];
        p.v[i][lane] = offset_of(used ? v : nobody);
        p.w[i].at[lane] = used && t.v[i] != kNone ? single(w[t.v[i]]) : 0;
        p.response[i].at[lane] = single(t.response[i]);
      }
      p.hard.at[lane] = single(t.hard);
      for (int k = 0; k < 3; ++k) {
        p.far[k].at[lane] = single(t.far[k]);
        for (int i = 0; i < 2; ++i) p.own[k][i].at[lane] = single(t.own[k][i + 1]);
      }
    }
  }
  return packs;
}

std::vector<const LaneKernels*> runnable_lane_kernels() {
  std::vector<const LaneKernels*> sets{&kPlainLaneKernels};
#if defined(__x86_64__) && defined(__GNUC__)
  const bool avx2 = __builtin_cpu_supports("avx2");
  const bool avx512 = avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                      __builtin_cpu_supports("avx512vl");
  if (avx2 && avx2_lane_kernels() != nullptr) sets.push_back(avx2_lane_kernels());
  if (avx512 && avx512_lane_kernels() != nullptr) sets.push_back(avx512_lane_kernels());
#endif
  return sets;
}

const LaneKernels& lane_kernels() {
  static const LaneKernels& widest = *runnable_lane_kernels().back();
  return widest;
}

}  // namespace toile::solver::lanes
