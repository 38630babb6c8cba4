#include "core/manifest/touch_log.h"

#include <gtest/gtest.h>

#include "tests/proto/schemas/kept_schema.h"

namespace toile::manifest {
namespace {

using drape::Touch;
using drape::TouchKind;

std::vector<Touch> touches() {
  return {{12, TouchKind::kPin, 1, {7, {0.1, 0.2, 0.7}}, {}},
          {40, TouchKind::kPull, 3, {0, {1.0 / 3, 1.0 / 3, 1.0 / 3}}, {0.1, 1e-17, -1.0 / 7}},
          {41, TouchKind::kPull, 3, {}, {0.2, 0, 0}},
          {99, TouchKind::kLetGo, 3, {}, {}},
          {99, TouchKind::kUnpin, 1, {}, {}}};
}

TEST(TouchLog, ReadsBackToTheBit) {
  const std::string text = write_touch_log(touches());
  const auto read = parse_touch_log(text);
  ASSERT_TRUE(read) << read.error().message << read.error().where;
  EXPECT_EQ(*read, touches());
  EXPECT_EQ(write_touch_log(*read), text);
}

TEST(TouchLog, SaysWhereItIsDamaged) {
  const std::string text = write_touch_log(touches());
  const auto changed = [&](const std::string& what, const std::string& to) {
    std::string broken = text;
    broken.replace(broken.find(what), what.size(), to);
    const auto read = parse_touch_log(broken);
    return read ? std::string("read") : read.error().code + " " + read.error().where;
  };
  EXPECT_EQ(changed("\"unpin\"", "\"unplug\""), "log.damaged /touches/4/touch");
  EXPECT_EQ(changed("\"step\": 12", "\"step\": -1"), "log.damaged /touches/0/step");
  EXPECT_EQ(changed("\"step\": 12", "\"stop\": 12"), "log.damaged /touches/0/stop");
  EXPECT_EQ(changed("0.7", "7"), "log.damaged /touches/0/shares/2");
  EXPECT_EQ(changed("\"toile_drape_log\": 1", "\"toile_drape_log\": 2"), "log.damaged /toile_drape_log");
  EXPECT_EQ(parse_touch_log(text.substr(0, text.size() / 2)).error().code, "log.damaged");
  EXPECT_EQ(parse_touch_log("").error().code, "log.damaged");
}

TEST(TouchLogSchema, IsKeptAsTheFieldsSayIt) {
  test::expect_kept("drape_log.schema.json", touch_log_schema());
}

}  // namespace
}  // namespace toile::manifest
