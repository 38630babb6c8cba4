#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "core/base/text.h"
#include "core/base/write_file.h"
#include "core/pattern/dxf/read.h"
#include "core/print/paper.h"
#include "core/project/create/create.h"
#include "core/project/create/import_report.h"
#include "core/project/resolve/resolve.h"
#include "server/app/commands.h"
#include "server/app/console.h"
#include "server/app/layer_option.h"
#include "server/app/mesh_reader.h"
#include "server/app/pattern_bytes.h"
#include "server/documents/pattern_file.h"

namespace toile::app {
namespace {

Result<dxf::DxfSettings> settings_of(const PatternImportOptions& options) {
  dxf::DxfSettings settings;
  settings.layers = TRY(read_layers(options.layers));
  if (options.unit == "mm") settings.mm_per_unit = 1;
  if (options.unit == "cm") settings.mm_per_unit = 10;
  if (options.unit == "inch") settings.mm_per_unit = 25.4;
  if (!options.size.empty()) settings.size = options.size;
  return settings;
}

Error in_file(Error error, const std::string& file) {
  error.where = file + (error.where.empty() ? "" : ": " + error.where);
  return error;
}

std::string join(const std::vector<std::string>& list) {
  std::string all;
  for (const std::string& text : list) all += (all.empty() ? "" : ", ") + text;
  return all;
}

void print_piece(const dxf::DxfPiece& piece) {
  const Result<pattern::Panel> panel = dxf::panel_from_piece(piece);
  if (!panel) {
    std::printf("piece %s: cannot be cut: %s\n", piece.name.c_str(), to_string(panel.error()).c_str());
    return;
  }
  const create::PieceMeasures m = create::measures_of(*panel);
  std::string more;
  if (!piece.size.empty()) more += ", size " + piece.size;
  if (piece.quantity > 1) more += ", cut " + std::to_string(piece.quantity) + " times";
  if (piece.mirrored > 0) more += " (" + std::to_string(piece.mirrored) + " turned over)";
  if (piece.unfolded) more += ", unfolded";
  if (!panel->notches.empty()) more += ", " + std::to_string(panel->notches.size()) + " notches";
  if (!panel->lines.empty()) more += ", " + std::to_string(panel->lines.size()) + " lines within";
  if (!panel->holes.empty()) more += ", " + std::to_string(panel->holes.size()) + " holes";
  std::printf(
      "piece %s: %s x %s mm, %s cm2, %zu edges%s, %s line, grain %s (line %d)\n", piece.name.c_str(),
      fixed_text(m.width_mm, 1).c_str(), fixed_text(m.height_mm, 1).c_str(),
      fixed_text(m.area_mm2 * 1e-2, 1).c_str(), panel->outline.edges.size(), more.c_str(),
      piece.on_sew_line ? "sew" : "cut",
      piece.grain ? (fixed_text(create::grain_degrees(*piece.grain), 1) + " deg").c_str() : "not told",
      piece.line);
}

Error no_layers(const std::string& file) {
  return {"pattern.no_layers", "a GarmentCode specification has no layers", file};
}

void print_layer(const dxf::DxfLayerUse& layer) {
  std::string kinds;
  for (const auto& [type, count] : layer.kinds)
    kinds += (kinds.empty() ? "" : ", ") + std::to_string(count) + " " + type;
  std::printf("layer %s: %s, read as %s%s\n", layer.name.c_str(), kinds.c_str(),
              std::string(dxf::read_as(layer)).c_str(), layer.given ? " (as told)" : "");
}

void print_drawing(const dxf::DxfDrawing& drawing) {
  if (!drawing.style.empty()) std::printf("%s\n", drawing.style.c_str());
  std::printf("unit %s, confidence %s\n", drawing.unit.name.c_str(),
              fixed_text(drawing.unit.confidence, 2).c_str());
  for (const std::string& evidence : drawing.unit.evidence) std::printf("  %s\n", evidence.c_str());
  if (drawing.sizes.size() > 1)
    std::printf("size %s of %s\n", drawing.size.c_str(), join(drawing.sizes).c_str());
  for (const dxf::DxfLayerUse& layer : drawing.layers)
    if (layer.given) print_layer(layer);
  for (const dxf::DxfPiece& piece : drawing.pieces) print_piece(piece);
  const dxf::DxfReport& r = drawing.report;
  std::printf("entities: %zu in the file, %zu kept, %zu converted, %zu dropped (--json lists them)\n",
              r.entities, r.kept, r.converted, r.dropped);
  for (const dxf::DxfWarning& warning : r.warnings)
    std::printf("warning: %s\n", dxf::warning_text(warning).c_str());
}

void print_specification(const create::NewProject& made) {
  for (const pattern::Panel& panel : made.pattern.panels) {
    const create::PieceMeasures m = create::measures_of(panel);
    std::printf("piece %s: %s x %s mm, %s cm2, %zu edges\n", panel.id.c_str(),
                fixed_text(m.width_mm, 1).c_str(), fixed_text(m.height_mm, 1).c_str(),
                fixed_text(m.area_mm2 * 1e-2, 1).c_str(), panel.outline.edges.size());
  }
  std::printf("%zu pieces and %zu seams, with their places\n", made.pattern.panels.size(),
              made.pattern.seams.size());
  for (const std::string& note : made.notes) std::printf("note: %s\n", note.c_str());
}

ExitCode import_specification(const std::string& text, const PatternImportOptions& options) {
  if (!options.layers.empty()) return fail(no_layers(options.file), options.json);
  const Result<create::NewProject> made = create::new_project(text, {});
  if (!made) return fail(in_file(made.error(), options.file), options.json);
  if (options.json) {
    std::printf("%s", json::write_json(
                          create::specification_json(made->pattern, create::seams_json(*made), made->notes))
                          .c_str());
  } else {
    print_specification(*made);
  }
  return kDone;
}

/// None while a piece cannot be cut: the report tells of it.
std::vector<json::JsonValue> proposals_of(const dxf::DxfDrawing& drawing) {
  const Result<create::NewProject> made = create::new_project(drawing, {});
  return made ? create::seams_json(*made) : std::vector<json::JsonValue>{};
}

/// As the file's name ends; DXF where it tells nothing else.
documents::PatternFormat pattern_format_of(const std::string& file) {
  const std::string ending = lower_case(std::filesystem::path(file).extension().string());
  if (ending == ".svg") return documents::PatternFormat::kSvg;
  if (ending == ".pdf") return documents::PatternFormat::kPdf;
  return documents::PatternFormat::kDxf;
}

}  // namespace

ExitCode pattern_import_command(const PatternImportOptions& options) {
  const Result<std::string> text = pattern_bytes(options.file);
  if (!text) return fail(text.error(), options.json);
  if (create::is_specification(*text)) return import_specification(*text, options);
  const Result<dxf::DxfSettings> settings = settings_of(options);
  if (!settings) return fail(settings.error(), options.json);
  const Result<dxf::DxfDrawing> drawing = dxf::read_dxf(*text, *settings);
  if (!drawing)
    return fail(in_file(with_way_out(drawing.error(), *text, options.file), options.file), options.json);
  if (options.json) {
    const std::vector<json::JsonValue> seams =
        options.no_seams ? std::vector<json::JsonValue>{} : proposals_of(*drawing);
    std::printf("%s", json::write_json(create::import_json(*drawing, seams)).c_str());
  } else {
    print_drawing(*drawing);
  }
  return kDone;
}

ExitCode pattern_layers_command(const PatternLayersOptions& options) {
  const Result<std::string> text = pattern_bytes(options.file);
  if (!text) return fail(text.error(), options.json);
  if (create::is_specification(*text)) return fail(no_layers(options.file), options.json);
  dxf::DxfSettings settings;
  const Result<dxf::DxfLayerMap> given = read_layers(options.layers);
  if (!given) return fail(given.error(), options.json);
  settings.layers = *given;
  const Result<std::vector<dxf::DxfLayerUse>> layers = dxf::read_dxf_layers(*text, settings);
  if (!layers) return fail(in_file(layers.error(), options.file), options.json);
  if (options.json) {
    std::printf("%s", json::write_json(std::vector<json::JsonMember>{
                                           {"file", options.file}, {"layers", create::layers_json(*layers)}})
                          .c_str());
  } else {
    for (const dxf::DxfLayerUse& layer : *layers) print_layer(layer);
  }
  return kDone;
}

ExitCode pattern_export_command(const PatternExportOptions& options) {
  const Result<resolve::ResolvedProject> read = resolve::read_project(options.project, own_mesh_importer());
  if (!read) return fail(read.error(), options.json);
  const pattern::Pattern& pattern = read->input.pattern;
  const Result<std::string> text = documents::pattern_file(
      pattern, read->project.name, pattern_format_of(options.out), *print::paper_named(options.paper));
  if (!text) return fail(text.error(), options.json);
  if (Status written = write_file(options.out, *text); !written) return fail(written.error(), options.json);
  const std::size_t pieces = pattern.panels.size();
  if (options.json) {
    std::printf("%s", json::write_json(std::vector<json::JsonMember>{{"file", options.out},
                                                                     {"pieces", static_cast<double>(pieces)}})
                          .c_str());
  } else {
    std::printf("%s: %zu pieces, millimetres\n", options.out.c_str(), pieces);
  }
  return kDone;
}

}  // namespace toile::app
