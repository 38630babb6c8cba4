#pragma once
// The shader programs that pictures are drawn by.

#include <vector>

#include "core/base/result.h"
#include "server/render/gl/objects.h"

namespace toile::render {

/// Shader programs, kept from one picture to the next.
struct Programs {
  GlProgram depth, sky, ground_sky;  ///< shadow maps; soft light at vertices, as two floats each
  GlProgram cloth, body, ground, backdrop;
  std::vector<GLuint> weaves{};  // a texture for each Structure; whoever made them deletes them
  /// Error: "render.shader".
  static Result<Programs> link(const GlFunctions& gl);
};

}  // namespace toile::render
