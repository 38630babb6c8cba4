#include "server/http/handlers/sweep_wish.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/base/names.h"
#include "core/base/text.h"
#include "server/http/handlers/answer.h"
#include "server/http/handlers/job_wish.h"
#include "server/http/router.h"

namespace toile::handlers {
namespace {

using json::JsonValue;

/// A text that is there; empty where it is not. Error: `code`.
Result<std::string> text_at(const JsonValue& in, const char* key, const char* code, const std::string& says,
                            const std::string& where) {
  const JsonValue* given = in.find(key);
  if (!given) return std::string();
  if (given->text() && !given->text()->empty()) return *given->text();
  return Error{code, "\"" + std::string(key) + "\" is " + says, json::pointer_to(where, key)};
}

/// Error: request.label.
Result<std::string> label_in(const JsonValue& in, const char* key, const std::string& where) {
  const std::string label =
      TRY(text_at(in, key, "request.label", "a text of 1 to 80 bytes on one line", where));
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  if (label.size() <= kLongestLabel && trimmed(label) == label &&
      std::none_of(label.begin(), label.end(), is_control))
    return label;
  return Error{"request.label", "\"" + std::string(key) + "\" is a text of 1 to 80 bytes on one line",
               json::pointer_to(where, key)};
}

Status check_keys(const JsonValue& object, const std::vector<std::string>& known, const std::string& where) {
  for (const json::JsonMember& member : *object.object()) {
    if (std::find(known.begin(), known.end(), member.key) != known.end()) continue;
    return Error{"request.unknown_key",
                 "the key " + in_quotes(member.key) + " is not known here; " + advice(member.key, known),
                 json::pointer_to(where, member.key)};
  }
  return {};
}

/// "eu38" is {"mannequin": {"preset": "eu38"}}.
JsonValue as_object(const JsonValue& given) {
  if (!given.text()) return given;
  return std::vector<json::JsonMember>{
      {"mannequin", std::vector<json::JsonMember>{{"preset", *given.text()}}}};
}

Result<jobs::SweepBody> read_body(const JsonValue& given, const std::string& where) {
  const JsonValue object = as_object(given);
  if (!object.object())
    return Error{
        "request.body",
        "a body is the name of a preset, or an object with \"mannequin\", \"asset\" or \"project_id\"; "
        "an empty one is the project's own",
        where};
  TRY(check_keys(object, {"label", "project_id", "mannequin", "asset", "unit", "up", "turn"}, where));
  jobs::SweepBody body;
  body.label = TRY(label_in(object, "label", where));
  body.project_id = TRY(text_at(object, "project_id", "request.project_id", "the id of a project", where));
  std::vector<json::JsonMember> wish;
  for (const json::JsonMember& member : *object.object())
    if (member.key != "label" && member.key != "project_id") wish.push_back(member);
  if (!wish.empty()) body.body = JsonValue(std::move(wish));
  return body;
}

Result<jobs::SweepFabric> read_fabric(const JsonValue& given, const std::string& where) {
  const Error wrong{
      "request.fabric",
      "a fabric is a name of the library, an id of the document, or an object with \"fabric\" and "
      "\"label\"; an empty one is as the project is cut",
      where};
  if (given.text() && !given.text()->empty()) return jobs::SweepFabric{"", *given.text()};
  if (!given.object()) return wrong;
  TRY(check_keys(given, {"label", "fabric"}, where));
  jobs::SweepFabric fabric;
  fabric.label = TRY(label_in(given, "label", where));
  fabric.fabric = TRY(text_at(given, "fabric", "request.fabric", "the name of a fabric", where));
  return fabric;
}

/// A list of the request, each element read by `read`; one element that asks nothing where it is not there.
template <typename Element>
Result<std::vector<Element>> read_list(const JsonValue& given, const char* key, const char* code,
                                       Result<Element> (*read)(const JsonValue&, const std::string&)) {
  const JsonValue* list = given.find(key);
  if (!list) return std::vector<Element>(1);
  const std::string where = json::pointer_to("", key);
  if (!list->array()) return Error{code, "\"" + std::string(key) + "\" is a list", where};
  std::vector<Element> elements;
  for (std::size_t i = 0; i < list->array()->size(); ++i) {
    Element element = TRY(read((*list->array())[i], json::pointer_to(where, i)));
    elements.push_back(std::move(element));
  }
  return elements;
}

}  // namespace

Result<jobs::SweepWish> read_sweep_wish(const http::HttpRequest& request) {
  const JsonValue given = TRY(read_object(
      request, {"project_id", "name", "body", "bodies", "fabrics", "priority", "pictures", "anew", "tags"},
      {.bytes = http::kSmallBody, .depth = 8}));
  jobs::SweepWish wish;
  wish.project_id = TRY(text_at(given, "project_id", "request.project_id", "the id of a project", ""));
  if (wish.project_id.empty())
    return Error{"request.project_id", "\"project_id\" is the id of a project", "/project_id"};
  wish.name = TRY(label_in(given, "name", ""));
  wish.body_id = TRY(text_at(given, "body", "request.body", "the id of a body in the document", ""));
  wish.bodies = TRY(read_list<jobs::SweepBody>(given, "bodies", "request.body", read_body));
  wish.fabrics = TRY(read_list<jobs::SweepFabric>(given, "fabrics", "request.fabric", read_fabric));
  wish.manner = TRY(read_job_wish(given));
  return wish;
}

}  // namespace toile::handlers
