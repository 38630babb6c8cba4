#include "server/render/gl/objects.h"

#include <utility>

namespace toile::render {
namespace {

template <typename Generate>
GLuint made(Generate generate, std::vector<GLuint>& kept) {
  GLuint name = 0;
  generate(1, &name);
  kept.push_back(name);
  return name;
}

template <typename Delete>
void drop(Delete remove, const std::vector<GLuint>& names) {
  if (!names.empty()) remove(static_cast<GLsizei>(names.size()), names.data());
}

/// 0 when it does not compile; then `log` says why.
GLuint compiled(const GlFunctions& gl, GLenum kind, const std::vector<const char*>& sources,
                std::string& log) {
  const GLuint shader = gl.CreateShader(kind);
  gl.ShaderSource(shader, static_cast<GLsizei>(sources.size()), sources.data(), nullptr);
  gl.CompileShader(shader);
  GLint fine = 0;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &fine);
  if (fine) return shader;
  log.assign(4096, '\0');
  GLsizei length = 0;
  gl.GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
  log.resize(static_cast<std::size_t>(length));
  gl.DeleteShader(shader);
  return 0;
}

}  // namespace

GlScope::~GlScope() {
  drop(gl_.DeleteFramebuffers, framebuffers_);
  drop(gl_.DeleteRenderbuffers, renderbuffers_);
  drop(gl_.DeleteTextures, textures_);
  drop(gl_.DeleteVertexArrays, vertex_arrays_);
  drop(gl_.DeleteBuffers, buffers_);
}

GLuint GlScope::buffer() { return made(gl_.GenBuffers, buffers_); }
GLuint GlScope::vertex_array() { return made(gl_.GenVertexArrays, vertex_arrays_); }
GLuint GlScope::texture() { return made(gl_.GenTextures, textures_); }
GLuint GlScope::framebuffer() { return made(gl_.GenFramebuffers, framebuffers_); }
GLuint GlScope::renderbuffer() { return made(gl_.GenRenderbuffers, renderbuffers_); }

Result<GlProgram> GlProgram::link(const GlFunctions& gl, const std::vector<const char*>& vertex,
                                  const std::vector<const char*>& fragment) {
  std::string log;
  const GLuint vertex_shader = compiled(gl, GL_VERTEX_SHADER, vertex, log);
  if (vertex_shader == 0)
    return Error{"render.shader", "a vertex shader does not compile: " + log, "", ErrorKind::kInternal};
  const GLuint fragment_shader = compiled(gl, GL_FRAGMENT_SHADER, fragment, log);
  if (fragment_shader == 0) {
    gl.DeleteShader(vertex_shader);
    return Error{"render.shader", "a fragment shader does not compile: " + log, "", ErrorKind::kInternal};
  }
  GlProgram program(gl, gl.CreateProgram());
  program.attach(vertex_shader);
  program.attach(fragment_shader);
  TRY(program.link());
  return program;
}

Result<GlProgram> GlProgram::link_capturing(const GlFunctions& gl, const std::vector<const char*>& vertex,
                                            const char* captured) {
  std::string log;
  const GLuint shader = compiled(gl, GL_VERTEX_SHADER, vertex, log);
  if (shader == 0)
    return Error{"render.shader", "a vertex shader does not compile: " + log, "", ErrorKind::kInternal};
  GlProgram program(gl, gl.CreateProgram());
  program.attach(shader);
  gl.TransformFeedbackVaryings(program.name_, 1, &captured, GL_INTERLEAVED_ATTRIBS);
  TRY(program.link());
  return program;
}

void GlProgram::attach(GLuint shader) {
  gl_->AttachShader(name_, shader);
  gl_->DeleteShader(shader);  // lives on as long as the program
}

Status GlProgram::link() {
  gl_->LinkProgram(name_);
  GLint fine = 0;
  gl_->GetProgramiv(name_, GL_LINK_STATUS, &fine);
  if (fine) return {};
  return Error{"render.shader", "a shader program does not link", "", ErrorKind::kInternal};
}

GlProgram::GlProgram(GlProgram&& other) noexcept : gl_(other.gl_), name_(std::exchange(other.name_, 0)) {}

GlProgram::~GlProgram() {
  if (name_ != 0) gl_->DeleteProgram(name_);
}

}  // namespace toile::render
