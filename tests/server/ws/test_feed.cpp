#include "server/ws/feed.h"

#include <gtest/gtest.h>

#include "tests/server/ws/stream_pieces.h"

namespace toile {
namespace {

using test::frame;
using test::progress;
using test::topology;

class FeedTest : public testing::Test {
 protected:
  /// What the viewer gets next, as a word.
  std::string next() {
    const ws::ChannelView view = channel.look();
    const std::optional<ws::FeedMessage> message = feed.next(view);
    if (!message) return "nothing";
    if (message->kind == ws::FeedMessage::Kind::kTopology) return "topology";
    if (message->kind == ws::FeedMessage::Kind::kProgress) return "progress";
    const std::string seq = std::to_string((*view.frame)->seq);
    if (*message->bytes == (*view.frame)->delta) return "delta " + seq;
    return *message->bytes == view.frame->key() ? "key " + seq : "something else";
  }

  ws::Channel channel;
  ws::Feed feed;
};

TEST_F(FeedTest, HasNothingBeforeTheJobRuns) { EXPECT_EQ(next(), "nothing"); }

TEST_F(FeedTest, SendsTopologyThenAKeyThenDeltas) {
  channel.set_topology(topology(1));
  channel.set_frame(frame(1));
  EXPECT_EQ(next(), "topology");
  EXPECT_EQ(next(), "key 1");
  EXPECT_EQ(next(), "nothing");
  channel.set_frame(frame(2));
  EXPECT_EQ(next(), "delta 2");
  channel.set_frame(frame(3));
  EXPECT_EQ(next(), "delta 3");
}

TEST_F(FeedTest, SendsAKeyOfTheNewestToAViewerThatMissedOne) {
  channel.set_topology(topology(1));
  channel.set_frame(frame(1));
  next();
  next();
  channel.set_frame(frame(2));
  channel.set_frame(frame(3));
  channel.set_frame(frame(4));
  EXPECT_EQ(next(), "key 4");
  channel.set_frame(frame(5));
  EXPECT_EQ(next(), "delta 5");
}

TEST_F(FeedTest, GivesALateViewerTheNewest) {
  channel.set_topology(topology(1));
  for (std::uint32_t seq = 1; seq <= 10; ++seq) channel.set_frame(frame(seq));
  EXPECT_EQ(next(), "topology");
  EXPECT_EQ(next(), "key 10");
}

TEST_F(FeedTest, SendsAKeyEveryThirtiethFrame) {
  channel.set_topology(topology(1));
  next();
  for (std::uint32_t seq = 1; seq <= 95; ++seq) {
    channel.set_frame(frame(seq));
    EXPECT_EQ(next(), (seq % 30 == 1 ? "key " : "delta ") + std::to_string(seq));
  }
}

TEST_F(FeedTest, BeginsAgainWithANewEpoch) {
  channel.set_topology(topology(1));
  channel.set_frame(frame(1));
  next();
  next();
  channel.set_topology(topology(2));
  channel.set_frame(frame(2));  // of the epoch before: passed over
  channel.set_frame(frame(1, 2));
  EXPECT_EQ(next(), "topology");
  EXPECT_EQ(next(), "key 1");
}

TEST_F(FeedTest, LetsFramesAndProgressTakeTurns) {
  channel.set_topology(topology(1));
  next();
  std::string got;
  for (std::uint32_t seq = 1; seq <= 6; ++seq) {  // both are always due
    channel.set_frame(frame(seq));
    channel.set_progress(progress(store::JobState::kRunning, static_cast<int>(seq)));
    got += next()[0];
  }
  EXPECT_EQ(got, "kpkpkp");
}

TEST_F(FeedTest, IsFinishedAfterTheLastFrameOnly) {
  channel.set_topology(topology(1));
  channel.set_frame(frame(7));
  channel.end(progress(store::JobState::kSucceeded, 350));
  EXPECT_FALSE(feed.finished(channel.look()));
  EXPECT_EQ(next(), "topology");
  EXPECT_FALSE(feed.finished(channel.look()));
  EXPECT_EQ(next(), "key 7");
  EXPECT_TRUE(feed.finished(channel.look()));
  EXPECT_EQ(next(), "nothing");
}

TEST_F(FeedTest, SharesTheBytesOfAMoment) {
  channel.set_topology(topology(1));
  channel.set_frame(frame(5));
  ws::Feed other;
  feed.next(channel.look());
  other.next(channel.look());
  EXPECT_EQ(feed.next(channel.look())->bytes.get(), other.next(channel.look())->bytes.get());
}

}  // namespace
}  // namespace toile
