#include "server/movie/film_recorder.h"

#include <algorithm>
#include <utility>

#include "core/base/aabb.h"

namespace toile::movie {

FilmRecorder::FilmRecorder(MotionLimits limits, Motion kept) : limits_(limits), motion_(std::move(kept)) {}

void FilmRecorder::begin(const sewing::GarmentMesh& garment) {
  const std::size_t numbers = 3 * garment.rest.size();
  const std::size_t each = std::max<std::size_t>(numbers, 1) * sizeof(std::int16_t);
  most_ = std::clamp(limits_.bytes / each, static_cast<std::size_t>(limits_.least_frames),
                     static_cast<std::size_t>(limits_.frames));
  const bool other = !motion_.frames.empty() && motion_.frames.front().grid.size() != numbers;
  if (other) motion_ = {};
}

/// Whether it is the first of its stride.
bool FilmRecorder::on_beat(std::size_t frame) const {
  return frame == 0 ||
         motion_.frames[frame].step / motion_.stride > motion_.frames[frame - 1].step / motion_.stride;
}

void FilmRecorder::thin() {
  std::vector<FilmFrame> kept;
  for (FilmFrame& frame : motion_.frames) {
    const bool first = kept.empty() || frame.step / motion_.stride > kept.back().step / motion_.stride;
    if (first || &frame == &motion_.frames.back()) kept.push_back(std::move(frame));
  }
  motion_.frames = std::move(kept);
}

void FilmRecorder::frame(const drape::Frame& frame) {
  std::vector<FilmFrame>& frames = motion_.frames;
  // A drape may go on from a checkpoint that is older than what was recorded, or from its start.
  while (!frames.empty() && frames.back().step >= frame.step) frames.pop_back();
  if (frames.empty()) {
    const Aabb3 box = bounding_box(frame.positions);
    motion_.grid = proto::grid_for(box.low, box.high);
  } else if (!on_beat(frames.size() - 1)) {
    frames.pop_back();  // it stood there as the last one only
  }
  frames.push_back({frame.step, static_cast<float>(frame.time),
                    proto::quantise(frame.positions, motion_.grid), static_cast<float>(frame.bodies)});
  while (frames.size() > most_) {
    motion_.stride *= 2;
    thin();
  }
}

}  // namespace toile::movie
