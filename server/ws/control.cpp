#include "server/ws/control.h"

#include "core/base/names.h"
#include "core/json/tree.h"

namespace toile::ws {

Result<Control> parse_control(std::string_view text) {
  const json::JsonValue tree = TRY(json::parse_json(text, {.bytes = 4096, .depth = 4}));
  const auto* members = tree.object();
  if (members && members->size() > 1) {
    return Error{"stream.unknown_key", "a message has a \"type\" and nothing else", "/"};
  }
  const json::JsonValue* type = tree.find("type");
  const std::string word = type && type->text() ? *type->text() : "";
  if (word == "pause") return Control::kPause;
  if (word == "resume") return Control::kResume;
  if (word == "cancel") return Control::kCancel;
  return Error{"stream.unknown_type",
               "a message is {\"type\": \"pause\"}, \"resume\" or \"cancel\", not " + in_quotes(word),
               "/type"};
}

}  // namespace toile::ws
