#include "server/http/admission.h"

#include <gtest/gtest.h>

#include "server/http/url.h"

namespace toile {
namespace {

class RouterTest : public testing::Test {
 protected:
  RouterTest() {
    const auto handler = [](const store::RequestContext&, const http::HttpRequest&) {
      return http::HttpResponse{};
    };
    router.add({.method = "GET", .pattern = "/api/v1/jobs", .handler = handler});
    http::Route post{.method = "POST", .pattern = "/api/v1/jobs", .handler = handler};
    post.body = http::BodyKind::kJson;
    router.add(std::move(post));
    router.add({.method = "GET", .pattern = "/api/v1/jobs/{id}", .handler = handler});
    http::Route result{.method = "GET", .pattern = "/api/v1/jobs/{id}/results/{name}", .handler = handler};
    result.parameters = {"x"};
    router.add(std::move(result));
    router.add_page(handler);
  }

  http::Admission admit_one(const std::string& method, const std::string& target,
                            http::Incoming incoming = {}) {
    request = {};
    request.method = method;
    request.target = target;
    request.headers = headers;
    return http::admit(router, request, incoming);
  }
  int status(const std::string& method, const std::string& target, http::Incoming incoming = {}) {
    const http::Admission admission = admit_one(method, target, incoming);
    return admission.route ? 200 : admission.refusal.status;
  }

  http::Router router;
  http::HttpRequest request;
  std::map<std::string, std::string> headers{{"host", "localhost:8460"}};
};

TEST_F(RouterTest, FindsTheRouteAndWhatItsBracesStandFor) {
  const http::Admission found = admit_one("GET", "/api/v1/jobs/j_1/results/final.glb?x=1");
  ASSERT_TRUE(found.route);
  EXPECT_EQ(found.route->pattern, "/api/v1/jobs/{id}/results/{name}");
  EXPECT_EQ(request.captures, (std::vector<std::string>{"j_1", "final.glb"}));
  EXPECT_EQ(request.parameter("x"), "1");
}

TEST_F(RouterTest, TakesNoParameterThatTheRouteDoesNotKnow) {
  const http::Admission refused = admit_one("GET", "/api/v1/jobs/j_1/results/final.glb?x=1&y=2");
  EXPECT_FALSE(refused.route);
  EXPECT_EQ(refused.refusal.status, 400);
  EXPECT_NE(refused.refusal.body.find("request.unknown_parameter"), std::string::npos)
      << refused.refusal.body;
  EXPECT_EQ(status("GET", "/index.html?y=2"), 200);
}

TEST_F(RouterTest, SaysWhichMethodsThereAre) {
  const http::Admission refused = admit_one("PATCH", "/api/v1/jobs");
  EXPECT_EQ(refused.refusal.status, 405);
  EXPECT_EQ(refused.refusal.headers.at(0), (std::pair<std::string, std::string>{"Allow", "GET, HEAD, POST"}));
  EXPECT_EQ(status("POST", "/api/v1/jobs/j_1"), 405);
  EXPECT_EQ(status("HEAD", "/api/v1/jobs/j_1"), 200);
  EXPECT_EQ(status("get", "/api/v1/jobs"), 405) << "methods are case-sensitive";
}

TEST_F(RouterTest, LeavesTheRestToThePageButNothingUnderApi) {
  EXPECT_EQ(status("GET", "/"), 200);
  EXPECT_EQ(status("GET", "/assets/index.js"), 200);
  EXPECT_EQ(status("POST", "/"), 405);
  EXPECT_EQ(status("GET", "/api"), 404);
  EXPECT_EQ(status("GET", "/api/v2/jobs"), 404);
  EXPECT_EQ(status("GET", "/api/v1/jobs/"), 404);
  EXPECT_EQ(status("GET", "/api/v1/jobs//results/x"), 404);
}

TEST_F(RouterTest, TakesAJsonBodyAsJsonOnlyAndOnlySoLarge) {
  EXPECT_EQ(status("POST", "/api/v1/jobs", {.upgrade = false, .has_body = true, .length = 10}), 415);
  headers["content-type"] = "Application/JSON; charset=utf-8";
  EXPECT_EQ(status("POST", "/api/v1/jobs", {.upgrade = false, .has_body = true, .length = 10}), 200);
  EXPECT_EQ(status("POST", "/api/v1/jobs", {.upgrade = false, .has_body = true, .length = http::kSmallBody}),
            200);
  EXPECT_EQ(
      status("POST", "/api/v1/jobs", {.upgrade = false, .has_body = true, .length = http::kSmallBody + 1}),
      413);
}

TEST_F(RouterTest, ServesNoOtherHost) {
  headers["host"] = "garments.example:8460";
  EXPECT_EQ(status("GET", "/api/v1/jobs"), 421);
  headers.erase("host");
  EXPECT_EQ(status("GET", "/api/v1/jobs"), 400);
}

TEST_F(RouterTest, LetsNoOtherPageChangeAnything) {
  headers["content-type"] = "application/json";
  for (const char* origin :
       {"http://evil.example", "null", "http://localhost:9999", "http://localhost:8460.evil.example"}) {
    headers["origin"] = origin;
    EXPECT_EQ(status("POST", "/api/v1/jobs"), 403) << origin;
    EXPECT_EQ(status("GET", "/api/v1/jobs", {.upgrade = true, .has_body = false, .length = {}}), 403)
        << origin;
    EXPECT_EQ(status("GET", "/api/v1/jobs"), 200) << origin;
  }
  headers["origin"] = "http://localhost:8460";
  EXPECT_EQ(status("POST", "/api/v1/jobs"), 200);
}

}  // namespace
}  // namespace toile
