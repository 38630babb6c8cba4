#pragma once
// Seams that cannot be sewn are left open, named, and the rest is draped.

#include <array>
#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/drape/drape_input.h"
#include "core/drape/drape_result.h"
#include "core/mesh/panel_mesh.h"
#include "core/preflight/finding.h"
#include "core/sewing/assembly.h"

namespace toile::drape {

/// mm², of the cloth that hangs together most by seams. REQUIRES seams that name panels of the pattern.
double most_together(const pattern::Pattern& pattern);

/// The input without the seams of which one side is more than three times as long as the other
/// (preflight/check_pattern.h): no cloth is gathered as much. `left_open` has them. The same input where less
/// than half would hang together of what does with them, for then the file's units or its seams are wrong as
/// a whole, and the look at the start refuses it.
DrapeInput with_seams_that_can_be_sewn(DrapeInput input);

/// Vertices of the garment that seams would join which are left open: some of each, in the order of
/// `left_open`.
std::vector<std::vector<std::array<Index, 2>>> facing_of_left_open(const DrapeInput& input,
                                                                   const mesh::PanelMeshes& meshes,
                                                                   const sewing::GarmentMesh& garment);

/// How far they are open, in the order of `left_open`. `x`: m, of the garment's vertices.
std::vector<OpenSeam> gaps_left_open(const DrapeInput& input,
                                     const std::vector<std::vector<std::array<Index, 2>>>& facing,
                                     std::span<const Vec3> x);

/// A finding for each seam that is left open.
void tell_left_open(const DrapeInput& input, const mesh::PanelMeshes& meshes,
                    const sewing::Assembly& assembly, preflight::Findings& findings);

}  // namespace toile::drape
