#include <cstdio>
#include <filesystem>
#include <string>
#include <system_error>

#include "core/base/text.h"
#include "core/json/tree.h"
#include "server/app/commands.h"
#include "server/app/console.h"
#include "server/app/interrupt.h"
#include "server/app/progress_bar.h"
#include "server/app/read_film.h"
#include "server/movie/make_movie.h"

namespace toile::app {
namespace {

namespace fs = std::filesystem;

Status read_size(const std::string& text, movie::MovieSettings& settings) {
  if (text.empty()) return {};
  int used = 0;
  const bool whole = std::sscanf(text.c_str(), "%5dx%5d%n", &settings.width, &settings.height, &used) == 2 &&
                     used == static_cast<int>(text.size());
  if (whole) return {};
  return Error{"movie.settings", "a size is WIDTHxHEIGHT in pixels, e.g. 720x900", "--size"};
}

/// As it is told, else as the file's name ends.
Result<movie::VideoFormat> video_format_of(const MovieOptions& options) {
  if (!options.format.empty()) return movie::video_format_from(options.format);
  const std::string ending = lower_case(fs::path(options.out).extension().string());
  if (!ending.empty()) {
    Result<movie::VideoFormat> format = movie::video_format_from(ending.substr(1));
    if (format) return format;
  }
  return Error{"movie.format",
               "a movie's file ends in .mp4 (H.264) or .avi (Motion JPEG); --format tells what another is",
               options.out};
}

Result<movie::MovieSettings> settings_of(const MovieOptions& options) {
  movie::MovieSettings settings;
  settings.kind = TRY(movie::movie_kind_from(options.kind));
  settings.format = TRY(video_format_of(options));
  TRY(read_size(options.size, settings));
  settings.fps = options.fps;
  settings.seconds = options.seconds;
  settings.stills = options.stills;
  settings.stills_every = options.stills_every;
  TRY(movie::check_settings(settings));
  return settings;
}

Result<movie::Film> film_of(const MovieOptions& options) {
  movie::Film film = TRY(read_film(options.source));
  if (options.trace.empty()) return film;
  film.motion = TRY(read_motion(options.trace));
  if (film.motion.frames.front().grid.size() == 3 * film.end.size()) return film;
  return Error{"trace.other", "the trace is of another drape: it has another number of vertices",
               options.trace};
}

Status make_stills_folder(const std::string& folder) {
  std::error_code failure;
  if (!folder.empty()) fs::create_directories(folder, failure);
  if (!failure) return {};
  return Error{"usage.out", "cannot make the folder for the pictures: " + failure.message(), folder};
}

/// Under another name until it is whole: a movie is there or not.
Status make(const movie::Film& film, const movie::MovieSettings& settings, const std::string& out) {
  ProgressBar bar;
  RunContext context;
  context.cancel = &cancel_on_interrupt();
  context.on_progress = [&](const Progress& progress) { bar.show(progress); };
  const fs::path half = out + ".half";
  Status made = movie::make_movie(film, settings, half, context);
  std::error_code failure;
  if (made) fs::rename(half, out, failure);
  std::error_code ignored;
  if (!made || failure) fs::remove(half, ignored);
  if (!made || !failure) return made;
  return Error{"export.write", "cannot write the movie: " + failure.message(), out, ErrorKind::kInternal};
}

void print_made(const movie::Film& film, const movie::MovieSettings& settings, const MovieOptions& options) {
  const int frames = movie::frames_of(film, settings);
  std::error_code ignored;
  const auto bytes = static_cast<double>(fs::file_size(options.out, ignored));
  if (options.json) {
    const json::JsonValue told(
        std::vector<json::JsonMember>{{"file", options.out},
                                      {"bytes", bytes},
                                      {"frames", static_cast<double>(frames)},
                                      {"fps", static_cast<double>(settings.fps)},
                                      {"width", static_cast<double>(settings.width)},
                                      {"height", static_cast<double>(settings.height)}});
    std::printf("%s", json::write_json(told).c_str());
    return;
  }
  std::printf("%s: %d pictures of %d x %d, %.1f s, %.0f kB\n", options.out.c_str(), frames, settings.width,
              settings.height, static_cast<double>(frames) / settings.fps, bytes / 1000);
}

}  // namespace

ExitCode movie_command(const MovieOptions& options) {
  const Result<movie::MovieSettings> settings = settings_of(options);
  if (!settings) return fail(settings.error(), options.json);
  const Result<movie::Film> film = film_of(options);
  if (!film) return fail(film.error(), options.json);
  if (Status folder = make_stills_folder(options.stills); !folder) return fail(folder.error(), options.json);
  const Status made = make(*film, *settings, options.out);
  if (!made && made.error().kind == ErrorKind::kCancelled) {
    print_error(made.error(), options.json);
    return kCancelled;
  }
  if (!made) return fail(made.error(), options.json);
  print_made(*film, *settings, options);
  return kDone;
}

}  // namespace toile::app
