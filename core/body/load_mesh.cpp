#include "core/body/load_mesh.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <exception>
#include <numeric>
#include <string>
#include <utility>

#include "core/body/sniff_mesh.h"

namespace toile {
namespace {

constexpr std::uintmax_t kMostBytes = std::uintmax_t{256} << 20;
constexpr std::size_t kMostTriangles = 2'000'000;
constexpr int kDeepest = 256;          // levels of the scene's tree
constexpr double kLeastArea2 = 1e-14;  // m², twice the area under which a triangle is a line

Error fail(const char* code, std::string message, const std::filesystem::path& path, std::string place = {}) {
  return {code, std::move(message), path.string() + (place.empty() ? "" : ": " + place)};
}

Status check_file(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    return fail("mesh.not_found", "There is no such file.", path);
  }
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) return fail("mesh.not_found", "The file cannot be opened: " + error.message() + ".", path);
  if (size == 0) return fail("mesh.empty", "The file is empty.", path);
  if (size > kMostBytes) {
    return fail("mesh.too_large", "The file is larger than 256 MiB; export the mesh with fewer triangles.",
                path);
  }
  return {};
}

Vec3 apply(const aiMatrix4x4& m, const aiVector3D& p) {
  const double x = p.x, y = p.y, z = p.z;
  return {m.a1 * x + m.a2 * y + m.a3 * z + m.a4, m.b1 * x + m.b2 * y + m.b3 * z + m.b4,
          m.c1 * x + m.c2 * y + m.c3 * z + m.c4};
}

// Gathers a scene's triangles, node by node.
class Gatherer {
 public:
  Gatherer(const aiScene& scene, const std::filesystem::path& path) : scene_(scene), path_(path) {}

  Status add(const aiNode& node, const aiMatrix4x4& above, int depth) {
    if (depth > kDeepest) return fail("mesh.unreadable", "The scene's tree is too deep.", path_);
    const aiMatrix4x4 place = above * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      if (node.mMeshes[i] >= scene_.mNumMeshes) {
        return fail("mesh.unreadable", "A node names a mesh that is not there.", path_);
      }
      if (Status s = add_mesh(*scene_.mMeshes[node.mMeshes[i]], place); !s) return s;
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) {
      if (Status s = add(*node.mChildren[i], place, depth + 1); !s) return s;
    }
    return {};
  }

  TriangleMesh take() { return std::move(mesh_); }

 private:
  Status add_mesh(const aiMesh& mesh, const aiMatrix4x4& place) {
    if (mesh_.triangles.size() + mesh.mNumFaces > kMostTriangles ||
        mesh_.vertices.size() + mesh.mNumVertices > 3 * kMostTriangles) {
      return fail("mesh.too_large", "The mesh has more than two million triangles.", path_);
    }
    const auto base = static_cast<Index>(mesh_.vertices.size());
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      mesh_.vertices.push_back(apply(place, mesh.mVertices[v]));
      if (!is_finite(mesh_.vertices.back())) {
        return fail("mesh.not_finite", "A coordinate is not a finite number.", path_,
                    "vertex " + std::to_string(base + v + 1) + " in reading order");
      }
    }
    const bool mirrored = place.Determinant() < 0;
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices != 3) continue;  // points and lines; polygons are triangles by now
      Tri t;
      for (int c = 0; c < 3; ++c) {
        if (face.mIndices[c] >= mesh.mNumVertices) {
          return fail("mesh.unreadable", "A face names a vertex that is not there.", path_);
        }
        t[c] = base + static_cast<Index>(face.mIndices[c]);
      }
      if (mirrored) std::swap(t[1], t[2]);
      mesh_.triangles.push_back(t);
    }
    return {};
  }

  const aiScene& scene_;
  const std::filesystem::path& path_;
  TriangleMesh mesh_;
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
TriangleMesh merged(const TriangleMesh& mesh) {
  const std::vector<Index> first = first_at_position(mesh.vertices);
  TriangleMesh out;
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

double guessed_unit(const TriangleMesh& mesh) {
  Vec3 low = mesh.vertices.front(), high = low;
  for (const Vec3& p : mesh.vertices) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const double e = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  return e < 5 ? 1 : e < 50 ? 0.1 : e < 500 ? 0.01 : 0.001;
}

void to_metres(TriangleMesh& mesh, const MeshSettings& settings) {
  const double unit = settings.unit_in_m > 0 ? settings.unit_in_m : guessed_unit(mesh);
  for (Vec3& p : mesh.vertices) {
    if (settings.z_up) p = {p.x, p.z, -p.y};
    p = p * unit;
  }
}

// Lets the reader see one file and no other.
class OneFile final : public Assimp::DefaultIOSystem {
 public:
  explicit OneFile(std::string path) : path_(std::move(path)) {}
  bool Exists(const char* file) const override { return path_ == file && DefaultIOSystem::Exists(file); }
  Assimp::IOStream* Open(const char* file, const char* mode) override {
    return path_ == file ? DefaultIOSystem::Open(file, mode) : nullptr;
  }

 private:
  std::string path_;
};

Result<TriangleMesh> import(const std::filesystem::path& path, bool alone) {
  Assimp::Importer importer;
  if (alone) importer.SetIOHandler(new OneFile(path.string()));  // the importer's to delete
  // No other processing: positions stay as the file says, and what is not geometry is not looked at.
  const aiScene* scene = importer.ReadFile(path.string(), aiProcess_Triangulate);
  if (scene == nullptr || scene->mRootNode == nullptr) {
    const std::string reason = importer.GetErrorString();
    return fail("mesh.unreadable",
                "The file is no mesh that can be read" + (reason.empty() ? "." : ": " + reason), path);
  }
  Gatherer gatherer(*scene, path);
  if (Status s = gatherer.add(*scene->mRootNode, aiMatrix4x4(), 0); !s) return s.error();
  return gatherer.take();
}

}  // namespace

Result<TriangleMesh> load_mesh(const std::filesystem::path& path, const MeshSettings& settings) {
  if (!(settings.unit_in_m >= 0 && settings.unit_in_m <= 1000)) {
    return fail("mesh.setting", "unit_in_m must lie between 0 and 1000.", path);
  }
  if (Status s = check_file(path); !s) return s.error();
  if (Status s = sniff_mesh(path); !s) return s.error();
  try {
    Result<TriangleMesh> scene = import(path, settings.alone);
    if (!scene) return scene.error();
    if (scene->triangles.empty()) return fail("mesh.no_triangles", "The file holds no triangles.", path);
    to_metres(*scene, settings);
    TriangleMesh mesh = merged(*scene);
    if (mesh.triangles.empty()) return fail("mesh.no_triangles", "All triangles are without area.", path);
    return mesh;
  } catch (const std::exception& e) {
    return fail("mesh.unreadable", std::string("Reading the mesh failed: ") + e.what(), path);
  } catch (...) {
    return fail("mesh.unreadable", "Reading the mesh failed.", path);
  }
}

}  // namespace toile
