#include "server/app/mesh_reader.h"

#include <string>
#include <vector>

namespace toile::app {

mesh_import::MeshImporter own_mesh_importer() { return mesh_import::MeshImporter("/proc/self/exe"); }

std::optional<int> read_mesh_for_parent(int argc, char** argv) {
  if (argc < 2 || std::string(argv[1]) != mesh_import::kMeshImportVerb) return std::nullopt;
  return mesh_import::run_mesh_import(std::vector<std::string>(argv + 2, argv + argc));
}

}  // namespace toile::app
