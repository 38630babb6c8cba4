#pragma once
// Owners of what OpenGL hands out by number.

#include <string>
#include <vector>

#include "core/base/result.h"
#include "server/render/gl/context.h"

namespace toile::render {

/// Makes objects and deletes them all when it ends. Its context must be current then.
class GlScope {
 public:
  explicit GlScope(const GlFunctions& gl) : gl_(gl) {}
  ~GlScope();
  GlScope(const GlScope&) = delete;
  GlScope& operator=(const GlScope&) = delete;

  GLuint buffer();
  GLuint vertex_array();
  GLuint texture();
  GLuint framebuffer();
  GLuint renderbuffer();

  const GlFunctions& gl() const { return gl_; }

 private:
  const GlFunctions& gl_;
  std::vector<GLuint> buffers_, vertex_arrays_, textures_, framebuffers_, renderbuffers_;
};

/// A linked shader program.
class GlProgram {
 public:
  /// Sources are joined in order. Error: "render.shader" with the compiler's words, a bug of ours or the
  /// driver's.
  static Result<GlProgram> link(const GlFunctions& gl, const std::vector<const char*>& vertex,
                                const std::vector<const char*>& fragment);
  /// One that draws nothing, and hands on what its vertex shader calls `captured` (transform feedback).
  static Result<GlProgram> link_capturing(const GlFunctions& gl, const std::vector<const char*>& vertex,
                                          const char* captured);
  GlProgram(GlProgram&& other) noexcept;
  GlProgram& operator=(GlProgram&&) = delete;
  ~GlProgram();

  void use() const { gl_->UseProgram(name_); }
  /// Location of a uniform; -1, which OpenGL ignores, where the program has no such.
  GLint at(const char* uniform) const { return gl_->GetUniformLocation(name_, uniform); }

 private:
  GlProgram(const GlFunctions& gl, GLuint name) : gl_(&gl), name_(name) {}
  void attach(GLuint shader);
  Status link();
  const GlFunctions* gl_;
  GLuint name_;
};

}  // namespace toile::render
