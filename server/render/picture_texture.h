#pragma once

#include "core/image/picture.h"
#include "server/render/gl/objects.h"

namespace toile::render {

/// The picture as a texture of OpenGL that repeats without end and stays calm far away and at a slant.
/// REQUIRES a picture of at most 2048 pixels a side, what every OpenGL 3.3 takes.
GLuint upload_picture(GlScope& scope, const image::Picture& picture);

}  // namespace toile::render
