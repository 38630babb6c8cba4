#pragma once
// Versions of a project in the store: states that were named, and the way back to them.

#include <string>

#include "core/base/result.h"
#include "server/documents/documents.h"
#include "server/store/versions.h"

namespace toile::documents {

inline constexpr std::size_t kLongestVersionName = 80;  // bytes

/// Names the state of the project when it stands at revision `expected` (0: at any). Errors: versions.name (1
/// to 80 bytes, without control characters or blanks around), those of Versions::add_version.
Result<store::VersionRow> name_version(Documents& documents, const store::RequestContext& context,
                                       const std::string& project, const std::string& name, int expected);

/// Makes the project what the version was, as one step of its history; the very same project where it stands
/// so. Errors: store.not_found, documents.file_taken where a file's name stands for another by now, those of
/// change_project.
Result<store::ProjectRow> restore_version(Documents& documents, const store::RequestContext& context,
                                          const std::string& project, const std::string& version,
                                          int expected);

}  // namespace toile::documents
