#include "server/accounts/link_gate.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "server/accounts/secrets.h"
#include "tests/server/store/store_folder.h"

namespace toile {
namespace {

using accounts::LinkGate;

class LinkGateTest : public testing::Test {
 protected:
  LinkGateTest() : store(opened(folder.path())) {}

  /// A link to a job of that owner; its secret.
  std::string link_of(const std::string& owner, std::int64_t expires_ms = 0) {
    store::LinkRow row;
    row.owner = owner;
    row.expires_ms = expires_ms;
    row.job = store->create_job(store::RequestContext(owner), {}, "")->id;
    const std::string secret = accounts::new_secret();
    last = *store->links()->add_link(row, accounts::hash_of_secret(secret));
    return secret;
  }
  static std::string code(LinkGate& gate, const std::string& secret, const std::string& from = "192.0.2.1") {
    return code_of(gate.open(secret, from).link);
  }

  const TemporaryFolder folder;
  std::unique_ptr<store::Store> store;
  store::LinkRow last;
};

TEST_F(LinkGateTest, OpensByTheSecretAlone) {
  LinkGate gate(*store->links(), false);
  const std::string secret = link_of("local");
  EXPECT_EQ(gate.open(secret, "192.0.2.1").link->id, last.id);
  EXPECT_EQ(code(gate, last.id), "links.unknown");
  EXPECT_EQ(code(gate, accounts::hash_of_secret(secret)), "links.unknown") << "what is kept opens nothing";
  EXPECT_EQ(code(gate, ""), "auth.required");
  EXPECT_EQ(code(gate, link_of("local", 1)), "links.expired");
}

TEST_F(LinkGateTest, ShowsNothingOfNobodyOnceThereAreAccounts) {
  LinkGate before(*store->links(), false), since(*store->links(), true);
  const std::string secret = link_of("local");
  EXPECT_TRUE(before.open(secret, "192.0.2.1").link);
  EXPECT_EQ(code(since, secret), "links.revoked");
  EXPECT_FALSE(since.is_still_good(accounts::hash_of_secret(secret)));
  store::AccountRow row;
  row.name = "anna";
  row.id = store::kSingleUser;
  ASSERT_TRUE(store->accounts()->add_account(row));
  EXPECT_TRUE(since.open(secret, "192.0.2.1").link) << "whoever took over what the single user had";
}

TEST_F(LinkGateTest, BoundsWrongOnesByNetwork) {
  LinkGate gate(*store->links(), false);
  const std::string secret = link_of("local");
  for (int i = 0; i < LinkGate::kMostWrong; ++i)
    EXPECT_EQ(code(gate, "wrong", "2001:db8::1"), "links.unknown");
  EXPECT_EQ(code(gate, "wrong", "2001:db8::2"), "auth.guesses");
  EXPECT_EQ(code(gate, "wrong", "2001:db8:1::1"), "links.unknown");
  EXPECT_TRUE(gate.open(secret, "2001:db8::3").link);
}

TEST_F(LinkGateTest, SeatsAreGivenBack) {
  std::vector<std::shared_ptr<const store::LinkRow>> seats;
  {
    LinkGate gate(*store->links(), false);
    link_of("local");
    for (int i = 0; i < LinkGate::kMostViewers; ++i) seats.push_back(gate.seat(last));
    EXPECT_NE(seats.back(), nullptr);
    EXPECT_EQ(gate.seat(last), nullptr);
    seats.pop_back();
    seats.push_back(gate.seat(last));
    EXPECT_EQ(seats.back()->id, last.id);
  }
  seats.clear();  // after the gate
}

}  // namespace
}  // namespace toile
