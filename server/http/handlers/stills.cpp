// /api/v1/jobs/{id}/stills: stills of a drape that has ended, from anywhere.

#include <optional>
#include <string>
#include <vector>

#include "server/http/handlers/orders.h"
#include "server/http/problem.h"
#include "server/jobs/job_stills.h"

namespace toile::handlers {
namespace {

Status read_number(const json::JsonValue& given, const char* key, double& into) {
  const json::JsonValue* value = given.find(key);
  if (!value) return {};
  if (!value->number())
    return Error{"render.camera", "\"" + std::string(key) + "\" is a number", "/" + std::string(key)};
  into = *value->number();
  return {};
}

/// A point [x, y, z] in metres, where it is given.
Result<std::optional<Vec3>> read_place(const json::JsonValue& given, const char* key) {
  const json::JsonValue* value = given.find(key);
  if (!value) return std::optional<Vec3>();
  const std::vector<json::JsonValue>* items = value->array();
  if (!items || items->size() != 3 || !(*items)[0].number() || !(*items)[1].number() || !(*items)[2].number())
    return Error{"render.camera", "\"" + std::string(key) + "\" is a place [x, y, z] in metres",
                 "/" + std::string(key)};
  return std::optional<Vec3>({*(*items)[0].number(), *(*items)[1].number(), *(*items)[2].number()});
}

Status read_flag(const json::JsonValue& given, const char* key, bool& into) {
  const json::JsonValue* value = given.find(key);
  if (!value) return {};
  if (!value->boolean())
    return Error{"render.settings", "\"" + std::string(key) + "\" is true or false", "/" + std::string(key)};
  into = *value->boolean();
  return {};
}

Result<movie::StillWish> read_wish(const json::JsonValue& given) {
  movie::StillWish wish;
  TRY(read_whole(given, "width", "render.settings", wish.settings.width));
  TRY(read_whole(given, "height", "render.settings", wish.settings.height));
  TRY(read_flag(given, "transparent", wish.settings.transparent));
  wish.map = word_in(given, "map", "");
  if (given.find("map") && wish.map.empty()) return Error{"map.unknown", "a map is told by its word", "/map"};
  const std::optional<Vec3> eye = TRY(read_place(given, "eye")), target = TRY(read_place(given, "target"));
  if (!eye && (target || given.find("angle")))
    return Error{"render.camera", "an own camera is told by \"eye\"", "/eye"};
  if (eye && given.find("view"))
    return Error{"render.camera", "a still is taken from a view or from an own camera", "/view"};
  if (eye) {
    render::Viewpoint from{*eye, target};
    TRY(read_number(given, "angle", from.angle));
    wish.from = from;
  } else {
    wish.from = TRY(render::view_from(word_in(given, "view", "three-quarter")));
  }
  TRY(movie::check_wish(wish));
  return wish;
}

http::HttpResponse ask(const Api& api, const store::RequestContext& context,
                       const http::HttpRequest& request) {
  const Result<json::JsonValue> given =
      read_object(request, {"view", "eye", "target", "angle", "map", "width", "height", "transparent"},
                  {.bytes = http::kSmallBody, .depth = 32});
  if (!given) return http::problem(given.error());
  const Result<movie::StillWish> wish = read_wish(*given);
  if (!wish) return http::problem(422, wish.error());
  const std::string& job = request.captures[0];
  return order_answer(job, "still", api.stills.ask(context, job, *wish));
}

http::HttpResponse list_stills(const Api& api, const store::RequestContext& context,
                               const http::HttpRequest& request) {
  return orders_answer(api.stills, "stills", context, request);
}

http::HttpResponse cancel_still(const Api& api, const store::RequestContext& context,
                                const http::HttpRequest& request) {
  return cancel_order(api.stills, context, request);
}

}  // namespace

ApiRoutes still_routes() {
  return {
      {.method = "POST",
       .pattern = "/api/v1/jobs/{id}/stills",
       .handler = ask,
       .body = http::BodyKind::kJson},
      {.pattern = "/api/v1/jobs/{id}/stills", .handler = list_stills},
      {.method = "DELETE", .pattern = "/api/v1/jobs/{id}/stills/{name}", .handler = cancel_still},
  };
}

}  // namespace toile::handlers
