// One garment on several bodies and of several fabrics, on this machine. What a server does of it stands in
// sweep_afar.cpp.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "core/base/names.h"
#include "core/base/read_file.h"
#include "core/base/write_file.h"
#include "core/project/resolve/resolve.h"
#include "core/sweep/variants.h"
#include "server/app/bring_file.h"
#include "server/app/commands.h"
#include "server/app/console.h"
#include "server/app/sweep_afar.h"
#include "server/app/sweep_bodies.h"
#include "server/app/sweep_table.h"
#include "server/documents/used_files.h"

namespace toile::app {
namespace {

namespace fs = std::filesystem;

/// A row or a column: what it is called, and the project made so.
struct Side {
  std::string label;
  BodyWord body;
  std::string fabric;  ///< empty: as the project is cut
};

struct LocalSweep {
  fs::path folder;  ///< of the project's files
  project::Project project;
  std::vector<Side> bodies, fabrics;
};

Status check_label(const std::vector<Side>& there, const std::string& label) {
  const bool taken =
      std::any_of(there.begin(), there.end(), [&](const Side& side) { return side.label == label; });
  if (!taken) return {};
  return Error{"sweep.duplicate", "it was said twice", label};
}

std::string own_body_name(const project::Project& project) {
  return project.bodies.empty() ? "-" : sweep::name_of(project.bodies.front());
}

project::ProjectBody body_of(const project::Project& project, const BodyWord& word) {
  project::ProjectBody body;
  body.id = sweep::main_body(project);
  body.mannequin = word.mannequin;
  body.file = fs::path(word.file).filename().string();
  return body;
}

Result<LocalSweep> read_sweep(const SweepOptions& options) {
  LocalSweep sweep;
  const std::string text = TRY(resolve::read_project_text(options.project));
  sweep.project = TRY(project::parse_project(text));
  sweep.folder = fs::path(options.project).parent_path();
  for (const std::string& said : options.bodies) {
    Side side;
    side.body = TRY(read_body_word(said));
    side.label =
        side.body.own ? own_body_name(sweep.project) : sweep::name_of(body_of(sweep.project, side.body));
    TRY(check_label(sweep.bodies, side.label));
    sweep.bodies.push_back(std::move(side));
  }
  for (const std::string& said : options.fabrics) {
    Side side;
    side.fabric = said == "own" ? "" : said;
    side.label = said == "own" ? sweep::main_fabric(sweep.project) : said;
    TRY(check_label(sweep.fabrics, side.label));
    if (!side.fabric.empty()) TRY(sweep::cut_of(sweep.project, side.fabric));
    sweep.fabrics.push_back(std::move(side));
  }
  return sweep;
}

/// The cell's document, with the files that it names beside it, so that it can be draped, looked at and
/// verified by itself.
Status write_cell(const LocalSweep& sweep, const Side& body, const Side& fabric, const fs::path& folder) {
  project::Project cell = sweep.project;
  const project::ProjectBody worn = body_of(sweep.project, body.body);
  if (!body.body.own) cell = TRY(sweep::worn_by(cell, worn));
  if (!fabric.fabric.empty()) cell = TRY(sweep::cut_of(std::move(cell), fabric.fabric));
  std::error_code ignored;
  fs::create_directories(folder, ignored);  // write_file says what is wrong with it
  TRY(write_file(folder / "project.json", project::write_project(cell)));
  for (const documents::UsedFile& file : documents::used_files(cell)) {
    TRY(resolve::check_file_name(file.name));
    const bool is_row = !body.body.file.empty() && file.kind == "body" && file.name == worn.file;
    TRY(bring_file(is_row ? fs::path(body.body.file) : sweep.folder / file.name, folder, file.name));
  }
  return {};
}

sweep::Cell cell_from(const fs::path& folder, ExitCode code) {
  sweep::Cell cell;
  cell.fraction = 1;
  cell.state = code == kCancelled                       ? "cancelled"
               : code == kInternal || code == kBadInput ? "failed"
                                                        : "succeeded";
  const std::optional<std::string> text = read_file(folder / "report.json");
  const Result<json::JsonValue> report = json::parse_json(text ? *text : "");
  if (report && cell.state == "succeeded") cell.figures = sweep::figures_of(*report);
  if (cell.figures) cell.reason_code = cell.figures->stop_reason;
  if (!cell.figures) cell.reason = "see what was said of it above";
  cell.pictured = cell.figures.has_value();
  return cell;
}

/// One after the other; what an interrupt cuts off ends the rest as well.
Result<sweep::Table> drape_all(const LocalSweep& sweep, const SweepOptions& options) {
  sweep::Table table;
  table.name = sweep.project.name;
  for (const Side& side : sweep.bodies) table.bodies.push_back(side.label);
  for (const Side& side : sweep.fabrics) table.fabrics.push_back(side.label);
  const std::size_t cells = sweep.bodies.size() * sweep.fabrics.size();
  bool over = false;
  for (const Side& body : sweep.bodies) {
    for (const Side& fabric : sweep.fabrics) {
      const fs::path folder = fs::path(options.out) / cell_folder(body.label, fabric.label);
      TRY(write_cell(sweep, body, fabric, folder));
      std::fprintf(stderr, "%zu/%zu %s, %s\n", table.cells.size() + 1, cells, clipped(body.label).c_str(),
                   clipped(fabric.label).c_str());
      DrapeOptions drape;
      drape.project = (folder / "project.json").string();
      drape.out = folder.string();
      drape.quiet = true;
      const ExitCode code = over ? kCancelled : drape_command(drape);
      over = over || code == kCancelled;
      table.cells.push_back(cell_from(folder, code));
    }
  }
  return table;
}

/// Folders of two cells must not be one.
Status check_folders(const LocalSweep& sweep) {
  std::map<std::string, std::string> taken;
  for (const Side& body : sweep.bodies) {
    for (const Side& fabric : sweep.fabrics) {
      const std::string cell = body.label + ", " + fabric.label;
      const auto [at, anew] = taken.emplace(cell_folder(body.label, fabric.label), cell);
      if (!anew)
        return Error{
            "sweep.duplicate",
            "two cells would have the folder " + in_quotes(at->first) + ": " + at->second + " and " + cell,
            ""};
    }
  }
  return {};
}

Result<sweep::Table> sweep_here(const SweepOptions& options) {
  const LocalSweep sweep = TRY(read_sweep(options));
  TRY(check_folders(sweep));
  return drape_all(sweep, options);
}

}  // namespace

ExitCode sweep_command(const SweepOptions& options) {
  if (!options.server_said.empty()) return sweep_afar(options);
  const Result<sweep::Table> table = sweep_here(options);
  if (!table) return fail(table.error(), options.json);
  if (Status written = write_table(*table, options.out); !written) return fail(written.error(), options.json);
  options.json ? static_cast<void>(std::printf("%s", table_json(*table).c_str())) : print_table(*table);
  return exit_code_of(*table);
}

}  // namespace toile::app
