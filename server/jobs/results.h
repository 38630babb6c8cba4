#pragma once
// The files that a drape leaves: on disk for the command line, in the store for a job.

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/base/run_context.h"
#include "core/drape/drape_input.h"
#include "core/drape/drape_result.h"
#include "core/image/texture.h"
#include "core/manifest/manifest.h"
#include "server/movie/film.h"
#include "server/store/store.h"

namespace toile::render {
class Stills;
}

namespace toile::jobs {

/// Writes final.obj, final.glb, final.hung and maps.json into `folder`, and drape.log where hands were on the
/// cloth; with `check_data` rest.obj, body.obj and sewn.json lie beside them, for programs that judge the
/// drape. Errors: export.*.
Status write_models(const drape::DrapeInput& input, const drape::DrapeResult& result,
                    const image::Textures& textures, const std::filesystem::path& folder, bool check_data);

/// Writes drape.film into `folder`: what movies and other looks at the drape are made of. Errors:
/// export.write.
Status write_film(const drape::DrapeInput& input, const drape::DrapeResult& result,
                  const image::Textures& textures, const movie::Motion& motion,
                  const std::filesystem::path& folder);

/// Writes manifest.json into `folder`, with what write_models and write_film have left there. REQUIRES a
/// manifest of the inputs. Errors: export.read, export.write.
Status write_manifest(manifest::Manifest manifest, const drape::DrapeResult& result,
                      const std::filesystem::path& folder, bool check_data);

/// Writes front.png, back.png, side.png and three-quarter.png into `folder`, drawn on the calling thread,
/// to which `stills` belongs. Errors: render.*, export.write; "cancelled" when the context was, between two
/// pictures.
Status write_stills(render::Stills& stills, const drape::DrapeInput& input, const drape::DrapeResult& result,
                    const image::Textures& textures, const std::filesystem::path& folder, int width,
                    int height, const RunContext& context = {});

/// Writes thumbnail.png, 320 by 400 pixels, drawn on the calling thread. Errors: render.*, export.write.
Status write_thumbnail(render::Stills& stills, const drape::DrapeInput& input,
                       const drape::DrapeResult& result, const image::Textures& textures,
                       const std::filesystem::path& folder);

/// A folder of its own for as long as it is held.
class TemporaryFolder {
 public:
  /// Makes it in `parent`. Error: export.write with the system's reason.
  static Result<std::unique_ptr<TemporaryFolder>> make(const std::filesystem::path& parent);
  /// Removes the folder with all that is in it.
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  explicit TemporaryFolder(std::filesystem::path path) : path_(std::move(path)) {}
  std::filesystem::path path_;
};

/// Puts every file of `folder` into the store as a result of the job, in the order of their names. Gives
/// them back as JobRow::results has them. Errors: export.read, those of the store.
Result<store::ResultFiles> keep_results(store::Store& store, const store::RequestContext& context,
                                        const std::string& job_id, const std::filesystem::path& folder);

}  // namespace toile::jobs
