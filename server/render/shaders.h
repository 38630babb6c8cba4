#pragma once
// GLSL 3.30 sources: the files of glsl/ by their names (cmake/toile_shaders.cmake). A program is kVersion +
// what it uses, in order.

namespace toile::render::shaders {

inline constexpr int kSkyTiles = 5;                       ///< sky maps lie in a square atlas, so many a side
inline constexpr int kSkyLights = kSkyTiles * kSkyTiles;  ///< directions from which the soft light comes

extern const char* const kVersion;
extern const char* const kDepthVertex;  ///< a surface into a shadow map
extern const char* const kDepthFragment;
extern const char* const kSky;            ///< soft light that reaches a place; goes before kSkyVertex
extern const char* const kSkyVertex;      ///< with "#define GROUND 1" or 0 before it
extern const char* const kStudio;         ///< key shadow, backdrop, tone; goes before fragment shaders
extern const char* const kSeams;          ///< seams, hems, stitches; goes before the cloth's fragment shader
extern const char* const kOpenSeams;      ///< those that did not close; goes behind kSeams
extern const char* const kSurfaceVertex;  ///< with "#define CLOTH 1" or 0 before it
extern const char* const kSurfaceFragment;
extern const char* const kGroundVertex;
extern const char* const kGroundFragment;
extern const char* const kBackdropVertex;
extern const char* const kBackdropFragment;

}  // namespace toile::render::shaders
