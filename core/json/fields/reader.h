#pragma once
// JSON → whatever describe() lists: a FieldReader visits the fields of an object and fills them. The first
// error wins and stops the rest.

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/names.h"
#include "core/base/text.h"
#include "core/base/types.h"
#include "core/json/fields/range.h"
#include "core/json/tree.h"

namespace toile::fields {

/// A value in the document together with its place, and the slot for the first error of the whole reading.
struct FieldPlace {
  const json::JsonValue& value;
  const std::string pointer;
  std::optional<Error>& error;

  void fail(std::string code, std::string message) const {
    if (!error) error = Error{std::move(code), std::move(message), pointer};
  }
  void want(std::string_view kind) const { fail("project.wrong_type", "this must be " + std::string(kind)); }
};

inline std::string said(Range range) {
  if (range.least == kAnything.least) return "at most " + number_text(range.most);
  if (range.most == kAnything.most) return "at least " + number_text(range.least);
  return "between " + number_text(range.least) + " and " + number_text(range.most);
}

inline void read(const FieldPlace& at, bool& out, Range) {
  const bool* value = at.value.boolean();
  if (!value) return at.want("true or false");
  out = *value;
}

inline void read(const FieldPlace& at, double& out, Range range) {
  const double* value = at.value.number();
  if (!value) return at.want("a number");
  if (*value < range.least || *value > range.most) {
    return at.fail("project.out_of_range", number_text(*value) + " is not " + said(range));
  }
  out = *value;
}

inline void read(const FieldPlace& at, int& out, Range range) {
  const double* value = at.value.number();
  if (!value || std::floor(*value) != *value) return at.want("a whole number");
  double whole = 0;
  read(at, whole, range);
  if (!at.error) out = static_cast<int>(whole);
}

inline void read(const FieldPlace& at, std::string& out, Range) {
  const std::string* value = at.value.text();
  if (!value) return at.want("a text in quotes");
  if (value->empty()) return at.fail("project.out_of_range", "this text must not be empty");
  if (value->size() > kLongestText) {
    return at.fail("project.out_of_range",
                   "this text is longer than " + std::to_string(kLongestText) + " bytes");
  }
  out = *value;
}

/// The elements of a list whose length is fixed, or null after an error.
inline const std::vector<json::JsonValue>* elements_of(const FieldPlace& at, std::size_t count) {
  const auto* elements = at.value.array();
  if (elements && elements->size() == count) return elements;
  at.want("a list of " + std::to_string(count));
  return nullptr;
}

template <typename T, std::size_t N>
void read(const FieldPlace& at, std::array<T, N>& out, Range range);

inline void read(const FieldPlace& at, Vec2& out, Range range) {
  std::array<double, 2> xy{};
  read(at, xy, range);
  out = {xy[0], xy[1]};
}

inline void read(const FieldPlace& at, Vec3& out, Range range) {
  std::array<double, 3> xyz{};
  read(at, xyz, range);
  out = {xyz[0], xyz[1], xyz[2]};
}

template <typename T, std::size_t N>
void read(const FieldPlace& at, std::array<T, N>& out, Range range) {
  const auto* elements = elements_of(at, N);
  for (std::size_t i = 0; elements && i < N; ++i) {
    read(FieldPlace{(*elements)[i], json::pointer_to(at.pointer, i), at.error}, out[i], range);
  }
}

inline void read(const FieldPlace& at, std::vector<std::pair<std::string, std::string>>& out, Range) {
  const auto* members = at.value.object();
  if (!members) return at.want("an object");
  for (const json::JsonMember& member : *members) {
    std::string to;
    read(FieldPlace{member.value, json::pointer_to(at.pointer, member.key), at.error}, to, kAnything);
    out.emplace_back(member.key, std::move(to));
  }
}

template <typename T>
void read(const FieldPlace& at, T& out, Range);

template <typename T>
void read(const FieldPlace& at, std::vector<T>& out, Range count) {
  const auto* elements = at.value.array();
  if (!elements) return at.want("a list");
  const auto size = static_cast<double>(elements->size());
  if (size < count.least || size > count.most) {
    return at.fail("project.out_of_range",
                   "a list of " + number_text(size) + " stands here, and its length must be " + said(count));
  }
  for (std::size_t i = 0; i < elements->size() && !at.error; ++i) {
    T element{};
    read(FieldPlace{(*elements)[i], json::pointer_to(at.pointer, i), at.error}, element, kElement<T>.range);
    out.push_back(std::move(element));
  }
}

template <typename T>
void read(const FieldPlace& at, std::optional<T>& out, Range range) {
  read(at, out.emplace(), range);
}

/// Visitor that only notes the keys, to tell a slip of the pen from a missing key.
struct KeyNames {
  std::vector<std::string> keys;

