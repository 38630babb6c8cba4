#include <algorithm>
#include <chrono>
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

constexpr int kViewers = 50;

struct Watched {
  double published = 0;        ///< frames a second
  std::vector<double> shares;  ///< of them that each viewer has got
  double cores = 0;            ///< that the server has kept busy
  double most_mb = 0;          ///< its largest resident memory
};

/// Steps that the drape has made.
double steps_of(Visitor& visitor, const std::string& job) {
  const json::JsonValue row = visitor.get("/api/v1/jobs/" + job);
  return number_of_member(*row.find("progress"), "step");
}

/// How fast a drape is depends on what else the machine does, so what a viewer gets is compared with what
/// there was to get.
Watched watch(const House& house, Visitor& visitor, const std::string& job, const Crowd& crowd,
              double seconds) {
  constexpr double kStepsPerFrame = 50;
  const std::vector<long> before = crowd.frames();
  const double first = steps_of(visitor, job), start = now_s(), worked = house.worked_s();
  Watched seen;
  while (now_s() - start < seconds) {
    seen.most_mb = std::max(seen.most_mb, house.resident_mb());
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  const std::vector<long> after = crowd.frames();
  const double took = now_s() - start, frames = (steps_of(visitor, job) - first) / kStepsPerFrame;
  seen.published = frames / took;
  for (std::size_t i = 0; i < after.size(); ++i)
    seen.shares.push_back(static_cast<double>(after[i] - before[i]) / frames);
  seen.cores = (house.worked_s() - worked) / took;
  return seen;
}

Figure shares_figure(const std::string& what, const Watched& seen) {
  const std::string note =
      fixed_text(seen.published, 0) + " frames a second, server " + fixed_text(seen.cores, 2) + " cores";
  return {"viewers", what, percentile(seen.shares, 0), "", Asked::kAtLeast, 0.9, load_average(), note};
}

Figure memory_figure(const std::string& what, double megabytes) {
  return {"viewers", what, megabytes, "MB", Asked::kAtMost, 5, load_average(), ""};
}

}  // namespace

Figures viewers_gate(const Scale& scale) {
  const double seconds = 10.0 * scale.times;
  const House house({"--workers", "1"});
  Visitor visitor(house.url());
  const std::string job = visitor.submit(visitor.project(Cloth{600, 16, 3600}), kPlain);
  while (text_of_member(visitor.get("/api/v1/jobs/" + job), "state") != "running" ||
         steps_of(visitor, job) == 0)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  Watched alone, many, with_stalled;
  {
    const Crowd one(house.port(), job, 1, true);
    alone = watch(house, visitor, job, one, seconds);
  }
  const Crowd crowd(house.port(), job, kViewers, true);
  many = watch(house, visitor, job, crowd, seconds);
  const Crowd stalled(house.port(), job, kViewers, false);
  with_stalled =
      watch(house, visitor, job, crowd, std::max(seconds, 45.0));  // they are parted from after 30 s
  return {shares_figure("share of the frames that one viewer got", alone),
          shares_figure("share that the slowest of 50 got", many),
          memory_figure("memory of 49 more", many.most_mb - alone.most_mb),
          shares_figure("share that the slowest of 50 got beside 50 that do not read", with_stalled),
          memory_figure("memory of 50 that do not read", with_stalled.most_mb - many.most_mb)};
}

}  // namespace toile::bench
