// compare_paper DIR PROJECT.json…
// Drapes each project by our engine and by the paper's method (core/paper), from the same start and sewn from
// where the pieces stand, and leaves DIR/table.md and a picture of the ends side by side for each.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "core/analysis/report.h"
#include "core/base/text.h"
#include "core/base/write_file.h"
#include "core/drape/pipeline.h"
#include "core/drape/worn_part.h"
#include "core/project/resolve/resolve.h"
#include "garment_picture.h"

namespace {

using namespace toile;
namespace fs = std::filesystem;

struct Way {
  const char* words;
  drape::DrapeMethod method;
  bool dress;
};
constexpr Way kWays[] = {{"toile", drape::DrapeMethod::kToile, true},
                         {"paper", drape::DrapeMethod::kPaper, true},
                         {"paper, sewn from where the pieces stand", drape::DrapeMethod::kPaper, false}};

constexpr const char* kHead =
    "| garment | solver | CPU s | steps | simulated s | ended | worn | crossings cloth-body, cloth-cloth "
    "(worst frame) | seam gap mm | stretched, pushed 99 % warp | weft |\n"
    "|---|---|---|---|---|---|---|---|---|---|---|\n";

std::string percent(double share) { return fixed_text(100 * share, 1); }

std::string strain_text(const analysis::StretchFigures& f) {
  return percent(f.tension.p99) + ", " + percent(f.compression.p99) + " %";
}

std::string row_of(const Way& way, const analysis::Report& r) {
  const auto count = [](const drape::CrossingCount& c) {
    return std::to_string(c.cloth_body) + ", " + std::to_string(c.cloth_cloth);
  };
  return "| " + r.name + " | " + way.words + " | " + fixed_text(r.cpu_s, 1) + " | " +
         std::to_string(r.steps) + " | " + fixed_text(r.simulated_s, 2) + " | " +
         drape::to_string(r.stop_reason) + " | " + std::string(drape::word_of(r.worn)) + " | " +
         count(r.intersections) + " (" + count(r.worst_frame) + ") | " + fixed_text(r.seam_gap_max_mm, 2) +
         " | " + strain_text(r.warp) + " | " + strain_text(r.weft) + " |\n";
}

/// Whether the garment is put on before it is draped: else both starts of the paper's method are one.
bool put_on_first(const drape::DrapeInput& input) {
  const auto run = drape::DrapeRun::start(input, {}, nullptr);
  return run && (*run)->session().began() == drape::Began::kDressed;
}

Status compare(const fs::path& project, const fs::path& folder, std::string& table) {
  const resolve::ResolvedProject read = TRY(resolve::read_project(project));
  std::vector<image::Picture> ends;
  for (const Way& way : kWays) {
    drape::DrapeInput input = read.input;
    input.settings.method = way.method;
    input.settings.dress = way.dress;
    input = drape::worn_part(std::move(input));
    if (!way.dress && !put_on_first(drape::worn_part(read.input))) continue;
    const drape::DrapeResult result = TRY(drape::drape(input, {}, nullptr));
    const std::string row = row_of(way, analysis::make_report(input, result));
    std::printf("%s", row.c_str());
    std::fflush(stdout);
    table += row;
    for (const render::View view : {render::View::kFront, render::View::kSide})
      ends.push_back(TRY(bench::picture_of(input, result, view, 240, 320)));
  }
  return bench::write_jpeg(folder / (project.parent_path().filename().string() + ".jpg"),
                           bench::side_by_side(ends));
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 3) return std::puts("compare_paper DIR PROJECT.json…"), 2;
  const fs::path folder = arguments[1];
  std::string table = kHead;
  for (int i = 2; i < count; ++i) {
    if (const Status done = compare(arguments[i], folder, table); !done)
      return std::printf("%s\n", to_string(done.error()).c_str()), 1;
  }
  if (const Status written = write_file(folder / "table.md", table); !written)
    return std::printf("%s\n", to_string(written.error()).c_str()), 1;
}
