// /api/v1/jobs/{id}/movies: movies of a drape that has ended.

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "server/http/handlers/answer.h"
#include "server/http/handlers/api.h"
#include "server/http/problem.h"

namespace toile::handlers {
namespace {

std::string place_of(const std::string& job, const std::string& name) {
  return "/api/v1/jobs/" + job + "/results/" + name;
}

json::JsonValue movie_json(const std::string& job, const jobs::MovieOrder& order) {
  json::JsonValue href, error;
  if (order.state == jobs::MovieState::kMade) href = json::JsonValue(place_of(job, order.name));
  if (order.error) {
    error = json::JsonValue(
        std::vector<json::JsonMember>{{"code", order.error->code}, {"detail", order.error->message}});
  }
  return std::vector<json::JsonMember>{{"name", order.name},
                                       {"state", std::string(jobs::word_of(order.state))},
                                       {"fraction", order.fraction},
                                       {"href", std::move(href)},
                                       {"error", std::move(error)}};
}

/// A whole number of the request's, where it is given. Error: movie.settings.
Status read_whole(const json::JsonValue& given, const char* key, int& into) {
  const json::JsonValue* value = given.find(key);
  if (!value) return {};
  const double* number = value->number();
  if (!number || std::floor(*number) != *number || std::abs(*number) > 1e6) {
    return Error{"movie.settings", "\"" + std::string(key) + "\" is a whole number", "/" + std::string(key)};
  }
  into = static_cast<int>(*number);
  return {};
}

std::string word_in(const json::JsonValue& given, const char* key, const char* usual) {
  const json::JsonValue* value = given.find(key);
  if (!value) return usual;
  return value->text() ? *value->text() : "";
}

Result<movie::MovieSettings> read_settings(const json::JsonValue& given) {
  movie::MovieSettings settings;
  settings.kind = TRY(movie::movie_kind_from(word_in(given, "kind", "drape")));
  settings.format = TRY(movie::video_format_from(word_in(given, "format", "mp4")));
  TRY(read_whole(given, "width", settings.width));
  TRY(read_whole(given, "height", settings.height));
  TRY(read_whole(given, "fps", settings.fps));
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
  const Result<jobs::MovieOrder> order = api.movies.ask(context, job, *settings);
  if (!order) return http::problem(order.error());
  const int status = order->state == jobs::MovieState::kMade ? 200 : 202;
  return json_answer(status, {{"movie", movie_json(job, *order)}});
}

http::HttpResponse list_movies(const Api& api, const store::RequestContext& context,
                               const http::HttpRequest& request) {
  const std::string& job = request.captures[0];
  const Result<std::vector<jobs::MovieOrder>> movies = api.movies.of_job(context, job);
  if (!movies) return http::problem(movies.error());
  std::vector<json::JsonValue> items;
  for (const jobs::MovieOrder& order : *movies) items.push_back(movie_json(job, order));
  return json_answer(200, {{"movies", std::move(items)}});
}

http::HttpResponse cancel_movie(const Api& api, const store::RequestContext& context,
                                const http::HttpRequest& request) {
  const Status cancelled = api.movies.cancel(context, request.captures[0], request.captures[1]);
  return cancelled ? no_content() : http::problem(cancelled.error());
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
