#pragma once
// The operations of proto/openapi.yaml with what it says of who may ask, so that tests can walk through them
// all and new ones are walked through by themselves.

#include <algorithm>
#include <cctype>
#include <fstream>
#include <string>
#include <vector>

namespace toile::test {

struct ContractRoute {
  std::string method, path;
  bool open = false;   ///< security: []
  bool admin = false;  ///< its security names the role admin
  bool link = false;   ///< for who has a share link, and for nobody by an account
};

/// In the contract's own order. It is read line by line: paths are indented by two, methods by four, what
/// belongs to an operation by six.
inline std::vector<ContractRoute> contract_routes() {
  std::ifstream in(std::string(TOILE_SOURCE_DIR) + "/proto/openapi.yaml");
  std::vector<ContractRoute> routes;
  std::string path;
  bool in_paths = false;
  for (std::string line; std::getline(in, line);) {
    if (!line.empty() && line[0] != ' ') in_paths = line == "paths:";
    if (!in_paths) continue;
    if (line.starts_with("  /")) path = line.substr(2, line.find(':') - 2);
    for (const char* method : {"get", "put", "post", "delete", "patch"}) {
      if (line != std::string("    ") + method + ":") continue;
      std::string upper = method;
      std::transform(upper.begin(), upper.end(), upper.begin(),
                     [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
      routes.push_back({upper, path});
    }
    if (!line.starts_with("      security:")) continue;
    routes.back().open = line.find("[]") != std::string::npos && line.find('{') == std::string::npos;
    routes.back().link = line.find("{link: []}") != std::string::npos;
    routes.back().admin = line.find("[admin]") != std::string::npos;
  }
  return routes;
}

}  // namespace toile::test
