#pragma once
// Where ffmpeg is, and what it means when it ends badly.

#include <string>

#include "core/base/result.h"
#include "core/base/run_child.h"

namespace toile::movie {

/// Path of the program. Error: movie.no_ffmpeg.
Result<std::string> ffmpeg_program();

/// Ok for an end with code 0. Errors: movie.too_large, movie.too_long, movie.failed.
Status ffmpeg_status(const ChildOutcome& outcome);

/// movie.failed, of an errno.
Error ffmpeg_not_run(int reason);

}  // namespace toile::movie
