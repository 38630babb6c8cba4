#pragma once
// Bodies as they stand at the end of a job.

#include <vector>

#include "core/base/result.h"
#include "core/geometry/triangle_mesh.h"
#include "server/store/store.h"

namespace toile::jobs {

/// Its film is there, which tells.
bool has_end_bodies(const store::JobRow& job);
/// From its film. Errors: film.*, those of the store.
Result<std::vector<geometry::TriangleMesh>> end_bodies(store::Store& store,
                                                       const store::RequestContext& context,
                                                       const store::JobRow& job);

}  // namespace toile::jobs
