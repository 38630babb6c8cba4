#pragma once
// The mesh of one body carried onto another shape, with its triangles.

#include <vector>

#include "core/body/mannequin/field.h"
#include "core/body/mannequin/mannequin.h"
#include "core/body/mannequin/remesh.h"
#include "core/body/mannequin/shape.h"
#include "core/geometry/triangle_mesh.h"

namespace toile::mannequin {

/// Triangles are finer where the body has detail, as far as there are enough of them. `field` must outlive
/// what is given back.
RemeshSettings remesh_settings(const BodyField& field, Index triangle_count);

/// `mesh` of the shape `before`, in statures, on `shape`; evened out `relaxations` times.
geometry::TriangleMesh fitted(geometry::TriangleMesh mesh, const BodyShape& before, const BodyShape& shape,
                              Index triangle_count, int relaxations);

/// A mesh in statures in metres, standing on the floor and as tall as asked; chords had cut a little off
/// both.
geometry::TriangleMesh stand(geometry::TriangleMesh mesh, double height);

/// From `from` to the shape and height of `to` by way of shapes between, so many that arms turn rather than
/// shrink when each vertex goes straight from one to the next: `mesh`, of the shape of `from` with any
/// triangles, at each of them, in metres. The last measures what `to` does but for where its triangles'
/// chords lie (within 1 cm on coarse meshes). REQUIRES figures of the same sex.
std::vector<geometry::TriangleMesh> on_the_way(geometry::TriangleMesh mesh, const Mannequin& from,
                                               const Mannequin& to);

}  // namespace toile::mannequin
