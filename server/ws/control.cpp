#include "server/ws/control.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>

#include "core/base/names.h"
#include "core/json/tree.h"

namespace toile::ws {
namespace {

using Kind = Control::Kind;
using drape::TouchKind;

/// A word of a viewer: what it means, and what stands with it.
struct Word {
  const char* type;
  Kind kind;
  TouchKind touch;
  std::initializer_list<const char*> members;
};

const std::array<Word, 8>& words() {
  static const std::array<Word, 8> table{{
      {"pause", Kind::kPause, {}, {}},
      {"resume", Kind::kResume, {}, {}},
      {"step", Kind::kStep, {}, {}},
      {"cancel", Kind::kCancel, {}, {}},
      {"pull", Kind::kTouch, TouchKind::kPull, {"epoch", "triangle", "shares", "to"}},
      {"let_go", Kind::kTouch, TouchKind::kLetGo, {}},
      {"pin", Kind::kTouch, TouchKind::kPin, {"epoch", "triangle", "shares"}},
      {"unpin", Kind::kTouch, TouchKind::kUnpin, {"pin"}},
  }};
  return table;
}

Error bad(const char* key, const char* wanted) {
  return {"stream.bad_value", std::string("this must be ") + wanted, json::pointer_to("", key)};
}

Result<int> whole(const json::JsonValue& tree, const char* key, double least) {
  const json::JsonValue* value = tree.find(key);
  const double* number = value ? value->number() : nullptr;
  const bool fits = number && std::floor(*number) == *number && *number >= least &&
                    *number <= std::numeric_limits<int>::max();
  if (!fits) return bad(key, "a whole number");
  return static_cast<int>(*number);
}

Result<std::array<double, 3>> three(const json::JsonValue& tree, const char* key) {
  const json::JsonValue* value = tree.find(key);
  const auto* elements = value ? value->array() : nullptr;
  if (!elements || elements->size() != 3) return bad(key, "a list of three numbers");
  std::array<double, 3> out{};
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double* number = (*elements)[i].number();
    if (!number) return bad(key, "a list of three numbers");
    out[i] = *number;
  }
  return out;
}

Result<jobs::LiveTouch> touch_in(const json::JsonValue& tree, TouchKind kind) {
  jobs::LiveTouch out;
  out.touch.kind = kind;
  if (kind == TouchKind::kUnpin) out.touch.id = TRY(whole(tree, "pin", 1));
  if (kind == TouchKind::kPull || kind == TouchKind::kPin) {
    out.epoch = static_cast<std::uint32_t>(TRY(whole(tree, "epoch", 1)));
    out.touch.at.triangle = TRY(whole(tree, "triangle", 0));
    out.touch.at.share = TRY(three(tree, "shares"));
  }
  if (kind == TouchKind::kPull) {
    const std::array<double, 3> to = TRY(three(tree, "to"));
    out.touch.target = {to[0], to[1], to[2]};
  }
  return out;
}

/// Each member that the word has, and no other.
Status check_members(const json::JsonValue& tree, const Word& word) {
  for (const json::JsonMember& member : *tree.object()) {
    const bool known =
        member.key == "type" || std::any_of(word.members.begin(), word.members.end(),
                                            [&](const char* key) { return member.key == key; });
    if (!known)
      return Error{"stream.unknown_key", "a message of this type has no " + in_quotes(member.key),
                   json::pointer_to("", member.key)};
  }
  return {};
}

}  // namespace

Result<Control> parse_control(std::string_view text) {
  const json::JsonValue tree = TRY(json::parse_json(text, {.bytes = 4096, .depth = 4}));
  const json::JsonValue* type = tree.find("type");
  const std::string said = type && type->text() ? *type->text() : "";
  const auto word =
      std::find_if(words().begin(), words().end(), [&](const Word& known) { return said == known.type; });
  if (word == words().end()) {
    std::string all;
    for (const Word& known : words()) all.append(all.empty() ? "" : ", ").append(known.type);
    return Error{"stream.unknown_type", "a message's \"type\" is one of " + all + ", not " + in_quotes(said),
                 "/type"};
  }
  TRY(check_members(tree, *word));
  Control control;
  control.kind = word->kind;
  if (control.kind == Kind::kTouch) control.touch = TRY(touch_in(tree, word->touch));
  return control;
}

}  // namespace toile::ws
