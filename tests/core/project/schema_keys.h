#pragma once
// A JSON schema as the flat list of keys that readers give of themselves.

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "core/json/fields/lister.h"
#include "core/json/tree.h"

namespace toile {

inline std::string file_text(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Flattens a schema of objects, lists, references and plain values to the form of project_keys. References
/// lead into the schema itself or into "project.schema.json".
class SchemaKeys {
 public:
  explicit SchemaKeys(const JsonValue& root) : root_(root), project_(root) { walk(root, "", false); }
  /// Of one definition of `root`, as a key of that name.
  SchemaKeys(const JsonValue& root, const JsonValue& project, const std::string& definition)
      : root_(root), project_(project) {
    walk(*root.find("$defs")->find(definition), "/" + definition, false);
    keys.erase("/" + definition);
  }

  std::map<std::string, fields::FieldKey> keys;
  std::vector<std::string> complaints;

 private:
  const JsonValue& resolved(const JsonValue& schema) const {
    const JsonValue* reference = schema.find("$ref");
    if (!reference) return schema;
    const std::string& text = *reference->text();
    const std::string name = text.substr(text.rfind('/') + 1);
    const JsonValue* target = root_.find("$defs")->find(name);
    return resolved(target ? *target : *project_.find("$defs")->find(name));
  }

  void walk(const JsonValue& given, const std::string& path, bool required) {
    const JsonValue& schema = resolved(given);
    if (schema.find("const")) return;  // says which kind of object this is
    const JsonValue* type = schema.find("type");
    if (!type) return complaints.push_back(path + " has no type");
    if (!given.find("description") && !schema.find("description") && !path.ends_with("*")) {
      complaints.push_back(path + " has no description");
    }
    if (!path.empty()) note(schema, path, *type->text(), required);
    if (const JsonValue* items = schema.find("items")) walk(*items, path + "/*", false);
    if (const JsonValue* properties = schema.find("properties")) walk_properties(schema, *properties, path);
  }

  void note(const JsonValue& schema, const std::string& path, const std::string& type, bool required) {
    fields::FieldKey key{path, type, required, {}, {}, {}};
    if (const JsonValue* least = schema.find("minimum")) key.minimum = *least->number();
    if (const JsonValue* most = schema.find("maximum")) key.maximum = *most->number();
    if (const JsonValue* words = schema.find("enum")) {
      for (const JsonValue& word : *words->array()) key.choices.push_back(*word.text());
    }
    keys.emplace(path, key);
  }

  void walk_properties(const JsonValue& schema, const JsonValue& properties, const std::string& path) {
    const JsonValue* closed = schema.find("additionalProperties");
    if (!closed || !closed->boolean() || *closed->boolean()) complaints.push_back(path + " is not closed");
    std::vector<std::string> required;
    if (const JsonValue* list = schema.find("required")) {
      for (const JsonValue& key : *list->array()) required.push_back(*key.text());
    }
    for (const JsonMember& member : *properties.object()) {
      const bool needed = std::find(required.begin(), required.end(), member.key) != required.end();
      walk(member.value, path + "/" + member.key, needed);
    }
  }

  const JsonValue &root_, &project_;
};

}  // namespace toile
