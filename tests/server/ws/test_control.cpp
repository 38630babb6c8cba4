#include "server/ws/control.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

TEST(Control, ReadsTheThreeCommands) {
  EXPECT_EQ(*ws::parse_control(R"({"type": "pause"})"), ws::Control::kPause);
  EXPECT_EQ(*ws::parse_control(R"({"type":"resume"})"), ws::Control::kResume);
  EXPECT_EQ(*ws::parse_control(R"( {"type":"cancel"} )"), ws::Control::kCancel);
}

TEST(Control, RefusesEverythingElse) {
  for (const char* text : {"", "pause", "{}", "[]", "null", R"({"type": 1})", R"({"type": "Pause"})",
                           R"({"type": )", R"({"type": "pause", "x": [[[[[[1]]]]]]})"}) {
    EXPECT_FALSE(ws::parse_control(text)) << text;
  }
  EXPECT_EQ(ws::parse_control(R"({"type": "fly"})").error().code, "stream.unknown_type");
  EXPECT_EQ(ws::parse_control(R"({"type": "pause", "why": "enough"})").error().code, "stream.unknown_key");
  EXPECT_EQ(ws::parse_control("{").error().code, "json.syntax");
  EXPECT_EQ(ws::parse_control(std::string(5000, ' ')).error().code, "json.too_large");
}

}  // namespace
}  // namespace toile
