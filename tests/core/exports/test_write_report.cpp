#include "core/exports/write_report.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/proto/schemas/kept_schema.h"

namespace toile::exports {
namespace {

TEST(ReportSchema, IsKeptAsTheFieldsSayIt) { test::expect_kept("report.schema.json", report_schema()); }

TEST(WriteReport, KeepsTheLayoutThatProgramsReadByLine) {
  analysis::Report report;
  report.name = "a \"skirt\"";
  report.steps = 3;
  report.simulated_s = 2;
  report.rms_speed = 1e-5;
  report.attachments = {{"hold", true, 1.5, 0.25}, {"", false, 0, 0}};
  const std::string text = report_json(report);
  EXPECT_TRUE(text.starts_with("{\n  \"name\": \"a \\\"skirt\\\"\",\n  \"settled\": ")) << text;
  EXPECT_NE(text.find("\n  \"steps\": 3,\n  \"simulated_s\": 2.0,\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\n  \"rms_speed\": 1e-05,\n"), std::string::npos) << text;
  EXPECT_NE(
      text.find("      \"off_mm\": 0.25,\n      \"released_s\": 1.5\n    },\n    {\n      \"id\": \"\",\n"
                "      \"released\": false,\n      \"off_mm\": 0.0\n    }\n  ],\n"),
      std::string::npos)
      << "what holds still has no time of release: " << text;
  EXPECT_NE(text.find("\n  \"findings\": [],\n"), std::string::npos) << text;
}

TEST(WriteReport, NamesWhatAFindingIsAboutApartFromTheWords) {
  analysis::Report report;
  report.findings = {
      preflight::found(preflight::FindingKind::kShortEdge, "short",
                       {preflight::piece_named("front, left"), preflight::edge_named("e3")}, {}),
      preflight::found(preflight::FindingKind::kThreadThroughBody, "through",
                       {preflight::seam_named("side"), preflight::body_named("woman")}, {})};
  const json::JsonValue written = json::parse_json(report_json(report)).value();
  const std::vector<json::JsonValue>& findings = *written.find("findings")->array();
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(json::write_json_line(*findings[0].find("about")),
            R"([{"thing": "piece", "id": "front, left"}, {"thing": "edge", "id": "e3"}])");
  EXPECT_EQ(json::write_json_line(*findings[1].find("about")),
            R"([{"thing": "seam", "id": "side"}, {"thing": "body", "id": "woman"}])");
}

TEST(WriteReport, WritesEveryKeyThatTheSchemaWants) {
  const json::JsonValue written = json::parse_json(report_json({})).value();
  const json::JsonValue schema = report_schema();
  for (const json::JsonValue& key : *schema.find("required")->array()) {
    EXPECT_NE(written.find(*key.text()), nullptr) << *key.text();
  }
  for (const json::JsonMember& member : *written.object()) {
    EXPECT_NE(schema.find("properties")->find(member.key), nullptr) << member.key;
  }
}

}  // namespace
}  // namespace toile::exports
