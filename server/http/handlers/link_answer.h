#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/json/tree.h"
#include "server/store/links.h"

namespace toile::handlers {

/// What may be taken by a link, as answers have it.
inline json::JsonValue takes_list(const store::LinkTakes& takes) {
  std::vector<json::JsonValue> words;
  if (takes.pictures) words.emplace_back(std::string("pictures"));
  if (takes.models) words.emplace_back(std::string("models"));
  if (takes.report) words.emplace_back(std::string("report"));
  return json::JsonValue(std::move(words));
}

}  // namespace toile::handlers
