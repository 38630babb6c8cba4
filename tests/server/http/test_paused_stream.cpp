// Viewers of a real drape that is paused and resumed many times.

#include <atomic>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "proto/cpp/frame_codec.h"
#include "tests/server/http/served.h"

namespace toile::test {
namespace {

using Milliseconds = std::chrono::milliseconds;

/// Reads a stream on a thread of its own, as quickly as it can or with a rest after every message.
class Viewer {
 public:
  Viewer(int port, const std::string& target, int rest_ms, int receive_buffer = 0)
      : socket_(port, target, "", receive_buffer), thread_([this, rest_ms] { read_all(rest_ms); }) {}
  ~Viewer() {
    leaving_ = true;
    thread_.join();
  }

  int step() const { return step_; }
  int frames() const { return frames_; }
  bool broken() const { return broken_; }
  bool passes(int step, double within_s = 120) const {
    for (int i = 0; i < within_s * 200 && step_ <= step; ++i) std::this_thread::sleep_for(Milliseconds(5));
    return step_ > step;
  }

 private:
  void read_all(int rest_ms) {
    std::vector<std::int16_t> grid;
    while (!leaving_) {
      const auto message = socket_.read(0.05);
      if (!message || message->opcode != Socket::kBinary) continue;
      if (const Result<proto::DecodedFrame> frame = proto::decode_frame(message->payload, grid)) {
        grid = frame->grid;
        ++frames_;
        step_ = frame->header.step;
      } else {
        broken_ = broken_ || had_topology_;  // the topology comes first and is no frame
        had_topology_ = true;
      }
      std::this_thread::sleep_for(Milliseconds(rest_ms));
    }
  }

  Socket socket_;
  bool had_topology_ = false;
  std::atomic<int> step_{-1}, frames_{0};
  std::atomic<bool> leaving_{false}, broken_{false};
  std::thread thread_;  // last: reads what stands above
};

class PausedStream : public Served {
 protected:
  /// A napkin that falls for as long as the test wants.
  std::string long_job() {
    const std::string body = napkin_request(
        post_asset(), "\"max_time_s\": 8", "\"max_time_s\": 60, \"end\": \"time\", \"time_step_s\": 0.00002");
    const std::string project = member(send_json("POST", "/api/v1/projects", body), "id");
    return member(send_json("POST", "/api/v1/jobs", "{\"project_id\": \"" + project + "\"}"), "id");
  }
  int act(const std::string& id, const std::string& verb) {
    return send_json("POST", "/api/v1/jobs/" + id + "/" + verb, "").status;
  }
};

TEST_F(PausedStream, EveryViewerGoesOnAfterEveryPause) {
  serve({}, true);
  const std::string id = long_job();
  ASSERT_FALSE(id.empty());
  const std::string target = "/api/v1/jobs/" + id + "/stream";
  const Viewer quick(port, target, 0), slow(port, target, 4, 4096);
  ASSERT_TRUE(quick.passes(0));
  ASSERT_TRUE(slow.passes(0));
  for (int i = 0; i < 8; ++i) {
    ASSERT_EQ(act(id, "pause"), 200);
    for (int again = 0; again < i % 3; ++again) {  // the worker may still hold it
      ASSERT_EQ(act(id, "resume"), 200);
      ASSERT_EQ(act(id, "pause"), 200);
    }
    int held = quick.step();
    for (int same = 0; same < 3;) {  // until the worker has let go and both have what there is
      std::this_thread::sleep_for(Milliseconds(20));
      same = quick.step() == held && slow.step() == held ? same + 1 : 0;
      held = quick.step();
    }
    ASSERT_EQ(act(id, "resume"), 200);
    ASSERT_TRUE(quick.passes(held)) << "after pause " << i << " at step " << held;
    ASSERT_TRUE(slow.passes(held)) << "after pause " << i << " at step " << held;
  }
  EXPECT_GT(slow.frames(), 8);
  EXPECT_FALSE(quick.broken() || slow.broken());
  EXPECT_EQ(act(id, "cancel"), 200);
}

}  // namespace
}  // namespace toile::test
