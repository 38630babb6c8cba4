#pragma once
// Documents as they were read lately: an edit, the drawing of its pieces and the next edit are of the same
// text.

#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/drape/drape_input.h"
#include "core/project/project.h"
#include "server/documents/documents.h"
#include "server/documents/projects.h"

namespace toile::documents {

/// What a document says, and its cloth: with or without the bodies, which take long.
struct ReadCloth {
  project::Project project;
  drape::DrapeInput cloth;
};

/// What tells a document with its files from all others.
std::string key_of(const store::OwnerId& owner, const std::string& document, const ProjectFileMap& files);

/// Null where nothing is kept of it.
std::shared_ptr<const ReadCloth> kept_cloth(Documents& documents, const store::OwnerId& owner,
                                            const std::string& document, const ProjectFileMap& files);

/// Keeps what somebody has read already.
std::shared_ptr<const ReadCloth> keep_cloth(Documents& documents, const store::OwnerId& owner,
                                            const std::string& document, const ProjectFileMap& files,
                                            ReadCloth read);

/// What is kept of it, or else read now. Errors: json.*, project.*, dxf.*, pattern.*, … as reading gives
/// them.
Result<std::shared_ptr<const ReadCloth>> read_cloth(Documents& documents,
                                                    const store::RequestContext& context,
                                                    const std::string& document, const ProjectFileMap& files);

}  // namespace toile::documents
