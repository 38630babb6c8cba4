#include "server/movie/ffmpeg.h"

#include <signal.h>

#include <system_error>

namespace toile::movie {

Result<std::string> ffmpeg_program() {
  std::string program = find_program("ffmpeg");
  if (!program.empty()) return program;
  return Error{"movie.no_ffmpeg",
               "this is drawn by ffmpeg, which is not installed: install Debian's package ffmpeg", "",
               ErrorKind::kUnavailable};
}

Error ffmpeg_not_run(int reason) {
  return {"movie.failed", "ffmpeg cannot be run: " + std::generic_category().message(reason), "",
          ErrorKind::kSystem};
}

Status ffmpeg_status(const ChildOutcome& outcome) {
  using End = ChildOutcome::End;
  if (outcome.end == End::kExited && outcome.code == 0) return {};
  if (outcome.end == End::kKilledBySignal && outcome.code == SIGXFSZ) {
    return Error{"movie.too_large",
                 "the file has more bytes than are allowed; ask for a smaller or shorter one", "",
                 ErrorKind::kTooLarge};
  }
  if (outcome.end == End::kTookTooLong)
    return Error{"movie.too_long", "ffmpeg took longer than is allowed", "", ErrorKind::kSystem};
  if (outcome.end == End::kNotStarted) return ffmpeg_not_run(outcome.code);
  return Error{"movie.failed", "ffmpeg ended without a file (code " + std::to_string(outcome.code) + ")", "",
               ErrorKind::kSystem};
}

}  // namespace toile::movie
