// How people come in by a browser, and go.

#include <cstdint>
#include <string>

#include "server/accounts/passwords.h"
#include "tests/server/http/with_accounts.h"

namespace toile::test {
namespace {

class Sessions : public Accounts {
 protected:
  void SetUp() override {
    Accounts::SetUp();
    anna.password = *accounts::hash_of_password(kPassword);
    ASSERT_TRUE(store->accounts()->change_account(anna));
  }
  Answer log_in(const std::string& name, const std::string& password, const std::string& headers = "") {
    return send_json("POST", "/api/v1/session",
                     R"({"name": ")" + name + R"(", "password": ")" + password + "\"}", headers);
  }
  /// A Cookie line of what the answer set.
  static std::string cookie_of(const Answer& answer) {
    const auto set = answer.headers.find("set-cookie");
    if (set == answer.headers.end()) return "";
    return "Cookie: " + set->second.substr(0, set->second.find(';')) + "\r\n";
  }
  std::string own_origin() const { return "Origin: http://localhost:" + std::to_string(port) + "\r\n"; }

  static constexpr const char* kPassword = "correct horse";
};

TEST_F(Sessions, BeginWithAPasswordAndEndWhenTheyAreEnded) {
  const Answer in = log_in("anna", kPassword);
  ASSERT_EQ(in.status, 204) << in.body;
  const std::string set = in.headers.at("set-cookie");
  for (const char* part : {"toile=toile_", "HttpOnly", "SameSite=Strict", "Path=/", "Max-Age=604800"})
    EXPECT_NE(set.find(part), std::string::npos) << part << " is not in " << set;
  EXPECT_EQ(set.find("Secure"), std::string::npos) << "the loopback without TLS: browsers would drop it";
  const std::string cookie = cookie_of(in);
  const Answer who = get("/api/v1/session", cookie);
  EXPECT_EQ(member(who, "name"), "anna");
  EXPECT_EQ(who.body.find("toile_"), std::string::npos);
  EXPECT_EQ(get("/api/v1/jobs", cookie).status, 200);
  const Answer out = ask(port, "DELETE", "/api/v1/session", "", cookie + own_origin());
  EXPECT_EQ(out.status, 204) << out.body;
  EXPECT_NE(out.headers.at("set-cookie").find("Max-Age=0"), std::string::npos);
  EXPECT_EQ(get("/api/v1/jobs", cookie).status, 401) << "also for whoever kept the cookie";
}

TEST_F(Sessions, BeginWithATokenAndHaveItsScopesAndItsEnd) {
  const std::int64_t soon =
      store->accounts()->key_of_secret(accounts::hash_of_secret(full))->key.created_ms + 60'000;
  const Answer in =
      send_json("POST", "/api/v1/session", R"({"token": ")" + token(anna, "read", soon) + "\"}");
  ASSERT_EQ(in.status, 204) << in.body;
  const std::string cookie = cookie_of(in);
  EXPECT_EQ(get("/api/v1/jobs", cookie).status, 200);
  EXPECT_PROBLEM(send_json("POST", "/api/v1/jobs", "{}", cookie + own_origin()), 403, "auth.scope");
  const auto told = json::parse_json(get("/api/v1/session", cookie).body);
  EXPECT_EQ(*told->find("expires_ms")->number(), static_cast<double>(soon));
  EXPECT_PROBLEM(send_json("POST", "/api/v1/session", R"({"token": "toile_0"})"), 401, "auth.token");
}

TEST_F(Sessions, RefuseInTheSameWordsWhateverIsWrong) {
  const Answer wrong = log_in("anna", "wrong horse");
  EXPECT_PROBLEM(wrong, 401, "auth.password");
  EXPECT_EQ(log_in("nobody", kPassword).body, wrong.body);
  EXPECT_EQ(log_in("ben", "").body, wrong.body) << "he has no password";
  anna.locked = true;
  ASSERT_TRUE(store->accounts()->change_account(anna));
  EXPECT_EQ(log_in("anna", kPassword).body, wrong.body);
  EXPECT_EQ(wrong.headers.count("set-cookie"), 0u);
}

TEST_F(Sessions, AllowFiveWrongPasswordsAMinuteAndThenNotTheRightOneEither) {
  for (int i = 0; i < accounts::LogIn::kMostWrong; ++i)
    EXPECT_PROBLEM(log_in("anna", "guess number " + std::to_string(i)), 401, "auth.password");
  const Answer late = log_in("anna", kPassword);
  EXPECT_PROBLEM(late, 429, "auth.guesses");
  EXPECT_GT(std::stoi(late.headers.at("retry-after")), 0);
  for (int i = 0; i < 15; ++i) log_in("name" + std::to_string(i), "wrong horse");
  EXPECT_PROBLEM(log_in("somebody", "wrong horse"), 429, "auth.guesses");
}

TEST_F(Sessions, ACookieDoesNothingForPagesOfOthers) {
  const std::string cookie = cookie_of(log_in("anna", kPassword));
  const std::string json = "Content-Type: application/json\r\n";
  EXPECT_PROBLEM(ask(port, "POST", "/api/v1/jobs", "{}", json + cookie), 403, "http.origin");
  EXPECT_PROBLEM(ask(port, "POST", "/api/v1/jobs", "{}", json + cookie + "Origin: https://evil.example\r\n"),
                 403, "http.origin");
  EXPECT_PROBLEM(ask(port, "POST", "/api/v1/jobs", "{}", json + cookie + own_origin()), 422,
                 "request.project_id");
  make_things();
  const std::string stream = "/api/v1/jobs/" + things["jobs"] + "/stream";
  EXPECT_EQ(Socket(port, stream, cookie).status(), 403);
  EXPECT_EQ(Socket(port, stream, cookie + own_origin()).status(), 101);
}

TEST_F(Sessions, ACookiesKeyIsNoTokenNorATokenACookie) {
  const std::string cookie = cookie_of(log_in("anna", kPassword));
  const std::string secret = cookie.substr(cookie.find('=') + 1, 70);
  EXPECT_PROBLEM(as(secret, "GET", "/api/v1/jobs"), 401, "auth.token");
  EXPECT_PROBLEM(get("/api/v1/jobs", "Cookie: toile=" + full + "\r\n"), 401, "auth.token");
  EXPECT_EQ(get("/api/v1/jobs", "Cookie: a=b; toile=" + secret + "; c=d\r\n").status, 200);
  EXPECT_EQ(get("/api/v1/jobs", "Cookie: nottoile=" + secret + "\r\n").status, 401);
}

TEST_F(Sessions, AreListedAmongTheKeysAndRevokedThere) {
  const std::string cookie = cookie_of(log_in("anna", kPassword));
  const auto keys = json::parse_json(get("/api/v1/keys", cookie).body);
  ASSERT_TRUE(keys && keys->find("keys"));
  const json::JsonValue& newest = keys->find("keys")->array()->front();
  EXPECT_EQ(*newest.find("kind")->text(), "session");
  const std::string address = "/api/v1/keys/" + *newest.find("id")->text();
  EXPECT_PROBLEM(as(token(ben, "read,submit"), "DELETE", address), 404, "store.not_found");
  EXPECT_EQ(as(full, "DELETE", address).status, 204);
  EXPECT_EQ(get("/api/v1/jobs", cookie).status, 401);
}

}  // namespace
}  // namespace toile::test
