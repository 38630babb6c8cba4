// bench_table1 SAMPLES DIR [--runs 1]
// Table 1 of Kim and Park 2003 anew: blouse, jacket, slacks and skirt of SAMPLES, with as many particles and
// body triangles as theirs had, draped by our engine and by their method (core/paper). Leaves DIR/table.md,
// DIR/table.csv and DIR/NAME.jpg, front and side of both ends. Processor seconds are the median of the runs;
// all else is the same in each.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
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

/// A line of the paper's table; its seconds are of a Pentium 4 of 1.3 GHz.
struct PaperRow {
  const char* garment;
  int particles, body_triangles, seconds;
};
constexpr PaperRow kTable[] = {{"blouse", 3581, 4562, 35},
                               {"jacket", 4453, 5624, 47},
                               {"slacks", 5660, 2204, 36},
                               {"skirt", 3130, 3304, 24}};

struct Method {
  const char* words;
  drape::DrapeMethod method;
};
constexpr Method kMethods[] = {{"toile", drape::DrapeMethod::kToile}, {"paper", drape::DrapeMethod::kPaper}};

constexpr const char* kHead =
    "| garment | particles (the paper’s) | body triangles (the paper’s) | method | CPU s | simulated s | "
    "ended | "
    "worn | crossings cloth-body, cloth-cloth (worst frame) | seam gap mm | stretched 99 % warp, weft |\n"
    "|---|---|---|---|---|---|---|---|---|---|---|\n";
constexpr const char* kCsvHead =
    "garment,method,particles,paper_particles,body_triangles,paper_body_triangles,particle_distance_mm,cpu_s,"
    "simulated_s,steps,ended,worn,cloth_body,cloth_cloth,worst_cloth_body,worst_cloth_cloth,seam_gap_mm,"
    "warp_p99_percent,weft_p99_percent\n";

struct Tables {
  std::string markdown = kHead, csv = kCsvHead;
};

