#include "server/shares/owner_shares.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

TEST(OwnerShares, CountUpWhatEachHasHad) {
  shares::OwnerShares shares;
  shares.enter("ann");
  shares.enter("bob");
  shares.charge("ann", 2);
  shares.charge("ann", 1);
  EXPECT_EQ(shares.had("ann"), 3);
  EXPECT_EQ(shares.had("bob"), 0);
  EXPECT_EQ(shares.had("eve"), 0);
}

TEST(OwnerShares, WhoComesLateIsOwedNothingForThePast) {
  shares::OwnerShares shares;
  shares.enter("ann");
  shares.charge("ann", 100);
  shares.enter("bob");
  EXPECT_EQ(shares.had("bob"), 100) << "else ann would wait until he has had as much";
}

TEST(OwnerShares, WhoGoesForAMomentKeepsWhatHeHasHad) {
  shares::OwnerShares shares;
  shares.enter("ann");
  shares.enter("bob");
  shares.charge("ann", 50);
  shares.leave("ann");
  shares.enter("ann");
  EXPECT_EQ(shares.had("ann"), 50);
}

TEST(OwnerShares, WhoStaysAwaySavesNothingUp) {
  shares::OwnerShares shares;
  shares.enter("ann");
  shares.enter("bob");
  shares.leave("ann");
  shares.charge("bob", 70);
  shares.enter("ann");
  EXPECT_EQ(shares.had("ann"), 70);
}

TEST(OwnerShares, TheFloorStaysWhenNobodyWantsAnything) {
  shares::OwnerShares shares;
  shares.enter("ann");
  shares.charge("ann", 30);
  shares.leave("ann");
  shares.enter("bob");
  EXPECT_EQ(shares.had("bob"), 30);
  shares.enter("ann");
  EXPECT_EQ(shares.had("ann"), 30);
}

TEST(OwnerShares, WantsOfOneOwnerAreCounted) {
  shares::OwnerShares shares;
  shares.enter("ann");
  shares.enter("ann");
  shares.leave("ann");
  shares.enter("bob");
  shares.charge("bob", 10);
  shares.enter("eve");
  EXPECT_EQ(shares.had("eve"), 0) << "ann still wants something and has had nothing";
  shares.leave("nobody");
}

}  // namespace
}  // namespace toile
