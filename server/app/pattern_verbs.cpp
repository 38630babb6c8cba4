#include "server/app/pattern_verbs.h"

#include <CLI/CLI.hpp>

#include "server/app/exit_codes_text.h"
#include "server/app/file_kinds.h"
#include "server/app/layer_option.h"

namespace toile::app {
namespace {

CLI::App* add_pattern_import(CLI::App& pattern, PatternImportOptions& import) {
  CLI::App* verb =
      pattern.add_subcommand("import", "Read a DXF file; say what it holds and what became of it");
  verb->add_option("file", import.file, "DXF file: AAMA, ASTM or plain, text or binary, R10 or later")
      ->required()
      ->check(not_a_pattern);
  verb->add_option("--size", import.size, "Size to take of a graded file (default: its sample size)");
  verb->add_option("--unit", import.unit, "Unit of the drawing (default: decided by what the file says)")
      ->check(CLI::IsMember({"mm", "cm", "inch"}));
  add_layer_option(*verb, import.layers);
  CLI::Option* json =
      verb->add_flag("--json", import.json, "Print as JSON, with every entity's fate and its lines");
  verb->add_flag("--no-seams", import.no_seams, "Leave out the proposals of seams, which take the longest")
      ->needs(json);
  verb->footer(std::string("Examples:\n"
                           "  toile pattern import shirt.dxf\n"
                           "  toile pattern import shirt.dxf --size 42 --unit cm --json\n"
                           "  toile pattern import shirt.dxf --layer 3=sew --layer 5=ignore\n\n") +
               kExitCodes);
  return verb;
}

CLI::App* add_pattern_layers(CLI::App& pattern, PatternLayersOptions& layers) {
  CLI::App* verb = pattern.add_subcommand(
      "layers", "Say which layers a DXF file has, what stands on them and what they are read as");
  verb->add_option("file", layers.file, "DXF file, also one in which no piece is found")
      ->required()
      ->check(not_a_pattern);
  add_layer_option(*verb, layers.layers);
  verb->add_flag("--json", layers.json, "Print as JSON");
  verb->footer(std::string("Layers are read by the numbers of AAMA and ASTM, or by names such as CUT; where "
                           "none is a layer\nof outlines, closed lines are pieces and holes by how they lie "
                           "(shape). --layer says otherwise.\n\n"
                           "Examples:\n"
                           "  toile pattern layers shirt.dxf\n"
                           "  toile pattern import shirt.dxf --layer 3=sew --layer OUTER=cut\n\n") +
               kExitCodes);
  return verb;
}

CLI::App* add_pattern_export(CLI::App& pattern, PatternExportOptions& exporting) {
  CLI::App* verb = pattern.add_subcommand("export", "Write a project's pieces as DXF, or to print at 1:1");
  verb->add_option("project", exporting.project, "Project document")->required()->check(not_a_project);
  verb->add_option("-o,--out", exporting.out,
                   "File to write: .dxf (AAMA's layers), .svg (one sheet) or .pdf (pages)")
      ->required();
  verb->add_option("--paper", exporting.paper, "Of a .pdf: its pages are glued to one sheet")
      ->check(CLI::IsMember({"a4", "a3", "a0", "letter"}))
      ->capture_default_str();
  verb->add_flag("--json", exporting.json, "Print as JSON");
  verb->footer(
      std::string(
          "Printed sheets show the lines that are sewn, without seam allowance, and a square to measure.\n\n"
          "Examples:\n"
          "  toile pattern export samples/skirt/project.json --out skirt.dxf\n"
          "  toile pattern export samples/skirt/project.json --out skirt.pdf --paper a3\n\n") +
      kExitCodes);
  return verb;
}

}  // namespace

PatternVerbs::PatternVerbs(CLI::App& app) {
  CLI::App* pattern = app.add_subcommand("pattern", "Pattern files: read them, write them");
  pattern->require_subcommand(1);
  import_ = add_pattern_import(*pattern, import_options_);
  layers_ = add_pattern_layers(*pattern, layers_options_);
  export_ = add_pattern_export(*pattern, export_options_);
}

std::optional<ExitCode> PatternVerbs::run() const {
  if (import_->parsed()) return pattern_import_command(import_options_);
  if (layers_->parsed()) return pattern_layers_command(layers_options_);
  if (export_->parsed()) return pattern_export_command(export_options_);
  return std::nullopt;
}

}  // namespace toile::app
