#pragma once
// A project from disk, draped in one go: for the verbs that drape.

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/drape/drape_result.h"
#include "core/drape/frame_sink.h"
#include "core/drape/touch.h"
#include "core/image/texture.h"
#include "core/manifest/manifest.h"
#include "core/project/resolve/resolve.h"

namespace toile::app {

/// The final.hung that `from` names: itself, or the one in that folder.
std::filesystem::path shape_path(const std::string& from);

/// A project that can be draped, and the marks of what it is made of.
struct ReadyProject {
  resolve::ResolvedProject read;
  manifest::Manifest manifest;  ///< its inputs; the results are to come
};

/// Reads the document at `path` with its files; `from` is final.hung of another drape, the folder where it
/// lies, or empty. What nothing holds on is left out of the input. Errors: json.*, project.*, usage.from,
/// hung.* and those of the files.
Result<ReadyProject> read_to_drape(const std::string& path, const std::string& from);

/// The touches that a drape.log has. Errors: usage.replay (it cannot be read), log.damaged.
Result<std::vector<drape::Touch>> read_touches(const std::filesystem::path& path);

/// Drapes with a bar of progress, until the end or Ctrl-C, with `touches` at their steps, on so many threads
/// (0: one for each processor). What cannot be put
/// on is left out of `input`, too. No positions where it was cancelled before there was any cloth. Errors:
/// those of drape::drape and of DrapeRun::replay.
Result<drape::DrapeResult> drape_once(drape::DrapeInput& input, drape::FrameSink& sink,
                                      std::vector<drape::Touch> touches, int threads = 0);

}  // namespace toile::app
