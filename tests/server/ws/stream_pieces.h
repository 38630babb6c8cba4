#pragma once
// Topologies and frames made up for tests.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "proto/cpp/frame_codec.h"
#include "server/jobs/publisher.h"

namespace toile::test {

inline std::shared_ptr<const jobs::StreamTopology> topology(std::uint32_t epoch,
                                                            const std::string& bytes = "topology") {
  return std::make_shared<const jobs::StreamTopology>(jobs::StreamTopology{epoch, bytes});
}

/// Where vertex `i` is at `seq`: a slow wave that no two frames share.
inline std::vector<std::int16_t> wave(std::uint32_t seq, std::size_t vertices) {
  std::vector<std::int16_t> grid(3 * vertices);
  for (std::size_t i = 0; i < grid.size(); ++i) {
    grid[i] = static_cast<std::int16_t>((i * 7 + seq * (1 + i % 5)) % 6000);
  }
  return grid;
}

inline std::shared_ptr<const jobs::StreamFrame> frame(std::uint32_t seq, std::uint32_t epoch = 1,
                                                      std::size_t vertices = 16) {
  auto made = std::make_shared<jobs::StreamFrame>();
  made->epoch = epoch;
  made->seq = seq;
  made->step = static_cast<int>(seq) * 50;
  made->time = seq * 0.01;
  made->grid = wave(seq, vertices);
  const proto::FrameHeader header{epoch, seq, made->step, static_cast<float>(made->time)};
  if (seq > 1) made->delta = proto::encode_delta(header, made->grid, wave(seq - 1, vertices));
  return made;
}

inline jobs::JobProgress progress(store::JobState state, int step) {
  jobs::JobProgress made;
  made.state = state;
  made.phase = "drape";
  made.step = step;
  return made;
}

}  // namespace toile::test
