// Clients that ask for much, send nothing, do not read, or go away.

#include <atomic>
#include <chrono>
#include <fstream>
#include <functional>
#include <map>
#include <thread>
#include <vector>

#include "tests/server/http/served.h"
#include "tests/server/store/update_job.h"

namespace toile::test {
namespace {

using std::chrono::milliseconds;

/// False after half a minute.
bool wait_for(const std::function<bool()>& holds) {
  for (int waited = 0; waited < 3000 && !holds(); ++waited) std::this_thread::sleep_for(milliseconds(10));
  return holds();
}

double resident_mb() {
  std::ifstream in("/proc/self/statm");
  double total = 0, resident = 0;
  in >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

std::string announcing(std::size_t bytes) {
  return "POST /api/v1/bodies?name=post.obj HTTP/1.1\r\nHost: localhost\r\nContent-Type: "
         "application/octet-stream\r\nContent-Length: " +
         std::to_string(bytes) + "\r\n\r\n";
}

class Limits : public Served {
 protected:
  /// A route whose handler takes until it is given up, at most twenty seconds.
  void add_endless(http::Work work) {
    more_routes = [this, work](http::Router& router) {
      http::Route route;
      route.method = "GET";
      route.pattern = "/api/v1/endless";
      route.work = work;
      route.handler = [this](const store::RequestContext& context, const http::HttpRequest&) {
        ++begun;
        given_up = wait_for([&] { return context.is_given_up() || let_go; }) && context.is_given_up();
        ++ended;
        http::HttpResponse response;
        response.status = 500;
        return response;
      };
      router.add(std::move(route));
    };
  }
  static std::string endless() { return "GET /api/v1/endless HTTP/1.1\r\nHost: localhost\r\n\r\n"; }

  /// A job that has ended, with a result of so many bytes.
  std::string job_with_result(std::size_t bytes) {
    const std::string id = make_job();
    EXPECT_TRUE(store->put_result(kMe, id, "final.glb", std::string(bytes, 'x')));
    store::JobRow row = store->job(kMe, id).value();
    row.state = store::JobState::kSucceeded;
    row.results = {{"final.glb", static_cast<std::int64_t>(bytes)}};
    EXPECT_TRUE(test::update_job(*store, kMe, row));
    return id;
  }

  std::atomic<int> begun{0}, ended{0};
  std::atomic<bool> given_up{false}, let_go{false};
};

TEST_F(Limits, BodiesThatAreAnnouncedAndNotSentTakeNothingFromOthers) {
  http::ServerSettings settings;
  settings.most_body_bytes = 1 << 20;
  serve(settings);
  std::vector<Wire> wires;
  for (int i = 0; i < 6; ++i) {
    wires.emplace_back(port);
    ASSERT_TRUE(wires.back().send(announcing(90 << 20)));
  }
  ASSERT_TRUE(wait_for([&] { return server->metrics().connections.load() == 6; }));
  EXPECT_NE(post_asset(), "");
}

TEST_F(Limits, MoreBytesOfBodiesThanThereIsRoomForAreRefusedForNow) {
  http::ServerSettings settings;
  settings.most_body_bytes = 100'000;
  serve(settings);
  const Answer refused = upload("body", "large.obj", std::string(200'000, 'v'));
  EXPECT_PROBLEM(refused, 503, "server.busy");
  EXPECT_EQ(refused.headers.at("retry-after"), "5");
  EXPECT_NE(post_asset(), "") << "what was taken has been given back";
}

TEST_F(Limits, ABodyThatStopsOrComesTooSlowlyIsBrokenOff) {
  http::ServerSettings settings;
  settings.body_pause_within = milliseconds(1500);
  settings.slow_for = milliseconds(300);
  settings.least_body_rate = 100'000;
  serve(settings);
  Wire silent(port), slow(port);
  ASSERT_TRUE(silent.send(announcing(1000)) && slow.send(announcing(1'000'000)));
  std::atomic<bool> over{false};
  std::jthread dripping([&] {
    while (!over && slow.send("v")) std::this_thread::sleep_for(milliseconds(20));
  });
  EXPECT_EQ(read_answer(slow).status, 408);
  EXPECT_TRUE(silent.closed(20));
  over = true;
}

TEST_F(Limits, IdleConnectionsMakeRoomForNewOnes) {
  serve();  // at most 64
  std::vector<Wire> idle;
  for (int i = 0; i < 150; ++i) idle.emplace_back(port);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(get("/healthz").status, 200);
  EXPECT_TRUE(idle.front().closed(20)) << "the one that was idle longest";
}

TEST_F(Limits, OneAddressHasItsShareOfConnections) {
  http::ServerSettings settings;
  settings.most_of_address = 8;
  serve(settings);
  std::vector<Wire> idle;
  for (int i = 0; i < 20; ++i) idle.emplace_back(port);
  EXPECT_TRUE(wait_for([&] { return server->metrics().connections.load() <= 9; }));
  EXPECT_EQ(get("/healthz").status, 200);
}

TEST_F(Limits, ResultsComeWholeAndWhoDoesNotReadThemCostsNoMemory) {
  serve();
  constexpr std::size_t kBytes = 20 << 20;
  const std::string target = "/api/v1/jobs/" + job_with_result(kBytes) + "/results/final.glb";
  const Answer whole = get(target);
  EXPECT_EQ(whole.body.size(), kBytes);
  EXPECT_EQ(whole.body.find_first_not_of('x'), std::string::npos);
  EXPECT_EQ(whole.headers.at("content-type"), "model/gltf-binary");

  const double before = resident_mb();
  std::vector<Wire> stalled;
  for (int i = 0; i < 40; ++i) {
    stalled.emplace_back(port, 4096);
    ASSERT_TRUE(stalled.back().send("GET " + target + " HTTP/1.1\r\nHost: localhost\r\n\r\n"));
  }
  for (Wire& wire : stalled) ASSERT_TRUE(wire.read_until("\r\n\r\n"));
  const double after = resident_mb();
  std::printf("resident: %.1f MB before, %.1f MB with 40 readers that stalled\n", before, after);
  EXPECT_LT(after - before, 60) << "40 times 20 MB do not lie in memory";
}

TEST_F(Limits, AHeadOfAResultHasItsLengthAndNoBody) {
  serve();
  const std::string target = "/api/v1/jobs/" + job_with_result(1000) + "/results/final.glb";
  Wire wire(port);
  ASSERT_TRUE(wire.send("HEAD " + target + " HTTP/1.1\r\nHost: localhost\r\n\r\n"));
  const Answer head = read_answer(wire, true);
  EXPECT_EQ(head.status, 200);
  EXPECT_EQ(head.headers.at("content-length"), "1000");
  ASSERT_TRUE(wire.send("GET /healthz HTTP/1.1\r\nHost: localhost\r\n\r\n"));
  EXPECT_EQ(read_answer(wire).status, 200) << "nothing stood between";
}

TEST_F(Limits, WorkIsGivenUpWhenWhoeverAskedForItGoes) {
  add_endless(http::Work::kHeavy);
  serve();
  {
    Wire wire(port);
    ASSERT_TRUE(wire.send(endless()));
    ASSERT_TRUE(wait_for([&] { return begun == 1; }));
  }
  EXPECT_TRUE(wait_for([&] { return ended == 1; }));
  EXPECT_TRUE(given_up);
}

TEST_F(Limits, WorkIsGivenUpWhenItTakesTooLongAndTheAnswerSaysSo) {
  add_endless(http::Work::kHeavy);
  http::ServerSettings settings;
  settings.work_within = milliseconds(200);
  serve(settings);
  EXPECT_PROBLEM(get("/api/v1/endless"), 503, "server.gave_up");
  EXPECT_TRUE(given_up);
}

TEST_F(Limits, WorkIsGivenUpWhenTheServerStops) {
  add_endless(http::Work::kUpload);
  serve();
  Wire wire(port);
  ASSERT_TRUE(wire.send(endless()));
  ASSERT_TRUE(wait_for([&] { return begun == 1; }));
  server->stop();
  EXPECT_EQ(ended, 1);
  EXPECT_TRUE(given_up);
}

TEST_F(Limits, SubmittingEditingAndShowingDoNotWaitForUploads) {
  add_endless(http::Work::kUpload);
  serve();
  const std::string project = make_project();
  std::vector<Wire> wires;
  for (int i = 0; i < 4; ++i) {
    wires.emplace_back(port);
    ASSERT_TRUE(wires.back().send(endless()));
  }
  ASSERT_TRUE(wait_for([&] { return begun == 2; })) << "all threads for uploads";
  EXPECT_EQ(send_json("POST", "/api/v1/jobs", "{\"project_id\": \"" + project + "\"}").status, 201);
  EXPECT_EQ(get("/api/v1/projects/" + project + "/pieces").status, 200);
  EXPECT_EQ(get("/api/v1/projects/" + project + "/check").status, 200);
  EXPECT_EQ(ended, 0) << "they were at it all the while";
  let_go = true;
}

TEST_F(Limits, HeavyWorkOfOneUserThatWaitsIsBounded) {
  add_endless(http::Work::kHeavy);
  http::ServerSettings settings;
  settings.most_waiting = 3;
  serve(settings);
  std::vector<Wire> wires;
  for (int i = 0; i < 2; ++i) {
    wires.emplace_back(port);
    ASSERT_TRUE(wires.back().send(endless()));
  }
  ASSERT_TRUE(wait_for([&] { return begun == 2; })) << "all threads for it";
  for (int i = 0; i < 4; ++i) {
    wires.emplace_back(port);
    ASSERT_TRUE(wires.back().send(endless()));
  }
  const auto refused = [&] {
    return get("/metrics").body.find("problems_total{code=\"server.too_much_at_once\"} 1\n") !=
           std::string::npos;
  };
  ASSERT_TRUE(wait_for(refused)) << "the fourth that would wait";
  EXPECT_EQ(get("/api/v1/projects").status, 200) << "what is light goes on";
  let_go = true;
  std::map<int, int> answers;
  for (Wire& wire : wires) ++answers[read_answer(wire).status];
  EXPECT_EQ(answers, (std::map<int, int>{{429, 1}, {500, 5}}));
}

TEST_F(Limits, JobsAssetsAndProjectsAreRemovedWithTheirData) {
  serve();
  const std::string asset = post_asset(), project = make_project();
  const std::string submission = "{\"project_id\": \"" + project + "\"}";
  const std::string job = member(send_json("POST", "/api/v1/jobs", submission), "id");
  const std::string job_at = "/api/v1/jobs/" + job, asset_at = "/api/v1/assets/" + asset,
                    project_at = "/api/v1/projects/" + project;
  EXPECT_PROBLEM(ask(port, "DELETE", asset_at), 409, "store.in_use");
  EXPECT_PROBLEM(ask(port, "DELETE", job_at), 409, "store.in_use");
  EXPECT_PROBLEM(ask(port, "DELETE", project_at + "?data=true"), 409, "jobs.state");
  EXPECT_PROBLEM(ask(port, "DELETE", project_at + "?data=perhaps"), 400, "request.data");
  EXPECT_EQ(get(project_at).status, 200);
  ASSERT_TRUE(jobs->cancel(kMe, job));
  ASSERT_TRUE(store->put_result(kMe, job, "report.json", "{}"));
  EXPECT_EQ(ask(port, "DELETE", project_at + "?data=true").status, 204);
  EXPECT_EQ(get(project_at).status, 404);
  EXPECT_EQ(get(job_at).status, 404);
  EXPECT_EQ(get(asset_at).status, 404);
  EXPECT_FALSE(std::filesystem::exists(folder / "data/results" / job));
  EXPECT_PROBLEM(ask(port, "DELETE", job_at), 404, "store.not_found");
  EXPECT_PROBLEM(ask(port, "DELETE", asset_at), 404, "store.not_found");
  EXPECT_EQ(post_asset(), asset) << "and may come again";
  EXPECT_EQ(get(asset_at + "/content").status, 200);
}

}  // namespace
}  // namespace toile::test
