// The service's gates that are figures, measured on the real server over the loopback.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "core/base/text.h"
#include "tests/bench/service/gates.h"
#include "tests/bench/service/visitor.h"

namespace {

using namespace toile::bench;

struct Gate {
  const char* name;
  Figures (*measure)(const Scale&);
};

constexpr Gate kGates[] = {
    {"submit", submit_gate},     {"light", light_gate},     {"interactive", interactive_gate},
    {"fairness", fairness_gate}, {"workers", workers_gate}, {"viewers", viewers_gate},
    {"memory", memory_gate}};

constexpr const char* kUsage =
    "Usage: bench_service [GATE…] [--times N] [--soak MINUTES] [--csv FILE]\n"
    "Gates: submit light interactive fairness workers viewers memory (default: all)\n"
    "Ends with 1 when a figure misses what is asked, with 2 when something cannot be measured.\n";

struct Options {
  std::vector<Gate> gates;
  Scale scale;
  std::string csv;
};

[[noreturn]] void explain(const std::string& word) {
  std::fputs(kUsage, stderr);
  give_up("does not know " + word);
}

Options read_options(const std::vector<std::string>& words) {
  Options options;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool takes = words[i] == "--times" || words[i] == "--soak" || words[i] == "--csv";
    if (takes && i + 1 == words.size()) explain(words[i] + " without a value");
    if (words[i] == "--times") {
      options.scale.times = std::max(1, std::atoi(words[++i].c_str()));
    } else if (words[i] == "--soak") {
      options.scale.soak_minutes = std::max(0.5, std::atof(words[++i].c_str()));
    } else if (words[i] == "--csv") {
      options.csv = words[++i];
    } else {
      const auto* const found = std::find_if(std::begin(kGates), std::end(kGates),
                                             [&](const Gate& gate) { return words[i] == gate.name; });
      if (found == std::end(kGates)) explain(words[i]);
      options.gates.push_back(*found);
    }
  }
  if (options.gates.empty()) options.gates.assign(std::begin(kGates), std::end(kGates));
  return options;
}

}  // namespace

int main(int count, char** words) {
  const Options options = read_options({words + 1, words + count});
  std::ofstream csv;
  if (!options.csv.empty()) {
    csv.open(options.csv);
    csv << kCsvHead;
  }
  bool all_hold = true;
  std::fputs(kTableHead, stdout);
  for (const Gate& gate : options.gates) {
    for (const Figure& figure : gate.measure(options.scale)) {
      std::fputs(table_line(figure).c_str(), stdout);
      std::fflush(stdout);
      csv << csv_line(figure) << std::flush;
      all_hold = all_hold && figure.holds();
    }
  }
  return all_hold ? 0 : 1;
}
