#include "server/app/mesh_reader.h"

#include <string>
#include <vector>

namespace toile {

MeshImporter own_mesh_importer() { return MeshImporter("/proc/self/exe"); }

std::optional<int> read_mesh_for_parent(int argc, char** argv) {
  if (argc < 2 || std::string(argv[1]) != kMeshImportVerb) return std::nullopt;
  return run_mesh_import(std::vector<std::string>(argv + 2, argv + argc));
}

}  // namespace toile
