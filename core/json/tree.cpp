#include "core/json/tree.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include <nlohmann/json.hpp>

#include "core/base/names.h"
#include "core/base/text.h"

namespace toile::json {

JsonValue::JsonValue() : data(nullptr) {}
JsonValue::JsonValue(bool value) : data(value) {}
JsonValue::JsonValue(double value) : data(value) {}
JsonValue::JsonValue(std::string value) : data(std::move(value)) {}
JsonValue::JsonValue(std::vector<JsonValue> elements) : data(std::move(elements)) {}
JsonValue::JsonValue(std::vector<JsonMember> members) : data(std::move(members)) {}

const JsonValue* JsonValue::find(std::string_view key) const {
  if (const auto* members = object()) {
    for (const JsonMember& member : *members) {
      if (member.key == key) return &member.value;
    }
  }
  return nullptr;
}

std::string pointer_to(std::string_view pointer, std::string_view key) {
  std::string out(pointer);
  out += '/';
  for (const char c : clipped(key)) {
    if (c == '~') {
      out += "~0";
    } else if (c == '/') {
      out += "~1";
    } else {
      out += c;
    }
  }
  return out;
}

std::string pointer_to(std::string_view pointer, std::size_t index) {
  return std::string(pointer) + '/' + std::to_string(index);
}

Error error_at(const std::string& pointer, Error error) {
  error.where = error.where.empty() ? pointer : pointer + ": " + error.where;
  return error;
}

namespace {

std::string line_and_column(std::string_view text, std::size_t position) {
  position = std::min(position, text.size());
  const std::string_view before = text.substr(0, position);
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const std::size_t line_start = before.rfind('\n');
  const std::size_t column = line_start == std::string_view::npos ? position + 1 : position - line_start;
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

/// What the parser expected, out of its longer message; never the input's own text.
std::string reason_of(std::string_view message) {
  const std::size_t start = message.find("while parsing");
  if (start == std::string_view::npos) return "a number or a character is not allowed here";
  return std::string(message.substr(start, message.find(';', start) - start).substr(0, 120));
}

/// Builds the tree from parse events and stops at the first thing that breaks a limit, so that a hostile text
/// costs no more than what was read until then.
class TreeBuilder final : public nlohmann::json_sax<nlohmann::json> {
 public:
  TreeBuilder(std::string_view text, std::size_t depth) : text_(text), max_depth_(depth) {}

  bool null() override { return add(JsonValue()); }
  bool boolean(bool value) override { return add(JsonValue(value)); }
  bool number_integer(std::int64_t value) override { return add(JsonValue(static_cast<double>(value))); }
  bool number_unsigned(std::uint64_t value) override { return add(JsonValue(static_cast<double>(value))); }
  bool number_float(double value, const std::string&) override { return add(JsonValue(value)); }
  bool string(std::string& value) override { return add(JsonValue(std::move(value))); }
  bool binary(nlohmann::json::binary_t&) override { return false; }

  bool start_object(std::size_t) override { return open(JsonValue(std::vector<JsonMember>())); }
  bool key(std::string& value) override {
    std::get<std::vector<JsonMember>>(open_.back()->data).push_back({std::move(value), {}});
    return true;
  }
  bool end_object() override {
    if (has_twin_keys()) return false;
    open_.pop_back();
    return true;
  }
  bool start_array(std::size_t) override { return open(JsonValue(std::vector<JsonValue>())); }
  bool end_array() override {
    open_.pop_back();
    return true;
  }
  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& e) override {
    error_ = Error{"json.syntax", "this is not valid JSON: " + reason_of(e.what()),
                   line_and_column(text_, position > 0 ? position - 1 : 0), ErrorKind::kMalformed};
    return false;
  }

  std::optional<Error>& error() { return error_; }
  JsonValue& root() { return root_; }

 private:
  /// The slot that the next value goes to. Only the last element of an open container is ever under
  /// construction, so that the pointers in open_ stay valid while their containers grow.
  JsonValue* slot() {
    if (open_.empty()) return &root_;
    if (auto* elements = std::get_if<std::vector<JsonValue>>(&open_.back()->data)) {
      return &elements->emplace_back();
    }
    return &std::get<std::vector<JsonMember>>(open_.back()->data).back().value;
  }

  bool add(JsonValue value) {
    *slot() = std::move(value);
    return true;
  }

  bool open(JsonValue container) {
    if (open_.size() == max_depth_) {
      error_ = Error{"json.too_deep", "the text nests deeper than " + std::to_string(max_depth_) + " levels",
                     pointer(), ErrorKind::kMalformed};
      return false;
    }
    JsonValue* place = slot();
    *place = std::move(container);
    open_.push_back(place);
    return true;
  }

  bool has_twin_keys() {
    const auto& members = *open_.back()->object();
    std::vector<std::string_view> keys;
    keys.reserve(members.size());
    for (const JsonMember& member : members) keys.push_back(member.key);
    std::sort(keys.begin(), keys.end());
    const auto twin = std::adjacent_find(keys.begin(), keys.end());
    if (twin == keys.end()) return false;
    error_ = Error{"json.duplicate_key", "the key " + in_quotes(*twin) + " stands twice in one object",
                   pointer(), ErrorKind::kMalformed};
    return true;
  }

  /// JSON pointer of the innermost open container.
  std::string pointer() const {
    std::string out;
    for (std::size_t i = 0; i + 1 < open_.size(); ++i) {
      if (const auto* elements = open_[i]->array()) {
        out = pointer_to(out, elements->size() - 1);
      } else {
        out = pointer_to(out, open_[i]->object()->back().key);
      }
    }
    return out;
  }

  std::string_view text_;
  std::size_t max_depth_;
  std::vector<JsonValue*> open_;
  JsonValue root_;
  std::optional<Error> error_;
};

constexpr std::size_t kLineWidth = 100;

std::string json_number(double value) {
  if (!std::isfinite(value)) return "null";  // JSON has no other word for it
  return value == 0 ? "0" : number_text(value);
}

std::string string_text(const std::string& value) {
  return nlohmann::json(value).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string scalar_text(const JsonValue& value) {
  if (const bool* b = value.boolean()) return *b ? "true" : "false";
  if (const double* n = value.number()) return json_number(*n);
  if (const std::string* s = value.text()) return string_text(*s);
  return "null";
}

/// `open` item, item `close`: on one line when that fits behind `indent` blanks, else one item a line.
std::string laid_out(char open, std::span<const std::string> items, char close, std::size_t indent,
                     std::size_t width) {
  if (items.empty()) return {open, close};
  std::size_t one_line = indent + 2;
  bool broken = false;
  for (const std::string& item : items) {
    one_line += item.size() + 2;
    broken = broken || item.find('\n') != std::string::npos;
  }
  const bool fits = !broken && one_line <= width;
  std::string gap;
  if (!fits) gap.append(1, '\n').append(indent + 2, ' ');
  std::string out(1, open);
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i > 0) out += fits ? ", " : ",";
    out += gap + items[i];
  }
  if (!fits) out.append(1, '\n').append(indent, ' ');
  return out + close;
}

std::string text_of(const JsonValue& value, std::size_t indent, std::size_t width) {
  std::vector<std::string> items;
  if (const auto* elements = value.array()) {
    for (const JsonValue& element : *elements) items.push_back(text_of(element, indent + 2, width));
    return laid_out('[', items, ']', indent, width);
  }
  if (const auto* members = value.object()) {
    for (const JsonMember& member : *members) {
      items.push_back(string_text(member.key) + ": " + text_of(member.value, indent + 2, width));
    }
    return laid_out('{', items, '}', indent, width);
  }
  return scalar_text(value);
}

}  // namespace

Status check_size(std::string_view text, const JsonLimits& limits) {
  if (text.size() <= limits.bytes) return {};
  return Error{"json.too_large",
               "the text has " + std::to_string(text.size()) + " bytes, and " + std::to_string(limits.bytes) +
                   " are allowed",
               "", ErrorKind::kTooLarge};
}

Result<JsonValue> parse_json(std::string_view text, const JsonLimits& limits) {
  TRY(check_size(text, limits));
  TreeBuilder builder(text, limits.depth);
  const bool whole = nlohmann::json::sax_parse(text.begin(), text.end(), &builder);
  if (builder.error()) return *std::move(builder.error());
  if (!whole)
    return Error{"json.syntax", "this is not valid JSON", "line 1, column 1", ErrorKind::kMalformed};
  return std::move(builder.root());
}

std::string write_json(const JsonValue& value) { return text_of(value, 0, kLineWidth) + "\n"; }

std::string write_json_line(const JsonValue& value) { return text_of(value, 0, SIZE_MAX); }

}  // namespace toile::json
