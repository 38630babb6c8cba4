#include "core/project/resolve/fabrics.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/base/names.h"
#include "core/base/units.h"
#include "core/fabric/library.h"
#include "core/material/coefficients.h"
#include "core/material/ellipse.h"
#include "core/material/laminate.h"
#include "core/project/resolve/make_all.h"
#include "core/project/resolve/pattern_names.h"

namespace toile::resolve {
namespace {

constexpr double kKilograms = 1e-3, kNewtonMetres = 1e-6;

void take(double& value, const std::optional<double>& given, double unit = 1) {
  if (given) value = *given * unit;
}

/// Takes what fabrics and pieces both may have.
template <typename Given>
void take_figures(const Given& given, material::Fabric& fabric) {
  take(fabric.areal_mass, given.areal_mass_g_m2, kKilograms);
  take(fabric.stretch_warp, given.stretch_warp_n_m);
  take(fabric.stretch_weft, given.stretch_weft_n_m);
  take(fabric.stretch_coupling, given.stretch_coupling_n_m);
  take(fabric.stretch_shear, given.stretch_shear_n_m);
  take(fabric.bend_warp, given.bend_warp_un_m, kNewtonMetres);
  take(fabric.bend_weft, given.bend_weft_un_m, kNewtonMetres);
  take(fabric.bend_bias, given.bend_bias_un_m, kNewtonMetres);
  if (given.thickness_mm) fabric.thickness = metres_from_mm(*given.thickness_mm);
  take(fabric.friction, given.friction);
}

/// A negative eigenvalue of the stiffness would let the cloth gain energy by stretching.
Status check_stable(const material::Fabric& fabric, const std::string& where) {
  if (fabric.stretch_coupling * fabric.stretch_coupling < fabric.stretch_warp * fabric.stretch_weft)
    return {};
  return Error{"project.unstable_fabric",
               "stretch_coupling_n_m must be less than the root of stretch_warp_n_m times stretch_weft_n_m",
               json::pointer_to(where, "stretch_coupling_n_m")};
}

/// REQUIRES a fabric that has its mass already.
void take_coefficients(const project::ProjectCoefficients& given, material::Fabric& fabric) {
  const auto stretch = [](const std::optional<double>& elasticity, double& stiffness, double& limit) {
    if (!elasticity) return;
    stiffness = material::stretch_of_elasticity(*elasticity);
    limit = *elasticity;
  };
  stretch(given.elasticity_warp, fabric.stretch_warp, fabric.limit_warp);
  stretch(given.elasticity_weft, fabric.stretch_weft, fabric.limit_weft);
  const auto rigidity = [&](double b) { return material::rigidity_of_bending(b, fabric.areal_mass); };
  if (given.bending_warp) fabric.bend_warp = rigidity(*given.bending_warp);
  if (given.bending_weft) fabric.bend_weft = rigidity(*given.bending_weft);
  if (given.bending_warp && given.bending_weft)
    fabric.bend_bias = rigidity(material::elliptical(*given.bending_warp, *given.bending_weft, kPi / 4));
}

Result<material::Fabric> fabric_of(const project::ProjectFabric& given, const std::string& where) {
  material::Fabric fabric;
  if (!given.like.empty())
    fabric = fabric::fabric_of(*TRY(fabric::named(given.like, json::pointer_to(where, "like"))));
  fabric.id = given.id;
  if (!given.name.empty() || given.like.empty()) fabric.name = given.name;
  take(fabric.areal_mass, given.areal_mass_g_m2, kKilograms);
  if (given.coefficients) take_coefficients(*given.coefficients, fabric);
  take_figures(given, fabric);
  if (given.limit_warp_percent) fabric.limit_warp = *given.limit_warp_percent / 100;
  if (given.limit_weft_percent) fabric.limit_weft = *given.limit_weft_percent / 100;
  take(fabric.limit_shear, given.limit_shear_rad);
  if (given.colour) std::copy(given.colour->begin(), given.colour->end(), fabric.colour);
  TRY(check_stable(fabric, where));
  return fabric;
}

/// The fabric as a piece has it.
Result<material::Fabric> with_physical(material::Fabric fabric, const project::ProjectPhysical& own,
                                       const std::string& where) {
  if (!own.interlining.empty()) {
    const fabric::FabricCard* other =
        TRY(fabric::named(own.interlining, json::pointer_to(where, "interlining")));
    fabric = material::fused(std::move(fabric), fabric::fabric_of(*other));
  }
  take_figures(own, fabric);
  TRY(check_stable(fabric, where));
  return fabric;
}

/// A fabric more for each piece that has its own. REQUIRES `input` with the fabrics of all pieces.
Status add_own_fabrics(const project::Project& project, drape::DrapeInput& input) {
  for (std::size_t i = 0; i < project.pieces.size(); ++i) {
    const project::ProjectPiece& piece = project.pieces[i];
    if (!piece.physical) continue;
    const auto common = static_cast<std::size_t>(input.fabric_of_panel[i]);
    material::Fabric own = TRY(with_physical(input.fabrics[common], *piece.physical,
                                             json::pointer_to(json::pointer_to("/pieces", i), "physical")));
    input.fabric_of_panel[i] = static_cast<Index>(input.fabrics.size());
    input.fabrics.push_back(std::move(own));
  }
  return {};
}

/// Index of the fabric of that name: the document's own, or the library's, which is added when it is new.
Result<Index> fabric_index(const std::string& name, const std::string& where, drape::DrapeInput& input) {
  std::vector<std::string> known;
  for (const material::Fabric& fabric : input.fabrics) known.push_back(fabric.id);
  const auto found = std::find(known.begin(), known.end(), name);
  if (found != known.end()) return static_cast<Index>(found - known.begin());
  const fabric::FabricCard* card = fabric::find(name);
  if (!card) {
    for (std::string& other : fabric::names()) known.push_back(std::move(other));
    return Error{"project.unknown_fabric",
                 "there is no fabric " + in_quotes(name) + "; " + advice(name, known), where};
  }
  input.fabrics.push_back(fabric::fabric_of(*card));
  return static_cast<Index>(input.fabrics.size()) - 1;
}

}  // namespace

const std::string& fabric_name(const project::Project& project, const project::ProjectPiece& piece) {
  return piece.fabric.empty() ? project.fabric : piece.fabric;
}

Status add_fabrics(const project::Project& project, drape::DrapeInput& input) {
  TRY(make_all(project.fabrics, "/fabrics", input.fabrics, fabric_of));
  for (std::size_t i = 0; i < project.pieces.size(); ++i) {
    const project::ProjectPiece& piece = project.pieces[i];
    const std::string where = json::pointer_to("/pieces", i);
    const std::string& name = fabric_name(project, piece);
    if (name.empty())
      return Error{"project.missing_key", "the key \"fabric\" is missing, and the project has none", where};
    const std::string place = piece.fabric.empty() ? "/fabric" : json::pointer_to(where, "fabric");
    input.fabric_of_panel.push_back(TRY(fabric_index(name, place, input)));
  }
  return add_own_fabrics(project, input);
}

}  // namespace toile::resolve
