#include "core/body/mesh_import/load.h"

#include <assimp/MemoryIOWrapper.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/IOSystem.hpp>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cstdint>
#include <cstring>
#include <exception>
#include <new>
#include <numeric>
#include <string>
#include <utility>

#include "core/base/aabb.h"
#include "core/body/mesh_import/repair.h"
#include "core/body/mesh_import/sniff.h"

namespace toile::mesh_import {
namespace {

constexpr int kDeepest = 256;  // levels of the scene's tree
// Cutting a polygon into triangles costs the square of its corners: half a million of them take minutes.
constexpr unsigned kMostCornersOfFace = 1000;        // of one face; a cap of a cylinder has a hundred
constexpr std::uint64_t kMostCutting = 200'000'000;  // corners², of all faces together

Error fail(const char* code, std::string message, const std::string& file, const std::string& place = {}) {
  return {code, std::move(message), file + (place.empty() ? "" : ": " + place)};
}

Error too_large(std::string message, const std::string& file) {
  return {"mesh.too_large", std::move(message), file, ErrorKind::kTooLarge};
}

Error no_memory(const std::string& file) {
  return fail(
      "mesh.memory",
      "Reading the mesh takes more memory than is allowed; export it with fewer triangles, or as STL.", file);
}

Status check_size(std::uintmax_t bytes, const std::string& file) {
  if (bytes == 0) return fail("mesh.empty", "The file is empty.", file);
  if (bytes <= kMostMeshBytes) return {};
  return too_large("The file is larger than 256 MiB; export the mesh with fewer triangles.", file);
}

Status check_file(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    return fail("mesh.not_found", "There is no such file.", path.string());
  }
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error)
    return fail("mesh.not_found", "The file cannot be opened: " + error.message() + ".", path.string());
  return check_size(size, path.string());
}

Vec3 apply(const aiMatrix4x4& m, const aiVector3D& p) {
  const double x = p.x, y = p.y, z = p.z;
  return {m.a1 * x + m.a2 * y + m.a3 * z + m.a4, m.b1 * x + m.b2 * y + m.b3 * z + m.b4,
          m.c1 * x + m.c2 * y + m.c3 * z + m.c4};
}

// Gathers a scene's triangles, node by node.
class Gatherer {
 public:
  Gatherer(const aiScene& scene, const std::string& file) : scene_(scene), file_(file) {}

  Status add(const aiNode& node, const aiMatrix4x4& above, int depth) {
    if (depth > kDeepest) return fail("mesh.unreadable", "The scene's tree is too deep.", file_);
    const aiMatrix4x4 place = above * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      if (node.mMeshes[i] >= scene_.mNumMeshes) {
        return fail("mesh.unreadable", "A node names a mesh that is not there.", file_);
      }
      // What a file claims is passed on unchecked by some readers: every index is looked at before use.
      if (Status s = add_mesh(*scene_.mMeshes[node.mMeshes[i]], place); !s) return s;
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) {
      if (Status s = add(*node.mChildren[i], place, depth + 1); !s) return s;
    }
    return {};
  }

  geometry::TriangleMesh take() { return std::move(mesh_); }

 private:
  Status add_mesh(const aiMesh& mesh, const aiMatrix4x4& place) {
    if (mesh_.triangles.size() + mesh.mNumFaces > kMostMeshTriangles ||
        mesh_.vertices.size() + mesh.mNumVertices > 3 * kMostMeshTriangles) {
      return too_large("The mesh has more than two million triangles.", file_);
    }
    const auto base = static_cast<Index>(mesh_.vertices.size());
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      mesh_.vertices.push_back(apply(place, mesh.mVertices[v]));
      if (!is_finite(mesh_.vertices.back())) {
        return fail("mesh.not_finite", "A coordinate is not a finite number.", file_,
                    "vertex " + std::to_string(base + v + 1) + " in reading order");
      }
    }
    // A mirroring node turns triangles inside out; their corners are swapped back.
    const bool mirrored = place.Determinant() < 0;
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices != 3) continue;  // points and lines; polygons are triangles by now
      Tri t;
      for (int c = 0; c < 3; ++c) {
        if (face.mIndices[c] >= mesh.mNumVertices) {
          return fail("mesh.unreadable", "A face names a vertex that is not there.", file_);
        }
        t[c] = base + static_cast<Index>(face.mIndices[c]);
      }
      if (mirrored) std::swap(t[1], t[2]);
      mesh_.triangles.push_back(t);
    }
    return {};
  }

  const aiScene& scene_;
  const std::string& file_;
  geometry::TriangleMesh mesh_;
};

