// Request targets and Host values.

#include "server/http/url.h"

#include "tests/fuzz/fuzz.h"

namespace toile::fuzz {

std::vector<std::string> seeds() {
  return {"/api/v1/projects/p1?limit=10&after=x",
          "/a/b%20c?x=1&x=2&y",
          "/%2e%2e/%5c",
          "/",
          "//",
          "localhost:8460",
          "[::1]:8460",
          "127.0.0.1",
          "a.localhost.",
          "/%E2%82%AC?%3D=%26",
          "/api/v1/jobs/1/final%"};
}

void try_input(std::string_view bytes) {
  if (const auto target = http::parse_target(bytes)) {
    for (const std::string& segment : target->segments) {
      expect(segment != "." && segment != "..", "no segment leads out of its folder");
      expect(segment.find_first_of(std::string_view("/\\\0", 3)) == std::string::npos,
             "no segment holds a slash or NUL");
    }
  }
  if (const auto host = http::host_name(bytes)) http::is_loopback_name(*host);
}

}  // namespace toile::fuzz
