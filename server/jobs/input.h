#pragma once

#include <map>
#include <string>

#include "core/base/result.h"
#include "core/drape/drape_input.h"
#include "core/image/texture.h"
#include "core/manifest/manifest.h"
#include "server/documents/documents.h"
#include "server/jobs/limits.h"

namespace toile::jobs {

/// A document and the owner's assets that it names (file name → asset id) as what a drape needs, without the
/// pieces that nothing holds on (core/drape/worn_part.h). Errors:
/// json.*, project.*, dxf.*, pattern.*, body.*, store.*; `where` is the place in the document.
Result<drape::DrapeInput> drape_input_of(documents::Documents& documents,
                                         const store::RequestContext& context, const std::string& document,
                                         const std::map<std::string, std::string>& files);

/// The file among a job's that it goes on from (core/warm): the shape in which another job's garment hung.
inline constexpr const char* kShapeFile = "final.hung";

/// The pictures of the same document, for whoever draws it. REQUIRES a pattern of its pieces. Errors:
/// json.*, project.*, image.*, documents.*, store.*.
Result<image::Textures> textures_of(documents::Documents& documents, const store::RequestContext& context,
                                    const std::string& document,
                                    const std::map<std::string, std::string>& files,
                                    const pattern::Pattern& pattern);

/// A drape of the project as it is now, once it is known that one can be made. Errors: store.not_found,
/// documents.missing_file, limits.particles, and those of reading the document without its bodies. `from`
/// is the id of a job from whose end to go on, or empty; its shape is kept as a file of the owner's. Errors:
/// jobs.no_shape, jobs.from.
Result<store::JobRow> row_of_drape(documents::Documents& documents, const store::RequestContext& context,
                                   const std::string& project_id, const JobLimits& limits = {},
                                   const std::string& from = "");

/// The same of a project that need not be kept: in other fabrics, on another body.
Result<store::JobRow> row_of_project(documents::Documents& documents, const store::RequestContext& context,
                                     const store::ProjectRow& project, const JobLimits& limits);
/// The same, from how a garment hangs (warm::encode_hung) that still drapes; empty: from the pieces.
Result<store::JobRow> row_of_drape_on(documents::Documents& documents, const store::RequestContext& context,
                                      const std::string& project_id, const JobLimits& limits,
                                      const std::string& shape);

/// The manifest's account of the job's document and files. Errors: project.*, store.*.
Result<manifest::Manifest> inputs_of(documents::Documents& documents, const store::RequestContext& context,
                                     const store::JobRow& job);

/// A hash of all that the results of the job follow from: the engine, its document, the bytes of its files
/// and the size of its pictures (pixels). Empty where `engine` is.
std::string input_of(const store::JobRow& job, const std::string& engine, int width, int height);

/// Whether such a hash is of that engine's results.
bool is_of_engine(const std::string& input, const std::string& engine);

}  // namespace toile::jobs
