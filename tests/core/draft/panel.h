#pragma once

#include <algorithm>
#include <string>

#include "core/draft/garment.h"

namespace toile {

inline const pattern::Panel& panel(const draft::Garment& g, const std::string& id) {
  return *std::find_if(g.pattern.panels.begin(), g.pattern.panels.end(),
                       [&](const pattern::Panel& p) { return p.id == id; });
}

}  // namespace toile
