#include "core/solver/lanes/passes.h"

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
    : triangles_(constraints::make_membrane(model)), groups_(groups_of(triangles_, model.vertex_count())) {}

void MembranePass::prepare(std::span<const double> w, double h) {
  constraints::prepare_membrane(triangles_, w, h);
  packs_ = pack_membrane(triangles_, groups_, w, h);
  limits_ = pack_limits(triangles_, groups_, w);
}

void MembranePass::solve(std::span<LanePoint> x, const LaneKernels& kernels) const {
  const LimitPack* limits = limits_.empty() ? nullptr : limits_.data();
  kernels.solve_membrane(packs_.data(), limits, packs_.size(), x.data());
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
