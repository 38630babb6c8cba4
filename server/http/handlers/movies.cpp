// /api/v1/jobs/{id}/movies: movies of a drape that has ended.

#include <string>

#include "server/http/handlers/orders.h"
#include "server/http/problem.h"
#include "server/jobs/movies.h"

namespace toile::handlers {
namespace {

Result<movie::MovieSettings> read_settings(const json::JsonValue& given) {
  movie::MovieSettings settings;
  settings.kind = TRY(movie::movie_kind_from(word_in(given, "kind", "drape")));
  settings.format = TRY(movie::video_format_from(word_in(given, "format", "mp4")));
  TRY(read_whole(given, "width", "movie.settings", settings.width));
  TRY(read_whole(given, "height", "movie.settings", settings.height));
  TRY(read_whole(given, "fps", "movie.settings", settings.fps));
  if (const json::JsonValue* seconds = given.find("seconds")) {
    if (!seconds->number()) return Error{"movie.settings", "\"seconds\" is a number", "/seconds"};
    settings.seconds = *seconds->number();
  }
  TRY(movie::check_settings(settings));
  return settings;
}

http::HttpResponse ask(const Api& api, const store::RequestContext& context,
                       const http::HttpRequest& request) {
  const Result<json::JsonValue> given =
      read_object(request, {"kind", "format", "width", "height", "fps", "seconds"},
                  {.bytes = http::kSmallBody, .depth = 32});
  if (!given) return http::problem(given.error());
  const Result<movie::MovieSettings> settings = read_settings(*given);
  if (!settings) return http::problem(422, settings.error());
  const std::string& job = request.captures[0];
  return order_answer(job, "movie", api.movies.ask(context, job, *settings));
}

http::HttpResponse list_movies(const Api& api, const store::RequestContext& context,
                               const http::HttpRequest& request) {
  return orders_answer(api.movies, "movies", context, request);
}

http::HttpResponse cancel_movie(const Api& api, const store::RequestContext& context,
                                const http::HttpRequest& request) {
  return cancel_order(api.movies, context, request);
}

}  // namespace

ApiRoutes movie_routes() {
  return {
      {.method = "POST",
       .pattern = "/api/v1/jobs/{id}/movies",
       .handler = ask,
       .body = http::BodyKind::kJson},
      {.pattern = "/api/v1/jobs/{id}/movies", .handler = list_movies},
      {.method = "DELETE", .pattern = "/api/v1/jobs/{id}/movies/{name}", .handler = cancel_movie},
  };
}

}  // namespace toile::handlers
