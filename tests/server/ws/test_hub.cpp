#include "server/ws/hub.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

#include "tests/server/ws/stream_pieces.h"

namespace toile {
namespace {

using test::frame;
using test::progress;
using test::topology;

class Counter : public ws::ChannelListener {
 public:
  void wake() override { ++woken; }
  std::atomic<int> woken{0};
};

TEST(Hub, WakesOnlyThoseWhoFollowTheJob) {
  ws::Hub hub;
  Counter one, other;
  const ws::Subscription first = hub.subscribe("j_1", &one), second = hub.subscribe("j_2", &other);
  hub.topology("j_1", topology(1));
  hub.frame("j_1", frame(1));
  hub.progress("j_1", progress(store::JobState::kRunning, 50));
  hub.ended("j_1", progress(store::JobState::kSucceeded, 50));
  EXPECT_EQ(one.woken, 4);
  EXPECT_EQ(other.woken, 0);
  EXPECT_EQ(hub.viewers(), 2u);
}

TEST(Hub, WakesNobodyWhoHasLeft) {
  ws::Hub hub;
  Counter one;
  {
    ws::Subscription gone = hub.subscribe("j_1", &one);
    ws::Subscription moved = std::move(gone);
    EXPECT_EQ(hub.viewers(), 1u);
  }
  hub.topology("j_1", topology(1));
  EXPECT_EQ(one.woken, 0);
  EXPECT_EQ(hub.viewers(), 0u);
}

TEST(Hub, KeepsNothingOfAJobThatWasOnlyAskedFor) {
  ws::Hub hub;
  Counter one;
  hub.subscribe("j_1", &one).reset();
  EXPECT_EQ(hub.channels(), 0u);
}

TEST(Hub, ShowsTheEndOfAJobUntil64LaterOnesHaveEnded) {
  ws::Hub hub;
  Counter one;
  hub.topology("j_0", topology(1));
  hub.frame("j_0", frame(9));
  hub.ended("j_0", progress(store::JobState::kSucceeded, 450));
  for (int i = 1; i < 64; ++i) hub.ended("j_" + std::to_string(i), progress(store::JobState::kFailed, 0));
  {
    const ws::Subscription late = hub.subscribe("j_0", &one);
    ASSERT_TRUE(late.look().frame);
    EXPECT_EQ((*late.look().frame)->seq, 9u);
    EXPECT_TRUE(late.look().ended);
  }
  hub.ended("j_64", progress(store::JobState::kFailed, 0));
  EXPECT_EQ(hub.channels(), 64u);
  const ws::Subscription later = hub.subscribe("j_0", &one);
  EXPECT_FALSE(later.look().topology);
  EXPECT_FALSE(later.look().ended);
}

TEST(Hub, DoesNotForgetAJobThatRunsAgain) {
  ws::Hub hub;
  hub.ended("j_0", progress(store::JobState::kQueued, 0));  // a drain
  hub.topology("j_0", topology(2));
  for (int i = 1; i < 100; ++i) hub.ended("j_" + std::to_string(i), progress(store::JobState::kFailed, 0));
  Counter one;
  const ws::Subscription viewer = hub.subscribe("j_0", &one);
  ASSERT_TRUE(viewer.look().topology);
  EXPECT_FALSE(viewer.look().ended);
}

TEST(Hub, StandsPublishersAndViewersAtOnce) {
  ws::Hub hub;
  std::atomic<bool> done{false};
  std::vector<std::thread> viewers;
  std::atomic<int> seen{0};
  for (int i = 0; i < 4; ++i) {
    viewers.emplace_back([&, i] {
      while (!done) {
        Counter counter;
        const ws::Subscription viewer = hub.subscribe("j_" + std::to_string(i % 2), &counter);
        const ws::ChannelView view = viewer.look();
        if (view.frame) seen += view.frame->key().empty() ? 0 : 1;
      }
    });
  }
  std::thread other([&] {
    for (std::uint32_t seq = 1; seq <= 300; ++seq) hub.frame("j_1", frame(seq));
  });
  hub.topology("j_0", topology(1));
  hub.topology("j_1", topology(1));
  for (std::uint32_t seq = 1; seq <= 300 || seen == 0; ++seq) hub.frame("j_0", frame(seq));
  other.join();
  done = true;
  for (std::thread& viewer : viewers) viewer.join();
  EXPECT_GT(seen, 0);
  EXPECT_EQ(hub.viewers(), 0u);
}

/// A viewer that leaves takes the channel away that nobody has published on yet; a publisher that holds it at
/// that moment would speak into nothing.
TEST(Hub, LosesNoTopologyToAViewerThatLeavesJustThen) {
  ws::Hub hub;
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  constexpr int kJobs = 10'000;  // sanitizers are slow, and look for races by themselves
#else
  constexpr int kJobs = 300'000;  // without care a few of them are lost
#endif
  std::atomic<int> at{0};
  std::thread viewer([&] {
    Counter counter;
    for (int i = 0; i < kJobs; i = at) hub.subscribe("j_" + std::to_string(i), &counter).reset();
  });
  int lost = 0;
  for (int i = 0; i < kJobs; at = ++i) {
    const std::string id = "j_" + std::to_string(i);
    hub.topology(id, topology(1));
    hub.progress(id, progress(store::JobState::kRunning, 1));
    Counter counter;
    if (!hub.subscribe(id, &counter).look().topology) ++lost;
    hub.ended(id, progress(store::JobState::kSucceeded, 1));
  }
  viewer.join();
  EXPECT_EQ(lost, 0);
}

}  // namespace
}  // namespace toile
