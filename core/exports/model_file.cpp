#include "core/exports/model_file.h"

#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/mesh.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Exporter.hpp>
#include <cmath>
#include <memory>
#include <utility>

#include "core/image/picture.h"

namespace toile::exports {
namespace {

constexpr ModelFormat kFormats[] = {
    // The binary one of assimp 5.2 writes colours as floats under a header that says bytes.
    {"ply", "PLY (text, coloured)", "ply", true, 1},
    {"stl", "STL (binary, millimetres)", "stlb", false, 1000},
    {"obj", "OBJ with materials", "obj", false, 1},
    {"dae", "COLLADA", "collada", false, 1},
};

Status check(const ModelPart& part) {
  const auto is_finite = [](const Vec3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  };
  if (!std::all_of(part.positions.begin(), part.positions.end(), is_finite))
    return Error{"export.not_finite", "a vertex has no place", part.name, ErrorKind::kInternal};
  const auto count = static_cast<Index>(part.positions.size());
  for (const Tri& triangle : part.triangles)
    for (const Index v : triangle)
      if (v < 0 || v >= count)
        return Error{"export.bad_index", "a triangle names a vertex that is not there", part.name,
                     ErrorKind::kInternal};
  return {};
}

float srgb(double linear) {
  return static_cast<float>(image::srgb_from_linear(std::clamp(linear, 0.0, 1.0)));
}

/// A name in a format whose words end at blanks.
std::string in_one_word(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return c <= ' '; }, '_');
  return name;
}

aiVector3D vector_of(Vec3 p) {
  return {static_cast<ai_real>(p.x), static_cast<ai_real>(p.y), static_cast<ai_real>(p.z)};
}

aiVector3D* copied(const std::vector<Vec3>& points, double scale) {
  auto* out = new aiVector3D[points.size()];
  for (std::size_t i = 0; i < points.size(); ++i) out[i] = vector_of(scale * points[i]);
  return out;
}

/// What the scene's destructor deletes.
std::unique_ptr<aiMesh> mesh_of(const ModelPart& part, const ModelFormat& format, double scale) {
  auto mesh = std::make_unique<aiMesh>();
  mesh->mName = aiString(in_one_word(part.name));
  mesh->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
  mesh->mNumVertices = static_cast<unsigned>(part.positions.size());
  mesh->mVertices = copied(part.positions, scale);
  mesh->mNormals = copied(part.normals, 1);
  if (!part.coordinates.empty()) {
    mesh->mNumUVComponents[0] = 2;
    mesh->mTextureCoords[0] = new aiVector3D[part.coordinates.size()];
    for (std::size_t i = 0; i < part.coordinates.size(); ++i)
      mesh->mTextureCoords[0][i] = vector_of({part.coordinates[i].x, part.coordinates[i].y, 0});
  }
  if (format.colours) {
    const aiColor4D colour(srgb(part.colour[0]), srgb(part.colour[1]), srgb(part.colour[2]), 1);
    mesh->mColors[0] = new aiColor4D[part.positions.size()];
    std::fill_n(mesh->mColors[0], part.positions.size(), colour);
  }
  mesh->mNumFaces = static_cast<unsigned>(part.triangles.size());
  mesh->mFaces = new aiFace[part.triangles.size()];
  for (std::size_t t = 0; t < part.triangles.size(); ++t) {
    aiFace& face = mesh->mFaces[t];
    face.mNumIndices = 3;
    face.mIndices = new unsigned[3];
    for (std::size_t c = 0; c < 3; ++c) face.mIndices[c] = static_cast<unsigned>(part.triangles[t][c]);
  }
  return mesh;
}

std::unique_ptr<aiMaterial> material_of(const ModelPart& part) {
  auto material = std::make_unique<aiMaterial>();
  const aiString name(in_one_word(part.name));
  const aiColor3D colour(srgb(part.colour[0]), srgb(part.colour[1]), srgb(part.colour[2]));
  const int both = 1;
  material->AddProperty(&name, AI_MATKEY_NAME);
  material->AddProperty(&colour, 1, AI_MATKEY_COLOR_DIFFUSE);
  material->AddProperty(&both, 1, AI_MATKEY_TWOSIDED);
  return material;
}

/// One node with its mesh and material for each part.
std::unique_ptr<aiScene> scene_of(const std::vector<const ModelPart*>& parts, const ModelFormat& format,
                                  double scale) {
  const auto count = static_cast<unsigned>(parts.size());
  auto scene = std::make_unique<aiScene>();
  scene->mRootNode = new aiNode("toile");
  scene->mRootNode->mChildren = new aiNode*[count];
  scene->mMeshes = new aiMesh*[count];
  scene->mMaterials = new aiMaterial*[count];
  for (unsigned i = 0; i < count; ++i) {
    auto* node = new aiNode(in_one_word(parts[i]->name));
    node->mParent = scene->mRootNode;
    node->mNumMeshes = 1;
    node->mMeshes = new unsigned[1]{i};
    scene->mRootNode->mChildren[i] = node;
    scene->mRootNode->mNumChildren = i + 1;
    scene->mMeshes[i] = mesh_of(*parts[i], format, scale).release();
    scene->mMeshes[i]->mMaterialIndex = i;
    scene->mNumMeshes = i + 1;
    scene->mMaterials[i] = material_of(*parts[i]).release();
    scene->mNumMaterials = i + 1;
  }
  return scene;
}

}  // namespace

std::span<const ModelFormat> model_formats() { return kFormats; }

const ModelFormat* model_format_named(std::string_view ending) {
  const auto* found = std::find_if(std::begin(kFormats), std::end(kFormats),
                                   [&](const ModelFormat& format) { return ending == format.ending; });
  return found == std::end(kFormats) ? nullptr : found;
}

Result<std::vector<ModelFile>> model_files(std::span<const ModelPart> parts, const ModelFormat& format,
                                           const std::string& stem, double units_per_metre) {
  std::vector<const ModelPart*> shown;
  for (const ModelPart& part : parts) {
    TRY(check(part));
    if (!part.triangles.empty()) shown.push_back(&part);
  }
  if (shown.empty()) return Error{"export.empty", "there is no surface to write", stem};
  const std::unique_ptr<aiScene> scene = scene_of(shown, format, units_per_metre);
  Assimp::ExportProperties properties;
  properties.SetPropertyString(AI_CONFIG_EXPORT_BLOB_NAME, stem);
  Assimp::Exporter exporter;
  const aiExportDataBlob* blob = exporter.ExportToBlob(scene.get(), format.id, 0, &properties);
  if (!blob) return Error{"export.model", exporter.GetErrorString(), stem, ErrorKind::kInternal};
  std::vector<ModelFile> files;
  for (; blob; blob = blob->next) {
    const std::string name = files.empty() ? stem + "." + format.ending : blob->name.C_Str();
    files.push_back({name, std::string(static_cast<const char*>(blob->data), blob->size)});
  }
  return files;
}

}  // namespace toile::exports
