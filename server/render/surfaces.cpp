#include "server/render/surfaces.h"

#include <cstddef>

namespace toile::render {
namespace {

void attribute(const GlFunctions& gl, GLuint location, int size, std::size_t stride, std::size_t offset) {
  gl.EnableVertexAttribArray(location);
  gl.VertexAttribPointer(location, size, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                         // NOLINTNEXTLINE(performance-no-int-to-ptr): so OpenGL takes an offset
                         reinterpret_cast<const void*>(offset));
}

template <typename T>
void fill_buffer(GlScope& scope, GLenum target, const std::vector<T>& data) {
  scope.gl().BindBuffer(target, scope.buffer());
  scope.gl().BufferData(target, static_cast<GLsizeiptr>(data.size() * sizeof(T)), data.data(),
                        GL_STATIC_DRAW);
}

}  // namespace

DrawnSurface upload_cloth(GlScope& scope, const ClothSurface& cloth) {
  const GlFunctions& gl = scope.gl();
  DrawnSurface surface{scope.vertex_array(),
                       static_cast<GLsizei>(cloth.vertices.size()),
                       static_cast<GLsizei>(3 * cloth.triangles.size()),
                       {}};
  gl.BindVertexArray(surface.vertex_array);
  fill_buffer(scope, GL_ARRAY_BUFFER, cloth.vertices);
  fill_buffer(scope, GL_ELEMENT_ARRAY_BUFFER, cloth.triangles);
  constexpr std::size_t kLines = offsetof(ClothVertex, lines);
  attribute(gl, 0, 3, sizeof(ClothVertex), offsetof(ClothVertex, position));
  attribute(gl, 1, 3, sizeof(ClothVertex), offsetof(ClothVertex, normal));
  attribute(gl, 2, 3, sizeof(ClothVertex), offsetof(ClothVertex, colour));
  attribute(gl, 3, 2, sizeof(ClothVertex), offsetof(ClothVertex, rest));
  attribute(gl, 4, 4, sizeof(ClothVertex), kLines + offsetof(VertexLines, distance));
  attribute(gl, 5, 4, sizeof(ClothVertex), kLines + offsetof(VertexLines, along));
  attribute(gl, 6, 4, sizeof(ClothVertex), kLines + offsetof(VertexLines, kind));
  attribute(gl, 7, 3, sizeof(ClothVertex), offsetof(ClothVertex, make));
  attribute(gl, 8, 2, sizeof(ClothVertex), offsetof(ClothVertex, picture_at));
  return surface;
}

DrawnSurface upload_indexed(GlScope& scope, const std::vector<BodyVertex>& vertices,
                            const std::vector<Tri>& triangles, LinearRgb colour) {
  const GlFunctions& gl = scope.gl();
  DrawnSurface surface{scope.vertex_array(), static_cast<GLsizei>(vertices.size()),
                       static_cast<GLsizei>(triangles.size() * 3), colour};
  gl.BindVertexArray(surface.vertex_array);
  fill_buffer(scope, GL_ARRAY_BUFFER, vertices);
  fill_buffer(scope, GL_ELEMENT_ARRAY_BUFFER, triangles);
  attribute(gl, 0, 3, sizeof(BodyVertex), offsetof(BodyVertex, position));
  attribute(gl, 1, 3, sizeof(BodyVertex), offsetof(BodyVertex, normal));
  return surface;
}

void draw(const GlFunctions& gl, const DrawnSurface& surface) {
  if (surface.count == 0) return;
  gl.BindVertexArray(surface.vertex_array);
  gl.DrawElements(GL_TRIANGLES, surface.count, GL_UNSIGNED_INT, nullptr);
}

void add_sky(GlScope& scope, const DrawnSurface& surface) {
  constexpr GLuint kSky = 9;  // as surface_vertex.glsl and ground_vertex.glsl have it
  constexpr std::size_t kSize = 2 * sizeof(float);
  if (surface.vertices == 0) return;
  const GlFunctions& gl = scope.gl();
  const GLuint found = scope.buffer();
  gl.BindBuffer(GL_ARRAY_BUFFER, found);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(kSize) * surface.vertices, nullptr, GL_STATIC_DRAW);
  gl.BindVertexArray(surface.vertex_array);
  gl.Enable(GL_RASTERIZER_DISCARD);
  gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, found);
  gl.BeginTransformFeedback(GL_POINTS);
  gl.DrawArrays(GL_POINTS, 0, surface.vertices);
  gl.EndTransformFeedback();
  gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
  gl.Disable(GL_RASTERIZER_DISCARD);
  gl.BindBuffer(GL_ARRAY_BUFFER, found);
  attribute(gl, kSky, 2, kSize, 0);
}

GLuint depth_map(GlScope& scope, int side) {
  const GlFunctions& gl = scope.gl();
  const GLuint map = scope.texture();
  gl.BindTexture(GL_TEXTURE_2D, map);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, side, side, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                nullptr);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  return map;
}

void bind_depth_target(GlScope& scope, GLuint map) {
  const GlFunctions& gl = scope.gl();
  gl.BindFramebuffer(GL_FRAMEBUFFER, scope.framebuffer());
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, map, 0);
  gl.DrawBuffer(GL_NONE);
  gl.ReadBuffer(GL_NONE);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LESS);
  gl.Clear(GL_DEPTH_BUFFER_BIT);
}

}  // namespace toile::render
