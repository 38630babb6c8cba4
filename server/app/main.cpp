// The command line: which verbs there are and what they take. The verbs themselves are in *_command.cpp.

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>
#include <optional>
#include <string>

#include "server/app/account_verbs.h"
#include "server/app/commands.h"
#include "server/app/console.h"
#include "server/app/exit_codes_text.h"
#include "server/app/fabric_verbs.h"
#include "server/app/file_kinds.h"
#include "server/app/help_verbs.h"
#include "server/app/layer_option.h"
#include "server/app/measure_option.h"
#include "server/app/mesh_reader.h"
#include "server/app/pattern_verbs.h"
#include "server/app/result_verbs.h"
#include "server/app/service_verbs.h"
#include "server/app/usage.h"

namespace toile::app {
namespace {

struct Options {
  DrapeOptions drape;
  std::string size;
  bool no_stills = false;
  CheckOptions check;
  BodyMakeOptions body_make;
  BodyMeasureOptions body_measure;
  BodyPresetsOptions body_presets;
  ProjectNewOptions project_new;
  ProjectArrangeOptions arrange;
  SampleOptions sample;
};

/// "1024x1280" into the stills' size; a message when it is none.
std::string read_size(const std::string& text, DrapeOptions& options) {
  int used = 0;
  const bool whole = std::sscanf(text.c_str(), "%5dx%5d%n", &options.width, &options.height, &used) == 2 &&
                     used == static_cast<int>(text.size());
  const auto fits = [](int pixels) { return pixels >= 16 && pixels <= 4096; };
  return whole && fits(options.width) && fits(options.height)
             ? ""
             : "a size is WIDTHxHEIGHT in pixels, 16 to 4096 each, e.g. 1024x1280";
}

CLI::App* add_drape(CLI::App& app, Options& options) {
  CLI::App* verb = app.add_subcommand("drape", "Sew and drape a project; leave models, stills and a report");
  verb->add_option("project", options.drape.project, "Project document (proto/schema/project.schema.json)")
      ->required()
      ->check(not_a_project);
  verb->add_option("-o,--out", options.drape.out, "Folder for the results; made when it is not there")
      ->required();
  verb->add_flag("--check-data", options.drape.check_data,
                 "Also write rest.obj, body.obj and sewn.json for checks by other programs");
  verb->add_option("--from", options.drape.from,
                   "Go on from how the garment hung at the end of another drape: its folder, or final.hung");
  verb->add_option("--replay", options.drape.replay,
                   "Hands that were on the cloth of another drape of this project: its drape.log");
  verb->add_option(
          "--threads", options.drape.threads,
          "Threads that drape; no byte of the results depends on it (default: one for each processor)")
      ->type_name("N")
      ->check(CLI::Range(1, kMostThreads));
  CLI::Option* trace = verb->add_option("--trace", options.drape.trace,
                                        "Keep the drape's frames in this file (proto/trace.md)");
  verb->add_option("--trace-every", options.drape.trace_every, "Keep every N-th frame only")
      ->needs(trace)
      ->check(CLI::Range(1, 1000000));
  verb->add_flag("--json", options.drape.json,
                 "Print the report as JSON on stdout, errors as JSON on stderr");
  verb->add_flag("--no-stills", options.no_stills, "Draw no pictures");
  verb->add_option("--size", options.size, "Size of the pictures in pixels, WIDTHxHEIGHT")
      ->type_name("WxH")
      ->check([&options](const std::string& text) { return read_size(text, options.drape); });
  verb->footer(
      std::string("Leaves report.json, report.html (to look at), final.obj, final.glb, final.hung, "
                  "maps.json, drape.film "
                  "(toile movie), manifest.json (toile verify) and front, back, side and three-quarter.png.\n"
                  "Ctrl-C ends the drape and keeps what there is; a second one ends at once.\n\n"
                  "Examples:\n"
                  "  toile drape samples/skirt/project.json --out out/skirt\n"
                  "  toile drape project.json --out out --json --no-stills\n"
                  "  toile drape edited.json --out out/edited --from out/skirt\n"
                  "  toile drape project.json --out out --trace out/frames.trace --trace-every 4\n\n") +
      kExitCodes);
  return verb;
}

CLI::App* add_check(CLI::App& app, Options& options) {
  CLI::App* verb =
      app.add_subcommand("check", "Read a project and say what it holds, or what is wrong with it");
  verb->add_option("project", options.check.project, "Project document")->required()->check(not_a_project);
  verb->add_flag("--json", options.check.json, "Print as JSON");
  verb->footer(
      std::string(
          "Lists the pieces with the ids and lengths of their edges, and both lengths of each seam.\n"
          "Then looks at the start as a drape does: what it finds, where, and what a drape would repair.\n\n"
          "Examples:\n"
          "  toile check samples/skirt/project.json\n"
          "  toile check project.json --json\n\n") +
      kExitCodes);
  return verb;
}

/// With its other spelling.
std::string option_of(measure::Measure m) {
  return measure_option(m) + (m == measure::Measure::kBust ? ",--chest" : "");
}

CLI::App* add_body_make(CLI::App& body, BodyMakeOptions& make) {
  CLI::App* verb =
      body.add_subcommand("make", "Make a mannequin from measures; write it as OBJ, metres, y up");
  verb->add_option("-o,--out", make.out, "OBJ file to write")->required();
  verb->add_option("--sex", make.sex, "Figure to start from (default: the preset's, or female)")
      ->check(CLI::IsMember({"female", "male", "child"}));
  verb->add_option("--preset", make.preset, "Size to start from, e.g. eu38, m50, child116; see body presets");
  for (int i = 0; i < measure::kMeasureCount; ++i) {
    const measure::Measure m = measure::measure_at(i);
    verb->add_option(option_of(m), make.measures_cm[i], "cm, " + std::string(measure::measure_rule(m)));
  }
  verb->add_option("--pose", make.pose, "a: arms hang off the body; t: arms level")
      ->check(CLI::IsMember({"a", "t"}))
      ->capture_default_str();
  verb->add_option("--arm-angle", make.arm_angle, "Degrees between a hanging arm and pose a's, 30 to 60")
      ->capture_default_str();
  verb->add_option("--triangles", make.triangles, "Number of triangles")->capture_default_str();
  verb->add_flag("--json", make.json, "Print as JSON");
  verb->footer(
      std::string(
          "Any subset of the measures will do; the rest follows from proportions. Prints every measure as\n"
          "the tape takes it back: girths asked for are met to 5 mm, lengths to 10 mm.\n\n"
          "Examples:\n"
          "  toile body make --out body.obj\n"
          "  toile body make --sex female --height 168 --bust 92 --waist 74 --hip 99 --out body.obj --json\n"
          "  toile body make --preset m50 --pose t --triangles 5624 --out man.obj\n\n") +
      kExitCodes);
  return verb;
}

CLI::App* add_sample(CLI::App& app, Options& options) {
  SampleOptions& sample = options.sample;
  CLI::App* verb = app.add_subcommand("sample", "Draft a garment to measure; without a name list them");
  verb->add_option("name", sample.name, "Which one");
  verb->add_option("-o,--out", sample.out, "Folder for its DXF file and project.json; made when not there");
  CLI::Option* body =
      verb->add_option("--body", sample.body, "Mesh of the person it is drafted for")->check(not_a_body);
  verb->add_option("--preset", sample.preset, "Size of a mannequin instead, see body presets")
      ->excludes(body);
  verb->add_option("--sex", sample.sex, "The mannequin's figure")
      ->check(CLI::IsMember({"female", "male", "child"}))
      ->excludes(body);
  for (int i = 0; i < measure::kMeasureCount; ++i) {
    const measure::Measure m = measure::measure_at(i);
    verb->add_option(option_of(m), sample.measures_cm[i], "cm, " + std::string(measure::measure_rule(m)))
        ->excludes(body);
  }
  verb->add_option("--cloth", sample.cloth, "Which of its cloths it is cut of (default: the first)");
  verb->add_flag("--json", sample.json, "Print as JSON");
  verb->footer(std::string("Pieces stand arranged around the body; toile drape takes the project as it is. "
                           "Prints the girths\nthat the construction gives the garment over the body's.\n\n"
                           "Examples:\n"
                           "  toile sample\n"
                           "  toile sample tshirt --out out/tshirt\n"
                           "  toile sample tshirt --preset m50 --waist 92 --out out/tshirt\n"
                           "  toile sample tshirt --body scan.obj --out out/tshirt\n\n") +
               kExitCodes);
  return verb;
}

CLI::App* add_body_measure(CLI::App& body, BodyMeasureOptions& measure) {
  CLI::App* verb = body.add_subcommand("measure", "Measure a standing body's mesh with a tape");
  verb->add_option("file", measure.file, "Mesh of a person; unit and directions are guessed from its shape")
      ->required();
  verb->add_flag("--json", measure.json, "Print as JSON");
  verb->footer(std::string("Examples:\n"
                           "  toile body measure scan.obj\n"
                           "  toile body measure scan.stl --json\n\n") +
               kExitCodes);
  return verb;
}

CLI::App* add_project_new(CLI::App& project, ProjectNewOptions& options) {
  CLI::App* verb = project.add_subcommand("new", "Make a project of a pattern and a body");
  verb->add_option("--pattern", options.pattern, "DXF file, or GarmentCode specification (JSON)")
      ->required()
      ->check(not_a_pattern);
  verb->add_option("--body", options.body, "Mesh of the body")->required()->check(not_a_body);
  verb->add_option("-o,--out", options.out, "Project document to write; the files that it names go beside it")
      ->required();
  verb->add_option(
          "--accept-seams", options.accept_seams,
          "Take the seams proposed with this confidence or more, those of 0.65 whose edges nothing surer\n"
          "wants, and likely ones (0.5) of pieces that nothing surer holds on")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  verb->add_flag("--no-seams", options.no_seams,
                 "Take none: they are sewn by hand, in the document or on the page")
      ->excludes("--accept-seams");
  add_layer_option(*verb, options.layers);
  verb->add_flag("--json", options.json, "Print as JSON");
  verb->footer(
      std::string(
          "A specification brings its seams and places. For a DXF file seams are proposed; where some\n"
          "are taken, its pieces are arranged around the body, else they stand flat before and behind it.\n\n"
          "Examples:\n"
          "  toile project new --pattern shirt.dxf --body body.obj --out project.json\n"
          "  toile project new --pattern shirt.dxf --body body.obj --out p.json --accept-seams 0.5\n\n") +
      kExitCodes);
  return verb;
}

CLI::App* add_project_arrange(CLI::App& project, ProjectArrangeOptions& options) {
  CLI::App* verb = project.add_subcommand("arrange", "Place a project's pieces around its body");
  verb->add_option("project", options.project, "Project document with seams and a standing body")
      ->required()
      ->check(not_a_project);
  verb->add_option("-o,--out", options.out,
                   "Document to write; beside the files that it names (default: the same)");
  verb->add_option("--as", options.as,
                   "How places are written: as matrices, or told by the boxes of the body's parts")
      ->check(CLI::IsMember({"matrix", "box"}))
      ->capture_default_str();
  verb->add_flag("--json", options.json, "Print as JSON");
  verb->footer(
      std::string("Says where each piece went and what the look at the start then finds. Waistbands and\n"
                  "the upper edges of skirts and trousers are held until gravity is full.\n\n"
                  "Examples:\n"
                  "  toile project arrange project.json\n"
                  "  toile project arrange project.json --out arranged.json --json\n"
                  "  toile project arrange project.json --as box\n\n") +
      kExitCodes);
  return verb;
}

ExitCode run(int argc, char** argv) {
  CLI::App app("Toile drapes garments: from a flat sewing pattern to cloth on a body.", "toile");
  app.set_version_flag("--version", std::string("toile ") + TOILE_VERSION);
  app.require_subcommand(1);
  app.footer(std::string("Examples:\n"
                         "  toile check samples/skirt/project.json\n"
                         "  toile drape samples/skirt/project.json --out out/skirt\n"
                         "  toile serve --port 8460 --data data\n"
                         "  toile drape --help\n\n") +
             kExitCodes);
  Options options;
  const CLI::App* drape = add_drape(app, options);
  const CLI::App* check = add_check(app, options);
  CLI::App* body = app.add_subcommand("body", "Bodies: make a mannequin, measure a mesh, list the sizes");
  body->require_subcommand(1);
  const CLI::App* body_make = add_body_make(*body, options.body_make);
  const CLI::App* body_measure = add_body_measure(*body, options.body_measure);
  CLI::App* body_presets = body->add_subcommand("presets", "List the sizes that body make knows");
  body_presets->add_flag("--json", options.body_presets.json, "Print as JSON");
  ServiceVerbs service(app);
  AccountVerbs accounts(app);
  PatternVerbs pattern(app);
  FabricVerbs fabric(app);
  CLI::App* project = app.add_subcommand("project", "Project documents: make one, place its pieces");
  project->require_subcommand(1);
  add_project_new(*project, options.project_new);
  const CLI::App* arrange = add_project_arrange(*project, options.arrange);
  const CLI::App* sample = add_sample(app, options);
  ResultVerbs results(app);
  HelpVerbs help(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return instead_of_a_verb(app, e);
  }
  options.drape.stills = !options.no_stills;
  if (drape->parsed()) return drape_command(options.drape);
  if (check->parsed()) return check_command(options.check);
  if (body_make->parsed()) return body_make_command(options.body_make);
  if (body_measure->parsed()) return body_measure_command(options.body_measure);
  if (body_presets->parsed()) return body_presets_command(options.body_presets);
  if (const std::optional<ExitCode> code = fabric.run()) return *code;
  if (const std::optional<ExitCode> code = pattern.run()) return *code;
  if (const std::optional<ExitCode> code = service.run()) return *code;
  if (const std::optional<ExitCode> code = accounts.run()) return *code;
  if (const std::optional<ExitCode> code = results.run()) return *code;
  if (const std::optional<ExitCode> code = help.run()) return *code;
  if (sample->parsed()) return sample_command(options.sample);
  if (arrange->parsed()) return project_arrange_command(options.arrange);
  return project_new_command(options.project_new);
}

}  // namespace
}  // namespace toile::app

int main(int argc, char** argv) {
  try {
    if (const std::optional<int> code = toile::app::read_mesh_for_parent(argc, argv)) return *code;
    return toile::app::run(argc, argv);
  } catch (const std::bad_alloc&) {
    toile::app::print_error(
        {"internal.memory", "there is not enough memory for this", "", toile::ErrorKind::kInternal}, false);
  } catch (const std::exception& e) {
    toile::app::print_error({"internal.exception", e.what(), "", toile::ErrorKind::kInternal}, false);
  }
  return toile::app::kInternal;
}
