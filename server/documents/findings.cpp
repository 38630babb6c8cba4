#include "server/documents/findings.h"

#include <string>
#include <vector>

namespace toile::documents {

json::JsonValue finding_json(const preflight::Finding& f) {
  std::vector<json::JsonValue> about;
  for (const preflight::Concern& c : f.about) {
    about.emplace_back(
        std::vector<json::JsonMember>{{"thing", std::string(preflight::name_of(c.thing))}, {"id", c.id}});
  }
  return std::vector<json::JsonMember>{
      {"code", std::string(preflight::code_of(f.kind))},
      {"severity", std::string(preflight::name_of(f.severity))},
      {"message", f.message},
      {"where", preflight::where_text(f)},
      {"about", std::move(about)},
      {"place", std::vector<json::JsonValue>{f.place.x, f.place.y, f.place.z}},
      {"repaired", f.repaired}};
}

}  // namespace toile::documents
