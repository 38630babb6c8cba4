#include "core/fabric/card.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/names.h"
#include "core/fabric/fields.h"
#include "core/json/fields/reader.h"
#include "core/json/fields/writer.h"

namespace toile::fabric {
namespace {

Status check_curve(const StretchCurve& curve, const char* key) {
  CurvePoint before;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (curve[i].strain_percent <= before.strain_percent || curve[i].tension_n_m <= before.tension_n_m) {
      return Error{"fabric.curve", "a curve's strain and tension grow from point to point",
                   json::pointer_to(json::pointer_to("", key), i)};
    }
    before = curve[i];
  }
  return {};
}

Status check_coupling(const FabricCard& card) {
  const double coupling = card.stretch_coupling_n_m;
  if (coupling * coupling <
      stretch_law(card.stretch_warp).stiffness * stretch_law(card.stretch_weft).stiffness)
    return {};
  return Error{"fabric.unstable",
               "the coupling must be less than the root of the product of both first stiffnesses",
               "/stretch_coupling_n_m"};
}

/// The keys that need a source: every number of the card that says how the cloth behaves.
std::vector<std::string> figures_of(const FabricCard& card) {
  std::vector<std::string> keys{
      "areal_mass_g_m2",   "thickness_mm",    "bend_warp_un_m", "bend_weft_un_m",
      "bend_bias_un_m",    "stretch_warp",    "stretch_weft",   "stretch_coupling_n_m",
      "stretch_shear_n_m", "limit_shear_rad", "friction"};
  if (card.drape_least_percent) keys.emplace_back("drape_least_percent");
  if (card.drape_most_percent) keys.emplace_back("drape_most_percent");
  return keys;
}

Status check_sources(const FabricCard& card) {
  const std::vector<std::string> figures = figures_of(card);
  std::vector<std::string> told;
  for (const FigureSource& source : card.sources) told.insert(told.end(), source.of.begin(), source.of.end());
  for (const std::string& key : figures) {
    if (std::count(told.begin(), told.end(), key) == 1) continue;
    return Error{"fabric.source", "one source must be told for " + in_quotes(key), "/sources"};
  }
  for (const std::string& key : told) {
    if (std::find(figures.begin(), figures.end(), key) != figures.end()) continue;
    return Error{"fabric.source", "there is no figure " + in_quotes(key) + "; " + advice(key, figures),
                 "/sources"};
  }
  return {};
}

}  // namespace

Result<FabricCard> parse_fabric(std::string_view text) {
  const json::JsonValue tree = TRY(json::parse_json(text));
  if (!tree.object()) return Error{"project.wrong_type", "a fabric file is a JSON object", ""};
  std::optional<Error> error;
  FabricCard card;
  fields::read(fields::FieldPlace{tree, "", error}, card, fields::kAnything);
  if (error) return *std::move(error);
  TRY(check_curve(card.stretch_warp, "stretch_warp"));
  TRY(check_curve(card.stretch_weft, "stretch_weft"));
  TRY(check_coupling(card));
  TRY(check_sources(card));
  return card;
}

json::JsonValue fabric_json(const FabricCard& card) {
  FabricCard copy = card;  // a visitor takes places, and writes to none of them here
  return fields::json_of(copy);
}

std::string write_fabric(const FabricCard& card) { return json::write_json(fabric_json(card)); }

StretchLaw stretch_law(const StretchCurve& curve) {
  constexpr double kPercent = 0.01;
  const CurvePoint& first = curve.front();
  const CurvePoint& last = curve.back();
  StretchLaw law{first.tension_n_m / (first.strain_percent * kPercent), 0};
  if (curve.size() == 1) return law;
  const CurvePoint& before = curve[curve.size() - 2];
  const double end = last.strain_percent * kPercent;
  const double slope =
      (last.tension_n_m - before.tension_n_m) / ((last.strain_percent - before.strain_percent) * kPercent);
  if (slope > law.stiffness)
    law.limit = std::max((slope * end - last.tension_n_m) / (slope - law.stiffness), 0.0);
  return law;
}

material::Fabric fabric_of(const FabricCard& card) {
  constexpr double kKilograms = 1e-3, kNewtonMetres = 1e-6, kMetres = 1e-3;
  const StretchLaw warp = stretch_law(card.stretch_warp), weft = stretch_law(card.stretch_weft);
  material::Fabric fabric;
  fabric.id = card.name;
  fabric.name = card.title;
  fabric.areal_mass = card.areal_mass_g_m2 * kKilograms;
  fabric.stretch_warp = warp.stiffness;
  fabric.stretch_weft = weft.stiffness;
  fabric.stretch_coupling = card.stretch_coupling_n_m;
  fabric.stretch_shear = card.stretch_shear_n_m;
  fabric.limit_warp = warp.limit;
  fabric.limit_weft = weft.limit;
  fabric.limit_shear = card.limit_shear_rad;
  fabric.bend_warp = card.bend_warp_un_m * kNewtonMetres;
  fabric.bend_weft = card.bend_weft_un_m * kNewtonMetres;
  fabric.bend_bias = card.bend_bias_un_m * kNewtonMetres;
  fabric.thickness = card.thickness_mm * kMetres;
  fabric.friction = card.friction;
  std::copy(card.colour.begin(), card.colour.end(), fabric.colour);
  return fabric;
}

double bending_length(double rigidity, double areal_mass) {
  constexpr double kGravity = 9.81;  // m/s²
  return std::cbrt(rigidity / (areal_mass * kGravity));
}

double fitting_distance(const material::Fabric& fabric) {
  constexpr double kShare = 1.0 / 3, kFinest = 0.006, kCoarsest = 0.015;
  const double least = std::min({fabric.bend_warp, fabric.bend_weft, fabric.bend_bias});
  return std::clamp(kShare * bending_length(least, fabric.areal_mass), kFinest, kCoarsest);
}

}  // namespace toile::fabric
