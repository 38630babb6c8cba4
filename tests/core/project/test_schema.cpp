// The schema and the reader say the same: the schema's keys, types, ranges and words, written out flat, are
// those that the reader lists.

#include <gtest/gtest.h>

#include <map>

#include "core/json/tree.h"
#include "core/project/keys.h"
#include "core/project/project.h"
#include "tests/core/project/documents.h"
#include "tests/core/project/schema_keys.h"

namespace toile {
namespace {

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
  for (const fields::FieldKey& key : project_keys()) {
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
