#include "server/app/sweep_table.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/names.h"
#include "core/base/read_file.h"
#include "core/base/text.h"
#include "core/base/write_file.h"
#include "core/image/reduce.h"
#include "core/sweep/contact_sheet.h"
#include "server/movie/draw_svg.h"

namespace toile::app {
namespace {

namespace fs = std::filesystem;

std::string plain(const std::string& label) {
  std::string out;
  for (const char c : label) {
    const bool kept = std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '.';
    out += kept && !(c == '.' && out.empty()) ? c : '-';
  }
  return out.substr(0, 60);
}

/// Of the cells in their order; empty where there is none.
std::vector<std::string> stills_of(const sweep::Table& table, const fs::path& folder) {
  std::vector<std::string> stills;
  for (const std::string& body : table.bodies) {
    for (const std::string& fabric : table.fabrics) {
      const std::optional<std::string> bytes = read_file(folder / cell_folder(body, fabric) / "front.png");
      const Result<std::string> small =
          bytes ? image::reduced_png(*bytes, sweep::kStillWidth) : Result<std::string>(std::string());
      stills.push_back(small ? *small : std::string());
    }
  }
  return stills;
}

std::string ease_text(const std::optional<sweep::Ease>& ease) {
  return ease ? fixed_text(ease->ease_mm / 10, 1) : "-";
}

ExitCode exit_code_of(const sweep::Cell& cell) {
  if (cell.state == "cancelled") return kCancelled;
  if (!cell.figures) return kBadInput;
  if (!cell.figures->settled) return kUnsettled;
  return cell.figures->worn == "no" ? kNotWorn : kDone;
}

}  // namespace

std::string cell_folder(const std::string& body, const std::string& fabric) {
  return plain(body) + "_" + plain(fabric);
}

std::string table_json(const sweep::Table& table) {
  std::vector<json::JsonValue> cells;
  for (std::size_t body = 0; body < table.bodies.size(); ++body)
    for (std::size_t fabric = 0; fabric < table.fabrics.size(); ++fabric)
      cells.push_back(sweep::cell_json(table, body, fabric));
  return json::write_json(std::vector<json::JsonMember>{{"name", table.name}, {"cells", std::move(cells)}});
}

Status write_table(const sweep::Table& table, const fs::path& folder) {
  TRY(write_file(folder / "table.csv", sweep::table_csv(table)));
  TRY(write_file(folder / "table.json", table_json(table)));
  const sweep::ContactSheet sheet = sweep::contact_sheet(table, stills_of(table, folder));
  const fs::path drawing = folder / "sheet.svg";
  TRY(write_file(drawing, sheet.svg));
  const Status drawn = movie::draw_svg(drawing, folder / "sheet.png", sheet.width);
  if (!drawn) std::fprintf(stderr, "toile: no sheet.png: %s\n", to_string(drawn.error()).c_str());
  std::error_code ignored;
  if (drawn) fs::remove(drawing, ignored);  // browsers show it as well, where there is no ffmpeg
  return {};
}

void print_table(const sweep::Table& table) {
  std::printf("%s\n", clipped(table.name).c_str());
  std::printf("  %-20s %-20s %-12s %-8s %6s %6s %6s %7s %5s\n", "body", "fabric", "end", "worn", "bust",
              "waist", "hip", "weft", "cpu");
  for (std::size_t body = 0; body < table.bodies.size(); ++body) {
    for (std::size_t fabric = 0; fabric < table.fabrics.size(); ++fabric) {
      const sweep::Cell& cell = table.at(body, fabric);
      std::printf("  %-20s %-20s ", clipped(table.bodies[body], 20).c_str(),
                  clipped(table.fabrics[fabric], 20).c_str());
      if (!cell.figures) {
        std::printf("%s %s\n", cell.state.c_str(), clipped(cell.reason, 200).c_str());
        continue;
      }
      const sweep::Figures& f = *cell.figures;
      std::printf(
          "%-12s %-8s %6s %6s %6s %6s%% %4ss\n", f.settled ? "settled" : clipped(f.stop_reason, 12).c_str(),
          f.worn.empty() ? "-" : f.worn.c_str(), ease_text(f.bust).c_str(), ease_text(f.waist).c_str(),
          ease_text(f.hip).c_str(), fixed_text(100 * f.weft_p99, 2).c_str(), fixed_text(f.cpu_s, 0).c_str());
    }
  }
}

ExitCode exit_code_of(const sweep::Table& table) {
  for (const ExitCode code : {kBadInput, kCancelled, kNotWorn, kUnsettled})
    if (std::any_of(table.cells.begin(), table.cells.end(),
                    [&](const sweep::Cell& cell) { return exit_code_of(cell) == code; }))
      return code;
  return kDone;
}

}  // namespace toile::app
