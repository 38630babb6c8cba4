// The schema is made of the fields by which the reader reads, and says of each what it means.

#include "core/project/schema.h"

#include <gtest/gtest.h>

#include <set>

#include "core/project/project.h"
#include "tests/core/project/documents.h"
#include "tests/proto/schemas/kept_schema.h"

namespace toile {
namespace {

TEST(ProjectSchema, IsKeptAsTheFieldsSayIt) {
  test::expect_kept("project.schema.json", project::project_schema());
}

/// Every path of the full document, with list elements as "*".
void paths_of(const json::JsonValue& value, const std::string& path, std::set<std::string>& seen) {
  seen.insert(path);
  if (const auto* elements = value.array()) {
    for (const json::JsonValue& element : *elements) paths_of(element, path + "/*", seen);
  }
  if (const auto* members = value.object()) {
    for (const json::JsonMember& member : *members) paths_of(member.value, path + "/" + member.key, seen);
  }
}

/// Goes through a schema of objects and lists, and notes its paths and what of them says nothing of itself.
struct Walk {
  const json::JsonValue& root;
  std::set<std::string> paths = {}, silent = {};

  void over(const json::JsonValue& given, const std::string& path) {
    paths.insert(path);
    const json::JsonValue& schema = test::resolved(root, given);
    const bool says = given.find("description") || schema.find("description");
    if (!says && !path.ends_with("*")) silent.insert(path);
    if (const json::JsonValue* items = schema.find("items")) over(*items, path + "/*");
    const json::JsonValue* properties = schema.find("properties");
    if (!properties) return;
    for (const json::JsonMember& member : *properties->object()) over(member.value, path + "/" + member.key);
  }
};

TEST(ProjectSchema, SaysOfEveryKeyWhatItMeans) {
  const json::JsonValue schema = project::project_schema();
  ASSERT_TRUE(json::parse_json(json::write_json(schema))) << "a key stands twice";
  Walk walk{schema};
  walk.over(schema, "");
  EXPECT_TRUE(walk.silent.empty()) << *walk.silent.begin();
}

TEST(ProjectSchema, HasNoKeyThatTheReaderWouldRefuse) {
  ASSERT_TRUE(project::parse_project(kFullDocument));
  std::set<std::string> seen;
  paths_of(*json::parse_json(kFullDocument), "", seen);
  const json::JsonValue schema = project::project_schema();
  Walk walk{schema};
  walk.over(schema, "");
  for (const std::string& path : walk.paths) {
    EXPECT_TRUE(seen.contains(path)) << path << " does not stand in the full document of the tests";
  }
}

TEST(ProjectSchema, SaysRangesWordsAndWhatMustStandThere) {
  const json::JsonValue schema = project::project_schema();
  const json::JsonValue& settings = *schema.find("$defs")->find("settings")->find("properties");
  EXPECT_EQ(
      json::write_json_line(*settings.find("gravity")),
      R"({"description": "m/s², downwards. Default 9.81.", "type": "number", "minimum": 0, "maximum": 1000})");
  EXPECT_EQ(json::write_json_line(*settings.find("end")->find("enum")), R"(["settled", "time"])");
  const json::JsonValue& body = *schema.find("$defs")->find("body");
  EXPECT_EQ(json::write_json_line(*body.find("required")), R"(["id"])");
  EXPECT_EQ(json::write_json_line(*body.find("oneOf")),
            R"([{"required": ["file"]}, {"required": ["mannequin"]}])");
  EXPECT_EQ(json::write_json_line(*body.find("additionalProperties")), "false");
}

}  // namespace
}  // namespace toile
