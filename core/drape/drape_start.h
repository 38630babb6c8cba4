#pragma once
// From the input to what a drape begins with: meshes, places, the look at them, and the garment put on.

#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/base/run_context.h"
#include "core/drape/drape_input.h"
#include "core/dressing/person.h"
#include "core/dressing/put_on.h"
#include "core/mesh/panel_mesh.h"
#include "core/preflight/finding.h"
#include "core/sewing/assembly.h"

namespace toile::drape {

/// A garment that was put on: one of the starts from which it may be draped. They are numbered in the order
/// in which they are tried: kSewnInPlace is sewing under contact from where the pieces stand; then come the
/// ways of core/dressing from there, and the same ways from where the pieces are arranged anew.
struct PutOn {
  std::vector<Vec3> positions;  ///< m, one a garment vertex, sewn ones together
  int start = 0;
};
inline constexpr int kSewnInPlace = 0;

/// The tries to put a garment on.
struct PutOnTries {
  std::optional<PutOn> on;        ///< certified
  int nearest = kSewnInPlace;     ///< where none was: number of the start that came nearest
  dressing::Shortfall shortfall;  ///< by how much it did not
  std::vector<Index> at_fault;    ///< and the panels that kept it from being certified, rising
  dressing::Effort effort;        ///< what is left of it
  bool gave_up = false;           ///< there was more to try, but the effort was spent
  bool strained = false;          ///< what is on is stretched far beyond its size

  bool well_on() const { return on && !strained; }
};

/// What a drape begins with.
struct DrapeStart {
  mesh::PanelMeshes meshes;
  sewing::Assembly assembly;     ///< repaired where that could be done
  sewing::Assembly placed;       ///< as the document has it
  preflight::Findings findings;  ///< of run_preflight, worst first; with an error among them no drape begins
  std::optional<dressing::Person> person;  ///< whom it is for
  std::optional<PutOn> dressed;            ///< the garment on the body, once it was put there
};

/// Meshes, places and looks at the start. Progress phases: "mesh", "place". Errors: pattern.*, mesh.*,
/// placement.* with the piece or seam at fault; "cancelled". What is wrong with the start is no error here.
Result<DrapeStart> prepare_start(const DrapeInput& input, const RunContext& context);

/// Puts the garment on the first body that stands like a person (core/dressing), if it has seams, the
/// settings want it, and the look at the start found anything about where its pieces stand, or most of them
/// lie beside the bodies. Where they cannot be sewn from there, they are arranged anew (core/arrange) for
/// that, and before anything else where they lie beside. With a certificate `start.dressed` has the shape,
/// and findings about where pieces stand become notes; else nothing changes. Starts up to number `after` are
/// passed over. Gives back the tries; nothing where there was nothing to try. Progress phase: "dress".
std::optional<PutOnTries> dress_start(const DrapeInput& input, DrapeStart& start, const RunContext& context,
                                      int after = kSewnInPlace, dressing::Effort effort = dressing::Effort());

/// Whether putting on can be tried: a person is to wear something that is sewn and has no layers, and the
/// settings want it.
bool may_put_on(const DrapeInput& input, const DrapeStart& start);

/// The next start after number `after` that is certified; none where none is left, or where the context
/// was cancelled. REQUIRES may_put_on(). Progress phase: "dress".
PutOnTries put_on_after(int after, const DrapeInput& input, const DrapeStart& start,
                        const RunContext& context, dressing::Effort effort = dressing::Effort());

/// Where pieces were placed does not matter any more: the garment is on.
void begin_on_body(DrapeStart& start);

}  // namespace toile::drape
