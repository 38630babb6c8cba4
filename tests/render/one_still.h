#pragma once

#include "server/render/still.h"

namespace toile::test {

/// One still; a test program's thread keeps the renderer, which takes half a second to make.
inline Result<render::Image> render_still(const render::Scene& scene, render::View view,
                                          const render::StillSettings& settings = {}) {
  thread_local render::Stills stills;
  return stills.render(scene, view, settings);
}

}  // namespace toile::test
