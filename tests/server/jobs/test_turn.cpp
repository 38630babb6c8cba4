#include "server/jobs/turn.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <deque>
#include <string>
#include <vector>

#include "server/shares/owner_shares.h"

namespace toile {
namespace {

using enum store::JobPriority;
using jobs::Claim;

std::optional<std::size_t> next(const std::vector<Claim>& waiting) { return jobs::next_turn(waiting); }

TEST(Turn, IsNobodysWhereNobodyWaits) { EXPECT_FALSE(next({})); }

TEST(Turn, OfEqualsIsTheFirsts) { EXPECT_EQ(next({{3, kBatch}, {3, kBatch}}), 0u); }

TEST(Turn, IsTheOwnersWhoHasHadLeast) { EXPECT_EQ(next({{3, kBatch}, {1, kBatch}, {2, kBatch}}), 1u); }

TEST(Turn, IsAnInteractiveDrapesBeforeBatchWork) {
  EXPECT_EQ(next({{0, kBatch}, {59, kInteractive}}), 1u);
  EXPECT_EQ(next({{0, kBatch}, {61, kInteractive}}), 0u) << "not for ever: others would never come";
}

TEST(Turn, ARunningDrapeMakesRoomOnlyForOneThatStandsClearlyBetter) {
  EXPECT_TRUE(jobs::makes_room({5, kBatch}, {5, kInteractive}));
  EXPECT_TRUE(jobs::makes_room({5, kBatch}, {3, kBatch}));
  EXPECT_FALSE(jobs::makes_room({5, kBatch}, {4.5, kBatch}));
  EXPECT_FALSE(jobs::makes_room({5, kBatch}, {5, kBatch})) << "one owner's batch work goes one by one";
  EXPECT_FALSE(jobs::makes_room({5, kInteractive}, {5, kBatch}));
}

TEST(Turn, WhatItCostsToTakeADrapeUpIsToBeWorthIt) {
  EXPECT_FALSE(jobs::makes_room({5, kBatch}, {3, kBatch}, 0.5));
  EXPECT_TRUE(jobs::makes_room({8, kBatch}, {3, kBatch}, 0.5));
  EXPECT_TRUE(jobs::makes_room({5, kBatch}, {3.5, kBatch}, 0.01)) << "no more often than without";
  EXPECT_FALSE(jobs::makes_room({5, kBatch}, {4.5, kBatch}, 0.01));
}

/// Owners whose drapes take turns on a few workers, a slice at a time, as the service has them do.
class Simulation {
 public:
  Simulation(int owners, int workers)
      : had_(static_cast<std::size_t>(owners)), running_(static_cast<std::size_t>(workers), -1) {
    for (int owner = 0; owner < owners; ++owner) shares_.enter(name_of(owner));
  }
  void add(int owner, double seconds) { jobs_.push_back({owner, seconds, false}); }

  /// One slice of every worker. False once one has nothing to do.
  bool slice() {
    constexpr double kSlice = 0.05;
    for (int& at : running_) {
      if (at >= 0) go_on(at, kSlice);
      if (at < 0) at = claim();
    }
    return std::all_of(running_.begin(), running_.end(), [](int at) { return at >= 0; });
  }

  /// Jain's index of what the owners have had: 1 when all have had the same.
  double fairness() const {
    double sum = 0, squares = 0;
    for (const double had : had_) {
      sum += had;
      squares += had * had;
    }
    return sum * sum / (static_cast<double>(had_.size()) * squares);
  }

 private:
  struct Job {
    int owner;
    double left;  ///< s
    bool held;
  };
  static std::string name_of(int owner) { return "owner" + std::to_string(owner); }
  Claim claim_of(const Job& job) const { return {shares_.had(name_of(job.owner)), kBatch}; }

  std::vector<int> waiting() const {
    std::vector<int> places;
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      if (!jobs_[i].held && jobs_[i].left > 0) places.push_back(static_cast<int>(i));
    }
    return places;
  }
  int claim() {
    const std::vector<int> places = waiting();
    std::vector<Claim> claims;
    for (const int place : places) claims.push_back(claim_of(jobs_[static_cast<std::size_t>(place)]));
    const std::optional<std::size_t> turn = jobs::next_turn(claims);
    if (!turn) return -1;
    jobs_[static_cast<std::size_t>(places[*turn])].held = true;
    return places[*turn];
  }
  void go_on(int& at, double slice) {
    Job& job = jobs_[static_cast<std::size_t>(at)];
    job.left -= slice;
    shares_.charge(name_of(job.owner), slice);
    had_[static_cast<std::size_t>(job.owner)] += slice;
    bool over = job.left <= 0;
    for (const int place : waiting())
      over = over || jobs::makes_room(claim_of(job), claim_of(jobs_[static_cast<std::size_t>(place)]));
    if (!over) return;
    job.held = false;
    at = -1;
  }

  shares::OwnerShares shares_;
  std::vector<Job> jobs_;
  std::vector<double> had_;
  std::vector<int> running_;
};

TEST(Turn, FiftyOwnersOfOneToTwentyDrapesHaveTheSameShare) {
  Simulation simulation(50, 2);
  for (int owner = 0; owner < 50; ++owner) {
    const int drapes = 1 + owner * 7 % 20;
    for (int i = 0; i < drapes; ++i) simulation.add(owner, 400.0 / drapes);  // so that nobody has done before
  }
  int slices = 0;
  while (simulation.slice() && slices < 6'000) ++slices;
  EXPECT_EQ(slices, 6'000);
  EXPECT_GE(simulation.fairness(), 0.95);
}

}  // namespace
}  // namespace toile
