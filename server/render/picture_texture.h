#pragma once

#include "core/image/picture.h"
#include "server/render/cloth_look.h"
#include "server/render/gl/objects.h"

namespace toile::render {

/// The picture as a texture of OpenGL that repeats without end and stays calm far away and at a slant.
/// REQUIRES a picture of at most 2048 pixels a side, what every OpenGL 3.3 takes.
GLuint upload_picture(GlScope& scope, const image::Picture& picture);

/// A tile of cloth (weave_tile) as a texture that repeats, smooth from afar.
GLuint upload_weave(GlScope& scope, Structure structure);

}  // namespace toile::render
