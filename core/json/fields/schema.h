#pragma once
// Whatever describe() says, as a JSON Schema (2020-12): the reader's rules for people and programs outside.

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/types.h"
#include "core/json/fields/range.h"
#include "core/json/tree.h"

namespace toile::fields {

/// The definitions of one schema file, in the order in which they were first needed, and those of another
/// file that this one may refer to.
class Definitions {
 public:
  Definitions() = default;
  /// `file` as references name it, relative to this schema's own place.
  Definitions(const Definitions& others, std::string file) : others_(&others), file_(std::move(file)) {}

  /// {"$ref": …} to the definition of that name; `make` is called for the definition when it is nowhere yet.
  template <typename Make>
  json::JsonValue refer(const std::string& name, Make make) {
    if (others_ && others_->has_object(name)) return reference(file_ + "#/$defs/" + name);
    if (!has(name)) {
      const std::size_t place = members_.size();
      members_.push_back({name, {}});  // holds the place, so that what it needs comes after it
      members_[place].value = make();
    }
    return reference("#/$defs/" + name);
  }

  const std::vector<json::JsonMember>& members() const { return members_; }

 private:
  static json::JsonValue reference(std::string to) {
    return std::vector<json::JsonMember>{{"$ref", std::move(to)}};
  }
  bool has(const std::string& name) const {
    return std::any_of(members_.begin(), members_.end(),
                       [&](const json::JsonMember& member) { return member.key == name; });
  }
  /// Small things (a text, a pair of numbers) each file says for itself.
  bool has_object(const std::string& name) const {
    return std::any_of(members_.begin(), members_.end(), [&](const json::JsonMember& member) {
      return member.key == name && member.value.find("properties") != nullptr;
    });
  }

  std::vector<json::JsonMember> members_;
  const Definitions* others_ = nullptr;
  std::string file_;
};

/// `schema` with a meaning first, in place of the one that it may have.
inline json::JsonValue described(const char* meaning, const json::JsonValue& schema) {
  if (*meaning == '\0') return schema;
  std::vector<json::JsonMember> members{{"description", std::string(meaning)}};
  for (const json::JsonMember& member : *schema.object())
    if (member.key != "description") members.push_back(member);
  return members;
}

inline json::JsonValue number_schema(const char* type, Range range) {
  std::vector<json::JsonMember> members{{"type", std::string(type)}};
  if (range.least != kAnything.least) members.push_back({"minimum", range.least});
  if (range.most != kAnything.most) members.push_back({"maximum", range.most});
  return members;
}

inline json::JsonValue list_schema(json::JsonValue items, Range count) {
  std::vector<json::JsonMember> members{{"type", std::string("array")}};
  if (count.least > 0) members.push_back({"minItems", count.least});
  if (count.most != kAnything.most) members.push_back({"maxItems", count.most});
  members.push_back({"items", std::move(items)});
  return members;
}

/// The schema of a value's type. The value itself says nothing; it stands here to choose among the overloads.
inline json::JsonValue schema_of(const bool&, Range, Definitions&) {
  return std::vector<json::JsonMember>{{"type", std::string("boolean")}};
}
inline json::JsonValue schema_of(const int&, Range range, Definitions&) {
  return number_schema("integer", range);
}
inline json::JsonValue schema_of(const double&, Range range, Definitions& definitions) {
  const auto make = [&] { return number_schema("number", range); };
  return *range.name == '\0' ? make() : definitions.refer(range.name, make);
}

inline json::JsonValue bounded_text(const char* meaning) {
  return described(meaning, std::vector<json::JsonMember>{{"type", std::string("string")},
                                                          {"minLength", 1.0},
                                                          {"maxLength", static_cast<double>(kLongestText)}});
}
inline json::JsonValue schema_of(const std::string&, Range, Definitions& definitions) {
  return definitions.refer("text", [] { return bounded_text(""); });
}

/// `count` numbers of the range; where that has a name, lists of them have one too.
inline json::JsonValue numbers_schema(double count, Range range, Definitions& definitions, const char* name,
                                      const char* meaning) {
  const auto make = [&](const char* said) {
    return described(said, list_schema(schema_of(0.0, range, definitions), {count, count}));
  };
  return *range.name == '\0' ? make("") : definitions.refer(name, [&] { return make(meaning); });
}
inline json::JsonValue schema_of(const Vec2&, Range range, Definitions& definitions) {
  return numbers_schema(2, range, definitions, "pair",
                        "Two numbers, x and y (or x and z where the key says so).");
}
inline json::JsonValue schema_of(const Vec3&, Range range, Definitions& definitions) {
  return numbers_schema(3, range, definitions, "triple", "Three numbers, x, y and z.");
}

inline json::JsonValue schema_of(const std::vector<std::pair<std::string, std::string>>&, Range,
                                 Definitions& definitions) {
  return std::vector<json::JsonMember>{
      {"type", std::string("object")},
      {"additionalProperties", schema_of(std::string(), kAnything, definitions)}};
}

template <typename T>
json::JsonValue schema_of(const T&, Range, Definitions&);

template <typename T, std::size_t N>
json::JsonValue schema_of(const std::array<T, N>&, Range range, Definitions& definitions) {
  const auto n = static_cast<double>(N);
  return list_schema(schema_of(T{}, range, definitions), {n, n});
}

template <typename T>
json::JsonValue schema_of(const std::vector<T>&, Range count, Definitions& definitions) {
  const ElementRule& rule = kElement<T>;
  return list_schema(described(rule.meaning, schema_of(T{}, rule.range, definitions)), count);
}

template <typename T>
json::JsonValue schema_of(const std::optional<T>&, Range range, Definitions& definitions) {
  return schema_of(T{}, range, definitions);
}

/// Visitor that writes the schema of one object.
class SchemaWriter {
 public:
  explicit SchemaWriter(Definitions& definitions) : definitions_(definitions) {}

