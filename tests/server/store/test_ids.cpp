#include "server/store/ids.h"

#include <gtest/gtest.h>

#include <set>

namespace toile {
namespace {

constexpr std::int64_t kNow = 1'790'000'000'000;

TEST(Ids, RiseWithTimeAndWithinAMillisecond) {
  store::IdSource ids;
  std::string last;
  for (int i = 0; i < 2000; ++i) {
    const std::string id = *ids.next('j', kNow + i / 100);
    EXPECT_TRUE(store::is_id(id, 'j')) << id;
    EXPECT_LT(last, id);
    last = id;
  }
}

TEST(Ids, RiseWhenTheClockIsSetBack) {
  store::IdSource before;
  const std::string newest = *before.next('j', kNow);
  store::IdSource after;
  after.start_after(newest);
  EXPECT_LT(newest, *after.next('j', kNow - 3'600'000));
  EXPECT_LT(newest, *after.next('j', 0));
}

TEST(Ids, RiseAfterAClockThatStoodBeyondTheLastTimeThereIs) {
  constexpr std::int64_t kYear2061 = 2'871'763'200'000;
  store::IdSource ids;
  std::string last = *ids.next('j', kYear2061);
  for (int i = 0; i < 200; ++i) {
    if (i == 100) {  // the next start, with the clock set right
      ids = store::IdSource();
      ids.start_after(last);
    }
    const std::string id = *ids.next('j', i < 100 ? kYear2061 : kNow);
    EXPECT_TRUE(store::is_id(id, 'j')) << id;
    EXPECT_LT(last, id);
    last = id;
  }
}

TEST(Ids, OfTheSameMomentDiffer) {
  std::set<std::string> seen;
  for (int i = 0; i < 200; ++i) {
    store::IdSource ids;
    seen.insert(*ids.next('p', kNow));
  }
  EXPECT_EQ(seen.size(), 200u);
}

TEST(Ids, HaveOneForm) {
  EXPECT_TRUE(store::is_id("j_0123456789abcdefghjk", 'j'));
  EXPECT_FALSE(store::is_id("p_0123456789abcdefghjk", 'j'));
  EXPECT_FALSE(store::is_id("j_0123456789abcdefghj", 'j'));
  EXPECT_FALSE(store::is_id("j_0123456789abcdefghji", 'j'));
  EXPECT_FALSE(store::is_id("j_0123456789ABCDEFGHJK", 'j'));
  EXPECT_FALSE(store::is_id("j_../../../../../../../", 'j'));
  EXPECT_FALSE(store::is_id("", 'j'));
}

}  // namespace
}  // namespace toile
