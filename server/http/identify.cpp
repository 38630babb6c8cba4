#include "server/http/identify.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <random>

namespace toile {
namespace {

bool is_plain_id(const std::string& id) {
  constexpr std::size_t kLongest = 64;
  return !id.empty() && id.size() <= kLongest && std::all_of(id.begin(), id.end(), [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' ||
           c == '_' || c == '.';
  });
}

}  // namespace

RequestIds::RequestIds() {
  std::array<char, 16> text;
  std::snprintf(text.data(), text.size(), "r_%08x_", static_cast<unsigned>(std::random_device()()));
  prefix_ = text.data();
}

std::string RequestIds::next() { return prefix_ + std::to_string(++count_); }

RequestContext local_user(const std::string& request_id, const Log& log) {
  return RequestContext("local", request_id, log);  // as in every row that a store of today holds
}

RequestContext identify(const HttpRequest& request, RequestIds& ids, const Log& log) {
  const std::string given = request.header("x-request-id");
  return local_user(is_plain_id(given) ? given : ids.next(), log);
}

}  // namespace toile
