// The fabrics of the library: a list, and one with its figures and their sources.

#include <cmath>
#include <cstdio>
#include <string>

#include "core/base/text.h"
#include "core/base/units.h"
#include "core/fabric/library.h"
#include "core/material/coefficients.h"
#include "server/app/commands.h"
#include "server/app/console.h"

namespace toile::app {
namespace {

double bending_mm(double rigidity, const material::Fabric& cloth) {
  return std::round(mm_from_metres(fabric::bending_length(rigidity, cloth.areal_mass)) * 10) / 10;
}

double hundredths(double value) { return std::round(value * 100) / 100; }

json::JsonValue coefficients_json(const material::Fabric& cloth) {
  const auto bending = [&](double rigidity) {
    return hundredths(material::bending_coefficient(rigidity, cloth.areal_mass));
  };
  return std::vector<json::JsonMember>{
      {"elasticity_warp", hundredths(material::elasticity_of(cloth.stretch_warp, cloth.limit_warp))},
      {"elasticity_weft", hundredths(material::elasticity_of(cloth.stretch_weft, cloth.limit_weft))},
      {"bending_warp", bending(cloth.bend_warp)},
      {"bending_weft", bending(cloth.bend_weft)}};
}

/// What follows from a card's figures.
std::vector<json::JsonMember> derived_json(const material::Fabric& cloth) {
  return {{"bending_length_warp_mm", bending_mm(cloth.bend_warp, cloth)},
          {"bending_length_weft_mm", bending_mm(cloth.bend_weft, cloth)},
          {"bending_length_bias_mm", bending_mm(cloth.bend_bias, cloth)},
          {"stretch_warp_n_m", cloth.stretch_warp},
          {"stretch_weft_n_m", cloth.stretch_weft},
          {"limit_warp_percent", cloth.limit_warp * 100},
          {"limit_weft_percent", cloth.limit_weft * 100},
          {"coefficients", coefficients_json(cloth)},
          {"particle_distance_mm", std::round(mm_from_metres(fabric::fitting_distance(cloth)) * 10) / 10}};
}

void print_line(const fabric::FabricCard& card) {
  const material::Fabric cloth = fabric::fabric_of(card);
  std::printf("%-18s %5.0f g/m²  %5.2f mm  bends %5.1f/%4.1f mm  %s\n", card.name.c_str(),
              card.areal_mass_g_m2, card.thickness_mm, bending_mm(cloth.bend_warp, cloth),
              bending_mm(cloth.bend_weft, cloth), card.title.c_str());
}

void print_curve(const char* way, const fabric::StretchCurve& curve, double stiffness, double limit) {
  std::printf("stretch, %s   %.0f N/m at first, limit %s; curve 0 %%: 0", way, stiffness,
              limit > 0 ? (fixed_text(limit * 100, 1) + " %").c_str() : "none");
  for (const fabric::CurvePoint& point : curve)
    std::printf(", %g %%: %g N/m", point.strain_percent, point.tension_n_m);
  std::printf("\n");
}

void print_card(const fabric::FabricCard& card) {
  const material::Fabric cloth = fabric::fabric_of(card);
  std::printf("%s: %s\n%s, %s, %s\n", card.name.c_str(), card.title.c_str(), card.fibre.c_str(),
              card.construction.c_str(), card.weave.c_str());
  if (!card.use.empty()) std::printf("for %s\n", card.use.c_str());
  std::printf("mass            %g g/m², %g mm thick\n", card.areal_mass_g_m2, card.thickness_mm);
  std::printf("bending         warp %g, weft %g, bias %g µN·m: bending lengths %.1f, %.1f, %.1f mm\n",
              card.bend_warp_un_m, card.bend_weft_un_m, card.bend_bias_un_m,
              bending_mm(cloth.bend_warp, cloth), bending_mm(cloth.bend_weft, cloth),
              bending_mm(cloth.bend_bias, cloth));
  print_curve("warp", card.stretch_warp, cloth.stretch_warp, cloth.limit_warp);
  print_curve("weft", card.stretch_weft, cloth.stretch_weft, cloth.limit_weft);
  std::printf("coupling        %g N/m\nshear           %g N/m per radian, limit %g rad\n",
              card.stretch_coupling_n_m, card.stretch_shear_n_m, card.limit_shear_rad);
  std::printf("friction        %g\n", card.friction);
  if (card.drape_least_percent && card.drape_most_percent)
    std::printf("drape           %g to %g %% are published\n", *card.drape_least_percent,
                *card.drape_most_percent);
  std::printf("coefficients    elasticity %.2f and %.2f, bending %.2f and %.2f (0 to 1, warp and weft)\n",
              material::elasticity_of(cloth.stretch_warp, cloth.limit_warp),
              material::elasticity_of(cloth.stretch_weft, cloth.limit_weft),
              material::bending_coefficient(cloth.bend_warp, cloth.areal_mass),
              material::bending_coefficient(cloth.bend_weft, cloth.areal_mass));
  std::printf("triangles       %.1f mm fit it\n", mm_from_metres(fabric::fitting_distance(cloth)));
  for (const fabric::FigureSource& source : card.sources) {
    for (std::size_t i = 0; i < source.of.size(); ++i)
      std::printf("%s%s", i > 0 ? ", " : "", source.of[i].c_str());
    std::printf(": %s%s\n", source.source.empty() ? "estimated from " : "",
                (source.source + source.estimated_from).c_str());
  }
}

}  // namespace

ExitCode fabric_list_command(const FabricListOptions& options) {
  std::vector<json::JsonValue> list;
  for (const fabric::FabricCard& card : fabric::library()) {
    if (options.json)
      list.push_back(fabric::fabric_json(card));
    else
      print_line(card);
  }
  if (options.json)
    std::printf("%s", json::write_json(std::vector<json::JsonMember>{{"fabrics", list}}).c_str());
  return kDone;
}

ExitCode fabric_show_command(const FabricShowOptions& options) {
  const Result<const fabric::FabricCard*> card = fabric::named(options.name, "");
  if (!card) return fail(card.error(), options.json);
  if (options.json) {
    std::vector<json::JsonMember> members = *fabric::fabric_json(**card).object();
    members.push_back({"derived", derived_json(fabric::fabric_of(**card))});
    std::printf("%s", json::write_json(members).c_str());
  } else {
    print_card(**card);
  }
  return kDone;
}

}  // namespace toile::app