  void object(const char*, const char* meaning) { meaning_ = meaning; }

  template <typename T>
  void field(std::string_view key, T& value, const char* meaning, Need need = Need::kOptional,
             Range range = kAnything) {
    add(key, described(meaning, schema_of(std::as_const(value), range, definitions_)), need);
  }
  void file(std::string_view key, std::string&, const char* meaning, Need need = Need::kOptional) {
    const json::JsonValue schema = definitions_.refer("file", [] {
      return bounded_text(
          "A file in the document's folder or below it, with '/' between folders. Absolute paths and '..' "
          "are "
          "refused.");
    });
    add(key, described(meaning, schema), need);
  }
  void choice(std::string_view key, std::string&, const char* meaning, Words words,
              Need need = Need::kOptional) {
    add(key, described(meaning, choice_schema(words)), need);
  }
  void shared_choice(const char* name, const char* meaning, std::string_view key, std::string&, Words words) {
    add(key, definitions_.refer(name, [&] { return described(meaning, choice_schema(words)); }),
        Need::kOptional);
  }
  void chosen_names(std::string_view key, ChosenNames&, const char* meaning, Words words) {
    const std::vector<json::JsonMember> schema{{"type", std::string("object")},
                                               {"maxProperties", static_cast<double>(kMostNames)},
                                               {"additionalProperties", choice_schema(words)}};
    add(key, described(meaning, schema), Need::kOptional);
  }
  template <typename... Keys>
  void exactly_one(Keys... keys) {
    for (const char* key : {keys...}) {
      std::vector<json::JsonValue> required{std::string(key)};
      one_of_.push_back(std::vector<json::JsonMember>{{"required", std::move(required)}});
    }
  }
  void unless(std::string_view other, Words keys) {
    std::vector<json::JsonValue> instead{std::string(other)}, those;
    for (const char* key : keys) those.emplace_back(std::string(key));
    any_of_ = {std::vector<json::JsonMember>{{"required", std::move(instead)}},
               std::vector<json::JsonMember>{{"required", std::move(those)}}};
  }
  /// A key that says which kind of object this is.
  void constant(std::string_view key, const char* meaning, const char* value) {
    add(key, described(meaning, std::vector<json::JsonMember>{{"const", std::string(value)}}),
        Need::kRequired);
  }

  /// The object's schema.
  json::JsonValue schema() const {
    std::vector<json::JsonMember> members{{"type", std::string("object")}, {"additionalProperties", false}};
    if (!required_.empty()) members.push_back({"required", required_});
    if (!one_of_.empty()) members.push_back({"oneOf", one_of_});
    if (!any_of_.empty()) members.push_back({"anyOf", any_of_});
    members.push_back({"properties", properties_});
    return described(meaning_, members);
  }

 private:
  static json::JsonValue choice_schema(Words words) {
    std::vector<json::JsonValue> list;
    for (const char* word : words) list.emplace_back(std::string(word));
    return std::vector<json::JsonMember>{{"type", std::string("string")}, {"enum", std::move(list)}};
  }
  void add(std::string_view key, json::JsonValue schema, Need need) {
    properties_.push_back({std::string(key), std::move(schema)});
    if (need == Need::kRequired) required_.emplace_back(std::string(key));
  }

  Definitions& definitions_;
  const char* meaning_ = "";
  std::vector<json::JsonValue> required_, one_of_, any_of_;
  std::vector<json::JsonMember> properties_;
};

/// Visitor that asks for an object's name only.
struct ObjectName {
  std::string name;

  void object(const char* given, const char*) { name = given; }
  template <typename... Said>
  void field(Said&&...) {}
  template <typename... Said>
  void file(Said&&...) {}
  void choice(std::string_view, std::string&, const char*, Words, Need = Need::kOptional) {}
  void shared_choice(const char*, const char*, std::string_view, std::string&, Words) {}
  void chosen_names(std::string_view, ChosenNames&, const char*, Words) {}
  template <typename... Keys>
  void exactly_one(Keys...) {}
  void unless(std::string_view, Words) {}
};

/// An object with fields of its own.
template <typename T>
json::JsonValue schema_of(const T&, Range, Definitions& definitions) {
  T object{};
  ObjectName named;
  describe(named, object);
  const auto make = [&] {
    SchemaWriter writer(definitions);
    describe(writer, object);
    return writer.schema();
  };
  return named.name.empty() ? make() : definitions.refer(named.name, make);
}

/// A schema file: its head, then the schema, then what it refers to.
inline json::JsonValue schema_file(const char* title, const char* meaning, const json::JsonValue& schema,
                                   const Definitions& definitions) {
  std::vector<json::JsonMember> members{
      {"$schema", std::string("https://json-schema.org/draft/2020-12/schema")},
      {"title", std::string(title)}};
  const json::JsonValue body = described(meaning, schema);
  members.insert(members.end(), body.object()->begin(), body.object()->end());
  if (!definitions.members().empty()) members.push_back({"$defs", definitions.members()});
  return members;
}

}  // namespace toile::fields
