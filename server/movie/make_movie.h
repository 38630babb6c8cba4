#pragma once
// Movies of a drape and of how it ended, drawn as stills are.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/base/run_context.h"
#include "server/movie/film.h"
#include "server/movie/video_file.h"

namespace toile::movie {

enum class MovieKind {
  kDrape,      ///< from the pieces to the end, seen from where the three-quarter still is taken
  kTurntable,  ///< the end, turned once
};
/// "drape", "turntable".
std::string_view word_of(MovieKind kind);
/// Error: movie.kind.
Result<MovieKind> movie_kind_from(std::string_view word);
/// Error: movie.format.
Result<VideoFormat> video_format_from(std::string_view word);

inline constexpr int kLeastSide = 64, kMostSide = 4096;  ///< pixels
inline constexpr int kMostFps = 60;
inline constexpr double kMostSeconds = 120;

struct MovieSettings {
  MovieKind kind = MovieKind::kDrape;
  VideoFormat format = VideoFormat::kMp4;
  int width = 720, height = 900;  ///< pixels, even
  int fps = 25;
  /// How long it lasts. Without it a drape lasts as long as it does, but 20 s at most, and a turn 8 s.
  std::optional<double> seconds = std::nullopt;
  /// Folder for every `stills_every`-th picture as PNG, numbered from 0; empty: none.
  std::filesystem::path stills = {};
  int stills_every = 1;
};

/// Error: movie.settings, in `where` the one at fault.
Status check_settings(const MovieSettings& settings);

/// How many pictures the movie has.
int frames_of(const Film& film, const MovieSettings& settings);

/// Draws it into `path` on the calling thread. Equal films and settings give equal bytes on one machine.
/// Progress phase: "movie". Errors: those of check_settings and VideoFile, render.*; movie.no_motion for the
/// drape of a film without frames; "cancelled".
Status make_movie(const Film& film, const MovieSettings& settings, const std::filesystem::path& path,
                  const RunContext& context = {});

}  // namespace toile::movie
