#include "server/render/shot.h"

#include <cstddef>
#include <utility>

namespace toile::render {
namespace {

constexpr int kKeyMapSide = 1280;    // texels; under 2 mm each around a person
constexpr float kBodySink = 0.002f;  // m; more than a coarse skin bulges through the cloth upon it
constexpr GLint kKeyUnit = 0, kPictureUnit = 1, kWeaveUnit = 2;

void set(const GlFunctions& gl, GLint location, Vec3 v) {
  gl.Uniform3f(location, static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z));
}

Error failed() {
  return {"render.failed", "OpenGL could not draw the picture; try a smaller one", "", ErrorKind::kInternal};
}

}  // namespace

Shot::Shot(const GlFunctions& gl, const Programs& programs, const Stage& stage, const Camera& camera)
    : gl_(gl),
      programs_(programs),
      stage_(stage),
      camera_(camera),
      lamps_(lamps_for(camera, stage.box())),
      scope_(gl) {}

void Shot::draw_key_map() {
  key_map_ = depth_map(scope_, kKeyMapSide);
  bind_depth_target(scope_, key_map_);
  gl_.Viewport(0, 0, kKeyMapSide, kKeyMapSide);
  programs_.depth.use();
  gl_.UniformMatrix4fv(programs_.depth.at("light_matrix"), 1, GL_FALSE, lamps_.key_matrix.data());
  stage_.draw_casters();
}

GLuint Shot::target(int width, int height, int samples) {
  const GLuint framebuffer = scope_.framebuffer();
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  const GLsizei count = samples > 1 ? samples : 0;
  for (const auto& [format, point] :
       {std::pair{GL_RGBA8, GL_COLOR_ATTACHMENT0}, std::pair{GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT}}) {
    const GLuint storage = scope_.renderbuffer();
    gl_.BindRenderbuffer(GL_RENDERBUFFER, storage);
    gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, count, format, width, height);
    gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, storage);
  }
  return gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE ? framebuffer : 0;
}

/// Uniforms that several programs share; those that a program does not have are ignored.
void Shot::set_lamps(const GlProgram& program, int width, int height) {
  program.use();
  gl_.UniformMatrix4fv(program.at("key_matrix"), 1, GL_FALSE, lamps_.key_matrix.data());
  set(gl_, program.at("key_light"), lamps_.key);
  set(gl_, program.at("fill_light"), lamps_.fill);
  set(gl_, program.at("rim_light"), lamps_.rim);
  gl_.Uniform1i(program.at("key_map"), kKeyUnit);
  gl_.Uniform1f(program.at("key_texel"), 1.0f / kKeyMapSide);
  gl_.Uniform4f(program.at("image_size"), static_cast<float>(width), static_cast<float>(height), 0, 0);
}

void Shot::set_viewer(const GlProgram& program) {
  gl_.UniformMatrix4fv(program.at("camera_matrix"), 1, GL_FALSE, camera_.matrix().data());
  set(gl_, program.at("eye"), camera_.eye);
}

void Shot::set_look(const GlProgram& program, const ClothLook& look) {
  gl_.Uniform4f(program.at("look"), look.roughness, look.sheen, look.uneven, look.pitch * kWeaveThreads);
  gl_.Uniform1i(program.at("weave"), kWeaveUnit);
  gl_.ActiveTexture(GL_TEXTURE0 + kWeaveUnit);
  gl_.BindTexture(GL_TEXTURE_2D, programs_.weaves[static_cast<std::size_t>(look.structure)]);
  gl_.ActiveTexture(GL_TEXTURE0);
}

/// Cloth without a picture first, then picture by picture.
void Shot::draw_cloth() {
  const GlProgram& program = programs_.cloth;
  program.use();
  gl_.Uniform1f(program.at("sink"), 0);
  gl_.Uniform1i(program.at("picture"), kPictureUnit);
  gl_.BindVertexArray(stage_.cloth().vertex_array);
  for (const ClothRun& run : stage_.runs()) {
    gl_.Uniform1i(program.at("pictured"), run.image == kNone ? 0 : 1);
    set_look(program, run.look);
    if (run.image != kNone) {
      gl_.ActiveTexture(GL_TEXTURE0 + kPictureUnit);
      gl_.BindTexture(GL_TEXTURE_2D, stage_.picture(run.image));
      gl_.ActiveTexture(GL_TEXTURE0);
    }
    const std::size_t first = sizeof(Index) * static_cast<std::size_t>(run.first);
    // NOLINTNEXTLINE(performance-no-int-to-ptr): so OpenGL takes an offset
    gl_.DrawElements(GL_TRIANGLES, run.count, GL_UNSIGNED_INT, reinterpret_cast<const void*>(first));
  }
}

void Shot::draw_picture(int width, int height, bool transparent) {
  gl_.Viewport(0, 0, width, height);
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthFunc(GL_LEQUAL);
  gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl_.ActiveTexture(GL_TEXTURE0 + kKeyUnit);
  gl_.BindTexture(GL_TEXTURE_2D, key_map_);
  gl_.ActiveTexture(GL_TEXTURE0);
  for (const GlProgram* program :
       {&programs_.cloth, &programs_.body, &programs_.ground, &programs_.backdrop}) {
    set_lamps(*program, width, height);
    set_viewer(*program);
  }
  draw_cloth();
  programs_.body.use();
  gl_.Uniform1f(programs_.body.at("sink"), stage_.cloth().count > 0 ? kBodySink : 0);
  for (const DrawnSurface& body : stage_.bodies()) {
    set(gl_, programs_.body.at("body_colour"), {body.colour[0], body.colour[1], body.colour[2]});
    draw(gl_, body);
  }
  draw_ground(transparent);
  if (transparent) return;
  programs_.backdrop.use();
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

void Shot::draw_ground(bool transparent) {
  programs_.ground.use();
  const Vec3 middle = stage_.middle();
  gl_.Uniform4f(programs_.ground.at("ground"), static_cast<float>(middle.x), static_cast<float>(middle.z),
                static_cast<float>(stage_.reach()), 0);
  gl_.Uniform1i(programs_.ground.at("shadow_only"), transparent ? 1 : 0);
  draw(gl_, stage_.ground());
}

Result<std::vector<std::uint8_t>> Shot::take(int width, int height, int samples, bool transparent) {
  draw_key_map();
  const GLuint drawn = target(width, height, samples);
  if (drawn == 0) return failed();
  draw_picture(width, height, transparent);
  const GLuint resolved = target(width, height, 1);
  if (resolved == 0) return failed();
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, drawn);
  gl_.BlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, resolved);
  std::vector<std::uint8_t> rgba(static_cast<std::size_t>(width) * height * 4);
  gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl_.ReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  if (gl_.GetError() != GL_NO_ERROR) return failed();
  return rgba;
}

}  // namespace toile::render
