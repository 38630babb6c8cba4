#include "core/project/resolve/fabrics.h"

#include <algorithm>
#include <utility>

#include "core/base/units.h"
#include "core/project/resolve/make_all.h"
#include "core/project/resolve/pattern_names.h"
#include "core/project/resolve/pieces.h"

namespace toile::resolve {
namespace {

Result<material::Fabric> fabric_of(const project::ProjectFabric& given, const std::string& where) {
  // A negative eigenvalue of the stiffness would let the cloth gain energy by stretching.
  if (given.stretch_coupling_n_m * given.stretch_coupling_n_m >=
      given.stretch_warp_n_m * given.stretch_weft_n_m) {
    return Error{"project.unstable_fabric",
                 "stretch_coupling_n_m must be less than the root of stretch_warp_n_m times stretch_weft_n_m",
                 json::pointer_to(where, "stretch_coupling_n_m")};
  }
  constexpr double kKilograms = 1e-3, kNewtonMetres = 1e-6;
  material::Fabric fabric;
  fabric.id = given.id;
  fabric.name = given.name;
  fabric.areal_mass = given.areal_mass_g_m2 * kKilograms;
  fabric.stretch_warp = given.stretch_warp_n_m;
  fabric.stretch_weft = given.stretch_weft_n_m;
  fabric.stretch_coupling = given.stretch_coupling_n_m;
  fabric.stretch_shear = given.stretch_shear_n_m;
  fabric.limit_warp = given.limit_warp_percent / 100;
  fabric.limit_weft = given.limit_weft_percent / 100;
  fabric.limit_shear = given.limit_shear_rad;
  fabric.bend_warp = given.bend_warp_un_m * kNewtonMetres;
  fabric.bend_weft = given.bend_weft_un_m * kNewtonMetres;
  fabric.bend_bias = given.bend_bias_un_m * kNewtonMetres;
  fabric.thickness = metres_from_mm(given.thickness_mm);
  fabric.friction = given.friction;
  std::copy(given.colour.begin(), given.colour.end(), fabric.colour);
  return fabric;
}

/// A fabric more for each piece that has its own. REQUIRES `input` with the project's fabrics.
Status add_own_fabrics(const project::Project& project, drape::DrapeInput& input) {
  for (std::size_t i = 0; i < project.pieces.size(); ++i) {
    const project::ProjectPiece& piece = project.pieces[i];
    if (!piece.physical) continue;
    const project::ProjectFabric& common =
        project.fabrics[static_cast<std::size_t>(input.fabric_of_panel[i])];
    Result<material::Fabric> own = fabric_of(with_physical(common, *piece.physical),
                                             json::pointer_to(json::pointer_to("/pieces", i), "physical"));
    if (!own) return own.error();
    input.fabric_of_panel[i] = static_cast<Index>(input.fabrics.size());
    input.fabrics.push_back(std::move(*own));
  }
  return {};
}

}  // namespace

Status add_fabrics(const project::Project& project, drape::DrapeInput& input) {
  const std::vector<std::string> fabrics = ids_of(project.fabrics);
  for (std::size_t i = 0; i < project.pieces.size(); ++i) {
    const project::ProjectPiece& piece = project.pieces[i];
    const Result<Index> fabric =
        index_of(piece.fabric, fabrics, "fabric", json::pointer_to(json::pointer_to("/pieces", i), "fabric"));
    if (!fabric) return fabric.error();
    input.fabric_of_panel.push_back(*fabric);
  }
  TRY(make_all(project.fabrics, "/fabrics", input.fabrics, fabric_of));
  return add_own_fabrics(project, input);
}

}  // namespace toile::resolve
