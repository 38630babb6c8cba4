#include "server/log/log_line.h"

#include <gtest/gtest.h>

#include "core/json/tree.h"

namespace toile {
namespace {

constexpr auto kMoment = std::chrono::system_clock::time_point(std::chrono::milliseconds(1'795'229'571'007));

TEST(LogText, IsTheEventAndItsFieldsInTheirOrder) {
  EXPECT_EQ(
      log::log_text("job claimed", LogFields{{"owner", "ann"}, {"job", "j_1"}}, LogFields{{"attempt", "2"}}),
      "job claimed owner=ann job=j_1 attempt=2");
}

TEST(LogText, PassesOverWhatIsEmptyAndQuotesWhatIsNoPlainWord) {
  EXPECT_EQ(log::log_text("answered", {}, LogFields{{"where", ""}, {"target", "/a b"}, {"name", "Jäckchen"}}),
            "answered target=\"/a b\" name=\"Jäckchen\"");
}

TEST(LogText, AStrangersWordsForgeNoLine) {
  EXPECT_EQ(log::log_text("answered", {}, LogFields{{"target", "/x\n2026 error \"owner\"=eve\\"}}),
            "answered target=\"/x\\x0a2026 error \\\"owner\\\"=eve\\\\\"");
}

TEST(LogJson, IsOneObjectWithTheMomentTheLevelAndAllFields) {
  EXPECT_EQ(
      log::log_json(kMoment, LogLevel::kWarning, "job claimed", LogFields{{"owner", "ann"}, {"job", "j_1"}},
                    LogFields{{"attempt", "2"}, {"where", ""}}),
      R"({"time": "2026-11-21T02:52:51.007Z", "level": "warning", "event": "job claimed", "owner": "ann", )"
      R"("job": "j_1", "attempt": "2"})");
}

TEST(LogJson, OfAKeyThatStandsTwiceTheLaterValueStays) {
  EXPECT_EQ(
      log::log_json(kMoment, LogLevel::kInfo, "e", LogFields{{"job", "j_1"}}, LogFields{{"job", "j_2"}}),
      R"({"time": "2026-11-21T02:52:51.007Z", "level": "info", "event": "e", "job": "j_2"})");
}

TEST(LogJson, AStrangersWordsForgeNoLineAndAreReadable) {
  const std::string line = log::log_json(kMoment, LogLevel::kInfo, "answered", {},
                                         LogFields{{"target", "/x\n{\"event\": \"\xff\"}"}});
  EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  const Result<json::JsonValue> read = json::parse_json(line);
  ASSERT_TRUE(read) << line;
  EXPECT_TRUE(read->find("target")->text()->starts_with("/x\n{\"event\": \"")) << line;
}

}  // namespace
}  // namespace toile
