#pragma once
// Surfaces and depth maps on the graphics side. What is made belongs to the scope.

#include <vector>

#include "core/base/types.h"
#include "server/render/gl/objects.h"
#include "server/render/scene.h"
#include "server/render/surface_vertices.h"

namespace toile::render {

/// A vertex array on the graphics side.
struct DrawnSurface {
  GLuint vertex_array = 0;
  GLsizei vertices = 0;
  GLsizei count = 0;   // indices
  LinearRgb colour{};  // of a body
};

DrawnSurface upload_cloth(GlScope& scope, const ClothSurface& cloth);
DrawnSurface upload_indexed(GlScope& scope, const std::vector<BodyVertex>& vertices,
                            const std::vector<Tri>& triangles, LinearRgb colour);
void draw(const GlFunctions& gl, const DrawnSurface& surface);
/// Gives each vertex the soft light (two floats) that the capturing program in use finds for it.
void add_sky(GlScope& scope, const DrawnSurface& surface);

/// An empty depth texture that compares when read; outside it nothing casts shadows.
GLuint depth_map(GlScope& scope, int side);
/// A framebuffer that draws depth only, into `map`, is bound, and its map empty.
void bind_depth_target(GlScope& scope, GLuint map);

}  // namespace toile::render
