#pragma once

#include <map>
#include <string>

#include "core/base/result.h"
#include "core/drape/drape_input.h"
#include "core/image/texture.h"
#include "server/documents/documents.h"

namespace toile::jobs {

/// A document and the owner's assets that it names (file name → asset id) as what a drape needs. Errors:
/// json.*, project.*, dxf.*, pattern.*, body.*, store.*; `where` is the place in the document.
Result<drape::DrapeInput> drape_input_of(documents::Documents& documents,
                                         const store::RequestContext& context, const std::string& document,
                                         const std::map<std::string, std::string>& files);

/// The pictures of the same document, for whoever draws it. REQUIRES the pattern that it resolves to. Errors:
/// json.*, project.*, image.*, documents.*, store.*.
Result<image::Textures> textures_of(documents::Documents& documents, const store::RequestContext& context,
                                    const std::string& document,
                                    const std::map<std::string, std::string>& files,
                                    const pattern::Pattern& pattern);

}  // namespace toile::jobs
