// Nobody gets where they do not belong: every operation of the contract is tried by who is not known, by who
// was, by who may less, and by who is somebody else.

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

#include "tests/server/http/with_accounts.h"

namespace toile::test {
namespace {

TEST_F(Accounts, TheContractTellsWhoMayAsk) {
  const std::vector<ContractRoute> routes = contract_routes();
  EXPECT_GE(routes.size(), 50u);
  const auto count = [&](auto is) { return std::count_if(routes.begin(), routes.end(), is); };
  EXPECT_GE(count([](const ContractRoute& r) { return r.open; }), 2);
  EXPECT_GE(count([](const ContractRoute& r) { return r.admin; }), 1);
  EXPECT_GE(count([](const ContractRoute& r) { return r.link; }), 9);
  for (const ContractRoute& route : routes)
    EXPECT_LE(int{route.open} + int{route.admin} + int{route.link}, 1) << told(route);
}

TEST_F(Accounts, LetsNobodyInWhoIsNotKnown) {
  make_things();
  const std::string expired = token(anna, "read,submit,admin", 1);
  const std::string revoked = token(anna, "read,submit,admin");
  ASSERT_TRUE(store->accounts()->remove_key(anna.id, last_key));
  for (const ContractRoute& route : contract_routes()) {
    if (route.open) {
      EXPECT_NE(member(tried(route, ""), "code"), "auth.required") << told(route);
      continue;
    }
    SCOPED_TRACE(told(route));
    const Answer none = tried(route, "");
    EXPECT_PROBLEM(none, 401, "auth.required");
    EXPECT_EQ(none.headers.at("www-authenticate"), "Bearer realm=\"toile\"");
    for (const std::string& secret : {expired, revoked, accounts::new_secret()}) {
      const Answer refused = tried(route, secret);
      EXPECT_TRUE(refused.status == 401 || refused.status == 429) << refused.status << refused.body;
      EXPECT_EQ(refused.body.find(things["projects"]), std::string::npos);
    }
  }
  EXPECT_PROBLEM(get("/api/v1/nothing"), 401, "auth.required");
  EXPECT_PROBLEM(ask(port, "PATCH", "/api/v1/jobs"), 401, "auth.required");
  EXPECT_EQ(as(full, "GET", "/api/v1/projects/" + things["projects"]).status, 200) << "nothing has changed";
  EXPECT_EQ(as(full, "GET", "/api/v1/jobs/" + things["jobs"]).status, 200);
}

TEST_F(Accounts, WantsTheScopeThatAnOperationIsOf) {
  make_things();
  const std::string reader = token(anna, "read"), writer = token(anna, "submit"),
                    both = token(anna, "read,submit");
  for (const ContractRoute& route : contract_routes()) {
    if (route.open || route.link || told(route) == "DELETE /api/v1/session") continue;  // asks no scope
    SCOPED_TRACE(told(route));
    EXPECT_PROBLEM(tried(route, route.admin             ? both
                                : route.method == "GET" ? writer
                                                        : reader),
                   403, "auth.scope");
  }
  EXPECT_EQ(as(reader, "GET", "/api/v1/jobs").status, 200);
  EXPECT_EQ(
      as(both, "POST", "/api/v1/projects/" + things["projects"] + "/undo", "", "If-Match: *\r\n").status,
      409);
}

TEST_F(Accounts, WhatIsSomebodyElsesIsNotThere) {
  make_things();
  const std::string foreign = token(ben, "read,submit");
  const std::string project = "/api/v1/projects/" + things["projects"],
                    job = "/api/v1/jobs/" + things["jobs"],
                    asset = "/api/v1/assets/" + things["assets"] + "/content";
  const std::string before = as(full, "GET", project).body + as(full, "GET", job).body;
  for (const ContractRoute& route : contract_routes()) {
    if (route.open || route.admin) continue;
    SCOPED_TRACE(told(route));
    const Answer answer = tried(route, foreign);
    if (route.link) {  // a token is no link's secret
      EXPECT_TRUE(answer.status == 401 || answer.status == 429) << answer.status << answer.body;
      continue;
    }
    EXPECT_NE(answer.status, 403);
    if (route.path.find("{id}") != std::string::npos) EXPECT_PROBLEM(answer, 404, "store.not_found");
    if (answer.status >= 300) continue;
    for (const char* room : {"projects", "jobs"})
      EXPECT_EQ(answer.body.find(things[room]), std::string::npos) << answer.body;
  }
  EXPECT_EQ(as(full, "GET", project).body + as(full, "GET", job).body, before);
  EXPECT_EQ(as(full, "GET", asset).body, kPost);
}

TEST_F(Accounts, TheOwnerGetsAtEverythingThatOthersDoNot) {
  make_things();
  for (const ContractRoute& route : contract_routes()) {
    if (route.method != "GET" || route.path.find("{id}") == std::string::npos) continue;
    if (route.path.ends_with("/stream") || route.path.find("/pictures/") != std::string::npos) continue;
    const Answer answer = tried(route, route.link ? shared : full);
    EXPECT_TRUE(answer.status == 200 || answer.status == 422)
        << told(route) << ": " << answer.body.substr(0, 300);
  }
}

TEST_F(Accounts, ASecondAccountBeginsEmpty) {
  make_things();
  const std::string foreign = token(ben, "read,submit");
  for (const char* list : {"assets", "projects", "jobs"})
    EXPECT_EQ(as(foreign, "GET", std::string("/api/v1/") + list).body.find(things[list]), std::string::npos);
}

TEST_F(Accounts, OneKeyForTwoOwnersMakesTwoThings) {
  make_things();
  const std::string once = "Content-Type: application/json\r\nIdempotency-Key: once\r\n";
  const std::string foreign = token(ben, "read,submit");
  const std::string file = "Content-Type: application/octet-stream\r\n";
  const std::string asset = member(as(foreign, "POST", "/api/v1/bodies?name=post.obj", kPost, file), "id");
  const std::string hers = member(as(full, "POST", "/api/v1/projects", napkin_request(asset), once), "id");
  const std::string his = member(as(foreign, "POST", "/api/v1/projects", napkin_request(asset), once), "id");
  EXPECT_FALSE(hers.empty() || his.empty());
  EXPECT_NE(hers, his);
}

TEST_F(Accounts, AProjectNamesNoFilesOfOthers) {
  make_things();
  const Answer answer = as(token(ben, "read,submit"), "POST", "/api/v1/projects",
                           napkin_request(things["assets"]), "Content-Type: application/json\r\n");
  EXPECT_GE(answer.status, 400);
  EXPECT_LT(answer.status, 500);
}

TEST_F(Accounts, GuessesEndIn429WithATimeToWait) {
  Answer last;
  for (int i = 0; i < 12; ++i) last = as("guess" + std::to_string(i), "GET", "/api/v1/jobs");
  EXPECT_PROBLEM(last, 429, "auth.guesses");
  const int wait = std::stoi(last.headers.at("retry-after"));
  EXPECT_GT(wait, 0);
  EXPECT_LE(wait, 60);
  EXPECT_EQ(as(full, "GET", "/api/v1/jobs").status, 200) << "who is known goes on";
}

TEST_F(Accounts, ABodyOfWhoIsNotKnownIsNotRead) {
  Wire wire(port);
  wire.send(
      "POST /api/v1/assets?kind=body&name=a.obj HTTP/1.1\r\nHost: localhost\r\n"
      "Content-Type: application/octet-stream\r\nContent-Length: 90000000\r\n\r\n");
  EXPECT_EQ(read_answer(wire).status, 401);
}

TEST_F(Accounts, TheStreamIsForWhoMayLook) {
  make_things();
  const std::string target = "/api/v1/jobs/" + things["jobs"] + "/stream";
  EXPECT_EQ(Socket(port, target).status(), 401);
  EXPECT_EQ(Socket(port, target, shown(token(anna, "submit"))).status(), 403);
  EXPECT_EQ(Socket(port, target, shown(token(ben, "read"))).status(), 404);
  EXPECT_EQ(Socket(port, target, shown(token(anna, "read"))).status(), 101);
}

class AccountStreams : public Accounts {
 protected:
  std::string running_job() {
    make_things();
    const std::string job =
        member(as(full, "POST", "/api/v1/jobs", "{\"project_id\": \"" + things["projects"] + "\"}",
                  "Content-Type: application/json\r\n"),
               "id");
    return "/api/v1/jobs/" + job;
  }
};

TEST_F(AccountStreams, WhoMayOnlyLookCommandsNothing) {
  const std::string job = running_job();
  Socket viewer(port, job + "/stream", shown(token(anna, "read")));
  ASSERT_EQ(viewer.status(), 101);
  viewer.send(Socket::kText, R"({"type": "cancel"})");
  std::string said;
  for (int i = 0; i < 5 && said.find("auth.scope") == std::string::npos; ++i) {
    const auto message = viewer.read(5);
    if (!message) break;
    said += message->payload;
  }
  EXPECT_NE(said.find("auth.scope"), std::string::npos) << said;
  EXPECT_EQ(member(as(full, "GET", job), "state"), "queued");
}

TEST_F(AccountStreams, EndWhenTheirKeyIsRevoked) {
  const std::string job = running_job();
  const std::string secret = token(anna, "read");
  Socket viewer(port, job + "/stream", shown(secret));
  ASSERT_EQ(viewer.status(), 101);
  ASSERT_TRUE(store->accounts()->remove_key(anna.id, last_key));
  EXPECT_EQ(viewer.read_to_close(), 1008);
}

class SingleUser : public Served {
 protected:
  void SetUp() override { serve(); }
};

TEST_F(SingleUser, NeedsNoTokenAndIsNotAskedForOne) {
  EXPECT_EQ(get("/api/v1/jobs").status, 200);
  EXPECT_EQ(get("/api/v1/jobs", "Authorization: Bearer nonsense\r\n").status, 200);
  EXPECT_EQ(get("/metrics").status, 200);
}

TEST_F(SingleUser, IsToldThatThereAreNoAccounts) {
  const Answer who = get("/api/v1/session");
  EXPECT_EQ(who.status, 200);
  EXPECT_FALSE(*json::parse_json(who.body)->find("accounts")->boolean());
  EXPECT_PROBLEM(send_json("POST", "/api/v1/session", R"({"name": "a", "password": "b"})"), 409,
                 "auth.no_accounts");
  EXPECT_PROBLEM(ask(port, "DELETE", "/api/v1/session"), 409, "auth.no_accounts");
  EXPECT_PROBLEM(get("/api/v1/keys"), 409, "auth.no_accounts");
}

}  // namespace
}  // namespace toile::test
