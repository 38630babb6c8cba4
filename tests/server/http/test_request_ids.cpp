// What a request is called, and that the log has everything that is done for it under that name.

#include <algorithm>
#include <mutex>
#include <set>
#include <stdexcept>

#include "server/http/identify.h"
#include "tests/server/http/served.h"

namespace toile::test {
namespace {

/// Keeps the lines.
class KeptLines final : public LogSink {
 public:
  struct Line {
    LogLevel level = LogLevel::kDebug;
    std::string event;
    std::map<std::string, std::string> fields;
  };

  void write(LogLevel level, std::string_view event, std::span<const LogField> bound,
             std::span<const LogField> more) noexcept override {
    Line line{level, std::string(event), {}};
    for (const LogField& field : bound) line.fields[field.key] = field.value;
    for (const LogField& field : more) line.fields[field.key] = field.value;
    const std::lock_guard hold(mutex_);
    lines_.push_back(std::move(line));
  }
  /// Those of one request.
  std::vector<Line> of(const std::string& request) const {
    const std::lock_guard hold(mutex_);
    std::vector<Line> out;
    for (const Line& line : lines_) {
      const auto id = line.fields.find("request");
      if (id != line.fields.end() && id->second == request) out.push_back(line);
    }
    return out;
  }
  /// How many requests have an id that the server made.
  std::size_t with_made_ids() const {
    const std::lock_guard hold(mutex_);
    std::set<std::string> ids;
    for (const Line& line : lines_) {
      const auto id = line.fields.find("request");
      if (id != line.fields.end() && id->second.starts_with("r_")) ids.insert(id->second);
    }
    return ids.size();
  }

 private:
  mutable std::mutex mutex_;
  std::vector<Line> lines_;
};

class RequestLog : public Served {
 protected:
  void SetUp() override {
    log = Log(lines);
    more_routes = [](http::Router& router) {
      router.add(
          {.method = "GET",
           .pattern = "/broken",
           .handler = [](const store::RequestContext&, const http::HttpRequest&) -> http::HttpResponse {
             throw std::runtime_error("a fault of ours");
           }});
      router.add({.method = "GET",
                  .pattern = "/worse",
                  .handler = [](const store::RequestContext&,
                                const http::HttpRequest&) -> http::HttpResponse { throw 7; },
                  .work = http::Work::kHeavy});
    };
    serve();
  }

  KeptLines lines;
};

TEST_F(RequestLog, EveryLineOfARequestHasTheIdThatItsCallerGave) {
  EXPECT_EQ(get("/api/v1/nothing", "X-Request-Id: page-17.a\r\n").headers.at("x-request-id"), "page-17.a");
  ASSERT_EQ(lines.of("page-17.a").size(), 1u);
  const KeptLines::Line line = lines.of("page-17.a")[0];
  EXPECT_EQ(line.event, "answered");
  EXPECT_EQ(line.fields.at("status"), "404");
  EXPECT_EQ(line.fields.at("target"), "/api/v1/nothing");
  EXPECT_EQ(line.fields.at("owner"), "local");
}

TEST_F(RequestLog, ARequestWithoutAPlainIdGetsOneInTheLogAndNoneInItsAnswer) {
  EXPECT_FALSE(get("/one").headers.contains("x-request-id"));
  for (const std::string& id : {std::string("two words"), std::string("\"quoted\""), std::string(65, 'a')}) {
    EXPECT_FALSE(get("/one", "X-Request-Id: " + id + "\r\n").headers.contains("x-request-id")) << id;
    EXPECT_TRUE(lines.of(id).empty());
  }
  EXPECT_EQ(lines.with_made_ids(), 4u);
}

TEST_F(RequestLog, AnExceptionOfAHandlerIsToldWithItsPlaceAndItsRequest) {
  const Answer answer = get("/broken", "X-Request-Id: r-broken\r\n");
  EXPECT_PROBLEM(answer, 500, "internal.exception");
  const std::vector<KeptLines::Line> told = lines.of("r-broken");
  const auto thrown =
      std::find_if(told.begin(), told.end(), [](const auto& line) { return line.event == "handler threw"; });
  ASSERT_NE(thrown, told.end());
  EXPECT_EQ(thrown->level, LogLevel::kError);
  EXPECT_EQ(thrown->fields.at("route"), "/broken");
  EXPECT_EQ(thrown->fields.at("what"), "a fault of ours");
}

TEST_F(RequestLog, WhatIsThrownAndIsNoExceptionIsAnsweredAndToldAsWell) {
  EXPECT_PROBLEM(get("/worse", "X-Request-Id: r-worse\r\n"), 500, "internal.unknown");
  const std::vector<KeptLines::Line> told = lines.of("r-worse");
  EXPECT_TRUE(std::any_of(told.begin(), told.end(), [](const auto& line) {
    return line.event == "handler threw what is no exception" && line.level == LogLevel::kError;
  }));
  EXPECT_EQ(get("/healthz").status, 200);
}

TEST(RequestIds, AreNotThoseOfAnotherServer) {
  http::RequestIds one, other;
  EXPECT_NE(one.next(), other.next());
  EXPECT_NE(one.next(), one.next());
}

}  // namespace
}  // namespace toile::test
