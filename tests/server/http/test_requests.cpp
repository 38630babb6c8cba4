// What arrives on a port: slow, oversized, doubtful and broken requests.

#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "tests/server/http/served.h"

namespace toile::test {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

class Requests : public Served {
 protected:
  void SetUp() override { serve(); }
  /// The status that raw bytes are answered with; 0 when the connection just ends.
  int status_of(const std::string& bytes) {
    Wire wire(port);
    wire.send(bytes);
    return read_answer(wire).status;
  }
  void expect_alive() { EXPECT_EQ(get("/healthz").status, 200); }
};

constexpr const char* kHost = "Host: localhost\r\n";

TEST_F(Requests, AnswersOneAfterTheOtherOnOneConnection) {
  Wire wire(port);
  for (int i = 0; i < 3; ++i) {
    wire.send("GET /healthz HTTP/1.1\r\nHost: localhost\r\n\r\n");
    EXPECT_EQ(read_answer(wire).status, 200);
  }
  wire.send(
      "GET /healthz HTTP/1.1\r\nHost: localhost\r\n\r\nGET /nothing HTTP/1.1\r\nHost: localhost\r\n\r\n");
  EXPECT_EQ(read_answer(wire).status, 200);
  EXPECT_EQ(read_answer(wire).status, 404);
  wire.send("GET /healthz HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n");
  EXPECT_EQ(read_answer(wire).status, 200);
  EXPECT_TRUE(wire.closed(2));
}

TEST_F(Requests, AnswersHeadWithoutABody) {
  Wire wire(port);
  wire.send(
      "HEAD /healthz HTTP/1.1\r\nHost: localhost\r\n\r\nGET /healthz HTTP/1.1\r\nHost: localhost\r\n\r\n");
  const Answer head = read_answer(wire, true);
  EXPECT_EQ(head.status, 200);
  EXPECT_EQ(head.headers.at("content-length"), "17");
  EXPECT_EQ(read_answer(wire).body, "{\"status\": \"ok\"}\n");
}

TEST_F(Requests, EndsAConnectionWhoseHeaderDoesNotCome) {
  Wire wire(port);
  const Clock::time_point began = Clock::now();
  wire.send("GET /healthz HTTP/1.1\r\n");
  for (int i = 0; i < 12 && !wire.closed(0.3); ++i) wire.send("X-Slow: a\r\n");
  EXPECT_TRUE(wire.closed(30)) << "an idle connection would have stayed for 60 s";
  EXPECT_GT(seconds_since(began), 2.5);  // from below: no load makes a server's patience shorter
  expect_alive();
}

TEST_F(Requests, RefusesALargeHeader) {
  EXPECT_EQ(
      status_of("GET /healthz HTTP/1.1\r\nHost: localhost\r\nX-Long: " + std::string(9000, 'a') + "\r\n\r\n"),
      431);
  std::string many = "GET /healthz HTTP/1.1\r\nHost: localhost\r\n";
  for (int i = 0; i < 1000; ++i) many += "X-" + std::to_string(i) + ": 1\r\n";
  EXPECT_EQ(status_of(many + "\r\n"), 431);
  EXPECT_EQ(status_of("GET /" + std::string(9000, 'a') + " HTTP/1.1\r\nHost: localhost\r\n\r\n"), 431);
  EXPECT_EQ(
      status_of("GET /healthz HTTP/1.1\r\nHost: localhost\r\nX-Long: " + std::string(7000, 'a') + "\r\n\r\n"),
      200);
  expect_alive();
}

TEST_F(Requests, RefusesWhatLeavesTheLengthOfTheBodyInDoubt) {
  const std::string post =
      std::string("POST /api/v1/jobs HTTP/1.1\r\nContent-Type: application/json\r\n") + kHost;
  EXPECT_EQ(status_of(post + "Content-Length: 2\r\nTransfer-Encoding: chunked\r\n\r\n2\r\n{}\r\n0\r\n\r\n"),
            400);
  EXPECT_EQ(status_of(post + "Transfer-Encoding: chunked\r\nContent-Length: 2\r\n\r\n2\r\n{}\r\n0\r\n\r\n"),
            400);
  EXPECT_EQ(status_of(post + "Content-Length: 2\r\nContent-Length: 3\r\n\r\n{} "), 400);
  EXPECT_EQ(status_of(post + "Content-Length: 2\r\nContent-Length: 2\r\n\r\n{}"), 400);
  EXPECT_EQ(status_of(post + "Content-Length: 2, 2\r\n\r\n{}"), 400);
  EXPECT_EQ(status_of(post + "Content-Length: -1\r\n\r\n{}"), 400);
  EXPECT_EQ(status_of(post + "Content-Length: 99999999999999999999\r\n\r\n{}"), 400);
  for (const char* coding : {"gzip", "gzip, chunked", "chunked, chunked"}) {
    EXPECT_EQ(status_of(post + "Transfer-Encoding: " + coding + "\r\n\r\n2\r\n{}\r\n0\r\n\r\n"), 400)
        << coding;
  }
  EXPECT_EQ(status_of(post + "Transfer-Encoding: chunked\r\n\r\nzz\r\n{}\r\n0\r\n\r\n"), 400);
  expect_alive();
}

TEST_F(Requests, RefusesWhatIsNotHttp) {
  for (const std::string& bytes :
       {std::string("\n"), std::string("\r\n\r\n\r\n"), std::string("GET / HTTP/1.1\nHost: localhost\n\n"),
        std::string("GET / HTTP/1.1\r\nHost: localhost\nX: 1\r\n\r\n"),
        std::string("GET  / HTTP/1.1\r\n\r\n"),
        std::string("\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03 and so on", 21), std::string(300, '\0'),
        std::string("GET / HTTP/9.9\r\nHost: localhost\r\n\r\n"), std::string("SSH-2.0-OpenSSH_9.2\r\n"),
        std::string("GET / HTTP/1.1\r\nHost : localhost\r\n\r\n"),
        std::string("GET / HTTP/1.1\r\n: x\r\n\r\n"), std::string("PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n")}) {
    const int status = status_of(bytes);
    EXPECT_TRUE(status == 400 || status == 431) << bytes << " gave " << status;
  }
  expect_alive();
}

TEST_F(Requests, RefusesForeignHostsAndOrigins) {
  EXPECT_EQ(status_of("GET /healthz HTTP/1.1\r\n\r\n"), 400);
  EXPECT_EQ(status_of("GET /healthz HTTP/1.1\r\nHost: localhost\r\nHost: localhost\r\n\r\n"), 400);
  EXPECT_EQ(status_of("GET /healthz HTTP/1.1\r\nHost: garments.example\r\n\r\n"), 421);
  EXPECT_PROBLEM(send_json("POST", "/api/v1/jobs", "{}", "Origin: http://evil.example\r\n"), 403,
                 "http.origin");
  EXPECT_PROBLEM(
      send_json("POST", "/api/v1/jobs", "{}", "Origin: http://localhost:" + std::to_string(port) + "\r\n"),
      422, "request.project_id");
}

TEST_F(Requests, RefusesBodiesThatAreTooLargeBeforeReadingThem) {
  const std::string json = "Content-Type: application/json\r\n";
  EXPECT_PROBLEM(ask(port, "POST", "/api/v1/jobs", std::string(300'000, ' '), json), 413, "http.too_large");
  EXPECT_PROBLEM(ask(port, "POST", "/api/v1/projects", std::string(5'000'000, ' '), json), 413,
                 "http.too_large");
  EXPECT_PROBLEM(upload("dxf", "a.dxf", std::string(53'000'000, 'x')), 413, "http.too_large");
  EXPECT_PROBLEM(ask(port, "POST", "/api/v1/assets?kind=fabric&name=a", std::string(300'000, 'x')), 413,
                 "http.too_large");
  Wire wire(port);
  wire.send(
      "POST /api/v1/bodies?name=a.obj HTTP/1.1\r\nHost: localhost\r\nContent-Length: 999999999999\r\n\r\n");
  EXPECT_EQ(read_answer(wire).status, 413);
  expect_alive();
}

TEST_F(Requests, CountsTheBytesOfChunkedBodies) {
  Wire wire(port);
  wire.send(
      "POST /api/v1/jobs HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n"
      "Transfer-Encoding: chunked\r\n\r\n");
  const std::string chunk = "10000\r\n" + std::string(65536, ' ') + "\r\n";
  for (int i = 0; i < 6; ++i) wire.send(chunk);
  EXPECT_EQ(read_answer(wire).status, 413);
  Wire good(port);
  good.send(
      "POST /api/v1/jobs HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n"
      "Transfer-Encoding: chunked\r\n\r\n1\r\n{\r\n1\r\n}\r\n0\r\n\r\n");
  EXPECT_EQ(read_answer(good).status, 422);
}

TEST_F(Requests, LetsThoseGoOnWhoAskFirst) {
  Wire wire(port);
  wire.send(
      "POST /api/v1/jobs HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n"
      "Content-Length: 2\r\nExpect: 100-continue\r\n\r\n");
  const auto go_on = wire.read_until("\r\n\r\n", 2);
  ASSERT_TRUE(go_on);
  EXPECT_TRUE(go_on->starts_with("HTTP/1.1 100 "));
  wire.send("{}");
  EXPECT_EQ(read_answer(wire).status, 422);
}

TEST_F(Requests, RefusesParametersThatItDoesNotKnow) {
  EXPECT_PROBLEM(get("/api/v1/jobs?colour=red"), 400, "request.unknown_parameter");
  EXPECT_EQ(member(get("/api/v1/jobs?limits=3"), "where"), "limits");
  EXPECT_EQ(get("/api/v1/jobs?limit=3").status, 200);
  EXPECT_EQ(get("/?from=bookmark").status, 200) << "the page is asked in many ways";
}

TEST_F(Requests, SaysWhenItAnswers) {
  const std::string date = get("/healthz").headers.at("date");
  EXPECT_EQ(date.size(), 29u) << date;
  EXPECT_TRUE(date.ends_with(" GMT")) << date;
}

TEST_F(Requests, GivesMethodsAndAddressesTheirDue) {
  EXPECT_PROBLEM(get("/api/v1/nothing"), 404, "http.not_found");
  EXPECT_PROBLEM(get("/api/v1/jobs/"), 404, "http.not_found");
  const Answer wrong = ask(port, "DELETE", "/api/v1/jobs");
  EXPECT_PROBLEM(wrong, 405, "http.method");
  EXPECT_EQ(wrong.headers.at("allow"), "POST, GET, HEAD");
  EXPECT_PROBLEM(ask(port, "TRACE", "/healthz"), 405, "http.method");
  EXPECT_PROBLEM(ask(port, "POST", "/api/v1/jobs", "{}", "Content-Type: text/plain\r\n"), 415,
                 "http.content_type");
  EXPECT_PROBLEM(
      ask(port, "POST", "/api/v1/assets?kind=dxf&name=a.dxf", "--x", "Content-Type: multipart/form-data\r\n"),
      415, "http.content_type");
}

TEST_F(Requests, ReadsNothingOutsideByAnyName) {
  for (const char* name : {"..", "../..", "%2e%2e", "..%2f..%2fetc%2fpasswd", "%2e%2e%2fdata%2ftoile.db",
                           "....//", "..%5c..", "%00", ".", "j_1%2f..", "~", "-", "*", "%2fetc%2fpasswd"}) {
    for (const char* before : {"/", "/api/v1/jobs/", "/api/v1/assets/", "/api/v1/projects/"}) {
      for (const char* after : {"", "/content", "/results/report.json"}) {
        const Answer answer = get(std::string(before) + name + after);
        EXPECT_TRUE(answer.status == 400 || answer.status == 404) << before << name << after << answer.status;
      }
    }
  }
}

TEST_F(Requests, LivesThroughAHundredConnectionsThatEndAnywhere) {
  const std::string whole =
      "POST /api/v1/jobs HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\nContent-Length: "
      "20\r\n\r\n"
      "{\"project_id\": \"p\"} ";
  for (std::size_t length = 0; length < whole.size(); length += 2) {
    Wire wire(port);
    wire.send(whole.substr(0, length));
  }
  expect_alive();
}

TEST_F(Requests, SaysWhenItIsNotReady) {
  EXPECT_EQ(get("/readyz").status, 200);
  server->drain();
  const Answer draining = get("/readyz");
  EXPECT_PROBLEM(draining, 503, "server.draining");
  EXPECT_TRUE(draining.headers.contains("retry-after"));
  EXPECT_EQ(get("/healthz").status, 200);
}

TEST_F(Requests, CountsWhatItAnswers) {
  get("/healthz");
  get("/nothing");
  const Answer metrics = get("/metrics");
  EXPECT_EQ(metrics.headers.at("content-type"), "text/plain; version=0.0.4; charset=utf-8");
  EXPECT_NE(metrics.body.find("toile_http_requests_total{method=\"GET\",status=\"404\"} 1\n"),
            std::string::npos)
      << metrics.body;
  EXPECT_NE(metrics.body.find("toile_jobs{state=\"running\"} 0\n"), std::string::npos);
  EXPECT_NE(metrics.body.find("toile_http_problems_total{code=\"http.not_found\"} 1\n"), std::string::npos);
}

/// What an operator watches: a family that is there before anything has happened can be asked for.
TEST_F(Requests, TellsAnOperatorHowItFares) {
  const Answer metrics = get("/metrics");
  for (const char* line :
       {"toile_build_info{version=\"", "toile_queue_age_seconds 0\n",
        "toile_job_wait_seconds_bucket{le=\"+Inf\"} 0\n", "toile_job_run_seconds_count 0\n",
        "# TYPE toile_work_seconds_total counter\n", "# TYPE toile_store_failures_total counter\n",
        "toile_mesh_readers_total{end=\"crashed\"} 0\n"}) {
    EXPECT_NE(metrics.body.find(line), std::string::npos) << line << " is not in\n" << metrics.body;
  }
  const std::size_t at = metrics.body.find("\ntoile_disk_free_bytes ");
  ASSERT_NE(at, std::string::npos);
  EXPECT_GT(std::strtod(metrics.body.c_str() + at + sizeof "\ntoile_disk_free_bytes", nullptr), 0);
}

TEST_F(Requests, StopsWithIdleAndHalfFinishedConnectionsOpen) {
  Wire idle(port), half(port), kept(port);
  half.send("GET /healthz HTT");
  kept.send("GET /healthz HTTP/1.1\r\nHost: localhost\r\n\r\n");
  EXPECT_EQ(read_answer(kept).status, 200);
  server->stop();
  server->stop();
  EXPECT_TRUE(idle.closed(30)) << "by itself it would have stayed for 60 s";
  EXPECT_TRUE(kept.closed(30));
}

TEST(HttpServer, OpensThePortOnTheLoopbackOnly) {
  const auto folder =
      std::filesystem::path(testing::TempDir()) / ("toile_loopback_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  auto store = sqlite::open_sqlite_store(folder.string());
  ASSERT_TRUE(store);
  documents::Documents documents(**store);
  ScriptedJobs jobs(documents);
  ws::Hub hub;
  for (const char* address : {"0.0.0.0", "::", "192.168.1.1", "10.0.0.1", "example.org", ""}) {
    http::ServerSettings settings;
    settings.address = address;
    settings.port = 0;
    http::HttpServer server(**store, jobs, hub, settings);
    const Status started = server.start();
    ASSERT_FALSE(started) << address;
    EXPECT_EQ(started.error().code, "server.address");
  }
  http::ServerSettings settings;
  settings.port = 0;
  http::HttpServer first(**store, jobs, hub, settings);
  ASSERT_TRUE(first.start());
  settings.port = first.port();
  http::HttpServer second(**store, jobs, hub, settings);
  const Status taken = second.start();
  ASSERT_FALSE(taken);
  EXPECT_EQ(taken.error().code, "server.port");
  first.stop();
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace toile::test
