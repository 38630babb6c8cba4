#include "server/documents/bodies.h"

#include "core/base/text.h"

namespace toile {
namespace {

std::size_t bytes_of(const RepairedMesh& kept) {
  const TriangleMesh& mesh = kept.mesh;
  return mesh.vertices.size() * sizeof(Vec3) + mesh.triangles.size() * sizeof(Tri);
}

std::string key_of(const std::string& asset_id, const MeshSettings& settings) {
  return asset_id + (settings.z_up ? " z " : " y ") + number_text(settings.unit_in_m);
}

}  // namespace

Result<std::shared_ptr<const RepairedMesh>> BodyCache::mesh(Store& store, const RequestContext& context,
                                                            const std::string& asset_id,
                                                            const MeshSettings& settings) {
  const Result<AssetRow> asset = store.asset(context, asset_id);  // first of all: is it theirs?
  if (!asset) return asset.error();
  if (asset->kind != "body") {
    return Error{"documents.wrong_kind", "this file is a " + asset->kind + ", and a body is wanted",
                 asset->name};
  }
  const std::string key = key_of(asset_id, settings);
  if (std::shared_ptr<const RepairedMesh> kept = kept_.find(key)) return kept;
  const std::string path = TRY(store.asset_path(context, asset_id));
  RepairedMesh read = TRY(importer_.stored(path, asset->name, settings));
  auto made = std::make_shared<const RepairedMesh>(std::move(read));
  kept_.keep(key, made, bytes_of(*made));
  return std::shared_ptr<const RepairedMesh>(std::move(made));
}

}  // namespace toile
