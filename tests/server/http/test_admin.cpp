// What whoever runs the service sees of it, and nobody else.

#include <string>

#include "tests/server/http/with_accounts.h"

namespace toile::test {
namespace {

class Admin : public Accounts {
 protected:
  Result<json::JsonValue> told(const std::string& what) {
    return json::parse_json(as(full, "GET", "/api/v1/admin/" + what).body, {.depth = 16});
  }
};

TEST_F(Admin, SeesWhoThereIsAndWhatTheyKeep) {
  make_things();
  const auto list = told("accounts");
  ASSERT_TRUE(list);
  const std::vector<json::JsonValue>& accounts = *list->find("accounts")->array();
  ASSERT_EQ(accounts.size(), 2u);
  EXPECT_EQ(*accounts[0].find("name")->text(), "anna");
  EXPECT_EQ(*accounts[0].find("projects")->number(), 1);
  EXPECT_GT(*accounts[0].find("bytes")->number(), 0);
  EXPECT_EQ(*accounts[1].find("name")->text(), "ben");
  EXPECT_EQ(*accounts[1].find("bytes")->number(), 0);
  EXPECT_FALSE(accounts[0].find("password"));
}

TEST_F(Admin, SeesTheDrapesOfEverybodyThatHaveNotEnded) {
  const std::string his = token(ben, "read,submit");
  const std::string json = "Content-Type: application/json\r\n";
  const std::string asset = member(
      as(his, "POST", "/api/v1/bodies?name=post.obj", kPost, "Content-Type: application/octet-stream\r\n"),
      "id");
  const std::string project = member(as(his, "POST", "/api/v1/projects", napkin_request(asset), json), "id");
  const std::string job =
      member(as(his, "POST", "/api/v1/jobs", "{\"project_id\": \"" + project + "\"}", json), "id");
  const auto list = told("jobs");
  ASSERT_TRUE(list);
  const std::vector<json::JsonValue>& seen = *list->find("jobs")->array();
  ASSERT_EQ(seen.size(), 1u);
  EXPECT_EQ(*seen[0].find("id")->text(), job);
  EXPECT_EQ(*seen[0].find("account")->text(), "ben");
  EXPECT_PROBLEM(as(full, "GET", "/api/v1/jobs/" + job), 404, "store.not_found");
}

TEST_F(Admin, SeesTheLoad) {
  const auto load = told("load");
  ASSERT_TRUE(load);
  EXPECT_TRUE(*load->find("ready")->boolean());
  EXPECT_GT(*load->find("disk_free_bytes")->number(), 0);
}

TEST_F(Admin, LocksOthersAndNotThemselves) {
  const std::string his = token(ben, "read");
  const std::string address = "/api/v1/admin/accounts/" + ben.id;
  EXPECT_EQ(as(full, "POST", address + "/lock").status, 204);
  EXPECT_EQ(as(his, "GET", "/api/v1/jobs").status, 401);
  EXPECT_EQ(as(full, "POST", address + "/unlock").status, 204);
  EXPECT_EQ(as(his, "GET", "/api/v1/jobs").status, 200);
  EXPECT_PROBLEM(as(full, "POST", "/api/v1/admin/accounts/" + anna.id + "/lock"), 409, "auth.own_account");
  EXPECT_PROBLEM(as(full, "POST", "/api/v1/admin/accounts/u_0/lock"), 404, "store.not_found");
}

TEST_F(Admin, IsNobodyWhoseAccountIsNoneAnyMore) {
  anna.admin = false;
  ASSERT_TRUE(store->accounts()->change_account(anna));
  EXPECT_PROBLEM(as(full, "GET", "/api/v1/admin/jobs"), 403, "auth.scope");
}

}  // namespace
}  // namespace toile::test
