#pragma once
// A list of the document → a list of the core's, each thing with the pointer of its place.

#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/json/tree.h"

namespace toile::resolve {

/// Appends make(thing, pointer of the thing) for each of `things`; stops at the first error.
template <typename Given, typename Made, typename Make>
Status make_all(const std::vector<Given>& things, const std::string& list, std::vector<Made>& made,
                Make make) {
  for (std::size_t i = 0; i < things.size(); ++i) {
    auto result = TRY(make(things[i], json::pointer_to(list, i)));
    made.push_back(std::move(result));
  }
  return {};
}

}  // namespace toile::resolve
