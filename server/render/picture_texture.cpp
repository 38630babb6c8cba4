#include "server/render/picture_texture.h"

#include <algorithm>
#include <cstdint>

namespace toile::render {
namespace {

// Of the extension EXT_texture_filter_anisotropic, which Mesa has had for long.
constexpr GLenum kMaxAnisotropy = 0x84FF, kAnisotropy = 0x84FE;
constexpr GLint kEnough = 8;

/// What OpenGL can do of that; 1 where it has not got the extension.
GLint anisotropy(const GlFunctions& gl) {
  GLint most = 1;
  gl.GetIntegerv(kMaxAnisotropy, &most);
  if (gl.GetError() != GL_NO_ERROR) return 1;
  return std::clamp(most, 1, kEnough);
}

GLuint upload(GlScope& scope, GLint format, int width, int height, const std::uint8_t* rgba) {
  const GlFunctions& gl = scope.gl();
  const GLuint texture = scope.texture();
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
  gl.GenerateMipmap(GL_TEXTURE_2D);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
  return texture;
}

}  // namespace

GLuint upload_picture(GlScope& scope, const image::Picture& picture) {
  const GLuint texture = upload(scope, GL_SRGB8_ALPHA8, picture.width, picture.height, picture.rgba.data());
  const GLint along = anisotropy(scope.gl());
  if (along > 1) scope.gl().TexParameteri(GL_TEXTURE_2D, kAnisotropy, along);
  return texture;
}

/// Not sharper at a slant than from the front: on a processor that costs more than all else of a picture.
GLuint upload_weave(GlScope& scope, Structure structure) {
  return upload(scope, GL_RGBA8, kWeaveSide, kWeaveSide, weave_tile(structure).data());
}

}  // namespace toile::render
