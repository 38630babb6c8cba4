#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "core/base/text.h"
#include "tests/bench/service/crowd.h"
#include "tests/bench/service/gates.h"
#include "tests/bench/service/house.h"
#include "tests/bench/service/visitor.h"

namespace toile::bench {
namespace {

/// What people do, once: a project, its drape with a viewer, what it left, and all of it removed.
void visit(const House& house, int number) {
  Visitor visitor(house.url());
  const std::string project = visitor.project(Cloth{200 + number % 40, 30, 0.3});
  const std::string job = visitor.submit(project, number % 4 == 0 ? kAnew : kPlain);
  {
    const Crowd viewer(house.port(), job, 1, true);
    visitor.wait_for(job);
  }
  for (const char* result : {"report.json", "drape.film", "final.glb"})
    visitor.ask("GET", "/api/v1/jobs/" + job + "/results/" + result);
  visitor.get("/api/v1/jobs?limit=20");
  visitor.get("/api/v1/projects?limit=20");
  visitor.ask("DELETE", "/api/v1/jobs/" + job);
  visitor.ask("DELETE", "/api/v1/projects/" + project);
}

}  // namespace

Figures memory_gate(const Scale& scale) {
  const House house({"--workers", "2"});
  const double minutes = scale.soak_minutes, start = now_s();
  std::vector<double> hours, resident;  // of the second half: at first, what is kept for later fills
  int visits = 0;
  double first_mb = 0;
  while (now_s() - start < 60 * minutes) {
    visit(house, visits++);
    const double at = now_s() - start;
    if (visits == 1) first_mb = house.resident_mb();
    if (at < 30 * minutes) continue;
    hours.push_back(at / 3600);
    resident.push_back(house.resident_mb());
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  if (resident.empty()) give_up("the soak is too short for a visit in its second half");
  const std::string note = std::to_string(visits) + " visits in " + fixed_text(minutes, 1) + " min, " +
                           fixed_text(first_mb, 1) + " MB after the first, " +
                           fixed_text(resident.front(), 1) + " MB at half time, " +
                           fixed_text(resident.back(), 1) + " MB at the end";
  // In some minutes a page more or less is a slope: only a long soak is judged.
  const Asked asked = minutes >= 20 ? Asked::kAtMost : Asked::kNothing;
  return {{"memory", "slope of the resident memory", slope(hours, resident), "MB/h", asked, 1, load_average(),
           note}};
}

}  // namespace toile::bench
