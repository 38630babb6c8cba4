#pragma once
// The scene's surfaces as vertex arrays for the graphics pipeline.

#include <vector>

#include "server/render/scene.h"

namespace toile::render {

/// A cloth vertex. Triangles share none, since seam lines differ by triangle.
struct ClothVertex {
  float position[3];       ///< m
  float normal[3];         ///< unit, right side outwards
  float colour[3];         ///< linear RGB
  float rest[2];           ///< m
  float line_distance[3];  ///< m, interpolated: distance to up to three lines that cross the triangle
  float line_strength[3];  ///< darkness of these lines, 0 to 1; below 0: how red, of an
                           ///< open seam; the same at all corners
  float picture_at[2];     ///< repeats of the panel's picture, right and down from its upper left corner
};

/// Triangles that follow each other in the vertex array and show the same picture.
struct ClothRun {
  Index image = kNone;       ///< index into Textures::images, or none
  int first = 0, count = 0;  ///< vertices
};

struct BodyVertex {
  float position[3];
  float normal[3];
};

/// Three vertices per triangle, those without a picture first, then picture by picture. Borders of pieces
/// that are sewn together carry a strong line, hems a faint one; lines run on around corners, through
/// triangles that touch a border with one vertex only.
std::vector<ClothVertex> cloth_vertices(const ClothView& cloth);

/// How cloth_vertices() falls into pictures; runs of no triangle are left out.
std::vector<ClothRun> cloth_runs(const ClothView& cloth);

/// One vertex per vertex of the mesh, for its own triangles as indices.
std::vector<BodyVertex> body_vertices(const geometry::TriangleMesh& mesh);

}  // namespace toile::render
