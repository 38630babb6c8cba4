#pragma once

#include <string>

#include "server/store/store.h"

namespace toile::handlers {

/// An asset as answers have it: JSON on one line, without a line feed.
std::string asset_json(const store::AssetRow& asset);

}  // namespace toile::handlers
