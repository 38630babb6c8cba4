#pragma once
// What triangulation makes of a pattern. From here on lengths are metres.

#include <vector>

#include "core/base/types.h"

namespace toile::mesh {

/// One panel as triangles. Vertices are sorted along a Morton curve of the flat panel, so that neighbours
/// in the plane are neighbours in memory and in a stream.
struct PanelMesh {
  std::vector<Vec2> rest;      ///< flat position of each vertex, metres, in the panel's own frame
  std::vector<Tri> triangles;  ///< counter-clockwise in the flat panel
  Vec2 warp{0, 1};             ///< unit vector of the grain

  /// For every edge of the panel (outline, then holes, as edges_of counts): its vertices in order from the
  /// edge's start to its end, both ends included.
  std::vector<std::vector<Index>> edge_vertices;

  /// For every line of the panel: its vertices from start to end; edges of the mesh join them;
  /// none for a line that is only drawn.
  std::vector<std::vector<Index>> line_vertices = {};
};

/// A vertex of a panel.
struct PanelVertex {
  Index panel = kNone;
  Index vertex = kNone;
  friend bool operator==(const PanelVertex&, const PanelVertex&) = default;
};

/// Two vertices that a seam brings together.
struct SewnPair {
  PanelVertex a, b;
};

/// A seam as matched vertices, in order along its side `a`; both ends included.
struct MatchedSeam {
  Index seam = kNone;  ///< index into Pattern::seams
  std::vector<SewnPair> pairs;
  double length_a = 0, length_b = 0;  ///< m, of the two series in the flat pattern
};

struct PanelMeshes {
  std::vector<PanelMesh> panels;  ///< one per panel of the pattern, same order
  std::vector<MatchedSeam> seams;
};

}  // namespace toile::mesh
