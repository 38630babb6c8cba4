// A fabric's missing figures, found from those that a laboratory measured.

#include <cmath>
#include <cstdio>

#include "core/base/rounded.h"
#include "core/base/units.h"
#include "core/fabric/card.h"
#include "core/trials/calibrate.h"
#include "server/app/commands.h"
#include "server/app/console.h"

namespace toile::app {
namespace {

constexpr double kGrams = 1e3, kMicro = 1e6, kPercent = 100;

std::optional<double> in_metres(const std::optional<double>& mm) {
  return mm ? std::optional(metres_from_mm(*mm)) : std::nullopt;
}

trials::Measured measured_of(const FabricCalibrateOptions& o) {
  trials::Measured m;
  m.areal_mass = o.mass;
  m.drape = o.drape;
  m.length_warp = in_metres(o.warp_length);
  m.length_weft = in_metres(o.weft_length);
  m.kes_bend_warp = o.kes_b_warp;
  m.kes_bend_weft = o.kes_b_weft;
  m.fast_e100_warp = o.fast_e100_warp;
  m.fast_e100_weft = o.fast_e100_weft;
  m.fast_eb5 = o.fast_eb5;
  m.kes_emt_warp = o.kes_emt_warp;
  m.kes_emt_weft = o.kes_emt_weft;
  m.kes_shear = o.kes_g;
  m.thickness = in_metres(o.thickness);
  return m;
}

/// As it stands in a document's list of fabrics.
json::JsonValue document_fabric(const material::Fabric& f) {
  return std::vector<json::JsonMember>{{"id", f.id},
                                       {"areal_mass_g_m2", rounded(f.areal_mass * kGrams, 2)},
                                       {"stretch_warp_n_m", rounded(f.stretch_warp, 2)},
                                       {"stretch_weft_n_m", rounded(f.stretch_weft, 2)},
                                       {"stretch_coupling_n_m", rounded(f.stretch_coupling, 2)},
                                       {"stretch_shear_n_m", rounded(f.stretch_shear, 2)},
                                       {"bend_warp_un_m", rounded(f.bend_warp * kMicro, 2)},
                                       {"bend_weft_un_m", rounded(f.bend_weft * kMicro, 2)},
                                       {"bend_bias_un_m", rounded(f.bend_bias * kMicro, 2)},
                                       {"thickness_mm", rounded(mm_from_metres(f.thickness), 2)}};
}

std::string found_words(const std::optional<trials::Unknown>& fitted) {
  if (!fitted) return "nothing";
  return *fitted == trials::Unknown::kBending ? "bending" : "shear";
}

void print_json(const trials::Calibration& c, const FabricCalibrateOptions& o) {
  std::vector<json::JsonValue> open;
  for (const std::string& sentence : c.open) open.emplace_back(sentence);
  std::vector<json::JsonMember> out{{"fabric", document_fabric(c.fabric)},
                                    {"found", found_words(c.fitted)},
                                    {"drapes", static_cast<double>(c.tests * o.drapes)},
                                    {"within_a_point", c.within}};
  if (o.drape) {
    out.push_back({"drape_percent", rounded(kPercent * c.drape, 2)});
    out.push_back({"off_points", rounded(kPercent * c.off, 2)});
  }
  out.push_back({"could_not_tell", std::move(open)});
  std::printf("%s", json::write_json(out).c_str());
}

void print_text(const trials::Calibration& c, const FabricCalibrateOptions& o) {
  const auto length = [&](double rigidity) {
    return mm_from_metres(fabric::bending_length(rigidity, c.fabric.areal_mass));
  };
  if (o.drape) {
    std::printf("drape      %.1f %%, measured %.1f %%: %s a point; %d drapes\n", kPercent * c.drape,
                kPercent * *o.drape, c.within ? "within" : "not within", c.tests * o.drapes);
    std::printf("found      %s\n", found_words(c.fitted).c_str());
  }
  std::printf("bending    warp %.2f, weft %.2f, bias %.2f uN m (lengths %.1f, %.1f, %.1f mm)\n",
              kMicro * c.fabric.bend_warp, kMicro * c.fabric.bend_weft, kMicro * c.fabric.bend_bias,
              length(c.fabric.bend_warp), length(c.fabric.bend_weft), length(c.fabric.bend_bias));
  std::printf("stretch    warp %.0f, weft %.0f N/m\nshear      %.1f N/m\n", c.fabric.stretch_warp,
              c.fabric.stretch_weft, c.fabric.stretch_shear);
  for (const std::string& sentence : c.open) std::printf("could not be told apart: %s\n", sentence.c_str());
  std::printf("for a document: %s\n", json::write_json_line(document_fabric(c.fabric)).c_str());
}

}  // namespace

ExitCode fabric_calibrate_command(const FabricCalibrateOptions& options) {
  constexpr int kMostDrapes = 20;
  const trials::DrapeTest test =
      trials::cusick_test(options.drapes, metres_from_mm(options.particle_distance_mm), {});
  const Result<trials::Calibration> found =
      trials::calibrate(measured_of(options), test, kMostDrapes / options.drapes);
  if (!found) return fail(found.error(), options.json);
  if (options.json)
    print_json(*found, options);
  else
    print_text(*found, options);
  return found->within ? kDone : kUnsettled;
}

}  // namespace toile::app
