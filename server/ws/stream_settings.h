#pragma once

#include <chrono>

namespace toile::ws {

/// How long a viewer may keep the server waiting.
struct StreamSettings {
  std::chrono::milliseconds ping_every{10'000};
  std::chrono::milliseconds pong_within{30'000};   ///< of the last sign of life, else the viewer is dropped
  std::chrono::milliseconds write_within{10'000};  ///< of the start of a write
  std::chrono::milliseconds check_every{5'000};    ///< that a viewer's key is still good
  std::chrono::milliseconds close_within{3'000};   ///< for the other side to answer a close
};

}  // namespace toile::ws
