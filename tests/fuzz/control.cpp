// What viewers say on a stream.

#include "server/ws/control.h"

#include "tests/fuzz/fuzz.h"

namespace toile::fuzz {

std::vector<std::string> seeds() {
  return {R"({"type": "pause"})", R"({"type": "resume"})", R"({"type": "cancel"})",
          R"({"type": 1, "more": [{}]})", "[]"};
}

void try_input(std::string_view bytes) {
  const Result<ws::Control> control = ws::parse_control(bytes);
  if (control) return;
  const std::string& code = control.error().code;
  expect(code.starts_with("json.") || code.starts_with("stream."), "a refusal says so");
  expect(control.error().message.size() < 10'000, "a refusal repeats no long message");
}

}  // namespace toile::fuzz
