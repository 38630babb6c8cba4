#include "core/base/crew.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <new>
#include <numeric>
#include <thread>
#include <vector>

namespace toile {
namespace {

TEST(Crew, DoesEachPartOnce) {
  for (const int threads : {1, 2, 3, 8}) {
    Crew crew(threads);
    EXPECT_EQ(crew.threads(), threads);
    for (const int count : {0, 1, 2, 7, 1000}) {
      std::vector<std::atomic<int>> done(static_cast<std::size_t>(count));
      crew.each(count, [&](int i) { ++done[static_cast<std::size_t>(i)]; });
      for (const std::atomic<int>& times : done) ASSERT_EQ(times, 1);
    }
  }
}

TEST(Crew, WorkAfterWorkIsNeverMixedUp) {
  Crew crew(4);
  for (int round = 0; round < 20000; ++round) {
    // What one piece of work wrote is seen by who gave it out, without any other means.
    std::array<std::int64_t, 6> written{};
    const int count = 2 + round % 5;
    crew.each(count, [&](int i) { written.at(static_cast<std::size_t>(i)) = round + i; });
    const std::int64_t n = count;
    ASSERT_EQ(std::accumulate(written.begin(), written.end(), std::int64_t{0}), n * round + n * (n - 1) / 2);
  }
}

TEST(Crew, HelpersThatSleptTakePartAgain) {
  Crew crew(3);
  const auto take_turns = [&] {  // each part waits for the others: one thread alone would never end
    std::atomic<int> here{0};
    crew.each(3, [&](int) {
      ++here;
      while (here < 3) std::this_thread::yield();
    });
    return here.load();
  };
  EXPECT_EQ(take_turns(), 3);
  std::this_thread::sleep_for(std::chrono::milliseconds(30));
  EXPECT_EQ(take_turns(), 3);
  EXPECT_GT(crew.helpers_cpu_s(), 0);
}

TEST(Crew, ThrowsOnWhatAPartThrewAndGoesOn) {
  for (const int threads : {1, 3}) {
    Crew crew(threads);
    for (int round = 0; round < 200; ++round) {
      std::array<int, 8> done{};
      const auto run_short = [&](int i) {
        if (i == round % 8) throw std::bad_alloc();
        done.at(static_cast<std::size_t>(i)) = 1;
      };
      ASSERT_THROW(crew.each(8, run_short), std::bad_alloc);
      std::atomic<int> after{0};
      crew.each(8, [&](int) { ++after; });
      ASSERT_EQ(after, 8) << "what was thrown once is not thrown again";
    }
  }
}

TEST(Crew, RangesCoverAllWithoutOverlap) {
  for (const int threads : {1, 2, 5}) {
    Crew crew(threads);
    for (const std::size_t count : {std::size_t{0}, std::size_t{3}, std::size_t{64}, std::size_t{1001}}) {
      std::vector<std::atomic<int>> seen(count);
      crew.ranges(count, 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) ++seen[i];
      });
      for (const std::atomic<int>& times : seen) ASSERT_EQ(times, 1);
    }
  }
}

TEST(Crew, WhoWorksAloneTakesWorkWhole) {
  EXPECT_EQ(Crew().parts(), 1u);
  EXPECT_GE(Crew(2).parts(), 4u);
}

}  // namespace
}  // namespace toile
