#include <gtest/gtest.h>

#include <string>

#include "server/store/accounts.h"
#include "tests/server/store/store_folder.h"

namespace toile {
namespace {

store::AccountRow row_of(const std::string& name, const std::string& id = "") {
  store::AccountRow row;
  row.name = name;
  row.id = id;
  return row;
}

store::KeyRow key_of(const std::string& owner, std::int64_t expires_ms = 0) {
  store::KeyRow key;
  key.owner = owner;
  key.label = "press";
  key.scopes = *store::scopes_from("read");
  key.expires_ms = expires_ms;
  return key;
}

TEST(Accounts, AreKeptOverAReopening) {
  const TemporaryFolder folder;
  std::string id;
  {
    const auto store = opened(folder.path());
    const auto added = store->accounts()->add_account(row_of("anna"));
    ASSERT_TRUE(added);
    id = added->id;
    EXPECT_TRUE(id.starts_with("u_")) << id;
    ASSERT_TRUE(store->accounts()->add_key(key_of(id), "hash"));
  }
  const auto store = opened(folder.path());
  EXPECT_EQ(store->accounts()->account_named("anna")->id, id);
  const auto known = store->accounts()->key_of_secret("hash");
  ASSERT_TRUE(known);
  EXPECT_EQ(known->account.name, "anna");
  EXPECT_EQ(known->key.owner, id);
  EXPECT_EQ(known->key.label, "press");
  EXPECT_EQ(to_text(known->key.scopes), "read");
  EXPECT_GT(known->key.created_ms, 1'735'689'600'000);
}

TEST(Accounts, HaveOneNameEachAndOneHasWhatTheSingleUserMade) {
  const TemporaryFolder folder;
  const auto store = opened(folder.path());
  store::Accounts& accounts = *store->accounts();
  ASSERT_TRUE(accounts.add_account(row_of("anna", store::kSingleUser)));
  EXPECT_EQ(code_of(accounts.add_account(row_of("anna"))), "accounts.taken");
  EXPECT_EQ(code_of(accounts.add_account(row_of("ben", store::kSingleUser))), "accounts.taken");
  ASSERT_TRUE(accounts.add_account(row_of("ben")));
  for (const char* name : {"", "Ben", ".ben", "b en", "b/en", "b\nen", "bj\xc3\xb6rn"})
    EXPECT_EQ(code_of(accounts.add_account(row_of(name))), "accounts.name") << name;
  EXPECT_EQ(code_of(accounts.add_account(row_of(std::string(65, 'a')))), "accounts.name");
  EXPECT_EQ(accounts.accounts()->size(), 2u);
  EXPECT_EQ(code_of(accounts.account_named("carl")), "store.not_found");
}

TEST(Accounts, KeysAreTheirOwnersToRemove) {
  const TemporaryFolder folder;
  const auto store = opened(folder.path());
  store::Accounts& accounts = *store->accounts();
  const std::string anna = accounts.add_account(row_of("anna"))->id;
  const std::string ben = accounts.add_account(row_of("ben"))->id;
  const std::string key = accounts.add_key(key_of(anna), "h1")->id;
  EXPECT_EQ(code_of(accounts.remove_key(ben, key)), "store.not_found");
  EXPECT_TRUE(accounts.keys(ben)->empty());
  EXPECT_EQ(accounts.keys(anna)->size(), 1u);
  EXPECT_EQ(code_of(accounts.remove_key(anna, key)), "ok");
  EXPECT_EQ(code_of(accounts.remove_key(anna, key)), "store.not_found");
  EXPECT_EQ(code_of(accounts.key_of_secret("h1")), "store.not_found");
}

TEST(Accounts, KeysOfAKindGoTogetherAndWhatHasExpiredWithTheNextThatIsMade) {
  const TemporaryFolder folder;
  const auto store = opened(folder.path());
  store::Accounts& accounts = *store->accounts();
  const std::string anna = accounts.add_account(row_of("anna"))->id;
  ASSERT_TRUE(accounts.add_key(key_of(anna, 1), "old"));
  EXPECT_TRUE(accounts.key_of_secret("old")) << "whoever asks decides what has expired";
  store::KeyRow session = key_of(anna);
  session.kind = store::KeyKind::kSession;
  ASSERT_TRUE(accounts.add_key(session, "session"));
  ASSERT_TRUE(accounts.add_key(key_of(anna), "token"));
  EXPECT_EQ(code_of(accounts.key_of_secret("old")), "store.not_found");
  ASSERT_TRUE(accounts.remove_keys(anna, store::KeyKind::kSession));
  EXPECT_EQ(code_of(accounts.key_of_secret("session")), "store.not_found");
  EXPECT_EQ(code_of(accounts.key_of_secret("token")), "ok");
}

}  // namespace
}  // namespace toile
