#pragma once
// Whatever describe() lists → JSON.

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/types.h"
#include "core/json/fields/range.h"
#include "core/json/tree.h"

namespace toile::fields {

inline json::JsonValue json_of(bool value) { return value; }
inline json::JsonValue json_of(int value) { return static_cast<double>(value); }
/// As the text of it reads back: JSON has no word for what is not finite, and -0 is written as 0.
inline json::JsonValue json_of(double value) {
  return std::isfinite(value) ? json::JsonValue(value + 0.0) : json::JsonValue();
}
inline json::JsonValue json_of(std::string& value) { return value; }
inline json::JsonValue json_of(Vec2 value) {
  return std::vector<json::JsonValue>{json_of(value.x), json_of(value.y)};
}
inline json::JsonValue json_of(Vec3 value) {
  return std::vector<json::JsonValue>{json_of(value.x), json_of(value.y), json_of(value.z)};
}

inline json::JsonValue json_of(std::vector<std::pair<std::string, std::string>>& names) {
  std::vector<json::JsonMember> members;
  members.reserve(names.size());
  for (const auto& [from, to] : names) members.push_back({from, to});
  return members;
}

template <typename T, std::size_t N>
json::JsonValue json_of(std::array<T, N>& values) {
  std::vector<json::JsonValue> elements;
  elements.reserve(values.size());
  for (T& value : values) elements.push_back(json_of(value));
  return elements;
}

template <typename T>
json::JsonValue json_of(T& object);

template <typename T>
json::JsonValue json_of(std::vector<T>& values) {
  std::vector<json::JsonValue> elements;
  elements.reserve(values.size());
  for (T& value : values) elements.push_back(json_of(value));
  return elements;
}

template <typename T>
json::JsonValue json_of(std::optional<T>& value) {
  return json_of(*value);
}

/// What says nothing is left out: an empty text, an empty list, an absent part.
inline bool is_absent(const std::string& value) { return value.empty(); }
template <typename T>
bool is_absent(const std::vector<T>& values) {
  return values.empty();
}
template <typename T>
bool is_absent(const std::optional<T>& value) {
  return !value;
}
template <typename T>
bool is_absent(const T&) {
  return false;
}

struct FieldWriter {
  std::vector<json::JsonMember> members;

  void object(const char*, const char*) {}
  template <typename T>
  void field(std::string_view key, T& value, const char*, Need = Need::kOptional, Range = kAnything) {
    if (!is_absent(value)) members.push_back({std::string(key), json_of(value)});
  }
  void file(std::string_view key, std::string& value, const char* meaning, Need = Need::kOptional) {
    field(key, value, meaning);
  }
  void choice(std::string_view key, std::string& value, const char* meaning, Words, Need = Need::kOptional) {
    field(key, value, meaning);
  }
  void shared_choice(const char*, const char* meaning, std::string_view key, std::string& value, Words) {
    field(key, value, meaning);
  }
  void chosen_names(std::string_view key, ChosenNames& value, const char* meaning, Words) {
    field(key, value, meaning);
  }
  template <typename... Keys>
  void exactly_one(Keys...) {}
  void unless(std::string_view, Words) {}
};

template <typename T>
json::JsonValue json_of(T& object) {
  FieldWriter writer;
  describe(writer, object);
  return std::move(writer.members);
}

}  // namespace toile::fields