  void object(const char*, const char*) {}
  template <typename T>
  void field(std::string_view key, T&, const char*, Need = Need::kOptional, Range = kAnything) {
    keys.emplace_back(key);
  }
  void file(std::string_view key, std::string&, const char*, Need = Need::kOptional) {
    keys.emplace_back(key);
  }
  void choice(std::string_view key, std::string&, const char*, Words, Need = Need::kOptional) {
    keys.emplace_back(key);
  }
  void shared_choice(const char*, const char*, std::string_view key, std::string&, Words) {
    keys.emplace_back(key);
  }
  void chosen_names(std::string_view key, ChosenNames&, const char*, Words) { keys.emplace_back(key); }
  template <typename... Keys>
  void exactly_one(Keys...) {}
  void unless(std::string_view, Words) {}
};

/// Visitor that fills an object's fields.
class FieldReader {
 public:
  explicit FieldReader(const FieldPlace& at) : at_(at) {}

  void object(const char*, const char*) {}

  template <typename T>
  void field(std::string_view key, T& out, const char*, Need need = Need::kOptional,
             Range range = kAnything) {
    if (at_.error) return;
    if (const json::JsonValue* value = at_.value.find(key)) {
      read(FieldPlace{*value, json::pointer_to(at_.pointer, key), at_.error}, out, range);
    } else if (need == Need::kRequired) {
      at_.fail("project.missing_key", "the key " + in_quotes(key) + " is missing");
    }
  }

  void file(std::string_view key, std::string& out, const char* meaning, Need need = Need::kOptional) {
    field(key, out, meaning, need);
  }

  void choice(std::string_view key, std::string& out, const char* meaning, Words words,
              Need need = Need::kOptional) {
    field(key, out, meaning, need);
    if (at_.error || !at_.value.find(key)) return;
    check_choice(json::pointer_to(at_.pointer, key), out, words);
  }
  void chosen_names(std::string_view key, ChosenNames& out, const char* meaning, Words words) {
    field(key, out, meaning);
    const std::string pointer = json::pointer_to(at_.pointer, key);
    if (!at_.error && out.size() > kMostNames)
      FieldPlace{at_.value, pointer, at_.error}.fail(
          "project.out_of_range", "at most " + std::to_string(kMostNames) + " names may stand here");
    for (const auto& [name, word] : out)
      if (!at_.error) check_choice(json::pointer_to(pointer, name), word, words);
  }
  void shared_choice(const char*, const char* meaning, std::string_view key, std::string& out, Words words) {
    choice(key, out, meaning, words);
  }

  template <typename... Keys>
  void exactly_one(Keys... given) {
    if (at_.error) return;
    const std::string_view keys[] = {given...};
    int found = 0;
    std::string all;
    for (std::size_t i = 0; i < std::size(keys); ++i) {
      found += at_.value.find(keys[i]) != nullptr;
      all += (i == 0 ? "" : i + 1 < std::size(keys) ? ", " : " or ") + in_quotes(keys[i]);
    }
    if (found == 1) return;
    at_.fail(found > 1 ? "project.two_ways" : "project.missing_key",
             found > 1 ? "only one of " + all + " may stand here" : "one of " + all + " must stand here");
  }
  void unless(std::string_view other, Words keys) {
    if (at_.error || at_.value.find(other)) return;
    for (const char* key : keys) {
      if (at_.value.find(key)) continue;
      return at_.fail("project.missing_key",
                      "the key " + in_quotes(key) + " is missing, and " + in_quotes(other) + " as well");
    }
  }

 private:
  void check_choice(const std::string& pointer, const std::string& given, Words words) {
    const std::vector<std::string> names(words.begin(), words.end());
    if (std::find(names.begin(), names.end(), given) != names.end()) return;
    FieldPlace{at_.value, pointer, at_.error}.fail(
        "project.unknown_value", in_quotes(given) + " is not known; " + advice(given, names));
  }

  const FieldPlace& at_;
};

/// An object with fields of its own.
template <typename T>
void read(const FieldPlace& at, T& out, Range) {
  const auto* members = at.value.object();
  if (!members) return at.want("an object");
  KeyNames known;
  describe(known, out);
  for (const json::JsonMember& member : *members) {
    if (std::find(known.keys.begin(), known.keys.end(), member.key) != known.keys.end()) continue;
    return FieldPlace{at.value, json::pointer_to(at.pointer, member.key), at.error}.fail(
        "project.unknown_key",
        "the key " + in_quotes(member.key) + " is not known; " + advice(member.key, known.keys));
  }
  FieldReader reader(at);
  describe(reader, out);
}

}  // namespace toile::fields
