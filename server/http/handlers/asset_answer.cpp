#include "server/http/handlers/asset_answer.h"

#include <utility>

#include "server/http/handlers/answer.h"

namespace toile::handlers {

std::string asset_json(const store::AssetRow& asset) {
  std::vector<json::JsonMember> members{{"id", asset.id},
                                        {"kind", asset.kind},
                                        {"name", asset.name},
                                        {"size", static_cast<double>(asset.size)},
                                        {"created_ms", static_cast<double>(asset.created_ms)}};
  return json_with(std::move(members), "info", asset.info.empty() ? "{}" : asset.info);
}

}  // namespace toile::handlers
