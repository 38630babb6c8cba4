#pragma once
// Bending, right on any mesh: a triangle and its up to three neighbours carry one curvature tensor.
//
// Over each edge that has a neighbour, the jump of the surface's slope is a fixed linear combination of four
// vertices (their flat positions decide it): j = Σ c x. A surface with curvatures κ = (κ_weft, κ_warp,
// κ_twist) makes the jumps S κ, S being the same combinations of the flat monomials (½u², ½v², uv). The
// triangle's energy is the least bending energy ½ A κᵀ D κ that agrees with its jumps, so the jumps'
// compliance is S D⁻¹ Sᵀ / A: exact for every quadratic surface, whatever the triangles' shapes, and a free
// border (fewer jumps) bends freely. Linear jumps of an inextensible surface are those of Bergou et al., "A
// Quadratic Bending Model for Inextensible Surfaces" (2006); one curvature a triangle from its three hinges
// is in the spirit of Grinspun et al. (2006).
// Linear jumps alone lose hold of a sharp fold: see unfolded() in core/solver/lanes/bend_kernel.h, where the
// pass is.

#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/solver/cloth_model.h"

namespace toile::solver::constraints {

/// A triangle with its hinges. Hinge k lies on the edge from corner k to corner k+1; v[3+k] is the
/// neighbour's far vertex, or kNone where the edge is free.
struct BendTriangle {
  Index v[6] = {kNone, kNone, kNone, kNone, kNone, kNone};
  double own[3][3] = {};      ///< weight of own corner i in jump k
  double far[3] = {};         ///< weight of the neighbour's vertex in jump k
  double compliance[6] = {};  ///< (00, 11, 22, 01, 02, 12), S D⁻¹ Sᵀ / A; m²/(N·m·m²) = 1/J
  double hard = 0;  ///< share·mobility over compliance / h², of its hardest way; set by prepare_bending
  double response[6] =
      {};  ///< inverse of (share · G W Gᵀ + compliance / h²), same order; set by prepare_bending
};

/// Bending matrix of a fabric: energy per area ½ (warp κ_warp² + weft κ_weft² + twist κ_twist²), where a
/// strip cut at 45° has the rigidity (warp + weft + twist)/4, so twist = 4·bias − warp − weft, kept positive.
struct BendMatrix {
  double weft = 0, warp = 0, twist = 0;  ///< N·m
};
BendMatrix bend_matrix(const material::Fabric& fabric);

/// Bending constraints of all triangles that have a neighbour. Edges with more than two triangles stay free.
std::vector<BendTriangle> make_bending(const ClothModel& model);

/// Solves the constant part for inverse masses `w` and substep `h`; needed again when either changes.
void prepare_bending(std::span<BendTriangle> triangles, std::span<const double> w, double h);

}  // namespace toile::solver::constraints
