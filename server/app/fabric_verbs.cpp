#include "server/app/fabric_verbs.h"

#include <CLI/CLI.hpp>

#include <string>

#include "server/app/exit_codes_text.h"

namespace toile::app {
namespace {

CLI::App* add_fabric_list(CLI::App& fabric, FabricListOptions& list) {
  CLI::App* verb = fabric.add_subcommand("list", "The fabrics that documents may name");
  verb->add_flag("--json", list.json, "Print as JSON, with every figure");
  verb->footer(std::string("Examples:\n  toile fabric list\n  toile fabric list --json\n\n") + kExitCodes);
  return verb;
}

CLI::App* add_fabric_show(CLI::App& fabric, FabricShowOptions& show) {
  CLI::App* verb = fabric.add_subcommand("show", "A fabric's figures, and where they come from");
  verb->add_option("name", show.name, "Its name, see fabric list")->required();
  verb->add_flag("--json", show.json, "Print as JSON");
  verb->footer(std::string("Examples:\n  toile fabric show single-jersey\n\n") + kExitCodes);
  return verb;
}

CLI::App* add_fabric_test(CLI::App& fabric, FabricTestOptions& test) {
  CLI::App* verb = fabric.add_subcommand("test", "Test a fabric as laboratories do");
  verb->add_option("name", test.name, "Its name, see fabric list")->required();
  verb->add_option("-o,--out", test.out, "Folder for its figure sheet, NAME.svg and NAME.png");
  verb->add_option("--drapes", test.drapes,
                   "Cusick drapes: warp turned by 0, 20, 43 degrees against the mesh, each face up")
      ->check(CLI::Range(1, 6))
      ->capture_default_str();
  verb->add_option("--particle-distance", test.particle_distance_mm,
                   "Edge length of their triangles, mm (default: what fits the fabric)")
      ->check(CLI::Range(2.0, 50.0));
  verb->add_flag("--json", test.json, "Print as JSON");
  verb->footer(std::string("Bending lengths from a strip 25 mm wide under its own weight (ASTM D1388), "
                           "tension per strain of a\n"
                           "strip and of a tube under air pressure, shear stiffness, friction, and the drape "
                           "coefficient and folds of a piece of 30 cm "
                           "on a disc of 18 cm\n"
                           "(BS 5058, ISO 9073-9), each beside what is known beforehand.\n\n"
                           "Examples:\n  toile fabric test denim-10oz --out out/fabrics\n\n") +
               kExitCodes);
  return verb;
}

void add_instruments(CLI::App& verb, FabricCalibrateOptions& c) {
  verb.add_option("--kes-b-warp", c.kes_b_warp, "KES-FB2, B along the warp, gf cm2/cm");
  verb.add_option("--kes-b-weft", c.kes_b_weft, "KES-FB2, B along the weft, gf cm2/cm");
  verb.add_option("--kes-g", c.kes_g, "KES-FB1, shear stiffness G, gf/(cm degree)");
  verb.add_option("--kes-emt-warp", c.kes_emt_warp, "KES-FB1, extension along the warp at 500 gf/cm, %");
  verb.add_option("--kes-emt-weft", c.kes_emt_weft, "KES-FB1, extension along the weft at 500 gf/cm, %");
  verb.add_option("--fast-e100-warp", c.fast_e100_warp, "FAST-3, extension along the warp at 100 gf/cm, %");
  verb.add_option("--fast-e100-weft", c.fast_e100_weft, "FAST-3, extension along the weft at 100 gf/cm, %");
  verb.add_option("--fast-eb5", c.fast_eb5, "FAST-3, extension on the bias at 5 gf/cm, %");
}

CLI::App* add_fabric_calibrate(CLI::App& fabric, FabricCalibrateOptions& c) {
  CLI::App* verb = fabric.add_subcommand("calibrate", "Find a fabric's missing figures from measured ones");
  verb->add_option("--mass", c.mass, "kg/m2")->required();
  verb->add_option("--drape", c.drape, "Drape coefficient, 0 to 1 (BS 5058, 30 cm on 18 cm)");
  verb->add_option("--warp-length", c.warp_length, "Bending length along the warp, mm (ASTM D1388, FAST-2)");
  verb->add_option("--weft-length", c.weft_length, "Bending length along the weft, mm");
  verb->add_option("--thickness", c.thickness, "mm");
  add_instruments(*verb, c);
  verb->add_option("--drapes", c.drapes, "Cusick drapes a test, of 20 in all")
      ->check(CLI::Range(1, 6))
      ->capture_default_str();
  verb->add_option("--particle-distance", c.particle_distance_mm,
                   "Edge length of their triangles, mm (default: what fits the fabric)")
      ->check(CLI::Range(2.0, 50.0));
  verb->add_flag("--json", c.json, "Print as JSON");
  verb->footer(std::string("What was measured is taken as it is. The drape coefficient tells bending, or "
                           "shear where bending was\nmeasured; what it could not tell apart is said.\n\n"
                           "Examples:\n  toile fabric calibrate --mass 0.15 --drape 0.62\n"
                           "  toile fabric calibrate --mass 0.15 --drape 0.62 --warp-length 21 "
                           "--weft-length 17\n\n") +
               kExitCodes);
  return verb;
}

}  // namespace

FabricVerbs::FabricVerbs(CLI::App& app) {
  CLI::App* fabric =
      app.add_subcommand("fabric", "Fabrics: list them, show one, test one, find one's figures");
  fabric->require_subcommand(1);
  list_ = add_fabric_list(*fabric, list_options_);
  show_ = add_fabric_show(*fabric, show_options_);
  test_ = add_fabric_test(*fabric, test_options_);
  calibrate_ = add_fabric_calibrate(*fabric, calibrate_options_);
}

std::optional<ExitCode> FabricVerbs::run() const {
  if (list_->parsed()) return fabric_list_command(list_options_);
  if (show_->parsed()) return fabric_show_command(show_options_);
  if (test_->parsed()) return fabric_test_command(test_options_);
  if (calibrate_->parsed()) return fabric_calibrate_command(calibrate_options_);
  return std::nullopt;
}

}  // namespace toile::app
