#include "core/solver/lanes/passes.h"

namespace toile {

namespace {

template <typename Triangle>
std::vector<LaneGroup> groups_of(const std::vector<Triangle>& triangles, Index vertex_count) {
  return group_apart(static_cast<Index>(triangles.size()), vertex_count,
                     [&](Index t) { return std::span<const Index>(triangles[t].v); });
}

}  // namespace

MembranePass::MembranePass(const ClothModel& model)
    : triangles_(make_membrane(model)), groups_(groups_of(triangles_, model.vertex_count())) {}

void MembranePass::prepare(std::span<const double> w, double h) {
  prepare_membrane(triangles_, w, h);
  packs_ = pack_membrane(triangles_, groups_, w);
  limits_ = pack_limits(triangles_, groups_);
  per_h2_ = 1 / (h * h);
}

void MembranePass::solve(std::span<Vec3> x, const LaneKernels& kernels) const {
  const LimitPack* limits = limits_.empty() ? nullptr : limits_.data();
  kernels.solve_membrane(packs_.data(), limits, packs_.size(), per_h2_, x.data());
}

BendPass::BendPass(const ClothModel& model)
    : triangles_(make_bending(model)), groups_(groups_of(triangles_, model.vertex_count())) {}

void BendPass::prepare(std::span<const double> w, double h) {
  prepare_bending(triangles_, w, h);
  packs_ = pack_bending(triangles_, groups_, w);
}

void BendPass::solve(std::span<Vec3> x, const LaneKernels& kernels) const {
  kernels.solve_bending(packs_.data(), packs_.size(), x.data());
}

}  // namespace toile
