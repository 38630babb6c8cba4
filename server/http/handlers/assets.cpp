// /api/v1/assets and /api/v1/bodies: uploaded files.

#include <string_view>
#include <utility>

#include "server/documents/assets.h"
#include "server/http/handlers/answer.h"
#include "server/http/handlers/api.h"
#include "server/http/handlers/asset_answer.h"
#include "server/http/problem.h"
#include "server/http/static_files.h"

namespace toile {
namespace {

HttpResponse upload(const Api& api, const HttpRequest& request, const std::string& kind) {
  const Result<AssetRow> asset =
      add_asset(api.store, kLocalOwner, kind, request.parameter("name"), request.body);
  if (!asset) return problem(asset.error());
  return created(json_answer(201, asset_json(*asset) + "\n"), "/api/v1/assets/" + asset->id);
}

HttpResponse list(const Api& api, const std::string& kind) {
  if (!kind.empty() && !is_asset_kind(kind)) {
    return problem(400, {"documents.kind", "kind is \"dxf\", \"specification\", \"body\" or \"image\"",
                         "kind", ErrorKind::kMalformed});
  }
  const Result<std::vector<AssetRow>> assets = api.store.assets(kLocalOwner, kind);
  if (!assets) return problem(assets.error());
  std::string items;
  for (const AssetRow& asset : *assets) items += (items.empty() ? "" : ", ") + asset_json(asset);
  return json_answer(200, "{\"assets\": [" + items + "]}\n");
}

HttpResponse show(const Api& api, const HttpRequest& request) {
  const Result<AssetRow> asset = api.store.asset(kLocalOwner, request.captures[0]);
  if (!asset) return problem(asset.error());
  return json_answer(200, asset_json(*asset) + "\n");
}

/// Only types that a browser does not run: the name is the uploader's own.
std::string type_of(const AssetRow& asset, std::string_view bytes) {
  if (asset.kind == "dxf") return "image/vnd.dxf";
  if (asset.kind == "image") return image_media_type(bytes);
  const std::string type = content_type_of(asset.name);
  return type.starts_with("model/") ? type : "application/octet-stream";
}

HttpResponse content(const Api& api, const HttpRequest& request) {
  const Result<AssetRow> asset = api.store.asset(kLocalOwner, request.captures[0]);
  if (!asset) return problem(asset.error());
  Result<std::string> bytes = api.store.asset_bytes(kLocalOwner, asset->id);
  if (!bytes) return problem(bytes.error());
  const std::string type = type_of(*asset, *bytes);
  HttpResponse response = file_answer(std::move(*bytes), type, asset->name);
  response.headers.emplace_back("Cache-Control", "private, max-age=31536000, immutable");
  return response;
}

Route upload_route(const char* pattern, HttpHandler handler) {
  Route route{.method = "POST", .pattern = pattern, .handler = std::move(handler)};
  route.body = BodyKind::kFile;
  route.heavy = true;
  return route;
}

}  // namespace

void add_asset_routes(Router& router, const Api& api) {
  Route assets = upload_route("/api/v1/assets", [&api](const HttpRequest& request) {
    return upload(api, request, request.parameter("kind"));
  });
  assets.limit = [](const HttpRequest& request) {
    const std::string kind = request.parameter("kind");
    return is_asset_kind(kind) ? most_asset_bytes(kind) : kSmallBody;
  };
  router.add(std::move(assets));
  Route bodies = upload_route("/api/v1/bodies",
                              [&api](const HttpRequest& request) { return upload(api, request, "body"); });
  bodies.limit = [](const HttpRequest&) { return kMostBodyBytes; };
  router.add(std::move(bodies));
  const auto get = [&router](const char* pattern, HttpHandler handler) {
    router.add({.method = "GET", .pattern = pattern, .handler = std::move(handler)});
  };
  get("/api/v1/assets", [&api](const HttpRequest& r) { return list(api, r.parameter("kind")); });
  get("/api/v1/bodies", [&api](const HttpRequest&) { return list(api, "body"); });
  get("/api/v1/assets/{id}", [&api](const HttpRequest& r) { return show(api, r); });
  get("/api/v1/assets/{id}/content", [&api](const HttpRequest& r) { return content(api, r); });
}

}  // namespace toile
