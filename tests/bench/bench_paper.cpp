// bench_paper OUT.csv PROJECT.json… [--rate 125,250] [--damping 0.02,0.1] [--passes 5,10] [--reflection
// 0,0.5]
//             [--start auto,sewn]
// The paper's method over each project, with every setting of the grid that the lists span (steps a second of
// simulated time; the rest as in core/paper/settings.h), a line a drape. What OUT.csv has already is kept.

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "core/analysis/report.h"
#include "core/base/text.h"
#include "core/drape/pipeline.h"
#include "core/drape/worn_part.h"
#include "core/project/resolve/resolve.h"

namespace {

using namespace toile;

struct Grid {
  std::vector<double> rates{250}, dampings{0.05}, passes{10}, reflections{0}, loads{2}, clearances{4};
  std::vector<std::string> starts{"auto"};
};

std::vector<std::string> parts_of(const std::string& list) {
  std::vector<std::string> parts;
  std::stringstream in(list);
  for (std::string part; std::getline(in, part, ',');) parts.push_back(part);
  return parts;
}

std::vector<double> numbers_of(const std::string& list) {
  std::vector<double> numbers;
  for (const std::string& part : parts_of(list)) numbers.push_back(std::atof(part.c_str()));
  return numbers;
}

constexpr const char* kHead =
    "garment,start,steps_per_s,damping,passes,reflection,load_n_m,clearance_mm,cpu_s,steps,simulated_s,stop,"
    "worn,cloth_body,"
    "cloth_cloth,worst_cloth_body,worst_cloth_cloth,seam_gap_mm,warp_stretch_p99,weft_stretch_p99,"
    "warp_push_p99,weft_push_p99,rms_speed_mm_s\n";

std::string line_of(const std::string& start, const drape::DrapeInput& input, const analysis::Report& r) {
  const paper::PaperSettings& p = input.settings.paper;
  std::ostringstream out;
  out << r.name << ',' << start << ',' << fixed_text(1 / p.time_step, 0) << ',' << p.damping << ','
      << p.passes << ',' << p.reflection << ',' << p.load << ',' << 1e3 * p.clearance << ','
      << fixed_text(r.cpu_s, 2) << ',' << r.steps << ',' << fixed_text(r.simulated_s, 2) << ','
      << drape::to_string(r.stop_reason) << ',' << drape::word_of(r.worn) << ',' << r.intersections.cloth_body
      << ',' << r.intersections.cloth_cloth << ',' << r.worst_frame.cloth_body << ','
      << r.worst_frame.cloth_cloth << ',' << fixed_text(r.seam_gap_max_mm, 2) << ','
      << fixed_text(r.warp.tension.p99, 4) << ',' << fixed_text(r.weft.tension.p99, 4) << ','
      << fixed_text(r.warp.compression.p99, 4) << ',' << fixed_text(r.weft.compression.p99, 4) << ','
      << fixed_text(1e3 * r.rms_speed, 1) << '\n';
  return out.str();
}

void try_one(const drape::DrapeInput& input, const std::string& start, std::ofstream& out) {
  const auto result = drape::drape(input, {}, nullptr);
  if (!result) {
    std::printf("%s, %s: %s\n", input.name.c_str(), start.c_str(), to_string(result.error()).c_str());
    return;
  }
  const std::string line = line_of(start, input, analysis::make_report(input, *result));
  std::printf("%s", line.c_str());
  std::fflush(stdout);
  out << line << std::flush;
}

void search(const drape::DrapeInput& project, const Grid& grid, std::ofstream& out) {
  for (const std::string& start : grid.starts) {
    drape::DrapeInput input = project;
    input.settings.method = drape::DrapeMethod::kPaper;
    input.settings.dress = start == "auto";
    input = drape::worn_part(std::move(input));
    for (const double rate : grid.rates)
      for (const double damping : grid.dampings)
        for (const double passes : grid.passes)
          for (const double reflection : grid.reflections)
            for (const double load : grid.loads)
              for (const double clearance : grid.clearances) {
                input.settings.paper = {1 / rate,   damping, static_cast<int>(passes),
                                        reflection, load,    1e-3 * clearance};
                try_one(input, start, out);
              }
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 3) return std::puts("bench_paper OUT.csv PROJECT.json… [--rate …] …"), 2;
  Grid grid;
  std::vector<std::filesystem::path> projects;
  for (int i = 2; i < count; ++i) {
    const std::string a = arguments[i];
    const auto next = [&] { return std::string(i + 1 < count ? arguments[++i] : ""); };
    if (a == "--rate") {
      grid.rates = numbers_of(next());
    } else if (a == "--damping") {
      grid.dampings = numbers_of(next());
    } else if (a == "--passes") {
      grid.passes = numbers_of(next());
    } else if (a == "--reflection") {
      grid.reflections = numbers_of(next());
    } else if (a == "--load") {
      grid.loads = numbers_of(next());
    } else if (a == "--clearance") {
      grid.clearances = numbers_of(next());
    } else if (a == "--start") {
      grid.starts = parts_of(next());
    } else {
      projects.emplace_back(a);
    }
  }
  const bool fresh = !std::filesystem::exists(arguments[1]);
  std::ofstream out(arguments[1], std::ios::app);
  if (fresh) out << kHead;
  for (const auto& path : projects) {
    const auto read = resolve::read_project(path);
    if (!read) return std::printf("%s\n", to_string(read.error()).c_str()), 2;
    search(read->input, grid, out);
  }
}
