#pragma once
// What a drape of a project would begin with: the pieces where they stand, and what the look at them finds.

#include <memory>
#include <string>

#include "core/base/result.h"
#include "server/documents/documents.h"

namespace toile::documents {

struct StartView {
  /// {"ready", "findings": […], "pieces": [{"id", "low", "high", "by_hand", "stands"}]}: by_hand is what
  /// place_piece was asked, or null; stands is what it would be asked for the piece to stand as it does;
  /// ready when no error is among the findings; places in metres, after what could be repaired.
  std::string check;
  /// uint32 bytes of the topology, the topology as in frames.md (epoch 1), float32 x, y, z of each vertex
  /// (m). Little endian.
  std::string geometry;
};

/// Of the project as it stands, kept for a while. Errors: those of reading it, pattern.*, mesh.*,
/// placement.*.
Result<std::shared_ptr<const StartView>> start_of(Documents& documents, const store::RequestContext& context,
                                                  const store::ProjectRow& project);

}  // namespace toile::documents
