#include "server/accounts/gate.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <set>
#include <string>

#include "server/accounts/passwords.h"
#include "server/accounts/secrets.h"
#include "tests/server/store/store_folder.h"

namespace toile {
namespace {

using accounts::Gate;

class GateTest : public testing::Test {
 protected:
  GateTest() : store(opened(folder.path())), kept(*store->accounts()), gate(kept) {}

  store::AccountRow account(const std::string& name, bool admin = false) {
    store::AccountRow row;
    row.name = name;
    row.admin = admin;
    return *kept.add_account(row);
  }
  std::string token(const store::AccountRow& of, const std::string& scopes = "read,submit",
                    std::int64_t expires_ms = 0) {
    store::KeyRow key;
    key.owner = of.id;
    key.scopes = *store::scopes_from(scopes);
    key.expires_ms = expires_ms;
    const std::string secret = accounts::new_secret();
    EXPECT_TRUE(kept.add_key(key, accounts::hash_of_secret(secret)));
    return secret;
  }
  std::string code(const std::string& shown, const std::string& address = "192.0.2.1") {
    return code_of(gate.who({shown, "", address}).caller);
  }

  const TemporaryFolder folder;
  std::unique_ptr<store::Store> store;
  store::Accounts& kept;
  Gate gate;
};

TEST(Secrets, AreAllChanceAndKeptAsAHashThatIsAlwaysTheSame) {
  std::set<std::string> seen;
  for (int i = 0; i < 100; ++i) seen.insert(accounts::new_secret());
  EXPECT_EQ(seen.size(), 100u);
  for (const std::string& secret : seen) EXPECT_EQ(secret.size(), 6 + 64u);
  // BLAKE2b of 32 bytes without key, of RFC 7693's example text.
  EXPECT_EQ(accounts::hash_of_secret("abc"),
            "bddd813c634239723171ef3fee98579b94964e3bb1cb3e427262c8c068d52319");
}

TEST(Passwords, AreKeptAsArgon2idWithASaltOfTheirOwn) {
  const auto hash = accounts::hash_of_password("correct horse");
  ASSERT_TRUE(hash);
  EXPECT_TRUE(hash->starts_with("$argon2id$v=19$m=19456,t=2,p=1$")) << *hash;
  EXPECT_NE(*accounts::hash_of_password("correct horse"), *hash);
  EXPECT_TRUE(accounts::is_password("correct horse", *hash));
  EXPECT_FALSE(accounts::is_password("Correct horse", *hash));
  EXPECT_FALSE(accounts::is_password("", *hash));
  EXPECT_FALSE(accounts::is_password("", "")) << "who has none is let in by none";
  EXPECT_FALSE(accounts::is_password(std::string(300, 'a'), *hash));
  EXPECT_EQ(code_of(accounts::hash_of_password("short")), "accounts.password");
  EXPECT_EQ(code_of(accounts::hash_of_password(std::string(257, 'a'))), "accounts.password");
}

TEST(Scopes, AreReadAsTheyAreWritten) {
  for (const char* text : {"read", "submit", "read,submit", "read,submit,admin"})
    EXPECT_EQ(to_text(*store::scopes_from(text)), text);
  for (const char* text : {"", ",", "read,", "write", "read;submit", "Read"})
    EXPECT_EQ(code_of(store::scopes_from(text)), "accounts.scope") << text;
}

TEST_F(GateTest, LetsInWhoeverShowsAGoodToken) {
  const store::AccountRow anna = account("anna");
  const auto answer = gate.who({token(anna), "", "192.0.2.1"});
  ASSERT_TRUE(answer.caller);
  EXPECT_EQ(answer.caller->account.id, anna.id);
  EXPECT_EQ(to_text(answer.caller->scopes), "read,submit");
  EXPECT_EQ(code(""), "auth.required");
  EXPECT_EQ(code("toile_"), "auth.token");
  EXPECT_EQ(code(accounts::new_secret()), "auth.token");
}

TEST_F(GateTest, KnowsNoTokenThatIsExpiredRevokedOrOfALockedAccount) {
  store::AccountRow anna = account("anna");
  const std::string past = token(anna, "read", 1), future = token(anna, "read", 4'000'000'000'000);
  const std::string good = token(anna);
  const std::string hash = accounts::hash_of_secret(good);
  EXPECT_EQ(code(past), "auth.token");
  EXPECT_EQ(code(future), "ok");
  EXPECT_EQ(code(good), "ok");
  anna.locked = true;
  ASSERT_TRUE(kept.change_account(anna));
  EXPECT_EQ(code(good), "auth.token");
  EXPECT_FALSE(gate.is_still_good(hash));
  anna.locked = false;
  ASSERT_TRUE(kept.change_account(anna));
  EXPECT_TRUE(gate.is_still_good(hash));
  const Result<std::vector<store::KeyRow>> keys = kept.keys(anna.id);
  ASSERT_TRUE(keys);
  for (const store::KeyRow& key : *keys) ASSERT_TRUE(kept.remove_key(anna.id, key.id));
  EXPECT_EQ(code(good), "auth.token");
  EXPECT_FALSE(gate.is_still_good(hash));
}

TEST_F(GateTest, TakesTheScopeAdminForWhatTheAccountMayNow) {
  store::AccountRow root = account("root", true);
  const std::string secret = token(root, "read,admin");
  EXPECT_EQ(to_text(gate.who({secret, "", ""}).caller->scopes), "read,admin");
  root.admin = false;
  ASSERT_TRUE(kept.change_account(root));
  EXPECT_EQ(to_text(gate.who({secret, "", ""}).caller->scopes), "read");
}

TEST_F(GateTest, AnAddressThatWasWrongOftenIsToldToWaitAndOthersAreNot) {
  const std::string good = token(account("anna"));
  for (int i = 0; i < Gate::kMostWrongTokens; ++i) EXPECT_EQ(code("guess" + std::to_string(i)), "auth.token");
  const auto answer = gate.who({"another guess", "", "192.0.2.1"});
  EXPECT_EQ(code_of(answer.caller), "auth.guesses");
  EXPECT_GT(answer.wait.count(), 0);
  EXPECT_LE(answer.wait.count(), 60);
  EXPECT_EQ(code("guess", "192.0.2.2"), "auth.token");
  EXPECT_EQ(code(good), "ok") << "who is known there goes on";
  EXPECT_EQ(code(""), "auth.required") << "and who shows nothing guesses nothing";
}

}  // namespace
}  // namespace toile
