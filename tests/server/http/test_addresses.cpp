// Where a server may listen, and how it is come to there.

#include <optional>
#include <string>

#include "server/accounts/passwords.h"
#include "server/http/address_rules.h"
#include "tests/server/http/with_accounts.h"

namespace toile::test {
namespace {

class Addresses : public Served {
 protected:
  Error refused(http::ServerSettings settings) {
    settings.port = 0;
    http::HttpServer other(*store, *jobs, hub, settings);
    const Status started = other.start();
    return started ? Error() : started.error();
  }
};

TEST_F(Addresses, BeyondTheLoopbackWantAccountsAndTls) {
  serve({}, false, true);
  http::ServerSettings open;
  for (const char* everywhere : {"0.0.0.0", "::", "192.0.2.1"}) {
    open.address = everywhere;
    EXPECT_EQ(refused(open).code, "server.address") << everywhere;
    EXPECT_NE(refused(open).message.find("toile account add"), std::string::npos) << "the way out";
  }
  http::ServerSettings plain = open;
  plain.gate = &doors->gate;
  EXPECT_EQ(refused(plain).code, "server.address");
  EXPECT_NE(refused(plain).message.find("--tls-certificate"), std::string::npos) << refused(plain).message;
  http::ServerSettings no_accounts = open;
  no_accounts.behind_proxy = true;
  EXPECT_EQ(refused(no_accounts).code, "server.address");
  http::ServerSettings good = plain;
  good.behind_proxy = true;
  good.address = "0.0.0.0";
  EXPECT_EQ(refused(good).code, "");
  for (const char* loopback : {"127.0.0.1", "localhost", "127.8.9.1"}) {
    http::ServerSettings own;
    own.address = loopback;
    EXPECT_EQ(refused(own).code, "") << loopback;
  }
}

TEST_F(Addresses, OfAContainerAreForTheMachineAroundItAlone) {
  const auto ip = [](const char* text) { return boost::asio::ip::make_address(text); };
  const auto gateway = std::optional(ip("172.17.0.1"));
  EXPECT_TRUE(http::is_host_of_container(ip("172.17.0.1"), ip("172.17.0.2"), gateway));
  EXPECT_TRUE(http::is_host_of_container(ip("127.0.0.1"), ip("127.0.0.1"), gateway)) << "the health check";
  EXPECT_TRUE(http::is_host_of_container(ip("::ffff:172.17.0.1"), ip("::ffff:172.17.0.2"), gateway));
  EXPECT_TRUE(http::is_host_of_container(ip("10.0.2.100"), ip("10.0.2.100"), std::nullopt));
  EXPECT_FALSE(http::is_host_of_container(ip("172.17.0.3"), ip("172.17.0.2"), gateway))
      << "another container";
  EXPECT_FALSE(http::is_host_of_container(ip("203.0.113.9"), ip("172.17.0.2"), gateway));
  EXPECT_FALSE(http::is_host_of_container(ip("172.17.0.1"), ip("172.17.0.2"), std::nullopt));
}

class BehindAProxy : public Accounts {
 protected:
  void SetUp() override {
    http::ServerSettings settings;
    settings.behind_proxy = true;
    serve(settings, false, true);
    anna = account("anna", true);
    anna.password = *accounts::hash_of_password("correct horse");
    ASSERT_TRUE(store->accounts()->change_account(anna));
    full = token(anna, "read,submit,admin");
  }
};

TEST_F(BehindAProxy, AnyNameOfTheServerIsGoodAndItsPageComesByHttps) {
  Wire wire(port);
  wire.send("GET /api/v1/jobs HTTP/1.1\r\nHost: toile.example\r\n" + shown(full) + "\r\n");
  EXPECT_EQ(read_answer(wire).status, 200);
  const std::string json = "Content-Type: application/json\r\n";
  const std::string host = "localhost:" + std::to_string(port) + "\r\n";
  EXPECT_EQ(as(full, "POST", "/api/v1/jobs", "{}", json + "Origin: https://" + host).status, 422);
  EXPECT_EQ(as(full, "POST", "/api/v1/jobs", "{}", json + "Origin: http://" + host).status, 403);
  const Answer in = send_json("POST", "/api/v1/session", R"({"name": "anna", "password": "correct horse"})");
  EXPECT_TRUE(in.headers.at("set-cookie").starts_with("__Host-toile=")) << in.headers.at("set-cookie");
  EXPECT_TRUE(in.headers.at("set-cookie").ends_with("; Secure"));
}

TEST_F(BehindAProxy, GuessesCountForWhomTheProxyNames) {
  const auto guess = [&](const std::string& from) {
    return as("guess", "GET", "/api/v1/jobs", "", "X-Forwarded-For: 192.0.2.250, " + from + "\r\n").status;
  };
  for (int i = 0; i < accounts::Gate::kMostWrongTokens; ++i) EXPECT_EQ(guess("192.0.2.7"), 401);
  EXPECT_EQ(guess("192.0.2.7"), 429);
  EXPECT_EQ(guess("192.0.2.8"), 401) << "another, though the proxy is the same";
}

}  // namespace
}  // namespace toile::test