bool before(const Vec3& a, const Vec3& b) {
  if (a.x != b.x) return a.x < b.x;
  return a.y != b.y ? a.y < b.y : a.z < b.z;
}

// The first vertex at each vertex's position.
std::vector<Index> first_at_position(const std::vector<Vec3>& vertices) {
  std::vector<Index> order(vertices.size()), first(vertices.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    if (vertices[a] == vertices[b]) return a < b;
    return before(vertices[a], vertices[b]);
  });
  for (size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && vertices[order[i]] == vertices[order[i - 1]];
    first[order[i]] = same ? first[order[i - 1]] : order[i];
  }
  return first;
}

// Equal positions become one vertex; triangles that are a line or a point go, and vertices that none uses.
geometry::TriangleMesh merged(const geometry::TriangleMesh& mesh) {
  const std::vector<Index> first = first_at_position(mesh.vertices);
  geometry::TriangleMesh out;
  std::vector<Index> number(mesh.vertices.size(), kNone);
  for (const Tri& t : mesh.triangles) {
    const Tri k{first[t[0]], first[t[1]], first[t[2]]};
    const Vec3 &a = mesh.vertices[k[0]], &b = mesh.vertices[k[1]], &c = mesh.vertices[k[2]];
    if (length(cross(b - a, c - a)) <= kLeastArea2) continue;
    Tri renumbered;
    for (int i = 0; i < 3; ++i) {
      Index& n = number[k[i]];
      if (n == kNone) {
        n = static_cast<Index>(out.vertices.size());
        out.vertices.push_back(mesh.vertices[k[i]]);
      }
      renumbered[i] = n;
    }
    out.triangles.push_back(renumbered);
  }
  return out;
}

double guessed_unit(const geometry::TriangleMesh& mesh) {
  const Vec3 size = bounding_box(mesh.vertices).size();
  const double e = std::max({size.x, size.y, size.z});
  return e < 5 ? 1 : e < 50 ? 0.1 : e < 500 ? 0.01 : 0.001;
}

void to_metres(geometry::TriangleMesh& mesh, const MeshSettings& settings) {
  const double unit = settings.unit_in_m > 0 ? settings.unit_in_m : guessed_unit(mesh);
  for (Vec3& p : mesh.vertices) {
    if (settings.z_up) p = {p.x, p.z, -p.y};
    p = p * unit;
  }
}

// Lets the reader see these bytes and no file of the machine.
class BytesOnly final : public Assimp::IOSystem {
 public:
  BytesOnly(std::string name, std::string_view bytes) : name_(std::move(name)), bytes_(bytes) {}
  bool Exists(const char* file) const override { return name_ == file; }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* file, const char* mode) override {
    if (name_ != file || std::strchr(mode, 'r') == nullptr) return nullptr;
    return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(bytes_.data()), bytes_.size());
  }
  void Close(Assimp::IOStream* file) override { delete file; }

 private:
  std::string name_;
  std::string_view bytes_;
};

