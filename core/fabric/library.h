#pragma once
// The fabrics that the program knows by name: the files of the folder fabrics/, which are built into it.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/fabric/card.h"

namespace toile::fabric {

/// A file of the folder fabrics/ as it was when the program was built; the build makes the list.
struct FabricFile {
  std::string_view name;  ///< without the folder and ".json"
  std::string_view text;
};
std::span<const FabricFile> fabric_files();

/// All of them, by name.
const std::vector<FabricCard>& library();

/// Their names, in the same order.
std::vector<std::string> names();

/// Null: there is none of that name.
const FabricCard* find(std::string_view name);

/// Error: project.unknown_fabric at `where`, with the names that come near.
Result<const FabricCard*> named(const std::string& name, const std::string& where);

}  // namespace toile::fabric
