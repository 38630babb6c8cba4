#include "core/solver/lanes/passes.h"

#include <algorithm>

#include "core/base/check.h"
#include "core/base/crew.h"

namespace toile::solver::lanes {

namespace {

template <typename Triangle>
PackPlan plan_of(const std::vector<Triangle>& triangles, Index vertex_count) {
  return plan_packs(static_cast<Index>(triangles.size()), vertex_count,
                    [&](Index t) { return std::span<const Index>(triangles[t].v); });
}

/// Points that are not worth a helper.
constexpr std::size_t kFewPoints = 4096;

/// Calls solve(begin, count) for the packs of each strip, round after round.
template <typename Solve>
void in_rounds(const PackPlan& plan, Crew& crew, const Solve& solve) {
  for (const std::vector<PackRange>& strips : plan.rounds) {
    crew.each(static_cast<int>(strips.size()), [&](int i) {
      const PackRange& packs = strips[static_cast<std::size_t>(i)];
      solve(packs.begin, packs.end - packs.begin);
    });
  }
}

}  // namespace

void spread(std::span<const Vec3> x, std::vector<LanePoint>& points, Crew& crew) {
  points.resize(x.size() + kMostSideBySide);
  // + 0.0 turns −0 into 0. No sum makes it −0 again, so that the sign of a move by nothing leaves no trace.
  crew.ranges(x.size(), kFewPoints, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) points[i] = {{x[i].x + 0.0, x[i].y + 0.0, x[i].z + 0.0, 0}};
  });
  std::fill(points.end() - kMostSideBySide, points.end(), LanePoint{});
}

void collect(std::span<const LanePoint> points, std::span<Vec3> x, Crew& crew) {
  crew.ranges(x.size(), kFewPoints, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) x[i] = {points[i].at[0], points[i].at[1], points[i].at[2]};
  });
}

MembranePass::MembranePass(const ClothModel& model)
    : triangles_(constraints::make_membrane(model)), plan_(plan_of(triangles_, model.vertex_count())) {
  set_preloads(std::vector<Vec3>(triangles_.size()));
}

void MembranePass::prepare(std::span<const double> w, double h) {
  constraints::prepare_membrane(triangles_, w, h);
  packs_ = pack_membrane(triangles_, plan_, w, h);
  limits_ = pack_limits(triangles_, plan_, w);
  w_.assign(w.begin(), w.end());
  h_ = h;
}

void MembranePass::lay_out_preloads() {
  preload_packs_.resize(plan_.groups.size());
  for (std::size_t g = 0; g < plan_.groups.size(); ++g) {
    for (int lane = 0; lane < kLanes; ++lane) {
      const Index t = plan_.groups[g][lane];
      if (t == kNone) continue;
      PreloadPack& p = preload_packs_[g];
      p.strain[0].at[lane] = static_cast<float>(preloads_[t].x);
      p.strain[1].at[lane] = static_cast<float>(preloads_[t].y);
      p.strain[2].at[lane] = static_cast<float>(preloads_[t].z);
    }
  }
}

void MembranePass::set_preloads(std::vector<Vec3> preloads) {
  TOILE_CHECK(preloads.size() == triangles_.size());
  preloads_ = std::move(preloads);
  lay_out_preloads();
}

void MembranePass::learn(std::span<const Vec3> x, double share, bool at_last) {
  std::vector<Vec3> noted(triangles_.size());
  for (std::size_t g = 0; g < plan_.groups.size(); ++g) {
    const Lanes(&lambda)[3] = preload_packs_[g].lambda;
    for (int lane = 0; lane < kLanes; ++lane) {
      const Index t = plan_.groups[g][lane];
      if (t == kNone) continue;
      noted[t] =
          Vec3{lambda[0].at[lane], lambda[1].at[lane], lambda[2].at[lane]} * lane_unit(triangles_[t], w_);
    }
  }
  constraints::learn_preloads(triangles_, noted, h_, share, at_last, x, preloads_);
  lay_out_preloads();
}

void MembranePass::give_way(std::span<const Vec3> x, const constraints::MayGive& may) {
  if (constraints::give_way(triangles_, x, may, preloads_)) lay_out_preloads();
}

void MembranePass::solve(std::span<LanePoint> x, bool takes_note, Crew& crew, const LaneKernels& kernels) {
  in_rounds(plan_, crew, [&](std::size_t begin, std::size_t count) {
    const LimitPack* limits = limits_.empty() ? nullptr : limits_.data() + begin;
    kernels.solve_membrane(packs_.data() + begin, limits, preload_packs_.data() + begin, count, takes_note,
                           x.data());
  });
}

BendPass::BendPass(const ClothModel& model)
    : triangles_(constraints::make_bending(model)), plan_(plan_of(triangles_, model.vertex_count())) {}

void BendPass::prepare(std::span<const double> w, double h) {
  constraints::prepare_bending(triangles_, w, h);
  packs_ = pack_bending(triangles_, plan_, w);
}

void BendPass::solve(std::span<LanePoint> x, Crew& crew, const LaneKernels& kernels) const {
  in_rounds(plan_, crew, [&](std::size_t begin, std::size_t count) {
    kernels.solve_bending(packs_.data() + begin, count, x.data());
  });
}

}  // namespace toile::solver::lanes
