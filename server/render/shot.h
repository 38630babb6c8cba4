#pragma once
// The taking of one picture with OpenGL.

#include <cstdint>
#include <vector>

#include "core/base/result.h"
#include "server/render/camera.h"
#include "server/render/gl/objects.h"
#include "server/render/programs.h"
#include "server/render/stage.h"
#include "server/render/studio.h"

namespace toile::render {

/// One picture of what is on a stage, drawn when it is taken. The context must be current as long as it
/// lives.
class Shot {
 public:
  Shot(const GlFunctions& gl, const Programs& programs, const Stage& stage, const Camera& camera);

  /// RGBA, 8-bit sRGB, rows from the bottom. Error: "render.failed".
  /// With `transparent`, colours are multiplied by their opacity.
  Result<std::vector<std::uint8_t>> take(int width, int height, int samples, bool transparent);

 private:
  void draw_key_map();
  void draw_cloth();
  void set_look(const GlProgram& program, const ClothLook& look);
  void draw_picture(int width, int height, bool transparent);
  void draw_ground(bool transparent);
  void set_lamps(const GlProgram& program, int width, int height);
  void set_viewer(const GlProgram& program);
  /// 0 when OpenGL cannot make it.
  GLuint target(int width, int height, int samples);

  const GlFunctions& gl_;
  const Programs& programs_;
  const Stage& stage_;
  const Camera& camera_;
  Lamps lamps_;
  GlScope scope_;
  GLuint key_map_ = 0;
};

}  // namespace toile::render