/// The document on a body of so many triangles; a body that is a file stays what it is.
Result<drape::DrapeInput> on_such_a_body(const fs::path& file, int triangles) {
  std::ifstream in(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  project::Project project = TRY(project::parse_project(text));
  for (project::ProjectBody& body : project.bodies)
    if (body.mannequin) body.mannequin->triangles = triangles;
  return resolve::resolve_project(project, resolve::files_in(file.parent_path(), {}));
}

/// Cut into triangles so that it has that many particles, as near as may be in a few tries.
Result<drape::DrapeInput> with_particles(drape::DrapeInput input, int particles) {
  constexpr int kTries = 8;
  constexpr double kNear = 0.005;
  double nearest = HUGE_VAL, best = input.settings.particle_distance;
  for (int i = 0; i < kTries && nearest > kNear; ++i) {
    const drape::DrapeStart start = TRY(drape::prepare_start(input, {}));
    const double share = static_cast<double>(start.assembly.positions.size()) / particles;
    if (std::abs(share - 1) < nearest) {
      nearest = std::abs(share - 1);
      best = input.settings.particle_distance;
    }
    input.settings.particle_distance *= std::sqrt(share);
  }
  input.settings.particle_distance = best;
  return input;
}

std::string words_of(const drape::CrossingCount& c, const char* between) {
  return std::to_string(c.cloth_body) + between + std::to_string(c.cloth_cloth);
}

void add_row(const PaperRow& row, const Method& method, double distance, const analysis::Report& r,
             Tables& to) {
  const std::string worn(drape::word_of(r.worn)), ended = drape::to_string(r.stop_reason);
  const std::string warp = fixed_text(100 * r.warp.tension.p99, 1),
                    weft = fixed_text(100 * r.weft.tension.p99, 1);
  to.markdown += std::string("| ") + row.garment + " | " + std::to_string(r.particles) + " (" +
                 std::to_string(row.particles) + ") | " + std::to_string(r.body_triangles) + " (" +
                 std::to_string(row.body_triangles) + ") | " + method.words + " | " + fixed_text(r.cpu_s, 1) +
                 " | " + fixed_text(r.simulated_s, 2) + " | " + ended + " | " + worn + " | " +
                 words_of(r.intersections, ", ") + " (" + words_of(r.worst_frame, ", ") + ") | " +
                 fixed_text(r.seam_gap_max_mm, 2) + " | " + warp + ", " + weft + " % |\n";
  to.csv += std::string(row.garment) + "," + method.words + "," + std::to_string(r.particles) + "," +
            std::to_string(row.particles) + "," + std::to_string(r.body_triangles) + "," +
            std::to_string(row.body_triangles) + "," + fixed_text(distance * 1e3, 2) + "," +
            fixed_text(r.cpu_s, 2) + "," + fixed_text(r.simulated_s, 3) + "," + std::to_string(r.steps) +
            "," + ended + "," + worn + "," + words_of(r.intersections, ",") + "," +
            words_of(r.worst_frame, ",") + "," + fixed_text(r.seam_gap_max_mm, 3) + "," + warp + "," + weft +
            "\n";
}

/// What the paper tells of it, below what was measured here.
void add_paper_row(const PaperRow& row, Tables& to) {
  to.markdown += std::string("| ") + row.garment + " | " + std::to_string(row.particles) + " | " +
                 std::to_string(row.body_triangles) + " | the paper’s own figures, Pentium 4 of 1.3 GHz | " +
                 std::to_string(row.seconds) + " | | | | | | |\n";
  to.csv += std::string(row.garment) + ",paper 2003 on a Pentium 4 of 1.3 GHz," +
            std::to_string(row.particles) + "," + std::to_string(row.particles) + "," +
            std::to_string(row.body_triangles) + "," + std::to_string(row.body_triangles) + ",," +
            std::to_string(row.seconds) + ",,,,,,,,,,,\n";
}

/// Drapes it `runs` times; the result's processor seconds are the median's.
Result<drape::DrapeResult> draped(const drape::DrapeInput& input, int runs) {
  drape::DrapeResult result;
  std::vector<double> seconds;
  for (int run = 0; run < runs; ++run) {
    result = TRY(drape::drape(input, {}, nullptr));
    seconds.push_back(result.cpu_s);
  }
  std::sort(seconds.begin(), seconds.end());
  result.cpu_s = seconds[seconds.size() / 2];
  return result;
}

Status measure(const PaperRow& row, const fs::path& samples, const fs::path& folder, int runs,
               Tables& tables) {
  const fs::path document = samples / row.garment / "project.json";
  drape::DrapeInput whole = TRY(on_such_a_body(document, row.body_triangles));
  whole = TRY(with_particles(drape::worn_part(std::move(whole)), row.particles));
  std::vector<image::Picture> ends;
  for (const Method& method : kMethods) {
    drape::DrapeInput input = whole;
    input.settings.method = method.method;
    const drape::DrapeResult result = TRY(draped(input, runs));
    const analysis::Report report = analysis::make_report(input, result);
    add_row(row, method, input.settings.particle_distance, report, tables);
    std::printf("%s, %s: %d particles, %d body triangles, %.1f s\n", row.garment, method.words,
                report.particles, report.body_triangles, report.cpu_s);
    std::fflush(stdout);
    for (const render::View view : {render::View::kFront, render::View::kSide})
      ends.push_back(TRY(bench::picture_of(input, result, view, 240, 320)));
  }
  add_paper_row(row, tables);
  return bench::write_jpeg(folder / (std::string(row.garment) + ".jpg"), bench::side_by_side(ends));
}

Status measure_all(const fs::path& samples, const fs::path& folder, int runs) {
  Tables tables;
  for (const PaperRow& row : kTable) TRY(measure(row, samples, folder, runs, tables));
  TRY(write_file(folder / "table.md", tables.markdown));
  return write_file(folder / "table.csv", tables.csv);
}

}  // namespace

int main(int count, char** arguments) {
  const bool with_runs = count == 5 && arguments[3] == std::string("--runs");
  if (count != 3 && !with_runs) {
    std::fprintf(stderr, "bench_table1 SAMPLES DIR [--runs 1]\n");
    return 2;
  }
  const int runs = with_runs ? std::max(1, std::atoi(arguments[4])) : 1;
  const Status done = measure_all(arguments[1], arguments[2], runs);
  if (done) return 0;
  std::fprintf(stderr, "%s\n", to_string(done.error()).c_str());
  return 1;
}
