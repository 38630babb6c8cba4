#include "server/app/read_token.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>

namespace toile::app {

Result<std::string> read_token(const std::string& path) {
  std::string token;
  std::string place = path;
  if (path.empty()) {
    const char* given = std::getenv("TOILE_TOKEN");  // NOLINT(concurrency-mt-unsafe): nobody writes it
    if (given == nullptr) return token;
    token = given;
    place = "TOILE_TOKEN";
  } else {
    std::ifstream in(path);
    if (!in) return Error{"usage.token", "cannot read the file of the token", path};
    std::getline(in, token);
  }
  while (!token.empty() && (token.back() == '\r' || token.back() == '\n' || token.back() == ' '))
    token.pop_back();
  const bool plain = std::all_of(token.begin(), token.end(), [](char c) { return c > 0x20 && c < 0x7f; });
  if (plain && !token.empty()) return token;
  return Error{"usage.token", "what stands there is no token; toile token make gives one", place};
}

}  // namespace toile::app
