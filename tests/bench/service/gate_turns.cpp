#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "core/base/text.h"
#include "tests/bench/service/gates.h"
#include "tests/bench/service/house.h"
#include "tests/bench/service/visitor.h"

namespace toile::bench {
namespace {

constexpr double kEndless = 3600;  ///< s, simulated: it is cancelled before

void sleep_s(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

/// Whether its cloth has moved.
bool has_begun(Visitor& visitor, const std::string& job) {
  const json::JsonValue row = visitor.get("/api/v1/jobs/" + job);
  const json::JsonValue* progress = row.find("progress");
  if (!progress || !progress->object()) return true;  // it has ended
  return number_of_member(*progress, "step") > 0;
}

/// What an owner has had of the workers, s.
double had(Visitor& visitor) {
  double sum = 0;
  std::string cursor;
  do {
    const json::JsonValue page = visitor.get("/api/v1/jobs?limit=100" + cursor);
    for (const json::JsonValue& job : *page.find("jobs")->array()) sum += number_of_member(job, "worked_s");
    const json::JsonValue* next = page.find("next");
    cursor = next && next->text() && !next->text()->empty() ? "&cursor=" + *next->text() : "";
  } while (!cursor.empty());
  return sum;
}

/// Owner i submits drapes of cloth_of(i), `each(i)` of them; what they have had after `seconds`.
template <typename ClothOf, typename Each>
Figure fairness(const std::string& what, double seconds, double asked, const ClothOf& cloth_of,
                const Each& each) {
  std::vector<std::string> names;
  for (int i = 0; i < 50; ++i) names.push_back("owner" + std::to_string(i));
  const House house(names, {"--workers", "2"});
  std::vector<Visitor> owners;
  owners.reserve(names.size());
  for (std::size_t i = 0; i < names.size(); ++i) owners.emplace_back(house.url(), house.tokens()[i]);
  std::vector<std::string> projects;
  for (int i = 0; i < 50; ++i) projects.push_back(owners[static_cast<std::size_t>(i)].project(cloth_of(i)));
  for (std::size_t i = 0; i < owners.size(); ++i)
    for (int job = 0; job < each(static_cast<int>(i)); ++job) owners[i].submit(projects[i], kPlain);
  const double memory = house.resident_mb();
  sleep_s(seconds);
  std::vector<double> all;
  double sum = 0;
  for (Visitor& owner : owners) {
    all.push_back(had(owner));
    sum += all.back();
  }
  const std::string note = "least " + fixed_text(percentile(all, 0), 2) + " s, most " +
                           fixed_text(percentile(all, 1), 2) + " s, in all " + fixed_text(sum, 1) + " s in " +
                           fixed_text(seconds, 0) + " s; server " +
                           fixed_text(house.resident_mb() - memory, 0) + " MB larger";
  return {"fairness", what, jain_index(all), "", Asked::kAtLeast, asked, load_average(), note};
}

}  // namespace

Figures interactive_gate(const Scale& scale) {
  const House house({"--workers", "2"});
  Visitor visitor(house.url());
  const Cloth large{600, 16, kEndless};
  const std::string batch = visitor.project(large);
  std::vector<std::string> running;
  for (int i = 0; i < 20; ++i) running.push_back(visitor.submit(batch, kPlain));
  while (!has_begun(visitor, running[0]) || !has_begun(visitor, running[1])) sleep_s(0.02);
  std::vector<double> waited;
  for (int i = 0; i < 10 * scale.times; ++i) {
    const std::string project = visitor.project(Cloth{300 + i % 10, 25, 1});
    const double before = now_s();
    const std::string job = visitor.submit(project, R"(, "priority": "interactive", "anew": true)");
    while (!has_begun(visitor, job)) sleep_s(0.005);
    waited.push_back(now_s() - before);
    visitor.wait_for(job);
  }
  const std::string note = "median " + fixed_text(percentile(waited, 0.5), 3) + " s of " +
                           std::to_string(waited.size()) + ", from the request to the first steps";
  return {{"interactive", "start among 20 of batch on two workers, longest", percentile(waited, 1), "s",
           Asked::kAtMost, 1, load_average(), note}};
}

Figures fairness_gate(const Scale& scale) {
  const double seconds = 100 * (scale.times > 1 ? 3 : 1);
  return {
      fairness(
          "Jain's index of 50 owners, a third with short drapes and a third with long ones", seconds, 0.95,
          [](int i) {
            return Cloth{300, 20, i % 3 == 0 ? 1.0 : i % 3 == 1 ? 4.0 : 12.0};
          },
          [](int i) { return i % 3 == 0 ? 40 : 8; }),
      fairness(
          "Jain's index of 50 owners, all with drapes without end", seconds, 0.95,
          [](int) {
            return Cloth{300, 20, kEndless};
          },
          [](int i) { return 1 + i % 3; })};
}

}  // namespace toile::bench
