#include "core/base/read_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "core/base/write_file.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

TEST(ReadFile, GivesAllBytesBackOrSaysThatItCannot) {
  const fs::path folder = fs::path(testing::TempDir()) / ("toile_read_file_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  const std::string bytes("a\0b\r\n\xff", 6);
  ASSERT_TRUE(write_file(folder / "f", bytes).ok());
  ASSERT_TRUE(write_file(folder / "empty", "").ok());
  EXPECT_EQ(read_file(folder / "f"), bytes);
  EXPECT_EQ(read_file(folder / "empty"), "");
  EXPECT_EQ(read_file(folder / "none"), std::nullopt);
  EXPECT_EQ(read_file(folder), std::nullopt) << "a folder";
  fs::remove_all(folder);
}

}  // namespace
}  // namespace toile
