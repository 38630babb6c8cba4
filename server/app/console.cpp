#include "server/app/console.h"

#include <cstdio>

#include "core/base/names.h"
#include "core/json/tree.h"

namespace toile::app {

void print_error(const Error& error, bool json) {
  std::string line;
  if (json) {
    const std::vector<json::JsonMember> parts{
        {"code", error.code}, {"message", error.message}, {"where", error.where}};
    line = json::write_json_line(std::vector<json::JsonMember>{{"error", parts}});
  } else {
    line = "toile: " + clipped(to_string(error), 2000);
  }
  std::fprintf(stderr, "%s\n", line.c_str());
}

ExitCode exit_code_of(const Error& error) {
  return error.kind == ErrorKind::kInternal ? kInternal : kBadInput;
}

ExitCode fail(const Error& error, bool json) {
  print_error(error, json);
  return exit_code_of(error);
}

}  // namespace toile::app
