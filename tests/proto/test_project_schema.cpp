// The schema and the reader say the same: the schema's keys, types, ranges and words, written out flat, are
// those that the reader lists.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>

#include "proto/cpp/json_codec.h"
#include "proto/cpp/project.h"
#include "tests/proto/documents.h"

namespace toile {
namespace {

std::string file_text(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Flattens a schema of objects, lists, references and plain values to the form of project_keys.
class SchemaKeys {
 public:
  explicit SchemaKeys(const JsonValue& root) : root_(root) { walk(root, "", false); }

  std::map<std::string, ProjectKey> keys;
  std::vector<std::string> complaints;

 private:
  const JsonValue& resolved(const JsonValue& schema) const {
    const JsonValue* reference = schema.find("$ref");
    if (!reference) return schema;
    const JsonValue* target = root_.find("$defs")->find(reference->text()->substr(8));  // after "#/$defs/"
    return resolved(*target);
  }

  void walk(const JsonValue& given, const std::string& path, bool required) {
    const JsonValue& schema = resolved(given);
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
    ProjectKey key{path, type, required, {}, {}, {}};
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

  const JsonValue& root_;
};

class ProjectSchema : public testing::Test {
 protected:
  void SetUp() override {
    Result<JsonValue> parsed =
        parse_json(file_text(std::string(TOILE_SOURCE_DIR) + "/proto/schema/project.schema.json"));
    ASSERT_TRUE(parsed) << to_string(parsed.error());
    schema = std::move(*parsed);
  }
  JsonValue schema;
};

TEST_F(ProjectSchema, DescribesAndClosesEveryObject) {
  const SchemaKeys listed(schema);
  EXPECT_TRUE(listed.complaints.empty()) << listed.complaints.front();
}

TEST_F(ProjectSchema, HasTheKeysThatTheReaderKnows) {
  const SchemaKeys listed(schema);
  std::size_t known = 0;
  for (const ProjectKey& key : project_keys()) {
    const auto found = listed.keys.find(key.path);
    ASSERT_NE(found, listed.keys.end()) << key.path << " is not in the schema";
    EXPECT_EQ(key.type, found->second.type) << key.path;
    EXPECT_EQ(key.required, found->second.required) << key.path;
    EXPECT_EQ(key.minimum, found->second.minimum) << key.path;
    EXPECT_EQ(key.maximum, found->second.maximum) << key.path;
    EXPECT_EQ(key.choices, found->second.choices) << key.path;
    ++known;
  }
  EXPECT_EQ(known, listed.keys.size()) << "the schema has keys that the reader does not know";
}

/// Every path of the full document, with list elements as "*".
void paths_of(const JsonValue& value, const std::string& path, std::map<std::string, bool>& seen) {
  seen[path] = true;
  if (const auto* elements = value.array()) {
    for (const JsonValue& element : *elements) paths_of(element, path + "/*", seen);
  }
  if (const auto* members = value.object()) {
    for (const JsonMember& member : *members) paths_of(member.value, path + "/" + member.key, seen);
  }
}

TEST_F(ProjectSchema, HasNoKeyThatTheReaderWouldRefuse) {
  ASSERT_TRUE(parse_project(kFullDocument));
  std::map<std::string, bool> seen;
  paths_of(*parse_json(kFullDocument), "", seen);
  for (const auto& [path, key] : SchemaKeys(schema).keys) {
    EXPECT_TRUE(seen.contains(path)) << path << " does not stand in the full document of the tests";
  }
}

}  // namespace
}  // namespace toile
