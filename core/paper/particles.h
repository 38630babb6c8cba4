#pragma once
// "Formation of particle system" (Kim and Park 2003): what a garment's mesh becomes for this method.

#include <span>
#include <vector>

#include "core/material/fabric.h"
#include "core/paper/stretch.h"
#include "core/sewing/garment_mesh.h"

namespace toile::paper {

/// An angle between two neighbouring links of a fan.
struct FanAngle {
  Index apex = kNone, a = kNone, b = kNone;
  double flat = 0;       ///< radians, in the flat piece
  double stiffness = 0;  ///< C_i, 0 to 1
};

/// The angles around each particle; particles that seams join have one fan.
struct Fans {
  std::vector<FanAngle> angles;  ///< fan after fan
  std::vector<Index> first;      ///< of each fan in `angles`, and one past the last at the end
  std::vector<double> flat;      ///< radians, the flat sum of each fan
  std::vector<Index> of;         ///< fan of each particle
};

/// A garment as particles. Indices are those of the garment's vertices.
struct Particles {
  std::vector<Tri> triangles;
  std::vector<double> weight;  ///< 1/m of each (1/kg); m in proportion to the area of its triangles
  std::vector<Index> weld;     ///< least particle that each is sewn to
  std::vector<Link> links;
  Fans fans;
  std::vector<std::vector<Index>> sewn;  ///< the particles that come to one place, rising; two at least
};

/// `warps` (unit vectors of the flat panels) and `fabric_of_panel` have one entry a panel. Elasticity (the
/// strain under `load`, N/m) and bending (core/material/coefficients.h) are coefficients from 0 to 1,
/// interpolated elliptically: elasticity along the link, bending across it, since the sheet bends about it.
Particles make_particles(const sewing::GarmentMesh& garment, std::span<const Vec2> warps,
                         std::span<const material::Fabric> fabrics, std::span<const Index> fabric_of_panel,
                         double load);

/// C of a link that lies at `angle` (radians) to the warp.
double bending_across(const material::Fabric& fabric, double angle);
/// ε_max of such a link: the strain under `load` (N/m), no more than the fabric's limit.
double elasticity_along(const material::Fabric& fabric, double angle, double load);

}  // namespace toile::paper
