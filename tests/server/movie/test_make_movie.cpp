#include "server/movie/make_movie.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "core/base/run_child.h"
#include "tests/server/movie/napkin_film.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

class MakeMovie : public testing::Test {
 protected:
  void SetUp() override {
    if (find_program("ffmpeg").empty()) GTEST_SKIP() << "SKIPPED: ffmpeg is not installed";
    folder = fs::path(testing::TempDir()) / ("toile_movie_" + std::to_string(::getpid()));
    fs::create_directories(folder);
  }
  void TearDown() override {
    if (!folder.empty()) fs::remove_all(folder);
  }
  std::string made(const movie::MovieSettings& settings) {
    const fs::path path = folder / "movie";
    const Status done = movie::make_movie(test::napkin_film(), settings, path);
    EXPECT_TRUE(done) << (done ? "" : to_string(done.error()));
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  fs::path folder;
};

const movie::MovieSettings kSmall{.width = 64, .height = 80, .fps = 5};

TEST_F(MakeMovie, WritesMp4WithItsIndexInFrontAndTheSameBytesEachTime) {
  const std::string bytes = made(kSmall);
  EXPECT_EQ(bytes.substr(4, 4), "ftyp");
  ASSERT_NE(bytes.find("moov"), std::string::npos);
  EXPECT_LT(bytes.find("moov"), bytes.find("mdat"));
  EXPECT_EQ(made(kSmall), bytes);
}

TEST_F(MakeMovie, WritesAviWithAsManyPicturesAsItSays) {
  movie::MovieSettings settings = kSmall;
  settings.kind = movie::MovieKind::kTurntable;
  settings.format = movie::VideoFormat::kAvi;
  settings.seconds = 1.2;
  const std::string bytes = made(settings);
  EXPECT_EQ(bytes.substr(0, 4), "RIFF");
  EXPECT_EQ(movie::frames_of(test::napkin_film(), settings), 6);
  const std::size_t header = bytes.find("avih");
  ASSERT_NE(header, std::string::npos);
  EXPECT_EQ(bytes[header + 8 + 16], 6) << "the frames of AVI's main header";
}

TEST_F(MakeMovie, WritesEveryNthPictureAsAStill) {
  movie::MovieSettings settings = kSmall;
  settings.kind = movie::MovieKind::kTurntable;
  settings.seconds = 1;
  settings.stills = folder;
  settings.stills_every = 2;
  made(settings);
  for (const char* name : {"00000.png", "00002.png", "00004.png"}) EXPECT_TRUE(fs::exists(folder / name));
  EXPECT_FALSE(fs::exists(folder / "00001.png"));
}

TEST_F(MakeMovie, EndsWhenItIsCancelled) {
  std::atomic<bool> cancel{false};
  RunContext context;
  context.cancel = &cancel;
  context.on_progress = [&](const Progress& progress) { cancel = progress.fraction > 0.1; };
  const Status made = movie::make_movie(test::napkin_film(), kSmall, folder / "movie", context);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().kind, ErrorKind::kCancelled) << to_string(made.error());
}

TEST_F(MakeMovie, SaysWhichPackageBringsFfmpegWhereThereIsNone) {
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", folder.c_str(), 1);
  const Status made = movie::make_movie(test::napkin_film(), kSmall, folder / "movie");
  ::setenv("PATH", path.c_str(), 1);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, "movie.no_ffmpeg");
  EXPECT_NE(made.error().message.find("Debian's package ffmpeg"), std::string::npos);
}

TEST_F(MakeMovie, IsEndedWhereItHasMoreBytesThanAreAllowed) {
  auto file = movie::VideoFile::open(
      folder / "movie",
      {.format = movie::VideoFormat::kAvi, .width = 64, .height = 80, .frames = 99, .most_bytes = 9000});
  ASSERT_TRUE(file);
  render::Image noise{64, 80, {}};
  unsigned state = 1;
  for (int i = 0; i < 64 * 80 * 3; ++i)
    noise.rgb.push_back(static_cast<std::uint8_t>((state = state * 1664525 + 1013904223) >> 24));
  Status added;
  for (int i = 0; i < 99 && added; ++i) added = (*file)->add(noise);
  if (added) added = (*file)->finish();
  ASSERT_FALSE(added);
  EXPECT_EQ(added.error().code, "movie.too_large") << added.error().message;
  EXPECT_LE(fs::file_size(folder / "movie"), 9000u);
}

TEST(MovieSettings, AreRefusedWithTheOneThatIsWrong) {
  const auto where = [](movie::MovieSettings settings) {
    return movie::check_settings(settings).error().where;
  };
  EXPECT_EQ(where({.width = 721}), "width");
  EXPECT_EQ(where({.height = 62}), "height");
  EXPECT_EQ(where({.fps = 0}), "fps");
  EXPECT_EQ(where({.seconds = 121}), "seconds");
  EXPECT_EQ(movie::movie_kind_from("walk").error().code, "movie.kind");
  EXPECT_EQ(movie::video_format_from("gif").error().code, "movie.format");
}

TEST(MovieOfADrape, NeedsFrames) {
  movie::Film film = test::napkin_film();
  film.motion.frames.clear();
  const Status made = movie::make_movie(film, kSmall, "/nonexistent/movie");
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, "movie.no_motion");
}

TEST(PositionsAt, LieBetweenTheFramesAround) {
  const movie::Motion motion = test::napkin_film().motion;
  EXPECT_NEAR(movie::positions_at(motion, 25 / 3000.0)[0].y, 0.9995, 1e-4);
  EXPECT_NEAR(movie::positions_at(motion, 1e9)[0].y, 0.991, 1e-4);
  EXPECT_NEAR(movie::positions_at(motion, -1)[0].y, 1, 1e-4);
}

}  // namespace
}  // namespace toile
