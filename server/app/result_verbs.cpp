#include "server/app/result_verbs.h"

#include <CLI/CLI.hpp>

#include <string>

#include "server/app/exit_codes_text.h"

namespace toile::app {
namespace {

CLI::App* add_movie(CLI::App& app, MovieOptions& movie) {
  CLI::App* verb =
      app.add_subcommand("movie", "Make a movie of a drape: how it came about, or its end turned");
  verb->add_option("result", movie.source, "Folder that toile drape has left, its drape.film, or a trace")
      ->required();
  verb->add_option("-o,--out", movie.out, "File to write; .mp4 (H.264) or .avi (Motion JPEG)")->required();
  verb->add_option("--of", movie.kind, "drape: from the pieces to the end; turntable: the end, turned once")
      ->check(CLI::IsMember({"drape", "turntable"}))
      ->capture_default_str();
  verb->add_option("--format", movie.format, "mp4 or avi (default: as the file's name ends)")
      ->check(CLI::IsMember({"mp4", "avi"}));
  verb->add_option("--size", movie.size, "Pixels, even, 64 to 4096 each (default: 720x900)")
      ->type_name("WxH");
  verb->add_option("--fps", movie.fps, "Pictures a second, 1 to 60")->capture_default_str();
  verb->add_option("--seconds", movie.seconds,
                   "How long it lasts (default: a drape as long as it did, but 20 s at most; a turn 8 s)");
  verb->add_option("--trace", movie.trace, "Show the frames of this trace: drape --trace keeps every one");
  CLI::Option* stills =
      verb->add_option("--stills", movie.stills, "Also write its pictures as PNG into this folder");
  verb->add_option("--stills-every", movie.stills_every, "Of each so many pictures write one")->needs(stills);
  verb->add_flag("--json", movie.json, "Print as JSON, errors as well");
  verb->footer(
      std::string("Needs ffmpeg (Debian's package ffmpeg). Ctrl-C ends it and leaves no file.\n\n"
                  "Examples:\n"
                  "  toile movie out/skirt --out skirt.mp4\n"
                  "  toile movie out/skirt --of turntable --size 1080x1350 --out turn.mp4\n"
                  "  toile movie out/skirt --out skirt.avi --stills out/frames --stills-every 5\n\n") +
      kExitCodes);
  return verb;
}

}  // namespace

ResultVerbs::ResultVerbs(CLI::App& app) : movie_(add_movie(app, movie_options_)) {}

std::optional<ExitCode> ResultVerbs::run() const {
  if (movie_->parsed()) return movie_command(movie_options_);
  return std::nullopt;
}

}  // namespace toile::app
