#pragma once
// Keeps what a film needs of a drape in bounded space, however long the drape lasts.

#include <cstddef>

#include "core/drape/frame_sink.h"
#include "server/movie/film.h"

namespace toile::movie {

struct MotionLimits {
  int frames = 240;                           ///< ten seconds at 24 a second
  std::size_t bytes = std::size_t{24} << 20;  ///< of their numbers; 6 a vertex and frame
  int least_frames = 16;                      ///< whatever they take
};

/// Takes the frames of a drape. Once there are more than the limits allow, every other one goes and the
/// stride doubles. What is kept follows from the steps of the frames alone, so that a drape that was broken
/// off and resumed leaves the same film.
class FilmRecorder final : public drape::FrameSink {
 public:
  /// `kept` is what a recorder had before the drape was broken off.
  explicit FilmRecorder(MotionLimits limits = {}, Motion kept = {});

  void begin(const sewing::GarmentMesh& garment) override;
  void frame(const drape::Frame& frame) override;

  const Motion& motion() const { return motion_; }

 private:
  bool on_beat(std::size_t frame) const;
  void thin();

  MotionLimits limits_;
  std::size_t most_ = 0;  ///< frames
  Motion motion_;
};

}  // namespace toile::movie
