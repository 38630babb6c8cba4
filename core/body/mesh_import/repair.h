#pragma once
// What strangers' meshes need before they can be a body: one closed surface with its outer side outside,
// where that can be had without guessing.

#include <string>
#include <vector>

#include "core/geometry/triangle_mesh.h"

namespace toile::mesh_import {

/// m², twice the area under which a triangle is a line.
inline constexpr double kLeastArea2 = 1e-14;

/// What was done to a mesh, and how it is now. All zero but `shells` for a mesh that was as it should be.
struct MeshRepairs {
  int welded = 0;          ///< points of borders, laid on others that were as good as there
  int flat = 0;            ///< triangles dropped that were a line after that
  int doubled = 0;         ///< triangles dropped that lay on another one
  int crowded_edges = 0;   ///< edges at which more than two triangles met: cut apart into surfaces
  int parted_points = 0;   ///< points new because surfaces only touched there
  int turned = 0;          ///< triangles turned over, so that neighbours and the outer side agree
  int holes = 0;           ///< small holes filled
  int hole_triangles = 0;  ///< triangles that fill them

  int shells = 0;        ///< surfaces that do not hang together
  int open_shells = 0;   ///< of them, with a border left
  int open_borders = 0;  ///< borders left: too long to be holes
  int one_sided = 0;     ///< shells without an outer side, as a Möbius strip

  friend bool operator==(const MeshRepairs&, const MeshRepairs&) = default;
};

/// Whether anything at all was changed.
bool repaired(const MeshRepairs& repairs);

/// A sentence for each thing done and each fault left, with counts: "2 small holes were filled with 9
/// triangles." Nothing for a closed mesh in one piece that was in order.
std::vector<std::string> repair_words(const MeshRepairs& repairs);

/// A mesh and what was done to it.
struct RepairedMesh {
  geometry::TriangleMesh mesh;
  MeshRepairs repairs;
};

/// Mends a mesh (metres) in this order: border points nearer than 2e-5 of its diagonal are welded, empty and
/// doubled triangles dropped, crowded edges and touching points parted, neighbours turned alike, holes filled
/// whose border is at most 0.35 of their shell's diagonal, closed shells turned outward unless they are the
/// wall of a hollow within another, and open ones by which way most of their area looks.
///
/// A mesh in order comes back with the same bytes. What crosses itself stays: contact and crossings look at
/// triangles one by one, and scans do it. The same mesh is mended the same way each time.
RepairedMesh repair_mesh(geometry::TriangleMesh mesh);

}  // namespace toile::mesh_import
