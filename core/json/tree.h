#pragma once
// JSON as a small tree, read within limits and written so that a person can read it. The library behind it
// stays inside tree.cpp.

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/result.h"

namespace toile::json {

struct JsonMember;

/// A JSON value. Objects keep their members in the order of the text.
struct JsonValue {
  std::variant<std::nullptr_t, bool, double, std::string, std::vector<JsonValue>, std::vector<JsonMember>>
      data;

  JsonValue();
  JsonValue(bool value);                       // NOLINT: implicit on purpose
  JsonValue(double value);                     // NOLINT: implicit on purpose
  JsonValue(std::string value);                // NOLINT: implicit on purpose
  JsonValue(std::vector<JsonValue> elements);  // NOLINT: implicit on purpose
  JsonValue(std::vector<JsonMember> members);  // NOLINT: implicit on purpose

  const bool* boolean() const { return std::get_if<bool>(&data); }
  const double* number() const { return std::get_if<double>(&data); }
  const std::string* text() const { return std::get_if<std::string>(&data); }
  const std::vector<JsonValue>* array() const { return std::get_if<std::vector<JsonValue>>(&data); }
  const std::vector<JsonMember>* object() const { return std::get_if<std::vector<JsonMember>>(&data); }

  /// The member of that name, or null; null as well when this is no object.
  const JsonValue* find(std::string_view key) const;
};

struct JsonMember {
  std::string key;
  JsonValue value;
};

/// What a text may cost before it is read at all.
struct JsonLimits {
  std::size_t bytes = std::size_t{4} << 20;
  std::size_t depth = 32;
};

/// Reads one JSON text (RFC 8259, UTF-8). Memory stays within a fixed multiple of the text's size. Errors:
/// json.too_large, json.too_deep, json.duplicate_key, json.syntax; `where` is a line and column or a JSON
/// pointer.
Result<JsonValue> parse_json(std::string_view text, const JsonLimits& limits = {});

/// JSON text with a line feed at the end. What fits goes on one line, the rest is indented by two blanks.
/// Numbers are written with the fewest digits that read back as the same double, zeros without a sign; bytes
/// that are not UTF-8 become U+FFFD.
std::string write_json(const JsonValue& value);

/// The same on one line, without the line feed.
std::string write_json_line(const JsonValue& value);

/// Error: json.too_large.
Status check_size(std::string_view text, const JsonLimits& limits);

/// `pointer` with one more reference token, escaped as RFC 6901 wants it and clipped when it is very long.
std::string pointer_to(std::string_view pointer, std::string_view key);
std::string pointer_to(std::string_view pointer, std::size_t index);

/// `error` with its place behind the pointer, or the file's name, of what led to it.
Error error_at(const std::string& pointer, Error error);

}  // namespace toile::json
