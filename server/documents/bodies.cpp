#include "server/documents/bodies.h"

#include "core/base/text.h"

namespace toile::documents {
namespace {

std::size_t bytes_of(const mesh_import::RepairedMesh& kept) {
  const geometry::TriangleMesh& mesh = kept.mesh;
  return mesh.vertices.size() * sizeof(Vec3) + mesh.triangles.size() * sizeof(Tri);
}

std::string key_of(const std::string& asset_id, const mesh_import::MeshSettings& settings) {
  return asset_id + (settings.z_up ? " z " : " y ") + number_text(settings.unit_in_m);
}

}  // namespace

Result<std::shared_ptr<const mesh_import::RepairedMesh>> BodyCache::mesh(
    store::Store& store, const store::RequestContext& context, const std::string& asset_id,
    const mesh_import::MeshSettings& settings) {
  const store::AssetRow asset = TRY(store.asset(context, asset_id));  // first of all: is it theirs?
  if (asset.kind != "body") {
    return Error{"documents.wrong_kind", "this file is a " + asset.kind + ", and a body is wanted",
                 asset.name};
  }
  const std::string key = key_of(asset_id, settings);
  if (std::shared_ptr<const mesh_import::RepairedMesh> kept = kept_.find(key)) return kept;
  const std::string path = TRY(store.asset_path(context, asset_id));
  mesh_import::RepairedMesh read = TRY(importer_.stored(path, asset.name, settings, context.given_up.get()));
  auto made = std::make_shared<const mesh_import::RepairedMesh>(std::move(read));
  kept_.keep(key, made, bytes_of(*made));
  return std::shared_ptr<const mesh_import::RepairedMesh>(std::move(made));
}

}  // namespace toile::documents
