// bench_proposals DATA even|odd|NAME… [--wrong] [--table FILE]: proposes seams for the random GarmentCode
// designs of DATA/garmentcode/random from their drawings alone, and compares them with the true ones: each
// file's precision and recall at 0.8, and how often seams told at a confidence are right. --wrong names what
// is wrong and missed; --table writes every proposal with its confidence and whether it is right.

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "core/base/stopwatch.h"
#include "core/pattern/seams/accept.h"
#include "core/project/create/create.h"
#include "tests/core/pattern/seams/seam_score.h"

namespace {

using namespace toile;
namespace fs = std::filesystem;

constexpr double kSure = 0.8;

/// Of the proposals whose confidence lies in one tenth.
struct CalibrationBin {
  int count = 0, right = 0;
  double told = 0;  ///< sum of their confidences
};

struct BenchTotal {
  test::SeamScore score;
  test::SeamScore worn;  ///< of what a garment takes to be worn (core/pattern/seams/accept.h)
  std::array<CalibrationBin, 10> bins;
  double seconds = 0;
};

struct BenchOptions {
  fs::path data;
  std::vector<std::string> which;
  bool wrong = false;
  std::string table;
};

std::string bytes_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

BenchOptions options_of(int argc, char** argv) {
  BenchOptions options;
  options.data = argc > 1 ? argv[1] : ".";
  for (int i = 2; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--wrong")
      options.wrong = true;
    else if (word == "--table" && i + 1 < argc)
      options.table = argv[++i];
    else
      options.which.push_back(word);
  }
  return options;
}

bool wanted(const std::string& name, const std::vector<std::string>& which) {
  const bool even = (name.back() - '0') % 2 == 0;
  for (const std::string& w : which)
    if (w == name || (w == "even" && even) || (w == "odd" && !even)) return true;
  return false;
}

std::set<fs::path> drawings(const BenchOptions& options) {
  std::set<fs::path> found;
  for (const auto& entry : fs::directory_iterator(options.data / "garmentcode" / "random"))
    if (entry.path().extension() == ".dxf" && wanted(entry.path().stem(), options.which))
      found.insert(entry.path());
  return found;
}

void count_bins(const std::vector<seams::SeamProposal>& proposals, const std::vector<bool>& right,
                BenchTotal& total) {
  for (std::size_t i = 0; i < proposals.size(); ++i) {
    const double told = proposals[i].confidence;
    CalibrationBin& bin = total.bins[std::min<std::size_t>(9, static_cast<std::size_t>(told * 10))];
    ++bin.count;
    bin.right += right[i];
    bin.told += told;
  }
}

Status bench_one(const fs::path& file, const BenchOptions& options, std::ofstream& table, BenchTotal& total) {
  create::NewProjectSettings settings;
  settings.name = file.stem();
  const Stopwatch watch;
  const create::NewProject made = TRY(create::new_project(bytes_of(file), settings));
  const double seconds = watch.cpu_s();
  fs::path truth_file = file;
  const std::vector<test::SewnPoints> truth =
      TRY(test::read_seams_by_ends(truth_file.replace_extension(".seams.json"), made.pattern));
  const test::SeamScore score = test::score_of(made.pattern, made.proposals, truth, kSure);
  const std::vector<bool> right = test::right_of(made.pattern, made.proposals, truth);
  std::printf("%-12s seams %2d proposed %2d right %2d found %2d precision %.2f recall %.2f %5.2f s\n",
              settings.name.c_str(), score.known, score.proposed, score.right, score.found, score.precision(),
              score.recall(), seconds);
  if (options.wrong) {
    for (const std::string& seam : score.wrong) std::printf("  wrong  %s\n", seam.c_str());
    for (const std::string& seam : score.missed) std::printf("  missed %s\n", seam.c_str());
  }
  for (std::size_t i = 0; i < right.size(); ++i)
    table << settings.name << '\t' << made.proposals[i].confidence << '\t' << right[i] << '\t'
          << test::points_of(made.pattern, made.proposals[i].seam).name << '\n';
  count_bins(made.proposals, right, total);
  const std::vector<bool> worn = seams::sewn_to_wear(made.pattern, made.proposals, kSure);
  std::vector<seams::SeamProposal> taken;
  for (std::size_t i = 0; i < worn.size(); ++i)
    if (worn[i]) taken.push_back(made.proposals[i]);
  total.worn.add(test::score_of(made.pattern, taken, truth, 0));
  total.score.add(score);
  total.seconds += seconds;
  return {};
}

void print_total(const BenchTotal& total) {
  std::printf("together: seams %d proposed %d right %d found %d precision %.3f recall %.3f, %.1f s\n",
              total.score.known, total.score.proposed, total.score.right, total.score.found,
              total.score.precision(), total.score.recall(), total.seconds);
  std::printf("to be worn: sewn %d right %d found %d precision %.3f recall %.3f\n", total.worn.proposed,
              total.worn.right, total.worn.found, total.worn.precision(), total.worn.recall());
  std::printf("told at      count  mean told  share right\n");
  for (std::size_t k = 0; k < total.bins.size(); ++k) {
    const CalibrationBin& bin = total.bins[k];
    if (bin.count == 0) continue;
    std::printf("%.1f to %.1f   %5d      %.2f       %.2f\n", 0.1 * static_cast<double>(k),
                0.1 * static_cast<double>(k + 1), bin.count, bin.told / bin.count,
                static_cast<double>(bin.right) / bin.count);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const BenchOptions options = options_of(argc, argv);
  BenchTotal total;
  std::ofstream table(options.table);
  for (const fs::path& file : drawings(options)) {
    const Status done = bench_one(file, options, table, total);
    if (!done) std::printf("%s: %s\n", file.c_str(), to_string(done.error()).c_str());
    std::fflush(stdout);
  }
  print_total(total);
}
