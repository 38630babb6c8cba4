#pragma once
// A running drape as viewers follow it.

#include <memory>
#include <string>
#include <vector>

#include "core/drape/drape_input.h"
#include "core/drape/drape_result.h"
#include "proto/cpp/frame_codec.h"
#include "server/jobs/publisher.h"

namespace toile::jobs {

/// Turns the moments of one run into frames: each is put on the grid and encoded once, however many look on.
class JobStream {
 public:
  /// Publishes the topology of a garment that stands at `start` (m). `publisher` must outlive the stream.
  JobStream(Publisher& publisher, std::string job_id, std::uint32_t epoch, const drape::DrapeInput& input,
            const sewing::GarmentMesh& garment, const std::vector<Vec3>& start);

  /// Publishes the next frame: the cloth at `positions` (m) after `step` substeps, at `time` (s).
  void show(int step, double time, const std::vector<Vec3>& positions);
  /// Of the newest frame; −1 before the first.
  int step() const { return last_ ? last_->step : -1; }

 private:
  Publisher& publisher_;
  std::string job_id_;
  std::uint32_t epoch_;
  proto::FrameGrid grid_;
  std::shared_ptr<const StreamFrame> last_;
};

}  // namespace toile::jobs
