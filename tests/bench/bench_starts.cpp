// bench_starts DATA even|odd|NAME|SPECIFICATION.json|PROJECT.json… [--body OBJ] [--mm 20] [--runs 3] [--csv
// FILE] What a drape spends before its first step: processor seconds of reading, of meshing and looking at
// the start, and of putting the garment on, each the median of some runs; how many particles there are, and
// what was found worst. Garments as in bench_dressing; projects keep their own particle distance unless --mm
// is said.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "core/base/stopwatch.h"
#include "core/drape/drape_start.h"
#include "tests/bench/designs.h"

namespace {

namespace fs = std::filesystem;
using namespace toile;

struct Options {
  fs::path body, csv;
  std::vector<fs::path> garments;
  std::optional<double> mm;
  int runs = 3;
};

Options read_options(int count, char** arguments) {
  const fs::path data = arguments[1];
  Options o{data / "bodies/garmentcode-mean_all.obj", {}, {}, {}, 3};
  for (int i = 2; i < count; ++i) {
    const std::string a = arguments[i];
    const bool valued = i + 1 < count;
    if (a == "--body" && valued) {
      o.body = arguments[++i];
    } else if (a == "--mm" && valued) {
      o.mm = std::atof(arguments[++i]);
    } else if (a == "--runs" && valued) {
      o.runs = std::max(1, std::atoi(arguments[++i]));
    } else if (a == "--csv" && valued) {
      o.csv = arguments[++i];
    } else {
      const std::vector<fs::path> named = bench::garments_named(data, a);
      o.garments.insert(o.garments.end(), named.begin(), named.end());
    }
  }
  return o;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// name,particles,start,read_s,look_s,put_on_s
Result<std::string> timed_start(const Options& o, const fs::path& file) {
  std::vector<double> read, look, put_on;
  std::size_t particles = 0;
  std::string begins;
  for (int run = 0; run < o.runs; ++run) {
    const Stopwatch watch;
    drape::DrapeInput input = TRY(bench::garment_input(file, o.body));
    if (o.mm) input.settings.particle_distance = *o.mm * 1e-3;
    read.push_back(watch.cpu_s());
    drape::DrapeStart start = TRY(drape::prepare_start(input, {}));
    look.push_back(watch.cpu_s() - read.back());
    drape::dress_start(input, start, {});
    put_on.push_back(watch.cpu_s() - read.back() - look.back());
    particles = start.assembly.positions.size();
    begins = start.dressed ? "put on" : "from its pieces";
    if (const auto error = preflight::first_error(start.findings)) begins = error->code;
  }
  char text[100];
  std::snprintf(text, sizeof text, ",%.3f,%.3f,%.3f", median(read), median(look), median(put_on));
  return bench::name_of_garment(file) + "," + std::to_string(particles) + "," + begins + text;
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 3) {
    std::fprintf(stderr, "bench_starts DATA even|odd|NAME|PROJECT.json… see the head of its source\n");
    return 2;
  }
  const Options o = read_options(count, arguments);
  std::string all = "garment,particles,start,read_s,look_s,put_on_s\n";
  std::printf("%s", all.c_str());
  for (const fs::path& file : o.garments) {
    const Result<std::string> line = timed_start(o, file);
    const std::string told = line ? *line : bench::name_of_garment(file) + ": " + to_string(line.error());
    std::printf("%s\n", told.c_str());
    std::fflush(stdout);
    if (line) all += told + "\n";
  }
  if (!o.csv.empty()) std::ofstream(o.csv) << all;
}
