#include "server/documents/findings.h"

#include <string>
#include <vector>

namespace toile {

JsonValue finding_json(const Finding& f) {
  return std::vector<JsonMember>{{"code", std::string(code_of(f.kind))},
                                 {"severity", std::string(name_of(f.severity))},
                                 {"message", f.message},
                                 {"where", where_text(f)},
                                 {"place", std::vector<JsonValue>{f.place.x, f.place.y, f.place.z}},
                                 {"repaired", f.repaired}};
}

}  // namespace toile
