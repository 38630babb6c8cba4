#include "server/http/message.h"

namespace toile::http {
namespace {

std::string value_of(const std::map<std::string, std::string>& map, const std::string& key) {
  const auto found = map.find(key);
  return found == map.end() ? std::string() : found->second;
}

}  // namespace

std::string HttpRequest::header(const std::string& lower_name) const { return value_of(headers, lower_name); }
std::string HttpRequest::parameter(const std::string& name) const { return value_of(query, name); }

}  // namespace toile::http
