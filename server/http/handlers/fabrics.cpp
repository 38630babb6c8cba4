// The fabrics that documents may name.

#include <utility>

#include "core/fabric/library.h"
#include "server/http/handlers/answer.h"
#include "server/http/handlers/api.h"
#include "server/http/problem.h"

namespace toile::handlers {
namespace {

http::HttpResponse fabrics(const Api&, const store::RequestContext&, const http::HttpRequest&) {
  std::vector<json::JsonValue> cards;
  for (const fabric::FabricCard& card : fabric::library()) cards.push_back(fabric::fabric_json(card));
  return json_answer(200, {{"fabrics", std::move(cards)}});
}

http::HttpResponse fabric_of_name(const Api&, const store::RequestContext&,
                                  const http::HttpRequest& request) {
  const Result<const fabric::FabricCard*> card = fabric::named(request.captures[0], "");
  if (card) return json_answer(200, fabric::write_fabric(**card));
  return http::problem({card.error().code, card.error().message, "", ErrorKind::kNotFound});
}

}  // namespace

ApiRoutes fabric_routes() {
  return {{.pattern = "/api/v1/fabrics", .handler = fabrics},
          {.pattern = "/api/v1/fabrics/{name}", .handler = fabric_of_name}};
}

}  // namespace toile::handlers
