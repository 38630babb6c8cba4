#include "server/render/programs.h"

#include <utility>

#include "server/render/shaders.h"

namespace toile::render {

Result<Programs> Programs::link(const GlFunctions& gl) {
  namespace s = shaders;
  constexpr const char* kCloth = "#define CLOTH 1\n";
  constexpr const char* kBody = "#define CLOTH 0\n";
  GlProgram depth =
      TRY(GlProgram::link(gl, {s::kVersion, s::kDepthVertex}, {s::kVersion, s::kDepthFragment}));
  GlProgram sky =
      TRY(GlProgram::link_capturing(gl, {s::kVersion, "#define GROUND 0\n", s::kSky, s::kSkyVertex}, "sky"));
  GlProgram ground_sky =
      TRY(GlProgram::link_capturing(gl, {s::kVersion, "#define GROUND 1\n", s::kSky, s::kSkyVertex}, "sky"));
  GlProgram cloth =
      TRY(GlProgram::link(gl, {s::kVersion, kCloth, s::kSurfaceVertex},
                          {s::kVersion, kCloth, s::kStudio, s::kSeams, s::kOpenSeams, s::kSurfaceFragment}));
  GlProgram body = TRY(GlProgram::link(gl, {s::kVersion, kBody, s::kSurfaceVertex},
                                       {s::kVersion, kBody, s::kStudio, s::kSurfaceFragment}));
  GlProgram ground = TRY(
      GlProgram::link(gl, {s::kVersion, s::kGroundVertex}, {s::kVersion, s::kStudio, s::kGroundFragment}));
  GlProgram backdrop = TRY(GlProgram::link(gl, {s::kVersion, s::kBackdropVertex},
                                           {s::kVersion, s::kStudio, s::kBackdropFragment}));
  return Programs{std::move(depth), std::move(sky),    std::move(ground_sky), std::move(cloth),
                  std::move(body),  std::move(ground), std::move(backdrop)};
}

}  // namespace toile::render
