#pragma once
// From the input to what a drape begins with: meshes, places, the look at them, and the garment put on.

#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/base/run_context.h"
#include "core/drape/drape_input.h"
#include "core/dressing/person.h"
#include "core/mesh/panel_mesh.h"
#include "core/preflight/finding.h"
#include "core/sewing/assembly.h"

namespace toile::drape {

/// What a drape begins with.
struct DrapeStart {
  mesh::PanelMeshes meshes;
  sewing::Assembly assembly;     ///< repaired where that could be done
  sewing::Assembly placed;       ///< as the document has it
  preflight::Findings findings;  ///< of run_preflight, worst first; with an error among them no drape begins
  std::optional<dressing::Person> person;    ///< whom it is for
  std::optional<std::vector<Vec3>> dressed;  ///< m, the garment on the body, once it was put there
};

/// Meshes, places and looks at the start. Progress phases: "mesh", "place". Errors: pattern.*, mesh.*,
/// placement.* with the piece or seam at fault; "cancelled". What is wrong with the start is no error here.
Result<DrapeStart> prepare_start(const DrapeInput& input, const RunContext& context);

/// Puts the garment on the first body that stands like a person (core/dressing), if it has seams, the
/// settings want it, and the look at the start found anything about where its pieces stand. Where they cannot
/// be sewn from there, they are arranged anew (core/arrange) for that. With a certificate `start.dressed` has
/// the shape, and findings about where pieces stand become notes; else nothing changes. Progress phase:
/// "dress".
void dress_start(const DrapeInput& input, DrapeStart& start, const RunContext& context);

/// Where pieces were placed does not matter any more: the garment is on.
void begin_on_body(DrapeStart& start);

}  // namespace toile::drape
