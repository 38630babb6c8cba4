#include "core/manifest/touch_log.h"

#include <algorithm>
#include <utility>

#include "core/json/fields/reader.h"
#include "core/json/fields/schema.h"
#include "core/json/fields/writer.h"
#include "core/manifest/touch_log_fields.h"

namespace toile::manifest {
namespace {

using drape::Touch;
using drape::TouchKind;

constexpr std::pair<TouchKind, const char*> kWords[] = {{TouchKind::kPull, "pull"},
                                                        {TouchKind::kLetGo, "let_go"},
                                                        {TouchKind::kPin, "pin"},
                                                        {TouchKind::kUnpin, "unpin"}};
/// A touch takes some 200 bytes at most.
constexpr std::size_t kMostBytes = std::size_t{32} << 20;

LoggedTouch logged(const Touch& touch) {
  LoggedTouch out{touch.step, "", touch.id, {}, {}, {}};
  for (const auto& [kind, word] : kWords) {
    if (kind == touch.kind) out.touch = word;
  }
  if (touch.at.triangle != kNone) {
    out.triangle = touch.at.triangle;
    out.shares = touch.at.share;
  }
  if (touch.kind == TouchKind::kPull) out.to = touch.target;
  return out;
}

Touch touch_of(const LoggedTouch& logged) {
  Touch touch;
  touch.step = logged.step;
  for (const auto& [kind, word] : kWords) {
    if (logged.touch == word) touch.kind = kind;
  }
  touch.id = logged.id;
  if (logged.triangle) touch.at.triangle = *logged.triangle;
  if (logged.shares) touch.at.share = *logged.shares;
  if (logged.to) touch.target = *logged.to;
  return touch;
}

}  // namespace

std::string write_touch_log(const std::vector<Touch>& touches) {
  TouchLog log;
  log.touches.reserve(touches.size());
  for (const Touch& touch : touches) log.touches.push_back(logged(touch));
  return json::write_json(fields::json_of(log));
}

Result<std::vector<Touch>> parse_touch_log(std::string_view text) {
  const auto damaged = [](const Error& error) {
    return Error{"log.damaged", error.message, error.where, ErrorKind::kInput};
  };
  const Result<json::JsonValue> tree = json::parse_json(text, {.bytes = kMostBytes, .depth = 8});
  if (!tree) return damaged(tree.error());
  TouchLog log;
  std::optional<Error> error;
  fields::read(fields::FieldPlace{*tree, "", error}, log, fields::kAnything);
  if (error) return damaged(*error);
  std::vector<Touch> touches;
  touches.reserve(log.touches.size());
  for (const LoggedTouch& touch : log.touches) touches.push_back(touch_of(touch));
  return touches;
}

json::JsonValue touch_log_schema() {
  fields::Definitions definitions;
  const json::JsonValue schema = fields::schema_of(TouchLog{}, fields::kAnything, definitions);
  return fields::schema_file("Toile log of hands on cloth", "", schema, definitions);
}

}  // namespace toile::manifest
