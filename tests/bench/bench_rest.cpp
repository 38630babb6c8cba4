// bench_rest DATA even|odd|NAME|SPECIFICATION.json|PROJECT.json… [--mm 20] [--seconds 1] [--damped] [--csv
// FILE] Is cloth at rest when a drape says so? Drapes each garment to its end and then lets it go: from a
// standstill, in true motion without damping (--damped: as the drape went), for one second or more. Prints a
// line for each with the largest and the RMS way that it went after each second, and what moved over 5 mm.
// Garments: the random GarmentCode designs of DATA/garmentcode/random on
// DATA/bodies/garmentcode-mean_all.obj, others of GarmentCode by their file, or projects with bodies of their
// own. Even designs are for tuning, odd ones for scores.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include "core/drape/checkpoint.h"
#include "core/drape/drape_start.h"
#include "core/drape/input_hash.h"
#include "core/drape/pipeline.h"
#include "tests/bench/designs.h"

namespace {

namespace fs = std::filesystem;
using namespace toile;

constexpr double kFar = 5e-3;  // m, that cloth at rest goes at most

struct Options {
  fs::path data, csv;
  std::vector<fs::path> garments;
  double mm = 20, seconds = 1, max_time = 0;
  bool damped = false;
};

Options read_options(int count, char** arguments) {
  Options o;
  o.data = arguments[1];
  for (int i = 2; i < count; ++i) {
    const std::string a = arguments[i];
    if (a == "--mm") {
      o.mm = std::atof(arguments[++i]);
    } else if (a == "--seconds") {
      o.seconds = std::atof(arguments[++i]);
    } else if (a == "--csv") {
      o.csv = arguments[++i];
    } else if (a == "--damped") {
      o.damped = true;
    } else {
      const auto named = bench::garments_named(o.data, a);
      o.garments.insert(o.garments.end(), named.begin(), named.end());
    }
  }
  return o;
}

/// A project keeps its own particle distance.
Result<drape::DrapeInput> input_of(const Options& o, const fs::path& file) {
  drape::DrapeInput input = TRY(bench::garment_input(file, o.data / "bodies/garmentcode-mean_all.obj"));
  if (file.string().ends_with("_specification.json")) input.settings.particle_distance = o.mm * 1e-3;
  return input;
}

/// The same drape as it ended, from a standstill and without an end.
Result<std::unique_ptr<drape::DrapeRun>> let_go(const drape::DrapeRun& ended, const drape::DrapeInput& free,
                                                const RunContext& context) {
  drape::RunState state = TRY(drape::decode_checkpoint(ended.checkpoint(), ended.start_hash()));
  state.session.phase = drape::DrapePhase::kDrape;
  state.session.stop_reason.reset();
  state.last_start = true;
  for (Vec3& v : state.session.solver.velocities) v = {};
  const drape::DrapeStart start = TRY(drape::prepare_start(free, context));
  return drape::DrapeRun::resume(
      free, drape::encode_checkpoint(drape::input_hash(free, start.placed), std::move(state)), context,
      nullptr);
}

struct Moved {
  double largest = 0, rms = 0, share = 0;  ///< m, m, of the vertices over kFar
};

Moved moved_between(std::span<const Vec3> from, std::span<const Vec3> to) {
  Moved m;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const double way = length(to[i] - from[i]);
    m.largest = std::max(m.largest, way);
    m.rms += way * way;
    m.share += way > kFar;
  }
  const double count = static_cast<double>(std::max<std::size_t>(1, from.size()));
  return {m.largest, std::sqrt(m.rms / count), m.share / count};
}

Status test_rest(const Options& o, const fs::path& file) {
  const RunContext context;
  const drape::DrapeInput input = TRY(input_of(o, file));
  const auto run = TRY(drape::DrapeRun::start(input, context, nullptr));
  run->advance(std::numeric_limits<int>::max(), context);
  const drape::DrapeResult end = run->conclude();
  std::string line = bench::name_of_garment(file) + "," + to_string(end.stop_reason) + ",";
  char text[200];
  std::snprintf(text, sizeof text, "%zu,%d,%.3f,%.2f,%.2f,%.1f,%d", end.positions.size(), end.steps,
                end.simulated_time, end.cpu_s, 1e3 * end.rms_speed, 1e3 * end.max_speed,
                end.worst.cloth_body + end.worst.cloth_cloth);
  line += text;

  drape::DrapeInput free = input;
  free.settings.until_settled = false;
  free.settings.max_time = std::numeric_limits<double>::max();
  if (!o.damped) free.settings.mode = drape::DrapeMode::kDynamic;
  const auto after = TRY(let_go(*run, free, context));
  const int a_second = static_cast<int>(std::lround(1 / input.settings.time_step));
  for (int s = 0; s < static_cast<int>(o.seconds); ++s) {
    after->advance(a_second, context);
    const Moved m = moved_between(end.positions, after->session().positions());
    std::snprintf(text, sizeof text, ",%.2f,%.2f,%.4f", 1e3 * m.largest, 1e3 * m.rms, m.share);
    line += text;
  }
  line += "\n";
  std::fputs(line.c_str(), stdout);
  std::fflush(stdout);
  if (o.csv.empty()) return {};
  std::FILE* table = std::fopen(o.csv.c_str(), "a");
  if (table == nullptr) return Error{"bench.csv", "the table cannot be written", o.csv.string()};
  std::fputs(line.c_str(), table);
  std::fclose(table);
  return {};
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 3) {
    std::fprintf(stderr, "bench_rest DATA even|odd|NUMBER|FILE… see the head of its source\n");
    return 2;
  }
  const Options o = read_options(count, arguments);
  std::printf(
      "garment,end,vertices,steps,simulated_s,cpu_s,rms_mm_s,fastest_mm_s,crossings,then for each second "
      "largest_mm,rms_mm,share_over_5mm\n");
  for (const fs::path& garment : o.garments) {
    if (const Status done = test_rest(o, garment); !done)
      std::printf("%s: %s\n", garment.c_str(), to_string(done.error()).c_str());
  }
}
