#include "server/jobs/stream.h"

#include <utility>

#include "core/base/aabb.h"
#include "server/documents/stream_pieces.h"

namespace toile::jobs {
namespace {

/// The grid of the cloth at its start. What it is to fall on says nothing about how far it falls.
proto::FrameGrid grid_of(const std::vector<Vec3>& start) {
  const Aabb3 box = bounding_box(start);
  return proto::grid_for(box.low, box.high);
}

}  // namespace

JobStream::JobStream(Publisher& publisher, std::string job_id, std::uint32_t epoch,
                     const drape::DrapeInput& input, const sewing::GarmentMesh& garment,
                     const std::vector<Vec3>& start)
    : publisher_(publisher), job_id_(std::move(job_id)), epoch_(epoch), grid_(grid_of(start)) {
  auto topology = std::make_shared<StreamTopology>();
  topology->epoch = epoch_;
  topology->bytes = proto::encode_topology(epoch_, grid_, garment, documents::stream_pieces(input, garment));
  publisher_.topology(job_id_, std::move(topology));
}

void JobStream::show(int step, double time, const std::vector<Vec3>& positions) {
  auto frame = std::make_shared<StreamFrame>();
  frame->epoch = epoch_;
  frame->seq = last_ ? last_->seq + 1 : 1;
  frame->step = step;
  frame->time = time;
  frame->grid = proto::quantise(positions, grid_);
  if (last_) {
    const proto::FrameHeader header{epoch_, frame->seq, step, static_cast<float>(time)};
    frame->delta = proto::encode_delta(header, frame->grid, last_->grid);
  }
  last_ = frame;
  publisher_.frame(job_id_, std::move(frame));
}

}  // namespace toile::jobs
