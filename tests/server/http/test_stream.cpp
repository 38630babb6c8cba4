// Viewers of a stream, from the handshake to the close.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fstream>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "tests/server/http/served.h"
#include "tests/server/ws/stream_pieces.h"

namespace toile::test {
namespace {

constexpr std::uint8_t kFin = 0x80;
constexpr std::size_t kVertices = 3000;
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;  // their bookkeeping grows the process
#else
constexpr bool kSanitized = false;
#endif

/// What one viewer got.
struct Seen {
  std::vector<std::string> texts;             ///< types of text messages, in order
  std::map<std::uint32_t, std::string> keys;  ///< by seq
  std::map<std::uint32_t, std::string> deltas;
  std::vector<std::uint32_t> order;  ///< seqs as they came
  std::vector<std::int16_t> grid;    ///< decoded, now
  std::string last_text;
  int topologies = 0, close = 0, bad = 0;
};

/// Takes in one message; false at the end.
bool take(Seen& seen, const std::optional<Socket::Message>& message) {
  if (!message) return false;
  if (message->opcode == Socket::kClose) {
    seen.close = message->close_code();
    return false;
  }
  if (message->opcode == Socket::kText) {
    const Result<json::JsonValue> tree = json::parse_json(message->payload);
    seen.texts.push_back(tree && tree->find("type") ? *tree->find("type")->text() : "?");
    seen.last_text = message->payload;
    return true;
  }
  if (message->payload == "topology") {
    ++seen.topologies;
    return true;
  }
  const Result<proto::DecodedFrame> frame = proto::decode_frame(message->payload, seen.grid);
  if (!frame) {
    ++seen.bad;
    return true;
  }
  seen.grid = frame->grid;
  seen.order.push_back(frame->header.seq);
  (frame->key ? seen.keys : seen.deltas)[frame->header.seq] = message->payload;
  return true;
}

/// Reads on until that frame has come; false when the stream ends before.
bool read_to(std::uint32_t seq, Socket& viewer, Seen& seen) {
  while (seen.order.empty() || seen.order.back() != seq)
    if (!take(seen, viewer.read())) return false;
  return true;
}

Seen watch(Socket& viewer) {
  Seen seen;
  while (take(seen, viewer.read())) {
  }
  return seen;
}

class Stream : public Served {
 protected:
  void SetUp() override {
    http::ServerSettings settings;
    settings.stream.ping_every = std::chrono::milliseconds(400);
    settings.stream.pong_within = std::chrono::milliseconds(2000);
    settings.stream.write_within = std::chrono::milliseconds(1000);
    serve(settings);
    id = make_job();
    ASSERT_FALSE(id.empty());
  }
  std::string target() const { return "/api/v1/jobs/" + id + "/stream"; }
  void publish(std::uint32_t from, std::uint32_t to, int pause_ms = 0) {
    for (std::uint32_t seq = from; seq <= to; ++seq) {
      hub.frame(id, frame(seq, 1, kVertices));
      if (pause_ms > 0) std::this_thread::sleep_for(std::chrono::milliseconds(pause_ms));
    }
  }
  void finish() {
    EXPECT_TRUE(static_cast<ScriptedJobs&>(*jobs).become(kMe, id, store::JobState::kSucceeded));
    hub.ended(id, progress(store::JobState::kSucceeded, 4711));
  }
  /// Waits until so many look on.
  bool viewers_become(std::size_t count, double within_s = 60) {
    for (int i = 0; i < within_s * 100; ++i) {
      if (hub.viewers() == count) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }
  void expect_alive() { EXPECT_EQ(get("/healthz").status, 200); }

  std::string id;
};

TEST_F(Stream, TellsTheJobThenTheClothThenTheEnd) {
  Socket viewer(port, target());
  ASSERT_EQ(viewer.status(), 101);
  ASSERT_TRUE(viewers_become(1));
  hub.topology(id, topology(1));
  Seen seen;
  for (std::uint32_t seq = 1; seq <= 65; ++seq) {  // one at a time: none may be passed over
    publish(seq, seq);
    ASSERT_TRUE(read_to(seq, viewer, seen));
  }
  hub.progress(id, progress(store::JobState::kRunning, 3250));
  finish();
  while (take(seen, viewer.read())) {
  }
  EXPECT_EQ(seen.texts.front(), "job");
  EXPECT_EQ(seen.texts.back(), "ended");
  EXPECT_EQ(seen.topologies, 1);
  EXPECT_EQ(seen.bad, 0);
  EXPECT_EQ(seen.order.back(), 65u);
  EXPECT_EQ(seen.grid, wave(65, kVertices)) << "what was decoded is what was shown";
  EXPECT_TRUE(seen.keys.contains(31));
  EXPECT_EQ(seen.keys.size() + seen.deltas.size(), 65u);
  EXPECT_EQ(seen.deltas.size(), 62u) << "all but 1, 31 and 61";
  EXPECT_EQ(seen.close, 1000);
  const Result<json::JsonValue> ended = json::parse_json(seen.last_text);
  EXPECT_EQ(*ended->find("step")->number(), 4711);
  EXPECT_EQ(*ended->find("job")->find("state")->text(), "succeeded");
}

TEST_F(Stream, ShowsTwoViewersTheSameStepsWithTheSameBytes) {
  Socket one(port, target()), two(port, target());
  ASSERT_TRUE(viewers_become(2));
  hub.topology(id, topology(1));
  Seen first, second;
  for (std::uint32_t seq = 1; seq <= 60; ++seq) {
    publish(seq, seq);
    ASSERT_TRUE(read_to(seq, one, first) && read_to(seq, two, second));
  }
  EXPECT_EQ(first.deltas.size(), 58u);
  EXPECT_EQ(first.deltas, second.deltas);
  EXPECT_EQ(first.grid, second.grid);
  EXPECT_EQ(first.keys.at(1), second.keys.at(1));
}

TEST_F(Stream, GivesALateViewerTheNewestAndNothingOlder) {
  hub.topology(id, topology(1));
  publish(1, 10);
  Socket viewer(port, target());
  ASSERT_TRUE(viewers_become(1));
  Seen seen;
  while (seen.order.empty() && take(seen, viewer.read())) {
  }
  EXPECT_EQ(seen.topologies, 1);
  EXPECT_EQ(seen.keys.size(), 1u);
  EXPECT_EQ(seen.grid, wave(10, kVertices));
  publish(11, 11);
  EXPECT_TRUE(take(seen, viewer.read()));
  EXPECT_TRUE(seen.deltas.contains(11));
  EXPECT_EQ(seen.grid, wave(11, kVertices));
}

TEST_F(Stream, ShowsTheLastMomentOfAJobThatHasEnded) {
  hub.topology(id, topology(1));
  publish(1, 5);
  finish();
  Socket viewer(port, target());
  const Seen seen = watch(viewer);
  EXPECT_EQ(seen.grid, wave(5, kVertices));
  EXPECT_EQ(seen.texts, (std::vector<std::string>{"job", "ended"}));
  EXPECT_EQ(seen.close, 1000);
}

TEST_F(Stream, SaysOfAJobFromLongAgoThatItHasEnded) {
  EXPECT_TRUE(static_cast<ScriptedJobs&>(*jobs).become(kMe, id, store::JobState::kSucceeded));
  Socket viewer(port, target());
  const Seen seen = watch(viewer);
  EXPECT_EQ(seen.texts, (std::vector<std::string>{"job", "ended"}));
  EXPECT_EQ(seen.close, 1000);
  EXPECT_TRUE(viewers_become(0));
}

TEST_F(Stream, TakesCommandsAndSaysWhenOneIsRefused) {
  Socket viewer(port, target());
  ASSERT_TRUE(viewer.read());  // the hello
  viewer.send(Socket::kText, R"({"type": "pause"})");
  viewer.send(Socket::kText, R"({"type": "pause"})");
  const auto refused = viewer.read();
  ASSERT_TRUE(refused);
  const Result<json::JsonValue> error = json::parse_json(refused->payload);
  EXPECT_EQ(*error->find("type")->text(), "error");
  EXPECT_EQ(*error->find("code")->text(), "jobs.state");
  EXPECT_EQ(store->job(kMe, id)->state, store::JobState::kPaused);
  viewer.send(Socket::kText, R"({"type": "cancel"})");
  viewer.send(Socket::kClose, "\x03\xe8");
  EXPECT_EQ(viewer.read_to_close(), 1000);
  EXPECT_TRUE(viewers_become(0));
  EXPECT_EQ(store->job(kMe, id)->state, store::JobState::kCancelled);
}

/// Waits until the job has been told of so many touches.
std::vector<jobs::LiveTouch> touches_become(ScriptedJobs& jobs, std::size_t count) {
  for (int i = 0; i < 3000 && jobs.touches().size() < count; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return jobs.touches();
}

constexpr const char* kPull =
    R"({"type": "pull", "epoch": 1, "triangle": 3, "shares": [0.5, 0.25, 0.25], "to": [0, 1, 0]})";

TEST_F(Stream, HandsOnWhatHandsDoAndLetsGoForAViewerThatVanishes) {
  auto& scripted = static_cast<ScriptedJobs&>(*jobs);
  {
    Socket one(port, target()), two(port, target());
    ASSERT_TRUE(one.read());
    ASSERT_TRUE(two.read());
    one.send(Socket::kText, kPull);
    ASSERT_EQ(touches_become(scripted, 1).size(), 1u);
    two.send(Socket::kText, kPull);
    ASSERT_EQ(touches_become(scripted, 2).size(), 2u);
    two.send(Socket::kText, R"({"type": "pin", "epoch": 1, "triangle": 3, "shares": [1, 0, 0]})");
    two.send(Socket::kText, R"({"type": "let_go"})");
    two.send(Socket::kText, R"({"type": "let_go"})");  // it holds nothing any more
    ASSERT_EQ(touches_become(scripted, 4).size(), 4u);
  }
  EXPECT_TRUE(viewers_become(0));
  const auto touches = touches_become(scripted, 5);
  ASSERT_EQ(touches.size(), 5u) << "who held something let go, once";
  using drape::TouchKind;
  EXPECT_EQ(touches[0].touch.kind, TouchKind::kPull);
  EXPECT_EQ(touches[0].touch.target, (Vec3{0, 1, 0}));
  EXPECT_NE(touches[0].touch.id, touches[1].touch.id) << "two viewers have two hands";
  EXPECT_EQ(touches[2].touch.kind, TouchKind::kPin);
  EXPECT_EQ(touches[3].touch.kind, TouchKind::kLetGo);
  EXPECT_EQ(touches[3].touch.id, touches[1].touch.id);
  EXPECT_EQ(touches[4].touch.kind, TouchKind::kLetGo);
  EXPECT_EQ(touches[4].touch.id, touches[0].touch.id);
}

/// The code of the next error that a viewer is told.
std::string next_error(Socket& viewer) {
  while (const auto message = viewer.read()) {
    const Result<json::JsonValue> said = json::parse_json(message->payload);
    if (said && *said->find("type")->text() == "error") return *said->find("code")->text();
  }
  return "";
}

TEST_F(Stream, TellsWhatTheClothRefusesWhenTheWorkerComesToIt) {
  Socket viewer(port, target());
  ASSERT_TRUE(viewer.read());
  viewer.send(Socket::kText, kPull);
  const auto touches = touches_become(static_cast<ScriptedJobs&>(*jobs), 1);
  ASSERT_EQ(touches.size(), 1u);
  touches[0].refused({"live.point", "there is no such point", ""});
  EXPECT_EQ(next_error(viewer), "live.point");
}

TEST_F(Stream, PassesOverHandsThatAreTooFast) {
  Socket viewer(port, target());
  ASSERT_TRUE(viewer.read());
  for (int i = 0; i < 300; ++i) viewer.send(Socket::kText, kPull);
  EXPECT_EQ(next_error(viewer), "live.too_fast");
  viewer.send(Socket::kText, R"({"type": "let_go"})");
  auto& scripted = static_cast<ScriptedJobs&>(*jobs);
  for (int i = 0; i < 3000; ++i) {
    const auto touches = scripted.touches();
    if (!touches.empty() && touches.back().touch.kind == drape::TouchKind::kLetGo) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  const auto touches = scripted.touches();
  EXPECT_EQ(touches.back().touch.kind, drape::TouchKind::kLetGo) << "letting go is always heard";
  EXPECT_LT(touches.size(), 290u);
}

TEST_F(Stream, LetsAPausedDrapeMakeOneStep) {
  EXPECT_TRUE(static_cast<ScriptedJobs&>(*jobs).become(kMe, id, store::JobState::kPaused));
  Socket viewer(port, target());
  ASSERT_TRUE(viewer.read());
  viewer.send(Socket::kText, R"({"type": "step"})");
  for (int i = 0; i < 3000 && store->job(kMe, id)->state == store::JobState::kPaused; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_EQ(store->job(kMe, id)->state, store::JobState::kQueued);
}

TEST_F(Stream, RefusesHandshakesThatAreNone) {
  EXPECT_PROBLEM(get(target()), 426, "http.upgrade");
  EXPECT_EQ(Socket(port, "/api/v1/jobs/j_00000000000000000000/stream").status(), 404);
  EXPECT_EQ(Socket(port, target(), "Origin: http://evil.example\r\n").status(), 403);
  EXPECT_EQ(Socket(port, target(), "Origin: http://localhost:" + std::to_string(port) + "\r\n").status(),
            101);
  const std::string upgrade = "Connection: Upgrade\r\nUpgrade: websocket\r\n";
  EXPECT_EQ(get(target(), upgrade).status, 400) << "no key";
  EXPECT_EQ(
      get(target(), upgrade + "Sec-WebSocket-Key: AAECAwQFBgcICQoLDA0ODw==\r\nSec-WebSocket-Version: 7\r\n")
          .status,
      426);
  EXPECT_EQ(get("/healthz",
                upgrade + "Sec-WebSocket-Key: AAECAwQFBgcICQoLDA0ODw==\r\nSec-WebSocket-Version: 13\r\n")
                .status,
            200)
      << "nothing to upgrade to";
  expect_alive();
}

TEST_F(Stream, AnswersEveryMalformedFrameWithItsCloseCode) {
  const std::string ping_of_126 = client_frame(kFin | Socket::kPing, std::string(126, 'a'));
  const std::string huge = std::string("\x82\xff\x7f\xff\xff\xff\xff\xff\xff\xff\x01\x02\x03\x04", 14);
  const std::string too_huge = std::string("\x82\xff\xff\xff\xff\xff\xff\xff\xff\xff\x01\x02\x03\x04", 14);
  const struct {
    const char* what;
    std::string bytes;
    std::vector<int> codes;
  } cases[] = {
      {"not masked", client_frame(kFin | Socket::kText, "{}", false), {1002}},
      {"reserved opcode 3", client_frame(kFin | 3, "{}"), {1002}},
      {"reserved control opcode 11", client_frame(kFin | 11, "{}"), {1002}},
      {"reserved bit 1", client_frame(kFin | 0x40 | Socket::kText, "{}"), {1002}},
      {"reserved bit 3", client_frame(kFin | 0x10 | Socket::kText, "{}"), {1002}},
      {"a ping in fragments", client_frame(Socket::kPing, "a"), {1002}},
      {"a ping of 126 bytes", ping_of_126, {1002}},
      {"a continuation of nothing", client_frame(kFin | Socket::kContinuation, "a"), {1002}},
      {"a new message within another",
       client_frame(Socket::kText, "{") + client_frame(kFin | Socket::kText, "}"),
       {1002}},
      {"a close of one byte", client_frame(kFin | Socket::kClose, "a"), {1002}},
      {"a close with a code that is never sent", client_frame(kFin | Socket::kClose, "\x03\xed"), {1002}},
      {"a close with bytes that are not UTF-8",
       client_frame(kFin | Socket::kClose, "\x03\xe8\xff"),
       {1002, 1007}},
      {"a length of 2^63 - 1", huge, {1009}},
      {"a length with its top bit set", too_huge, {1002, 1009}},
      {"a message of 5000 bytes", client_frame(kFin | Socket::kText, std::string(5000, ' ')), {1009}},
      {"text that is not UTF-8", client_frame(kFin | Socket::kText, "\xff\xfe"), {1007}},
      {"a binary message", client_frame(kFin | Socket::kBinary, "abc"), {1003}},
      {"text that is not JSON", client_frame(kFin | Socket::kText, "pause"), {1008}},
      {"a command that nobody knows", client_frame(kFin | Socket::kText, R"({"type": "fly"})"), {1008}},
      {"deep JSON", client_frame(kFin | Socket::kText, std::string(4000, '[')), {1008}},
      {"an empty message", client_frame(kFin | Socket::kText, ""), {1008}},
  };
  for (const auto& one : cases) {
    Socket viewer(port, target());
    ASSERT_EQ(viewer.status(), 101) << one.what;
    viewer.send_raw(one.bytes);
    const int code = viewer.read_to_close(5);
    EXPECT_TRUE(std::count(one.codes.begin(), one.codes.end(), code) == 1)
        << one.what << " closed with " << code;
    EXPECT_TRUE(viewer.wire().closed(5)) << one.what;
  }
  EXPECT_TRUE(viewers_become(0));
  expect_alive();
}

TEST_F(Stream, LivesThroughViewersThatVanish) {
  for (int i = 0; i < 30; ++i) {
    Socket viewer(port, target());
    if (i % 3 == 0) viewer.send_raw(client_frame(kFin | Socket::kText, "{\"type\"").substr(0, 5));
    if (i % 3 == 1) viewer.send_raw("\x81");
  }
  EXPECT_TRUE(viewers_become(0));
  expect_alive();
}

TEST_F(Stream, DropsAViewerThatAnswersNoPing) {
  Socket quiet(port, target()), lively(port, target());
  ASSERT_TRUE(viewers_become(2));
  std::atomic<bool> done{false};
  std::atomic<int> answered{0};
  std::thread answering([&] {
    while (!done) {
      const auto message = lively.read(0.05, false);
      if (message && message->opcode == Socket::kPing && lively.send(Socket::kPong, message->payload))
        ++answered;
    }
  });
  EXPECT_TRUE(viewers_become(1));
  int asked = 0;
  while (const auto message = quiet.read(20, false)) asked += message->opcode == Socket::kPing ? 1 : 0;
  EXPECT_GE(asked, 1) << "it was asked before it was dropped";
  for (const int before = answered; answered < before + 4 && hub.viewers() == 1;) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_EQ(hub.viewers(), 1u) << "who answers stays";
  done = true;
  answering.join();
}

TEST_F(Stream, SaysGoodByeWhenTheServerStops) {
  Socket viewer(port, target());
  ASSERT_TRUE(viewers_become(1));
  std::thread stopping([this] { server->stop(); });
  EXPECT_EQ(viewer.read_to_close(), 1001);
  stopping.join();
}

double resident_mb() {
  std::ifstream in("/proc/self/status");
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("VmRSS:")) return std::stod(line.substr(6)) / 1024;
  }
  return 0;
}

TEST_F(Stream, TwentyViewersOfWhichFiveStopReadingCostNoMemoryAndHoldUpNobody) {
  constexpr int kReading = 15, kStalled = 5;
  std::vector<Socket> stalled;
  for (int i = 0; i < kStalled; ++i) stalled.emplace_back(port, target(), "", 4096);
  std::vector<Seen> seen(kReading);
  std::vector<std::thread> readers;
  for (Seen& one : seen) {
    readers.emplace_back([this, &one] {
      Socket viewer(port, target());
      for (;;) {
        const bool more = take(one, viewer.read());
        if (!more) break;
        if (one.keys.size() > 2) one.keys.erase(one.keys.begin());  // the test itself keeps nothing
        one.deltas.clear();
      }
    });
  }
  ASSERT_TRUE(viewers_become(kReading + kStalled));
  hub.topology(id, topology(1));
  publish(1, 60, 4);
  const double before = resident_mb();
  double most = before;
  std::uint32_t last = 60;
  for (int rounds = 0; rounds < 25 || (hub.viewers() > kReading && rounds < 400); ++rounds) {
    publish(last + 1, last + 50, 3);
    last += 50;
    most = std::max(most, resident_mb());
  }
  EXPECT_LE(hub.viewers(), static_cast<std::size_t>(kReading)) << "who stops reading is dropped";
  finish();
  for (std::thread& reader : readers) reader.join();
  for (const Seen& one : seen) {
    EXPECT_EQ(one.close, 1000);
    EXPECT_EQ(one.bad, 0);
    EXPECT_EQ(one.grid, wave(last, kVertices));
    EXPECT_GT(one.order.size(), 100u);
  }
  std::printf("resident: %.1f MB before, %.1f MB at most; %u frames\n", before, most, last);
  EXPECT_TRUE(kSanitized || most - before < 4);
}

}  // namespace
}  // namespace toile::test
