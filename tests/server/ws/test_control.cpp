#include "server/ws/control.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

using Kind = ws::Control::Kind;
using drape::TouchKind;

TEST(Control, ReadsTheCommandsOfAJob) {
  EXPECT_EQ(ws::parse_control(R"({"type": "pause"})")->kind, Kind::kPause);
  EXPECT_EQ(ws::parse_control(R"({"type":"resume"})")->kind, Kind::kResume);
  EXPECT_EQ(ws::parse_control(R"({"type":"step"})")->kind, Kind::kStep);
  EXPECT_EQ(ws::parse_control(R"( {"type":"cancel"} )")->kind, Kind::kCancel);
}

TEST(Control, ReadsWhatHandsDo) {
  const auto pull =
      ws::parse_control(R"({"type":"pull","epoch":3,"triangle":7,"shares":[0.25,0.25,0.5],"to":[1,-2,0.5]})");
  ASSERT_TRUE(pull);
  EXPECT_EQ(pull->kind, Kind::kTouch);
  EXPECT_EQ(pull->touch.epoch, 3U);
  EXPECT_EQ(pull->touch.touch, (drape::Touch{0, TouchKind::kPull, 0, {7, {0.25, 0.25, 0.5}}, {1, -2, 0.5}}));
  const auto pin = ws::parse_control(R"({"type":"pin","shares":[1,0,0],"triangle":0,"epoch":1})");
  ASSERT_TRUE(pin);
  EXPECT_EQ(pin->touch.touch, (drape::Touch{0, TouchKind::kPin, 0, {0, {1, 0, 0}}, {}}));
  EXPECT_EQ(ws::parse_control(R"({"type":"let_go"})")->touch.touch.kind, TouchKind::kLetGo);
  EXPECT_EQ(ws::parse_control(R"({"type":"unpin","pin":4})")->touch.touch.id, 4);
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

TEST(Control, RefusesHandsThatHoldNothing) {
  const auto refusal = [](const char* text) {
    const auto control = ws::parse_control(text);
    return control ? std::string("read") : control.error().code + " " + control.error().where;
  };
  EXPECT_EQ(refusal(R"({"type":"unpin"})"), "stream.bad_value /pin");
  EXPECT_EQ(refusal(R"({"type":"unpin","pin":0})"), "stream.bad_value /pin");
  EXPECT_EQ(refusal(R"({"type":"unpin","pin":1,"to":[0,0,0]})"), "stream.unknown_key /to");
  EXPECT_EQ(refusal(R"({"type":"pin","triangle":0,"shares":[1,0,0]})"), "stream.bad_value /epoch");
  EXPECT_EQ(refusal(R"({"type":"pin","epoch":1,"triangle":-1,"shares":[1,0,0]})"),
            "stream.bad_value /triangle");
  EXPECT_EQ(refusal(R"({"type":"pin","epoch":1,"triangle":1.5,"shares":[1,0,0]})"),
            "stream.bad_value /triangle");
  EXPECT_EQ(refusal(R"({"type":"pin","epoch":1,"triangle":1e30,"shares":[1,0,0]})"),
            "stream.bad_value /triangle");
  EXPECT_EQ(refusal(R"({"type":"pin","epoch":1,"triangle":1,"shares":[1,0]})"), "stream.bad_value /shares");
  EXPECT_EQ(refusal(R"({"type":"pin","epoch":1,"triangle":1,"shares":[1,0,"0"]})"),
            "stream.bad_value /shares");
  EXPECT_EQ(refusal(R"({"type":"pull","epoch":1,"triangle":1,"shares":[1,0,0]})"), "stream.bad_value /to");
}

}  // namespace
}  // namespace toile
