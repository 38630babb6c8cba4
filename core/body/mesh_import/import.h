#pragma once
// A mesh file made fit to be a body: read, then mended; in a process of its own, when the file may be
// anything.

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/run_child.h"
#include "core/body/mesh_import/load.h"
#include "core/body/mesh_import/repair.h"

namespace toile::mesh_import {

/// Limits of the reader's process: far more than two million triangles need, far less than a server has.
ChildLimits mesh_import_limits();

/// Of those, what a file of so many bytes may take: a small file that wants much is no mesh but a bomb.
ChildLimits limits_for(const ChildLimits& most, std::uint64_t bytes);

/// How the readers of one importer ended.
struct ReaderEnds {
  std::int64_t started = 0;
  std::int64_t crashed = 0;  ///< by what they read
  std::int64_t refused = 0;  ///< took too much time, memory or output
};

/// Reads and mends mesh files. Safe to use from many threads.
class MeshImporter {
 public:
  /// Reads in this process: for files that one trusts. Only the formats of mesh_formats().
  MeshImporter();
  /// Has `program` read, in a process of its own, with kMeshImportVerb and the arguments that
  /// run_mesh_import() takes: any format that assimp knows. At most three at once; further calls wait. The
  /// process ends when `cancel`, that each of the calls below takes, becomes true: error mesh.cancelled.
  explicit MeshImporter(std::string program, const ChildLimits& limits = mesh_import_limits());

  ReaderEnds ends() const;

  /// A file on this machine's disk, and the files that it names. Errors: those of load_mesh; of a reader in
  /// another process also "mesh.crashed", "mesh.too_long", "mesh.memory", "mesh.reader" (not started).
  Result<RepairedMesh> file(const std::filesystem::path& path, const MeshSettings& settings) const;

  /// A file that a stranger gave the name `name`; nothing but its bytes is read. Errors: the same, with
  /// `name` as place.
  Result<RepairedMesh> bytes(const std::string& name, std::string_view bytes, const MeshSettings& settings,
                             const std::atomic<bool>* cancel = nullptr) const;
  /// The same of a file on disk that goes by `name`.
  Result<RepairedMesh> stored(const std::filesystem::path& path, const std::string& name,
                              const MeshSettings& settings, const std::atomic<bool>* cancel = nullptr) const;

 private:
  struct Reader;
  std::shared_ptr<const Reader> reader_;  ///< none: this process
};

/// First argument of the program that reads.
inline constexpr const char* kMeshImportVerb = "import-mesh";

/// The other side: reads as the arguments say, writes the mesh or the error to standard output, and returns
/// the exit code. Before it looks at a byte of a stranger it is confined (confine.h).
int run_mesh_import(const std::vector<std::string>& arguments);

}  // namespace toile::mesh_import
