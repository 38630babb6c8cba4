// Webhooks: told when a job has ended, signed, again after a failure and after a restart, never where nobody
// may be sent, and nobody else's.

#include <gtest/gtest.h>

#include <boost/asio/ip/address.hpp>

#include <condition_variable>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "server/accounts/signature.h"
#include "server/http/public_address.h"
#include "server/http/remote_url.h"
#include "server/webhooks/attempt.h"
#include "server/webhooks/deliverer.h"
#include "tests/server/http/with_accounts.h"

namespace toile::test {
namespace {

constexpr const char* kJson = "Content-Type: application/json\r\n";

/// What came in at the route of the test's own that stands for somebody else's server.
class Inbox {
 public:
  http::HttpResponse take(const http::HttpRequest& request) {
    const std::lock_guard hold(mutex_);
    messages_.push_back(request);
    http::HttpResponse response;
    response.status = statuses_.empty() ? 200 : statuses_.front();
    if (!statuses_.empty()) statuses_.erase(statuses_.begin());
    came_.notify_all();
    return response;
  }
  /// What the next requests are answered with; then 200.
  void answer_with(std::vector<int> statuses) {
    const std::lock_guard hold(mutex_);
    statuses_ = std::move(statuses);
  }
  /// Once there are so many; fewer when they do not come.
  std::vector<http::HttpRequest> wait_for(std::size_t count) {
    std::unique_lock hold(mutex_);
    came_.wait_for(hold, std::chrono::seconds(60), [&] { return messages_.size() >= count; });
    return messages_;
  }
  std::size_t count() {
    const std::lock_guard hold(mutex_);
    return messages_.size();
  }

