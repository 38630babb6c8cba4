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

constexpr int kClients = 50;
constexpr int kJobs = 10;  ///< of each client and round: the queue takes a thousand

/// What each submission of a round took, ms. `pause_s`: from one of a client to its next; the first come
/// spread over one pause.
std::vector<double> round(const std::vector<std::string>& serve, double pause_s) {
  const House house(serve);
  std::vector<std::vector<double>> took(kClients);
  std::vector<std::string> projects;
  for (int i = 0; i < kClients; ++i)
    projects.push_back(Visitor(house.url()).project(Cloth{200 + i, 35, 0.2}));
  std::vector<std::thread> clients;
  const double start = now_s() + 0.5;
  for (std::size_t i = 0; i < kClients; ++i) {
    clients.emplace_back([&, i] {
      Visitor visitor(house.url());
      visitor.get("/healthz");  // connected
      for (int job = 0; job < kJobs; ++job) {
        const double due = start + pause_s * (job + static_cast<double>(i) / kClients);
        std::this_thread::sleep_for(std::chrono::duration<double>(due - now_s()));
        const double before = now_s();
        visitor.submit(projects[i], kPlain);
        took[i].push_back(1000 * (now_s() - before));
      }
    });
  }
  for (std::thread& client : clients) client.join();
  std::vector<double> all;
  for (const std::vector<double>& one : took) all.insert(all.end(), one.begin(), one.end());
  return all;
}

Figure measure(const Scale& scale, const std::string& what, const std::vector<std::string>& serve,
               double pause_s, Asked asked) {
  std::vector<double> all;
  for (int i = 0; i < scale.times; ++i) {
    const std::vector<double> one = round(serve, pause_s);
    all.insert(all.end(), one.begin(), one.end());
  }
  const std::string note = "median " + fixed_text(percentile(all, 0.5), 1) + ", most " +
                           fixed_text(percentile(all, 1), 1) + ", of " + std::to_string(all.size());
  return {"submit", "p99, " + what, percentile(all, 0.99), "ms", asked, 100, load_average(), note};
}

}  // namespace

Figures submit_gate(const Scale& scale) {
  const std::vector<std::string> idle{"--no-workers"}, busy{"--workers", "2"};
  return {measure(scale, "50 clients once a second", idle, 1, Asked::kAtMost),
          measure(scale, "50 clients as fast as answers come", idle, 0, Asked::kAtMost),
          measure(scale, "50 clients once a second, two workers drape what comes", busy, 1, Asked::kNothing)};
}

}  // namespace toile::bench
