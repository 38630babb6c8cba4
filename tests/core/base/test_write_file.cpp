#include "core/base/write_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <iterator>
#include <string>

namespace toile {
namespace {

namespace fs = std::filesystem;

class WriteFile : public testing::Test {
 protected:
  WriteFile()
      : directory_(fs::path(testing::TempDir()) / ("toile_write_file_" + std::to_string(::getpid()))) {
    fs::remove_all(directory_);
    fs::create_directories(directory_);
  }
  ~WriteFile() override { fs::remove_all(directory_); }

  std::ptrdiff_t files() const {
    return std::distance(fs::directory_iterator(directory_), fs::directory_iterator());
  }
  static std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  fs::path directory_;
};

TEST_F(WriteFile, ReplacesAFileWhole) {
  const fs::path path = directory_ / "a.txt";
  ASSERT_TRUE(write_file(path, "a longer first text").ok());
  ASSERT_TRUE(write_file(path, std::string_view("sh\0rt", 5)).ok());
  EXPECT_EQ(read(path), std::string("sh\0rt", 5));
  EXPECT_EQ(files(), 1);
}

TEST_F(WriteFile, NamesThePathAndTheReasonWhenTheFolderIsMissing) {
  const fs::path path = directory_ / "missing" / "a.txt";
  const Status status = write_file(path, "text");
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, "export.write");
  EXPECT_EQ(status.error().where, path.string());
  EXPECT_NE(status.error().message.find("No such file or directory"), std::string::npos);
}

TEST_F(WriteFile, LeavesNothingBehindWhenTheNameIsTakenByAFolder) {
  fs::create_directories(directory_ / "taken" / "inside");
  const Status status = write_file(directory_ / "taken", "text");
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, "export.write");
  EXPECT_EQ(files(), 1);
}

TEST_F(WriteFile, KeepsTheOldFileWhenThereIsNoRoomForTheNew) {
  const fs::path path = directory_ / "a.txt";
  ASSERT_TRUE(write_file(path, "old").ok());
  // A limit on file size stands for a full disk: the write fails half way.
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{4096, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const Status status = write_file(path, std::string(100'000, 'x'));
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);

  ASSERT_FALSE(status.ok());
  EXPECT_NE(status.error().message.find("File too large"), std::string::npos) << status.error().message;
  EXPECT_EQ(read(path), "old");
  EXPECT_EQ(files(), 1);
}

}  // namespace
}  // namespace toile
