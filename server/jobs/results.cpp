#include "server/jobs/results.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <system_error>
#include <utility>
#include <vector>

#include "core/base/hash.h"
#include "core/base/read_file.h"
#include "core/exports/map_file.h"
#include "core/exports/write_glb.h"
#include "core/exports/write_obj.h"
#include "core/manifest/touch_log.h"
#include "server/documents/stream_pieces.h"
#include "server/movie/film_codec.h"
#include "server/render/png.h"
#include "server/render/still.h"

namespace toile::jobs {
namespace {

namespace fs = std::filesystem;

constexpr int kThumbnailWidth = 320,
              kThumbnailHeight = 400;  // pixels; the page's list shows them at half of it

std::vector<std::string> panel_names(const pattern::Pattern& pattern) {
  std::vector<std::string> names;
  for (const pattern::Panel& panel : pattern.panels) names.push_back(panel.id);
  return names;
}

render::Scene scene_of(const drape::DrapeInput& input, const drape::DrapeResult& result,
                       const image::Textures& textures) {
  render::Scene scene;
  scene.cloth.positions = result.positions;
  scene.cloth.triangles = result.garment.triangles;
  scene.cloth.panel_of_triangle = result.garment.panel_of_triangle;
  scene.cloth.weld = result.garment.weld;
  scene.cloth.rest = result.garment.rest;
  scene.cloth.textures = &textures;
  for (const Index fabric : input.fabric_of_panel) {
    const material::Fabric& cloth = input.fabrics[static_cast<std::size_t>(fabric)];
    scene.cloth.colour_of_panel.push_back({cloth.colour[0], cloth.colour[1], cloth.colour[2]});
  }
  scene.cloth.look_of_panel = movie::looks_of(input);
  for (const body::Body& body : result.bodies) scene.bodies.push_back({.mesh = &body.mesh});
  return scene;
}

Result<std::string> bytes_of(const fs::path& path) {
  if (auto bytes = read_file(path)) return std::move(*bytes);
  return Error{"export.read", "cannot read the file back", path.string(), ErrorKind::kInternal};
}

Status write_bytes(const fs::path& path, std::string_view bytes) {
  std::ofstream out(path, std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (out) return {};
  return Error{"export.write", "cannot write the file", path.string(), ErrorKind::kInternal};
}

/// Where there were none, one of a drape before goes.
Status write_touches(const std::vector<drape::Touch>& touches, const fs::path& folder) {
  const fs::path path = folder / manifest::kTouchLogFile;
  if (!touches.empty()) return write_bytes(path, manifest::write_touch_log(touches));
  std::error_code failure;
  fs::remove(path, failure);
  if (!failure) return {};
  return Error{"export.write", "cannot remove the log of another drape", path.string(), ErrorKind::kInternal};
}

}  // namespace

Status write_models(const drape::DrapeInput& input, const drape::DrapeResult& result,
                    const image::Textures& textures, const fs::path& folder, bool check_data) {
  const sewing::GarmentMesh& garment = result.garment;
  const std::vector<std::string> names = panel_names(input.pattern);
  const exports::ObjPanels panels{names, garment.panel_of_triangle, garment.rest};
  TRY(check_data ? exports::write_check_data(folder, garment, result.positions, result.bodies, panels)
                 : exports::write_obj(folder / "final.obj", result.positions, garment.triangles, panels));
  TRY(write_bytes(folder / "final.hung", warm::encode_hung(result.hung)));
  TRY(write_touches(result.touches, folder));
  const std::vector<analysis::ClothMap> maps = analysis::cloth_maps(input, result);
  TRY(write_bytes(folder / exports::kMapFile, exports::write_maps(garment, names, maps)));
  exports::GlbModel model;
  model.garment = &garment;
  model.positions = result.positions;
  model.panel_names = names;
  model.fabrics = input.fabrics;
  model.fabric_of_panel = input.fabric_of_panel;
  model.bodies = result.bodies;
  model.textures = &textures;
  model.maps = maps;
  return exports::write_glb(folder / "final.glb", model);
}

Status write_film(const drape::DrapeInput& input, const drape::DrapeResult& result,
                  const image::Textures& textures, const movie::Motion& motion, const fs::path& folder) {
  const movie::Film film =
      movie::film_of(input, result, documents::stream_pieces(input, result.garment), textures, motion);
  return write_bytes(folder / movie::kFilmFile, movie::encode_film(film));
}

Status write_manifest(manifest::Manifest manifest, const drape::DrapeResult& result, const fs::path& folder,
                      bool check_data) {
  std::vector<std::string> names{movie::kFilmFile, "final.glb", "final.hung", "final.obj", exports::kMapFile};
  if (check_data) names.insert(names.end(), {"body.obj", "rest.obj", "sewn.json"});
  if (!result.touches.empty()) names.push_back(manifest::kTouchLogFile);
  std::sort(names.begin(), names.end());
  for (const std::string& name : names) {
    const std::string bytes = TRY(bytes_of(folder / name));
    manifest.results.push_back(manifest::mark_of(name, std::string_view(bytes)));
  }
  manifest.positions = hash_of(result.positions);
  manifest.steps = result.steps;
  return write_bytes(folder / manifest::kManifestFile, manifest::write_manifest(manifest));
}

Status write_stills(render::Stills& stills, const drape::DrapeInput& input, const drape::DrapeResult& result,
                    const image::Textures& textures, const fs::path& folder, int width, int height,
                    const RunContext& context) {
  const render::Scene scene = scene_of(input, result, textures);
  const render::StillSettings settings{.width = width, .height = height};
  const std::unique_ptr<render::StagedScene> staged = TRY(stills.stage(scene));
  for (const auto& [view, name] :
       {std::pair{render::View::kFront, "front"}, std::pair{render::View::kBack, "back"},
        std::pair{render::View::kSide, "side"}, std::pair{render::View::kThreeQuarter, "three-quarter"}}) {
    if (context.cancelled())
      return Error{"cancelled", "the pictures are not wanted any more", "", ErrorKind::kCancelled};
    const render::Image image = TRY(staged->picture(view, settings));
    TRY(render::write_png(folder / (std::string(name) + ".png"), image));
  }
  return {};
}

Status write_thumbnail(render::Stills& stills, const drape::DrapeInput& input,
                       const drape::DrapeResult& result, const image::Textures& textures,
                       const fs::path& folder) {
  const render::Image image =
      TRY(stills.render(scene_of(input, result, textures), render::View::kThreeQuarter,
                        {.width = kThumbnailWidth, .height = kThumbnailHeight}));
  return render::write_png(folder / "thumbnail.png", image);
}

Result<std::unique_ptr<TemporaryFolder>> TemporaryFolder::make(const fs::path& parent) {
  std::string path = parent / "results-XXXXXX";
  if (::mkdtemp(path.data()) == nullptr) {
    return Error{"export.write", "cannot make a temporary folder: " + std::generic_category().message(errno),
                 path, ErrorKind::kInternal};
  }
  return std::unique_ptr<TemporaryFolder>(new TemporaryFolder(path));
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;  // what cannot be removed stays until the store's next start
  fs::remove_all(path_, ignored);
}

Result<store::ResultFiles> keep_results(store::Store& store, const store::RequestContext& context,
                                        const std::string& job_id, const fs::path& folder) {
  std::map<std::string, fs::path> files;
  std::error_code failure;
  for (fs::directory_iterator at(folder, failure), end; !failure && at != end; at.increment(failure)) {
    files.emplace(at->path().filename().string(), at->path());
  }
  if (failure)
    return Error{"export.read", "cannot list the results: " + failure.message(), folder.string(),
                 ErrorKind::kInternal};
  store::ResultFiles kept;
  for (const auto& [name, path] : files) {
    const std::string bytes = TRY(bytes_of(path));
    TRY(store.put_result(context, job_id, name, bytes));
    kept[name] = {static_cast<std::int64_t>(bytes.size()), hash_of(std::string_view(bytes))};
  }
  return kept;
}

}  // namespace toile::jobs