Result<geometry::TriangleMesh> gathered(const aiScene& scene, const std::string& file,
                                        const MeshSettings& settings) {
  Gatherer gatherer(scene, file);
  TRY(gatherer.add(*scene.mRootNode, aiMatrix4x4(), 0));
  geometry::TriangleMesh all = gatherer.take();
  if (all.triangles.empty()) return fail("mesh.no_triangles", "The file holds no triangles.", file);
  to_metres(all, settings);
  geometry::TriangleMesh mesh = merged(all);
  if (mesh.triangles.empty()) return fail("mesh.no_triangles", "All triangles are without area.", file);
  return mesh;
}

/// Before they are cut.
Status check_faces(const aiScene& scene, const std::string& file) {
  std::uint64_t cutting = 0;
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    for (unsigned f = 0; f < scene.mMeshes[m]->mNumFaces; ++f) {
      const std::uint64_t corners = scene.mMeshes[m]->mFaces[f].mNumIndices;
      cutting += corners > 4 ? corners * corners : 0;
      if (corners <= kMostCornersOfFace && cutting <= kMostCutting) continue;
      return fail(
          "mesh.huge_face",
          "A face has " + std::to_string(corners) +
              " corners, and such faces are not cut into triangles here; export the mesh as triangles.",
          file, "face " + std::to_string(f + 1) + " of mesh " + std::to_string(m + 1));
    }
  }
  return {};
}

Result<geometry::TriangleMesh> import(Assimp::Importer& importer, const std::string& file,
                                      const MeshSettings& settings) {
  if (!importer.IsExtensionSupported(std::filesystem::path(file).extension().string())) {
    return fail("mesh.unreadable", "Files with this ending are no meshes that can be read.", file);
  }
  // No other processing: positions stay as the file says, and what is not geometry is not looked at.
  const aiScene* scene = importer.ReadFile(file, 0);
  if (scene != nullptr) {
    TRY(check_faces(*scene, file));
    scene = importer.ApplyPostProcessing(aiProcess_Triangulate);
  }
  if (scene != nullptr && scene->mRootNode != nullptr) return gathered(*scene, file, settings);
  const std::string reason = importer.GetErrorString();
  if (reason.find("bad_alloc") != std::string::npos) return no_memory(file);
  return fail("mesh.unreadable",
              "The file is no mesh that can be read" + (reason.empty() ? "." : ": " + reason), file);
}

/// Assimp promises to throw nothing, and yet its readers' allocations and ours may. What is no std::exception
/// is a fault that nobody foresaw: it ends the reader's process, which the caller tells as "mesh.crashed".
Result<geometry::TriangleMesh> import_safely(Assimp::Importer& importer, const std::string& file,
                                             const MeshSettings& settings) {
  try {
    return import(importer, file, settings);
  } catch (const std::bad_alloc&) {
    return no_memory(file);
  } catch (const std::exception& e) {
    return fail("mesh.unreadable", std::string("Reading the mesh failed: ") + e.what(), file);
  }
}

Status check_settings(const MeshSettings& settings, const std::string& file) {
  if (settings.unit_in_m >= 0 && settings.unit_in_m <= 1000) return {};
  return fail("mesh.setting", "unit_in_m must lie between 0 and 1000.", file);
}

}  // namespace

Result<geometry::TriangleMesh> load_mesh(const std::filesystem::path& path, const MeshSettings& settings) {
  const std::string file = path.string();
  TRY(check_settings(settings, file));
  TRY(check_file(path));
  TRY(sniff_mesh(path, settings.any_format));
  Assimp::Importer importer;
  return import_safely(importer, file, settings);
}

Result<geometry::TriangleMesh> load_mesh_bytes(const std::string& name, std::string_view bytes,
                                               const MeshSettings& settings) {
  TRY(check_settings(settings, name));
  TRY(check_size(bytes.size(), name));
  TRY(sniff_mesh_bytes(name, bytes, settings.any_format));
  Assimp::Importer importer;
  importer.SetIOHandler(new BytesOnly(name, bytes));  // the importer's to delete
  return import_safely(importer, name, settings);
}

}  // namespace toile::mesh_import
