#include "server/jobs/movies.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "core/base/read_file.h"
#include "core/base/text.h"

namespace toile::jobs {
namespace {

bool is_movie(const std::string& name) { return name.ends_with(".mp4") || name.ends_with(".avi"); }

Result<std::string> made_movie(const Ingredients& from, const std::string& name,
                               const movie::MovieSettings& settings, const RunContext& context) {
  const std::filesystem::path path = from.scratch / name;
  TRY(movie::make_movie(from.film, settings, path, context));
  std::optional<std::string> made = read_file(path);
  if (!made) return Error{"export.read", "cannot read the movie back", path.string(), ErrorKind::kInternal};
  return std::move(*made);
}

}  // namespace

std::string movie_name(const movie::MovieSettings& settings) {
  std::string name = std::string(movie::word_of(settings.kind)) + "-" + std::to_string(settings.width) + "x" +
                     std::to_string(settings.height) + "-" + std::to_string(settings.fps);
  if (settings.seconds) name += "-" + number_text(*settings.seconds) + "s";
  return name + "." + movie::word_of(settings.format);
}

Movies::Movies(store::Store& store, OrderLimits limits)
    : OnDemand(store, limits,
               {"movie", "movie.no_film", "movie.busy", "movie.too_many", "movie.failed", is_movie}) {}

Result<Order> Movies::ask(const store::RequestContext& context, const std::string& job_id,
                          const movie::MovieSettings& settings) {
  TRY(movie::check_settings(settings));
  if (std::max(settings.width, settings.height) > limits().side) {
    return Error{"movie.settings",
                 "a movie has at most " + std::to_string(limits().side) + " pixels a side here",
                 settings.width > limits().side ? "width" : "height"};
  }
  const std::string name = movie_name(settings);
  return OnDemand::ask(context, job_id, name,
                       [name, settings](const Ingredients& from, const RunContext& run) {
                         return made_movie(from, name, settings, run);
                       });
}

}  // namespace toile::jobs
