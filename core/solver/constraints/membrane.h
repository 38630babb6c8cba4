#pragma once
// In-plane stretch and shear of a triangle, as one compliant constraint of three components (XPBD: Macklin,
// Müller and Chentanez 2016; small steps of one iteration: Macklin et al. 2019). Energy per area ½ εᵀ K ε
// with ε = (|f_weft| − 1, |f_warp| − 1, f_weft · f_warp), f the deformation gradient's columns.
//
// Two things change with the stress, neither of them by a jump. Cloth that is pushed together buckles: a mesh
// with edges of length l can fold no narrower than 2l, for which Euler's load is π²B/l²; beyond that load it
// resists with a twentieth of its stiffness, along warp, weft and on the bias. Without the bias, shear
// keeps coarse triangles from giving way. (Tension
// fields, and Choi and Ko, "Stable but Responsive Cloth", 2002, do the like.) And beyond the fabric's limits
// a hard second spring works beside the first. The pass itself is in core/solver/lanes.

#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/solver/cloth_model.h"

namespace toile::solver::constraints {

/// Share of its stiffness that cloth has left once it has buckled between the vertices.
inline constexpr double kBuckledStiffness = 0.05;

struct MembraneTriangle {
  Tri v{};
  double b[4] = {};  ///< inverse of the rest edges' matrix: f_weft = e1·b0 + e2·b1, f_warp = e1·b2 + e2·b3
  double compliance[4] = {};  ///< of (weft, warp, coupling, shear), K⁻¹ / area, 1/J
  double buckling = 0;        ///< Euler's load times area, J
  double limit[3] = {};       ///< strain along weft and warp, shear; 0: none
  double stop[3] = {};  ///< what the limits take off the system, J/h² of strain; set by prepare_membrane
  double share = 1;     ///< of the mobility, see one_pass.h; set by prepare_membrane
};

std::vector<MembraneTriangle> make_membrane(const ClothModel& model);

/// Fits the triangles to inverse masses `w` (1/kg) and substep `h` (s); needed again when either changes.
void prepare_membrane(std::span<MembraneTriangle> triangles, std::span<const double> w, double h);

/// The strains (weft, warp, shear) of one triangle at positions x. Shear is the change of the right angle's
/// cosine.
Vec3 membrane_strain(const MembraneTriangle& triangle, std::span<const Vec3> x);

}  // namespace toile::solver::constraints
