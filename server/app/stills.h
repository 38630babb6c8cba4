#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/drape/drape_input.h"
#include "core/drape/drape_result.h"

namespace toile {

/// Writes front.png, back.png, side.png and three-quarter.png into `folder`. Errors: render.*, export.write.
Status write_stills(const DrapeInput& input, const DrapeResult& result, const std::filesystem::path& folder,
                    int width, int height);

}  // namespace toile