 private:
  std::mutex mutex_;
  std::condition_variable came_;
  std::vector<http::HttpRequest> messages_;
  std::vector<int> statuses_;
};

/// A route of the server under test that takes what webhooks are told.
std::function<void(http::Router&)> inbox_route(Inbox& inbox) {
  return [&inbox](http::Router& router) {
    http::Route route;
    route.method = "POST";
    route.pattern = "/inbox";
    route.body = http::BodyKind::kJson;
    route.access = http::Access::kOpen;
    route.any_parameter = true;
    route.handler = [&inbox](const store::RequestContext&, const http::HttpRequest& request) {
      return inbox.take(request);
    };
    router.add(std::move(route));
  };
}

webhooks::DeliverySettings quick() {
  webhooks::DeliverySettings settings;
  settings.to_private = true;
  settings.look_every = std::chrono::milliseconds(20);
  settings.waits_ms = {30, 30, 30};
  return settings;
}

class Webhooks : public Served {
 protected:
  void SetUp() override {
    more_routes = inbox_route(inbox);
    serve();
  }
  void TearDown() override {
    deliverer.reset();
    Served::TearDown();
  }
  void deliver(const webhooks::DeliverySettings& settings = quick()) {
    deliverer.reset();
    deliverer = std::make_unique<webhooks::Deliverer>(*store::webhooks_of(*store), settings, log);
  }
  Answer make(const std::string& more = "") {
    return send_json(
        "POST", "/api/v1/webhooks",
        "{\"url\": \"http://127.0.0.1:" + std::to_string(port) + "/inbox?from=toile\"" + more + "}");
  }
  static std::string id_of(const Answer& made) {
    return *json::parse_json(made.body)->find("webhook")->find("id")->text();
  }
  std::string cancelled_job() {
    const std::string job = make_job();
    EXPECT_EQ(ask(port, "POST", "/api/v1/jobs/" + job + "/cancel").status, 200);
    return job;
  }
  /// The newest delivery once it is not `waiting`, or has been tried so often.
  json::JsonValue delivery(const std::string& webhook, int attempts = 99) {
    for (int tries = 0; tries < 600; ++tries) {
      const auto tree = json::parse_json(get("/api/v1/webhooks/" + webhook + "/deliveries").body);
      const auto& list = *tree->find("deliveries")->array();
      if (!list.empty() && (*list.front().find("outcome")->text() != "waiting" ||
                            *list.front().find("attempts")->number() >= attempts))
        return list.front();
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    ADD_FAILURE() << "it never came to an end";
    return {};
  }

  Inbox inbox;
  std::unique_ptr<webhooks::Deliverer> deliverer;
};

TEST_F(Webhooks, AreToldSignedThatAJobHasEnded) {
  const Answer made = make(R"(, "label": "Atelier")");
  ASSERT_EQ(made.status, 201) << made.body;
  EXPECT_EQ(made.headers.at("location"), "/api/v1/webhooks/" + id_of(made));
  EXPECT_EQ(made.headers.at("cache-control"), "no-store");
  const std::string secret = member(made, "secret"), job = cancelled_job();
  deliver();
  const std::vector<http::HttpRequest> came = inbox.wait_for(1);
  ASSERT_EQ(came.size(), 1u);
  EXPECT_EQ(came[0].parameter("from"), "toile");
  const auto said = json::parse_json(came[0].body);
  ASSERT_TRUE(said) << came[0].body;
  EXPECT_EQ(*said->find("job")->text(), job);
  EXPECT_EQ(*said->find("state")->text(), "cancelled");
  EXPECT_EQ(*said->find("event")->number(), 2);
  const std::string sign = came[0].header("toile-signature"), seconds = sign.substr(2, sign.find(',') - 2);
  EXPECT_EQ(sign, "t=" + seconds + ",v1=" + accounts::hmac_sha256(secret, seconds + "." + came[0].body));
  EXPECT_EQ(came[0].header("toile-delivery"),
            std::to_string(static_cast<int>(*said->find("delivery")->number())));
  const json::JsonValue done = delivery(id_of(made));
  EXPECT_EQ(*done.find("outcome")->text(), "delivered");
  EXPECT_EQ(*done.find("status")->number(), 200);
  EXPECT_EQ(get("/api/v1/webhooks").body.find(secret), std::string::npos) << "it is told once";
}

TEST_F(Webhooks, AreToldAgainAfterAFailureUntilTheyTakeIt) {
  const std::string id = id_of(make());
  inbox.answer_with({500, 302});
  cancelled_job();
  deliver();
  const std::vector<http::HttpRequest> came = inbox.wait_for(3);
  ASSERT_EQ(came.size(), 3u);
  EXPECT_EQ(came[0].body, came[2].body) << "the same, so that it is known again";
  const json::JsonValue done = delivery(id);
  EXPECT_EQ(*done.find("outcome")->text(), "delivered");
  EXPECT_EQ(*done.find("attempts")->number(), 3);
}

TEST_F(Webhooks, AreGivenUpInTheEndAndAtOnceWhereNobodyIs) {
  const std::string id = id_of(make());
  inbox.answer_with({500, 500, 500, 500, 500});
  cancelled_job();
  deliver();
  json::JsonValue done = delivery(id);
  EXPECT_EQ(*done.find("outcome")->text(), "given_up");
  EXPECT_EQ(*done.find("attempts")->number(), 4);
  EXPECT_EQ(*done.find("error")->text(), "the answer was 500");
  inbox.answer_with({410});
  cancelled_job();
  for (int tries = 0; tries < 600 && inbox.count() < 5; ++tries)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  done = delivery(id);
  EXPECT_EQ(*done.find("attempts")->number(), 1);
  EXPECT_EQ(*done.find("status")->number(), 410);
}

TEST_F(Webhooks, AreToldAfterARestartWhatWasStillToBeTold) {
  const std::string id = id_of(make());
  webhooks::DeliverySettings slow = quick();
  slow.waits_ms = {200};
  inbox.answer_with({500});
  const std::string job = cancelled_job();
  deliver(slow);
  inbox.wait_for(1);
  EXPECT_EQ(*delivery(id, 1).find("status")->number(), 500);
  deliverer.reset();
  let_go();
  store = std::move(*sqlite::open_sqlite_store((folder / "data").string()));
  const auto kept = store::webhooks_of(*store)->deliveries(kMe.owner, id, 10);
  ASSERT_TRUE(kept);
  ASSERT_EQ(kept->size(), 1u);
  EXPECT_EQ(kept->front().outcome, store::Outcome::kWaiting);
  EXPECT_EQ(kept->front().event.job, job);
  EXPECT_EQ(kept->front().attempts, 1);
  const auto due = store::webhooks_of(*store)->due_deliveries(kept->front().next_ms);
  ASSERT_TRUE(due);
  EXPECT_EQ(due->size(), 1u) << "so whoever delivers next tells it";
}

TEST_F(Webhooks, LeadToNoPrivateAddress) {
  const std::string id = id_of(make());
  const std::string name = id_of(send_json(
      "POST", "/api/v1/webhooks", "{\"url\": \"http://localhost:" + std::to_string(port) + "/inbox\"}"));
  cancelled_job();
  webhooks::DeliverySettings settings = quick();
  settings.to_private = false;
  deliver(settings);
  for (const std::string& webhook : {id, name}) {
    const json::JsonValue done = delivery(webhook);
    EXPECT_EQ(*done.find("outcome")->text(), "given_up");
    EXPECT_TRUE(done.find("error")->text()->starts_with("client.private_address"))
        << *done.find("error")->text();
  }
  EXPECT_EQ(inbox.count(), 0u);
}

TEST_F(Webhooks, HearOfWhatTheyWantAndCanBeTried) {
  const std::string id = id_of(make(R"(, "states": ["failed"])"));
  cancelled_job();
  deliver();
  ASSERT_EQ(ask(port, "POST", "/api/v1/webhooks/" + id + "/ping").status, 202);
  const std::vector<http::HttpRequest> came = inbox.wait_for(1);
  ASSERT_EQ(came.size(), 1u);
  EXPECT_EQ(*json::parse_json(came[0].body)->find("state")->text(), "ping")
      << "a cancelled one is not wanted";
  EXPECT_EQ(*delivery(id).find("outcome")->text(), "delivered");
}

TEST_F(Webhooks, AreTenAtMostAndGoWithWhatWaits) {
  std::vector<std::string> ids;
  for (int i = 0; i < 10; ++i) ids.push_back(id_of(make()));
  EXPECT_PROBLEM(make(), 409, "webhooks.too_many");
  cancelled_job();
  for (const std::string& id : ids) EXPECT_EQ(ask(port, "DELETE", "/api/v1/webhooks/" + id).status, 204);
  EXPECT_PROBLEM(ask(port, "DELETE", "/api/v1/webhooks/" + ids[0]), 404, "store.not_found");
  EXPECT_PROBLEM(get("/api/v1/webhooks/" + ids[0] + "/deliveries"), 404, "store.not_found");
  EXPECT_TRUE(store::webhooks_of(*store)->due_deliveries(std::int64_t{1} << 60)->empty());
}

TEST_F(Webhooks, RefuseWhatIsNoAddress) {
  for (const char* url : {"", "ftp://example.org/", "http://", "https://anna:secret@example.org/", "/inbox",
                          "http://example.org/#part", "http://example.org:/", "javascript:alert(1)"}) {
    EXPECT_PROBLEM(send_json("POST", "/api/v1/webhooks", std::string("{\"url\": \"") + url + "\"}"), 422,
                   "webhooks.url");
  }
  const std::string good = R"({"url": "https://example.org/a", )";
  EXPECT_PROBLEM(send_json("POST", "/api/v1/webhooks", good + R"("states": ["running"]})"), 422,
                 "webhooks.states");
  EXPECT_PROBLEM(send_json("POST", "/api/v1/webhooks", good + R"("states": []})"), 422, "webhooks.states");
  EXPECT_PROBLEM(send_json("POST", "/api/v1/webhooks", good + R"("secret": "mine"})"), 422,
                 "request.unknown_key");
}

class AccountWebhooks : public Accounts {
 protected:
  std::vector<store::OwnerId> owners_of_due() {
    const auto due = store::webhooks_of(*store)->due_deliveries(std::int64_t{1} << 60);
    EXPECT_TRUE(due);
    std::vector<store::OwnerId> owners;
    for (const store::DueDelivery& one : *due) owners.push_back(one.owner);
    return owners;
  }
};

TEST_F(AccountWebhooks, HearOfTheirOwnersJobsAlone) {
  make_things();  // a webhook of Anna's that wants to hear of cancelled jobs
  const std::string his = token(ben, "read,submit");
  const Answer made = as(his, "POST", "/api/v1/webhooks", R"({"url": "https://example.org/"})", kJson);
  ASSERT_EQ(made.status, 201) << made.body;
  const std::string wish = "{\"project_id\": \"" + things["projects"] + "\"}";
  const std::string job = member(as(full, "POST", "/api/v1/jobs", wish, kJson), "id");
  ASSERT_EQ(as(full, "POST", "/api/v1/jobs/" + job + "/cancel").status, 200);
  using Owners = std::vector<store::OwnerId>;
  EXPECT_EQ(owners_of_due(), Owners{anna.id});
  const std::string id = *json::parse_json(made.body)->find("webhook")->find("id")->text();
  EXPECT_PROBLEM(as(full, "GET", "/api/v1/webhooks/" + id + "/deliveries"), 404, "store.not_found");
  EXPECT_EQ(as(full, "GET", "/api/v1/webhooks").body.find(id), std::string::npos);
  ASSERT_EQ(as(his, "POST", "/api/v1/webhooks/" + id + "/ping").status, 202);
  EXPECT_EQ(owners_of_due().size(), 2u);
  store::AccountRow locked = ben;
  locked.locked = true;
  ASSERT_TRUE(store->accounts()->change_account(locked));
  EXPECT_EQ(owners_of_due(), Owners{anna.id}) << "a locked account's are not told";
}

TEST(WebhookParts, SignAsRfc4231Says) {
  EXPECT_EQ(accounts::hmac_sha256("Jefe", "what do ya want for nothing?"),
            "5bdcc146bf60754e6a042426089575c75a003f089d2739839dec58b964ec3843");
}

TEST(WebhookParts, KnowWhichAddressesAreOfTheInternet) {
  const auto is_public = [](const char* text) {
    return http::is_public(boost::asio::ip::make_address(text));
  };
  for (const char* text : {"0.0.0.0",
                           "10.1.2.3",
                           "100.64.0.1",
                           "100.127.255.255",
                           "127.0.0.1",
                           "127.9.9.9",
                           "169.254.169.254",
                           "172.16.0.1",
                           "172.31.255.255",
                           "192.0.0.8",
                           "192.168.1.1",
                           "198.18.0.1",
                           "198.19.255.255",
                           "203.0.113.9",
                           "224.0.0.1",
                           "255.255.255.255",
                           "::",
                           "::1",
                           "fe80::1",
                           "fc00::1",
                           "fd12::1",
                           "ff02::1",
                           "::ffff:127.0.0.1",
                           "::ffff:10.0.0.1",
                           "64:ff9b::7f00:1",
                           "2002:7f00:1::",
                           "2001:db8::1",
                           "2001::1",
                           "3fff::1"})
    EXPECT_FALSE(is_public(text)) << text;
  for (const char* text :
       {"1.1.1.1", "100.128.0.1", "172.32.0.1", "192.169.0.1", "198.20.0.1", "223.255.255.1",
        "2606:4700::1111", "2a00:1450::1", "2001:4860::1", "::ffff:1.1.1.1"})
    EXPECT_TRUE(is_public(text)) << text;
}

TEST(WebhookParts, TakeAnAddressApart) {
  const auto parts = http::read_remote_url("https://example.org:8443/told/by?toile=1&a=%20");
  ASSERT_TRUE(parts);
  EXPECT_EQ(parts->origin, "https://example.org:8443");
  EXPECT_EQ(parts->target, "/told/by?toile=1&a=%20");
  EXPECT_EQ(http::read_remote_url("http://[::1]")->target, "/");
  EXPECT_EQ(http::read_remote_url("http://[::1]")->origin, "http://[::1]");
  EXPECT_FALSE(http::read_remote_url("https://example.org/" + std::string(1000, 'a')));
}

TEST(WebhookParts, WaitLongerAndLongerBetweenAttempts) {
  store::DeliveryRow row;
  std::int64_t before = 0;
  for (const std::int64_t wait : webhooks::usual_waits()) {
    EXPECT_GT(wait, before);
    row = webhooks::after_attempt(row, Result<int>(503), 1000, webhooks::usual_waits());
    EXPECT_EQ(row.outcome, store::Outcome::kWaiting);
    EXPECT_EQ(row.next_ms, 1000 + wait);
    before = wait;
  }
  EXPECT_EQ(webhooks::after_attempt(row, Result<int>(503), 1000, webhooks::usual_waits()).outcome,
            store::Outcome::kGivenUp);
}

}  // namespace
}  // namespace toile::test
