#include "server/jobs/stream.h"

#include <algorithm>
#include <utility>

#include "server/documents/stream_pieces.h"

namespace toile {
namespace {

/// The grid of the cloth at its start. What it is to fall on says nothing about how far it falls.
FrameGrid grid_of(const std::vector<Vec3>& start) {
  Vec3 lo, hi;
  if (!start.empty()) lo = hi = start.front();
  for (const Vec3& p : start) {
    lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
    hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
  }
  return grid_for(lo, hi);
}

}  // namespace

JobStream::JobStream(Publisher& publisher, std::string job_id, std::uint32_t epoch, const DrapeInput& input,
                     const GarmentMesh& garment, const std::vector<Vec3>& start)
    : publisher_(publisher), job_id_(std::move(job_id)), epoch_(epoch), grid_(grid_of(start)) {
  auto topology = std::make_shared<StreamTopology>();
  topology->epoch = epoch_;
  topology->bytes = encode_topology(epoch_, grid_, garment, stream_pieces(input, garment));
  publisher_.topology(job_id_, std::move(topology));
}

void JobStream::show(int step, double time, const std::vector<Vec3>& positions) {
  auto frame = std::make_shared<StreamFrame>();
  frame->epoch = epoch_;
  frame->seq = last_ ? last_->seq + 1 : 1;
  frame->step = step;
  frame->time = time;
  frame->grid = quantise(positions, grid_);
  if (last_) {
    const FrameHeader header{epoch_, frame->seq, step, static_cast<float>(time)};
    frame->delta = encode_delta(header, frame->grid, last_->grid);
  }
  last_ = frame;
  publisher_.frame(job_id_, std::move(frame));
}

}  // namespace toile
