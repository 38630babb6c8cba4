#pragma once
// The look at a start before a drape: what would go wrong is found with its place, repaired where a small
// move does it, and otherwise refused or told in words.

#include <span>
#include <vector>

#include "core/body/body.h"
#include "core/mesh/panel_mesh.h"
#include "core/pattern/pattern.h"
#include "core/preflight/finding.h"
#include "core/sewing/assembly.h"

namespace toile::preflight {

/// What a start is judged by, beside its assembly.
struct PreflightInput {
  const pattern::Pattern& pattern;
  const mesh::PanelMeshes& meshes;
  std::span<const body::Body> bodies;
  double particle_distance = 0.015;  ///< m
};

/// Looks at everything and repairs `assembly`: a piece that is turned round is turned back, a seam that is
/// sewn crosswise is reversed, pieces that cross or touch each other or a body are moved apart as a whole.
/// Nothing is repaired in a way that makes something else worse. Findings are sorted by severity; without an
/// error among them the start has no crossing and no contact.
///
/// finding_kind.h has the table of all kinds.
Findings run_preflight(const PreflightInput& input, sewing::Assembly& assembly);

}  // namespace toile::preflight
