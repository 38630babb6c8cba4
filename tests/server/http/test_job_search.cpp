// Jobs found by tag, state, project and time.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/server/http/with_accounts.h"

namespace toile::test {
namespace {

using Words = std::vector<std::string>;

class JobSearches : public Served {
 protected:
  void SetUp() override {
    serve();
    project = make_project();
  }
  Answer submit(const std::string& tags, const std::string& headers = "") {
    return send_json("POST", "/api/v1/jobs", "{\"project_id\": \"" + project + "\", \"tags\": " + tags + "}",
                     headers);
  }
  std::string job(const std::string& tags) { return member(submit(tags), "id"); }
  Words found(const std::string& query) {
    const Answer answer = get("/api/v1/jobs" + query);
    EXPECT_EQ(answer.status, 200) << answer.body;
    const auto tree = json::parse_json(answer.body, {.depth = 64});
    Words ids;
    for (const json::JsonValue& row : *tree->find("jobs")->array()) ids.push_back(*row.find("id")->text());
    return ids;
  }
  Words tags_of(const std::string& text) {
    const auto tree = json::parse_json(text, {.depth = 64});
    Words tags;
    for (const json::JsonValue& tag : *tree->find("tags")->array()) tags.push_back(*tag.text());
    return tags;
  }

  std::string project;
};

TEST_F(JobSearches, FindByTag) {
  const std::string spring = job(R"(["spring", "anna's choice"])"), autumn = job(R"(["autumn"])"),
                    plain = job("[]");
  EXPECT_EQ(found("?tag=spring"), Words{spring});
  EXPECT_EQ(found("?tag=anna%27s%20choice"), Words{spring});
  EXPECT_EQ(found("?tag=spr"), Words{}) << "whole words";
  EXPECT_EQ(found(""), (Words{plain, autumn, spring}));
  EXPECT_EQ(tags_of(get("/api/v1/jobs/" + spring).body), (Words{"anna's choice", "spring"}));
  const Answer changed = send_json("PUT", "/api/v1/jobs/" + plain + "/tags", R"({"tags": ["spring"]})");
  ASSERT_EQ(changed.status, 200) << changed.body;
  EXPECT_EQ(found("?tag=spring"), (Words{plain, spring}));
  ASSERT_EQ(send_json("PUT", "/api/v1/jobs/" + spring + "/tags", R"({"tags": []})").status, 200);
  EXPECT_EQ(found("?tag=spring"), Words{plain});
}

TEST_F(JobSearches, FindByStateProjectAndTime) {
  const std::string first = job("[]"), second = job("[]");
  ASSERT_EQ(ask(port, "POST", "/api/v1/jobs/" + first + "/cancel").status, 200);
  EXPECT_EQ(found("?state=cancelled"), Words{first});
  EXPECT_EQ(found("?state=queued,running"), Words{second});
  EXPECT_EQ(found("?state=queued,cancelled"), (Words{second, first}));
  project = make_project();
  const std::string other = job("[]");
  EXPECT_EQ(found("?project=" + project), Words{other});
  EXPECT_EQ(found("?project=" + project + "&state=cancelled"), Words{});
  const std::string made = std::to_string(store->job(kMe, other)->created_ms);
  EXPECT_EQ(found("?since=" + made).front(), other);
  const Words before = found("?until=" + made);
  EXPECT_EQ(std::count(before.begin(), before.end(), other), 0);
  EXPECT_EQ(found("?since=99999999999999"), Words{});
}

TEST_F(JobSearches, GoPageByPage) {
  Words made;
  for (int i = 0; i < 3; ++i) {
    made.insert(made.begin(), job(R"(["spring"])"));
    job("[]");
  }
  const Answer first = get("/api/v1/jobs?tag=spring&limit=2");
  const std::string next = member(first, "next");
  EXPECT_EQ(found("?tag=spring&limit=2"), (Words{made[0], made[1]}));
  EXPECT_EQ(found("?tag=spring&limit=2&cursor=" + next), Words{made[2]});
}

TEST_F(JobSearches, TagsGoAlongWithARetryAndAKey) {
  const Answer once = submit(R"(["spring"])", "Idempotency-Key: once\r\n");
  ASSERT_EQ(once.status, 201) << once.body;
  EXPECT_EQ(tags_of(submit(R"(["spring"])", "Idempotency-Key: once\r\n").body), Words{"spring"});
  const std::string id = member(once, "id");
  ASSERT_EQ(ask(port, "POST", "/api/v1/jobs/" + id + "/cancel").status, 200);
  const Answer again = ask(port, "POST", "/api/v1/jobs/" + id + "/retry");
  ASSERT_EQ(again.status, 201) << again.body;
  EXPECT_EQ(tags_of(again.body), Words{"spring"});
  ASSERT_EQ(ask(port, "DELETE", "/api/v1/jobs/" + id).status, 204);
  EXPECT_EQ(found("?tag=spring"), Words{member(again, "id")});
}

TEST_F(JobSearches, RefuseWhatIsNoTagAndNoFilter) {
  const std::string long_one(65, 'a');
  for (const std::string& tags : {std::string(R"("spring")"), std::string(R"([""])"),
                                  std::string(R"([" spring"])"), std::string(R"(["a", "a"])"),
                                  std::string(R"(["a\nb"])"), std::string("[1]"), "[\"" + long_one + "\"]"})
    EXPECT_PROBLEM(submit(tags), 422, "request.tags");
  EXPECT_EQ(found(""), Words{}) << "and nothing is draped";
  EXPECT_PROBLEM(get("/api/v1/jobs?state=asleep"), 400, "request.state");
  EXPECT_PROBLEM(get("/api/v1/jobs?since=yesterday"), 400, "request.since");
  EXPECT_PROBLEM(get("/api/v1/jobs?until=-1"), 400, "request.until");
  EXPECT_PROBLEM(get("/api/v1/jobs?colour=red"), 400, "request.unknown_parameter");
  EXPECT_PROBLEM(send_json("PUT", "/api/v1/jobs/j_0/tags", R"({"tags": []})"), 404, "store.not_found");
}

class AccountSearches : public Accounts {};

TEST_F(AccountSearches, FindAnOwnersOwnAlone) {
  make_things();
  const std::string json = "Content-Type: application/json\r\n";
  ASSERT_EQ(
      as(full, "PUT", "/api/v1/jobs/" + things["jobs"] + "/tags", R"({"tags": ["spring"]})", json).status,
      200);
  const std::string his = token(ben, "read,submit");
  for (const char* query : {"?tag=spring", "?state=succeeded", ""})
    EXPECT_EQ(as(his, "GET", std::string("/api/v1/jobs") + query).body.find(things["jobs"]),
              std::string::npos);
  EXPECT_NE(as(full, "GET", "/api/v1/jobs?tag=spring").body.find(things["jobs"]), std::string::npos);
  const std::string seen = as(shared, "GET", "/api/v1/shared/" + things["shared"]).body;
  EXPECT_NE(seen.find("state"), std::string::npos);
  EXPECT_EQ(seen.find("spring"), std::string::npos) << "who has a link sees no tags";
}

}  // namespace
}  // namespace toile::test
