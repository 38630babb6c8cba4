#pragma once
// The pictures that a project document puts on its pieces. A drape does without them: whoever draws reads
// them.

#include <cstddef>

#include "core/base/result.h"
#include "core/image/texture.h"
#include "core/pattern/pattern.h"
#include "core/project/project.h"
#include "core/project/resolve/files.h"

namespace toile::resolve {

/// A project shows at most so many different pictures, of so many bytes together.
inline constexpr std::size_t kMostTextureImages = 32;
inline constexpr std::size_t kMostTextureBytes = std::size_t{64} << 20;

/// Reads each picture once, in the order of the pieces, and lays it on them. Of more than four each keeps
/// half as many pixels a side. REQUIRES a pattern whose panels are pieces of the
/// project. Errors: image.*,
/// image.too_many, and whatever the files give; `where` is the JSON pointer of the piece's picture.
Result<image::Textures> read_textures(const project::Project& project, const pattern::Pattern& pattern,
                                      const ProjectFiles& files);

}  // namespace toile::resolve
