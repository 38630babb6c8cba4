#include <chrono>
#include <string>
#include <thread>

#include "tests/bench/service/gates.h"
#include "tests/bench/service/house.h"
#include "tests/bench/service/visitor.h"

namespace toile::bench {
namespace {

/// Waits until nothing is queued or runs.
void wait_for_all(Visitor& visitor) {
  for (;;) {
    const json::JsonValue left = visitor.get("/api/v1/jobs?state=queued,running&limit=1");
    const json::JsonValue* jobs = left.find("jobs");
    if (!jobs || !jobs->array()) give_up("a list of jobs has none");
    if (jobs->array()->empty()) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(25));
  }
}

/// Seconds that `count` drapes of a cloth take on so many workers, from the first submission to the last end.
double seconds_of(const House& house, const Cloth& cloth, int count, const char* manner) {
  Visitor visitor(house.url());
  const std::string project = visitor.project(cloth);
  visitor.wait_for(visitor.submit(project, manner));  // what is made once is made
  const double before = now_s();
  for (int i = 0; i < count; ++i) visitor.submit(project, manner);
  wait_for_all(visitor);
  return now_s() - before;
}

double seconds_on(int workers, const Cloth& cloth, int count, const char* manner) {
  const House house({"--workers", std::to_string(workers)});
  return seconds_of(house, cloth, count, manner);
}

}  // namespace

Figures light_gate(const Scale& scale) {
  const Cloth tiny{200, 35, 1};
  const int count = 60 * scale.times;
  const House house({"--workers", "1"});
  const double worked = house.worked_s();
  const double took = seconds_of(house, tiny, count, kPlain);
  const double cores = house.worked_s() - worked;
  const std::string note = std::to_string(count) + " drapes of 49 particles and 3000 steps";
  return {{"light", "drapes a second on one worker", count / took, "1/s", Asked::kAtLeast, 5, load_average(),
           note},
          {"light", "drapes a processor second of the server", (count + 1) / cores, "1/s", Asked::kAtLeast, 5,
           load_average(), note}};
}

Figures workers_gate(const Scale& scale) {
  const Cloth cloth{600, 16, 2};
  Figures figures;
  for (const auto& [manner, what] :
       {std::pair{kPlain, "without pictures"}, std::pair{kAnew, "with pictures"}}) {
    std::vector<double> ratios;
    for (int i = 0; i < scale.times; ++i)
      ratios.push_back(seconds_on(1, cloth, 8, manner) / seconds_on(2, cloth, 8, manner));
    figures.push_back({"workers", std::string("time on one over time on two, 8 drapes ") + what,
                       percentile(ratios, 0.5), "", Asked::kAtLeast, 1.8, load_average(),
                       "median of " + std::to_string(scale.times)});
  }
  return figures;
}

}  // namespace toile::bench
