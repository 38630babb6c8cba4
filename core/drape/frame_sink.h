#pragma once

#include "core/drape/drape_result.h"

namespace toile::drape {

/// Who wants to see a drape while it runs. Called on the draping thread, in order of steps.
class FrameSink {
 public:
  virtual ~FrameSink() = default;
  /// Once, before the first frame.
  virtual void begin(const sewing::GarmentMesh& garment) = 0;
  virtual void frame(const Frame& frame) = 0;
};

}  // namespace toile::drape
