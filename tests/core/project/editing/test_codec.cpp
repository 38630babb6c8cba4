// Every edit as JSON, and its schema.

#include <gtest/gtest.h>

#include <set>

#include "core/project/editing/edits.h"
#include "tests/core/project/editing/every_edit.h"
#include "tests/proto/schemas/kept_schema.h"

namespace toile {
namespace {

TEST(EditCodec, WritesEveryEditAsItWasRead) {
  const json::JsonValue list = json::parse_json(kEveryEdit).value();
  const Result<std::vector<editing::ProjectEdit>> edits = editing::read_edits(list, "/edits");
  ASSERT_TRUE(edits) << to_string(edits.error());
  EXPECT_EQ(json::write_json(editing::edits_json(*edits)), json::write_json(list));
}

TEST(EditCodec, TriesEveryEditThatThereIs) {
  const std::vector<std::string> names = editing::edit_names();
  std::set<std::string> tried;
  const json::JsonValue list = json::parse_json(kEveryEdit).value();
  for (const json::JsonValue& edit : *list.array()) tried.insert(*edit.find("edit")->text());
  EXPECT_EQ(tried, std::set<std::string>(names.begin(), names.end()));
  EXPECT_EQ(tried.size(), list.array()->size());
}

TEST(EditSchema, IsKeptAsTheFieldsSayIt) { test::expect_kept("edit.schema.json", editing::edit_schema()); }

TEST(EditSchema, DefinesEveryEditUnderItsName) {
  const json::JsonValue schema = editing::edit_schema();
  std::vector<std::string> listed;
  for (const json::JsonValue& one : *schema.find("items")->find("oneOf")->array()) {
    const json::JsonValue& edit = test::resolved(schema, one);
    listed.push_back(*edit.find("properties")->find("edit")->find("const")->text());
    EXPECT_NE(edit.find("description"), nullptr) << listed.back();
  }
  EXPECT_EQ(listed, editing::edit_names());
}

TEST(EditSchema, SendsToTheProjectsSchemaForItsObjects) {
  const json::JsonValue schema = editing::edit_schema();
  const json::JsonValue& hole = *schema.find("$defs")->find("add_hole")->find("properties")->find("edges");
  EXPECT_EQ(*hole.find("items")->find("$ref")->text(), "project.schema.json#/$defs/edge");
  EXPECT_EQ(schema.find("$defs")->find("edge"), nullptr);
}

}  // namespace
}  // namespace toile
