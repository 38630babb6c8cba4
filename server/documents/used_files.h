#pragma once

#include <string>
#include <vector>

#include "core/project/project.h"

namespace toile::documents {

/// A place of the document that names a file.
struct UsedFile {
  std::string name;
  std::string kind;   ///< "dxf", "body" or "image"
  std::string where;  ///< JSON pointer
};

/// In the order of the document; a name stands once for each place.
std::vector<UsedFile> used_files(const project::Project& project);

}  // namespace toile::documents
