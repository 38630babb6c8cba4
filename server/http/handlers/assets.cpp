// /api/v1/assets and /api/v1/bodies: uploaded files.

#include <string_view>
#include <utility>

#include "server/documents/assets.h"
#include "server/http/handlers/answer.h"
#include "server/http/handlers/api.h"
#include "server/http/handlers/asset_answer.h"
#include "server/http/problem.h"
#include "server/http/static_files.h"

namespace toile::handlers {
namespace {

http::HttpResponse keep(const Api& api, const store::RequestContext& context,
                        const http::HttpRequest& request, const std::string& kind) {
  const Result<store::AssetRow> asset =
      documents::add_asset(api.documents, context, kind, request.parameter("name"), request.body);
  if (!asset) return http::problem(asset.error());
  return created(json_answer(201, asset_json(*asset) + "\n"), "/api/v1/assets/" + asset->id);
}

http::HttpResponse upload(const Api& api, const store::RequestContext& context,
                          const http::HttpRequest& request) {
  return keep(api, context, request, request.parameter("kind"));
}

http::HttpResponse upload_body(const Api& api, const store::RequestContext& context,
                               const http::HttpRequest& request) {
  return keep(api, context, request, "body");
}

http::HttpResponse list_kind(const Api& api, const store::RequestContext& context, const std::string& kind) {
  if (!kind.empty() && !documents::is_asset_kind(kind)) {
    return http::problem(
        400, {"documents.kind", "kind is " + documents::asset_kinds_text(), "kind", ErrorKind::kMalformed});
  }
  const Result<std::vector<store::AssetRow>> assets = api.store.assets(context, kind);
  if (!assets) return http::problem(assets.error());
  std::string items;
  for (const store::AssetRow& asset : *assets) items += (items.empty() ? "" : ", ") + asset_json(asset);
  return json_answer(200, "{\"assets\": [" + items + "]}\n");
}

http::HttpResponse list_assets(const Api& api, const store::RequestContext& context,
                               const http::HttpRequest& request) {
  return list_kind(api, context, request.parameter("kind"));
}

http::HttpResponse list_bodies(const Api& api, const store::RequestContext& context,
                               const http::HttpRequest&) {
  return list_kind(api, context, "body");
}

http::HttpResponse show_asset(const Api& api, const store::RequestContext& context,
                              const http::HttpRequest& request) {
  const Result<store::AssetRow> asset = api.store.asset(context, request.captures[0]);
  if (!asset) return http::problem(asset.error());
  return json_answer(200, asset_json(*asset) + "\n");
}

/// Only types that a browser does not run: the name is the uploader's own.
std::string type_of(const store::AssetRow& asset, const http::AnswerFile* file) {
  constexpr std::size_t kOpening = 16;  // bytes that tell a picture's format
  if (asset.kind == "dxf") return "image/vnd.dxf";
  if (asset.kind == "image") return documents::image_media_type(file ? file->read(0, kOpening) : "");
  const std::string type = http::content_type_of(asset.name);
  return type.starts_with("model/") ? type : "application/octet-stream";
}

http::HttpResponse content(const Api& api, const store::RequestContext& context,
                           const http::HttpRequest& request) {
  const Result<store::AssetRow> asset = api.store.asset(context, request.captures[0]);
  if (!asset) return http::problem(asset.error());
  const Result<std::string> path = api.store.asset_path(context, asset->id);
  if (!path) return http::problem(path.error());
  http::HttpResponse response = file_answer_from(*path, "application/octet-stream", asset->name);
  if (!response.file) return response;
  response.content_type = type_of(*asset, response.file.get());
  response.headers.emplace_back("Cache-Control", "private, max-age=31536000, immutable");
  return response;
}

http::HttpResponse remove_asset(const Api& api, const store::RequestContext& context,
                                const http::HttpRequest& request) {
  const Status removed = api.store.remove_asset(context, request.captures[0]);
  return removed ? no_content() : http::problem(removed.error());
}

std::size_t most_bytes_of_kind(const http::HttpRequest& request) {
  const std::string kind = request.parameter("kind");
  return documents::is_asset_kind(kind) ? documents::most_asset_bytes(kind) : http::kSmallBody;
}

}  // namespace

ApiRoutes asset_routes() {
  return {
      {.method = "POST",
       .pattern = "/api/v1/assets",
       .handler = upload,
       .body = http::BodyKind::kFile,
       .limit = most_bytes_of_kind,
       .work = http::Work::kUpload,
       .parameters = {"kind", "name"}},
      {.method = "POST",
       .pattern = "/api/v1/bodies",
       .handler = upload_body,
       .body = http::BodyKind::kFile,
       .limit = [](const http::HttpRequest&) { return documents::kMostBodyBytes; },
       .work = http::Work::kUpload,
       .parameters = {"name"}},
      {.pattern = "/api/v1/assets", .handler = list_assets, .parameters = {"kind"}},
      {.pattern = "/api/v1/bodies", .handler = list_bodies},
      {.pattern = "/api/v1/assets/{id}", .handler = show_asset},
      {.pattern = "/api/v1/assets/{id}/content", .handler = content},
      {.method = "DELETE", .pattern = "/api/v1/assets/{id}", .handler = remove_asset},
  };
}

}  // namespace toile::handlers
