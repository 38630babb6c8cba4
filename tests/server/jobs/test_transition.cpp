#include "server/jobs/transition.h"

#include <gtest/gtest.h>

#include <map>

namespace toile {
namespace {

using S = store::JobState;
using E = jobs::JobEvent;

/// What may happen, and what becomes of it. All other pairs are refused.
const std::map<std::pair<S, E>, S>& legal() {
  static const std::map<std::pair<S, E>, S> table{
      {{S::kQueued, E::kClaim}, S::kRunning},     {{S::kQueued, E::kPause}, S::kPaused},
      {{S::kQueued, E::kCancel}, S::kCancelled},  {{S::kQueued, E::kFinish}, S::kSucceeded},
      {{S::kQueued, E::kFail}, S::kFailed},       {{S::kQueued, E::kRequeue}, S::kQueued},
      {{S::kRunning, E::kProgress}, S::kRunning}, {{S::kRunning, E::kPause}, S::kPaused},
      {{S::kRunning, E::kCancel}, S::kCancelled}, {{S::kRunning, E::kFinish}, S::kSucceeded},
      {{S::kRunning, E::kDraped}, S::kRunning},   {{S::kRunning, E::kFail}, S::kFailed},
      {{S::kRunning, E::kRequeue}, S::kQueued},   {{S::kPaused, E::kResume}, S::kQueued},
      {{S::kPaused, E::kCancel}, S::kCancelled},  {{S::kPaused, E::kFinish}, S::kSucceeded},
      {{S::kPaused, E::kFail}, S::kFailed},
  };
  return table;
}

template <typename F>
void for_all_pairs(F&& f) {
  for (const S state : store::kJobStates) {
    for (const E event : jobs::kJobEvents) f(state, event);
  }
}

TEST(JobTransition, EveryPairOfStateAndEventIsEitherInTheTableOrRefusedWithWords) {
  for_all_pairs([](S state, E event) {
    const Result<jobs::JobTransition> next = jobs::next_state(state, event);
    const auto expected = legal().find({state, event});
    const std::string place =
        std::string(store::name_of(state)) + " and event " + std::to_string(static_cast<int>(event));
    if (expected != legal().end()) {
      ASSERT_TRUE(next.ok()) << place;
      EXPECT_EQ(next->state, expected->second) << place;
    } else {
      ASSERT_FALSE(next.ok()) << place;
      EXPECT_EQ(next.error().code, "jobs.state") << place;
      EXPECT_NE(next.error().message.find(store::name_of(state)), std::string::npos) << next.error().message;
      EXPECT_NE(next.error().message.find(" cannot be "), std::string::npos) << next.error().message;
    }
  });
}

TEST(JobTransition, TheListHoldsEveryEventOnce) {
  for (std::size_t i = 0; i < jobs::kJobEvents.size(); ++i)
    EXPECT_EQ(static_cast<std::size_t>(jobs::kJobEvents[i]), i);
  EXPECT_EQ(jobs::kJobEvents.back(), E::kRequeue);
}

TEST(JobTransition, FinalStatesHaveNoWayOut) {
  for_all_pairs([](S state, E event) {
    if (store::is_final(state)) {
      EXPECT_FALSE(jobs::next_state(state, event).ok());
    }
  });
}

TEST(JobTransition, AChangeOfStateIsAlwaysWrittenDown) {
  for_all_pairs([](S state, E event) {
    const Result<jobs::JobTransition> next = jobs::next_state(state, event);
    if (next && next->state != state) {
      EXPECT_TRUE(next->effects.persist) << store::name_of(state);
    }
  });
}

TEST(JobTransition, AJobStandsInTheQueueExactlyWhileItIsQueued) {
  for_all_pairs([](S state, E event) {
    const Result<jobs::JobTransition> next = jobs::next_state(state, event);
    if (!next) return;
    EXPECT_EQ(next->effects.queue != jobs::QueuePlace::kOut, next->state == S::kQueued)
        << store::name_of(state);
  });
}

TEST(JobTransition, TheLastWordIsSaidExactlyOnReachingAFinalState) {
  for_all_pairs([](S state, E event) {
    const Result<jobs::JobTransition> next = jobs::next_state(state, event);
    if (!next) return;
    EXPECT_EQ(next->effects.ends, store::is_final(next->state)) << store::name_of(state);
  });
}

TEST(JobTransition, WhateverLeavesRunningTellsTheWorker) {
  for (const E event : jobs::kJobEvents) {
    const Result<jobs::JobTransition> next = jobs::next_state(S::kRunning, event);
    if (next && next->state != S::kRunning) {
      EXPECT_TRUE(next->effects.interrupt);
    }
  }
}

TEST(JobTransition, AResumedJobGoesToTheHeadOfTheQueueAndARequeuedOneToItsEnd) {
  EXPECT_EQ(jobs::next_state(S::kPaused, E::kResume)->effects.queue, jobs::QueuePlace::kFront);
  EXPECT_EQ(jobs::next_state(S::kRunning, E::kRequeue)->effects.queue, jobs::QueuePlace::kBack);
}

}  // namespace
}  // namespace toile
