#include "server/http/fair_pool.h"

#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace toile {
namespace {

/// One thread, which is held until the test has said what is to wait. The thread holds before the test
/// begins: what it has not taken yet would wait beside what the test posts, and it could take that first.
class FairPoolTest : public testing::Test {
 protected:
  ~FairPoolTest() override {
    go();
    pool.join();
  }
  void SetUp() override {
    ASSERT_TRUE(pool.post("first", [this] {
      held.set_value();
      gate.get_future().wait();
    }));
    held.get_future().wait();
  }
  void go() {
    if (!std::exchange(gone, true)) gate.set_value();
  }
  bool post(const std::string& owner, double seconds = 0) {
    return pool.post(owner, [this, owner, seconds] {
      std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
      done += owner;
    });
  }

  std::promise<void> held, gate;
  bool gone = false;
  std::string done;
  http::FairPool pool{1, 100};
};

TEST_F(FairPoolTest, WhoAsksForMuchWaitsForItHimself) {
  for (int i = 0; i < 5; ++i) ASSERT_TRUE(post("a", 0.02));
  ASSERT_TRUE(post("b", 0.01));
  go();
  pool.join();
  EXPECT_EQ(done, "abaaaa") << "b came last and waits for one of a's only";
}

TEST_F(FairPoolTest, CountsTheTimeAndNotThePieces) {
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(post("a", 0.2));
  for (int i = 0; i < 4; ++i) ASSERT_TRUE(post("b", 0.001));
  go();
  pool.join();
  EXPECT_EQ(done, "abbbbaa") << "four short ones cost less than one long one";
}

TEST_F(FairPoolTest, TakesOneOwnersWorkInItsOrder) {
  std::string order;
  for (const char name : std::string("abcdef"))
    ASSERT_TRUE(pool.post("ann", [&order, name] { order += name; }));
  go();
  pool.join();
  EXPECT_EQ(order, "abcdef");
}

TEST_F(FairPoolTest, RefusesMoreOfOneOwnerThanMayWaitAndTakesOthers) {
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(post("a"));
  EXPECT_FALSE(post("a"));
  EXPECT_TRUE(post("b"));
}

}  // namespace
}  // namespace toile
