#include "server/accounts/guesses.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

using accounts::Guesses;
using std::chrono::seconds;

const Guesses::Clock::time_point kThen{};

TEST(Guesses, ManyMissesWithinAMinuteMakeWait) {
  Guesses guesses(3, seconds(60));
  for (int i = 0; i < 2; ++i) guesses.missed("a", kThen + seconds(i));
  EXPECT_EQ(guesses.wait("a", kThen + seconds(2)).count(), 0);
  guesses.missed("a", kThen + seconds(2));
  EXPECT_EQ(guesses.wait("a", kThen + seconds(3)).count(), 57) << "until a minute after the first";
  EXPECT_EQ(guesses.wait("b", kThen + seconds(3)).count(), 0) << "others do not";
  EXPECT_EQ(guesses.wait("a", kThen + seconds(60)).count(), 0);
  guesses.missed("a", kThen + seconds(61));
  EXPECT_EQ(guesses.wait("a", kThen + seconds(61)).count(), 0) << "a new minute begins with one";
}

TEST(Guesses, WhatIsRightForgetsWhatWasWrong) {
  Guesses guesses(1);
  guesses.missed("a", kThen);
  EXPECT_GT(guesses.wait("a", kThen).count(), 0);
  guesses.met("a");
  EXPECT_EQ(guesses.wait("a", kThen).count(), 0);
}

TEST(Guesses, HoldNoMoreNamesThanTheyMayAndForgetTheOldest) {
  Guesses guesses(1, seconds(60), 3);
  for (const char* name : {"a", "b", "c"}) guesses.missed(name, kThen + seconds(name[0] - 'a'));
  guesses.missed("d", kThen + seconds(5));
  EXPECT_EQ(guesses.wait("a", kThen + seconds(6)).count(), 0) << "the oldest";
  for (const char* name : {"b", "c", "d"})
    EXPECT_GT(guesses.wait(name, kThen + seconds(6)).count(), 0) << name;
  guesses.missed("e", kThen + seconds(61));
  EXPECT_GT(guesses.wait("c", kThen + seconds(61)).count(), 0) << "b's window was over, and made room";
}

TEST(Guesses, TakeAnAddressOfIpv6ForItsNetwork) {
  EXPECT_EQ(accounts::network_of("192.0.2.7"), "192.0.2.7");
  EXPECT_EQ(accounts::network_of("::ffff:192.0.2.7"), "192.0.2.7");
  EXPECT_EQ(accounts::network_of("2001:db8:1:2:3:4:5:6"), "2001:db8:1:2::/64");
  EXPECT_EQ(accounts::network_of("2001:db8:1:2::9"), "2001:db8:1:2::/64");
  EXPECT_EQ(accounts::network_of("unknown"), "unknown");
}

}  // namespace
}  // namespace toile
