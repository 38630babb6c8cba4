#pragma once
// The tasks that other cloth simulators were given: OBJ files of a cloth and a body, with seams and led
// vertices where a task has them.

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/geometry/triangle_mesh.h"
#include "core/solver/cloth_model.h"

namespace toile::peers {

/// A vertex that is led to a place and held there.
struct LedVertex {
  Index v = kNone;
  Vec3 target;  ///< m
};

/// The cloth is flat and free of stress where it starts.
struct PeerTask {
  std::string name;
  geometry::TriangleMesh cloth;
  geometry::TriangleMesh body;
  std::vector<std::array<Index, 2>> sewn;
  std::vector<LedVertex> led;
};

/// Reads NAME_cloth.obj, NAME_body.obj and, where they are, NAME_seams.txt (i j a line) and NAME_pins.txt (i
/// x y z a line), vertices counted from 0. Errors: "bench.missing", "bench.bad_file" with file and line.
Result<PeerTask> read_task(const std::filesystem::path& folder, const std::string& name);

/// The same task put differently. What is right is right however it is put.
struct Disguise {
  double turn_degrees = 0;               ///< of all, about the y axis
  std::optional<std::uint64_t> shuffle;  ///< seed: vertices and triangles of the cloth in another order
  bool flip = false;                     ///< all mirrored in z, so that the cloth lies on its other face
};

/// A disguised task, and the way back.
struct DisguisedTask {
  PeerTask task;
  std::vector<Index> place;  ///< where each vertex of the original stands in the disguised list
  Disguise disguise;

  /// Positions of the disguised cloth in the order and place of the original.
  std::vector<Vec3> undo(std::span<const Vec3> positions) const;
};
DisguisedTask put_on(const PeerTask& task, const Disguise& disguise);

/// The fabric of all tasks: isotropic, 0.2 kg/m², E·t = 2000 N/m, Poisson's ratio 0.3, 1 mm thick.
material::Fabric bench_fabric();

/// `vertex_of` gives the solver's vertex of each cloth vertex (welded vertices have the same); sewn ones that
/// are not welded count as one for neighbourhood.
solver::ClothModel task_model(const PeerTask& task, const material::Fabric& fabric,
                              std::span<const Index> vertex_of, Index vertex_count);

/// Least vertex that each is sewn to, directly or through others; itself where it is not.
std::vector<Index> sewn_classes(const PeerTask& task);

/// m, of the rest triangles' edges.
double mean_edge_of(const geometry::TriangleMesh& cloth);

}  // namespace toile::peers
