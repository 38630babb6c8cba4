#pragma once
// Whatever describe() lists, as a flat list of keys: for whoever must agree with the reader.

#include <array>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/types.h"
#include "core/json/fields/range.h"

namespace toile::fields {

/// A key of a format, for comparing its reader with its schema. `path` counts list elements as "*", e.g.
/// "/pieces/*/from/dxf".
struct FieldKey {
  std::string path;
  std::string type;  ///< JSON Schema's word: "object", "array", "string", "number", "integer", "boolean"
  bool required = false;
  std::optional<double> minimum, maximum;  ///< of a number
  std::vector<std::string> choices;        ///< of a string that is one of a few
};

class FieldLister {
 public:
  FieldLister(std::vector<FieldKey>& keys, std::string path) : keys_(keys), path_(std::move(path)) {}

  template <typename T>
  void field(std::string_view key, T& value, Need need = Need::kOptional, Range range = kAnything) {
    note(path_ + '/' + std::string(key), value, need == Need::kRequired, range);
  }
  void choice(std::string_view key, std::string&, std::initializer_list<const char*> words) {
    FieldKey& noted = add(path_ + '/' + std::string(key), "string", false);
    noted.choices.assign(words.begin(), words.end());
  }
  template <typename... Keys>
  void exactly_one(Keys...) {}

 private:
  FieldKey& add(const std::string& path, const char* type, bool required) {
    return keys_.emplace_back(FieldKey{path, type, required, {}, {}, {}});
  }
  void add_number(const std::string& path, const char* type, bool required, Range range) {
    FieldKey& key = add(path, type, required);
    if (range.least != kAnything.least) key.minimum = range.least;
    if (range.most != kAnything.most) key.maximum = range.most;
  }

  void note(const std::string& path, bool&, bool required, Range) { add(path, "boolean", required); }
  void note(const std::string& path, std::string&, bool required, Range) { add(path, "string", required); }
  void note(const std::string& path, int&, bool required, Range range) {
    add_number(path, "integer", required, range);
  }
  void note(const std::string& path, double&, bool required, Range range) {
    add_number(path, "number", required, range);
  }
  void note(const std::string& path, Vec2&, bool required, Range range) {
    add(path, "array", required);
    add_number(path + "/*", "number", false, range);
  }
  void note(const std::string& path, Vec3&, bool required, Range range) {
    add(path, "array", required);
    add_number(path + "/*", "number", false, range);
  }
  void note(const std::string& path, std::vector<std::pair<std::string, std::string>>&, bool required,
            Range) {
    add(path, "object", required);
  }
  template <typename T, std::size_t N>
  void note(const std::string& path, std::array<T, N>&, bool required, Range range) {
    add(path, "array", required);
    T element{};
    note(path + "/*", element, false, range);
  }
  template <typename T>
  void note(const std::string& path, std::vector<T>&, bool required, Range) {
    add(path, "array", required);
    T element{};
    note(path + "/*", element, false, kElementRange<T>);
  }
  template <typename T>
  void note(const std::string& path, std::optional<T>&, bool required, Range range) {
    T value{};
    note(path, value, required, range);
  }
  template <typename T>
  void note(const std::string& path, T& object, bool required, Range) {
    add(path, "object", required);
    FieldLister inner(keys_, path);
    describe(inner, object);
  }

  std::vector<FieldKey>& keys_;
  std::string path_;
};

}  // namespace toile::fields
