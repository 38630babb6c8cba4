#include "server/render/shaders.h"

namespace toile::render::shaders {

const char* const kVersion = "#version 330 core\n#define SKY_TILES 5\n#define SKY_LIGHTS 25\n";
static_assert(kSkyTiles == 5 && kSkyLights == 25, "kVersion repeats these numbers");

}  // namespace toile::render::shaders
