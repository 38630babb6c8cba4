#pragma once
// The scene's surfaces as vertex arrays for the graphics pipeline.

#include <vector>

#include "server/render/scene.h"
#include "server/render/seam_lines.h"

namespace toile::render {

/// A cloth vertex.
struct ClothVertex {
  float position[3];  ///< m
  float normal[3];    ///< unit, right side outwards
  float colour[3];    ///< linear RGB
  float rest[2];      ///< m
  VertexLines lines;
  float make[3];  ///< m: thickness, width of a hem, how far beside seams a row of stitches runs (0: none)
  float picture_at[2];  ///< repeats of the panel's picture, right and down from its upper left corner
};

/// Triangles that follow each other and look alike.
struct ClothRun {
  Index image = kNone;  ///< index into Textures::images, or none
  ClothLook look;
  int first = 0, count = 0;  ///< corners
};

struct ClothSurface {
  std::vector<ClothVertex> vertices;
  std::vector<Tri>
      triangles;  ///< those without a picture first, then picture by picture, then panel by panel
  std::vector<ClothRun> runs;  ///< of no triangle are left out
};

struct BodyVertex {
  float position[3];
  float normal[3];
};

/// A vertex that triangles of several panels have in common becomes one for each.
ClothSurface cloth_surface(const ClothView& cloth);

/// One vertex per vertex of the mesh, for its own triangles as indices.
std::vector<BodyVertex> body_vertices(const geometry::TriangleMesh& mesh);

}  // namespace toile::render
