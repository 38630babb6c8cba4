#include "core/solver/lanes/passes.h"

#include "core/base/check.h"

namespace toile::solver::lanes {

namespace {

template <typename Triangle>
std::vector<LaneGroup> groups_of(const std::vector<Triangle>& triangles, Index vertex_count) {
  return group_apart(static_cast<Index>(triangles.size()), vertex_count,
                     [&](Index t) { return std::span<const Index>(triangles[t].v); });
}

}  // namespace

void spread(std::span<const Vec3> x, std::vector<LanePoint>& points) {
  points.resize(x.size() + 1);
  // + 0.0 turns −0 into 0. No sum makes it −0 again, so that the sign of a move by nothing leaves no trace.
  for (std::size_t i = 0; i < x.size(); ++i) points[i] = {{x[i].x + 0.0, x[i].y + 0.0, x[i].z + 0.0, 0}};
  points.back() = {};
}

void collect(std::span<const LanePoint> points, std::span<Vec3> x) {
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = {points[i].at[0], points[i].at[1], points[i].at[2]};
}

MembranePass::MembranePass(const ClothModel& model)
    : triangles_(constraints::make_membrane(model)), groups_(groups_of(triangles_, model.vertex_count())) {
  set_preloads(std::vector<Vec3>(triangles_.size()));
}

void MembranePass::prepare(std::span<const double> w, double h) {
  constraints::prepare_membrane(triangles_, w, h);
  packs_ = pack_membrane(triangles_, groups_, w, h);
  limits_ = pack_limits(triangles_, groups_, w);
  w_.assign(w.begin(), w.end());
  h_ = h;
}

void MembranePass::lay_out_preloads() {
  preload_packs_.resize(groups_.size());
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    for (int lane = 0; lane < kLanes; ++lane) {
      const Index t = groups_[g][lane];
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
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const Lanes(&lambda)[3] = preload_packs_[g].lambda;
    for (int lane = 0; lane < kLanes; ++lane) {
      const Index t = groups_[g][lane];
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

void MembranePass::solve(std::span<LanePoint> x, bool takes_note, const LaneKernels& kernels) {
  const LimitPack* limits = limits_.empty() ? nullptr : limits_.data();
  kernels.solve_membrane(packs_.data(), limits, preload_packs_.data(), packs_.size(), takes_note, x.data());
}

BendPass::BendPass(const ClothModel& model)
    : triangles_(constraints::make_bending(model)), groups_(groups_of(triangles_, model.vertex_count())) {}

void BendPass::prepare(std::span<const double> w, double h) {
  constraints::prepare_bending(triangles_, w, h);
  packs_ = pack_bending(triangles_, groups_, w);
}

void BendPass::solve(std::span<LanePoint> x, const LaneKernels& kernels) const {
  kernels.solve_bending(packs_.data(), packs_.size(), x.data());
}

}  // namespace toile::solver::lanes
