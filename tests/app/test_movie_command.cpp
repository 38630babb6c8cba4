#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "server/movie/film_codec.h"
#include "tests/app/program.h"
#include "tests/server/movie/napkin_film.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

class MovieCommand : public testing::Test {
 protected:
  void SetUp() override {
    folder = fresh_folder("toile_movie_command");
    write_text(folder / movie::kFilmFile, movie::encode_film(test::napkin_film()));
  }
  Ran made(const std::string& out, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"movie", folder, "--out", folder / out, "--size", "64x80", "--fps", "5"};
    words.insert(words.end(), more.begin(), more.end());
    return run_toile(words);
  }
  static bool has_ffmpeg() { return fs::exists("/usr/bin/ffmpeg"); }

  fs::path folder;
};

TEST_F(MovieCommand, TakesTheFormatOfTheFilesName) {
  if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  ASSERT_EQ(made("a.mp4").code, 0);
  EXPECT_EQ(text_of(folder / "a.mp4").substr(4, 4), "ftyp");
  ASSERT_EQ(made("a.AVI").code, 0);
  EXPECT_EQ(text_of(folder / "a.AVI").substr(0, 4), "RIFF");
  ASSERT_EQ(made("a.film", {"--format", "avi"}).code, 0);
  EXPECT_EQ(text_of(folder / "a.film").substr(0, 4), "RIFF");
}

TEST_F(MovieCommand, RefusesANameThatTellsNoFormat) {
  for (const char* name : {"a.webm", "a", "a.gif"}) {
    const Ran run = made(name);
    EXPECT_NE(run.code, 0);
    EXPECT_NE(run.err.find("movie.format"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find(".mp4"), std::string::npos) << run.err;
    EXPECT_FALSE(fs::exists(folder / name));
  }
}

TEST_F(MovieCommand, RefusesAFilmThatIsCutOff) {
  const std::string whole = text_of(folder / movie::kFilmFile);
  write_text(folder / movie::kFilmFile, whole.substr(0, whole.size() / 2));
  const Ran run = made("a.mp4");
  EXPECT_NE(run.code, 0);
  EXPECT_NE(run.err.find("film.damaged"), std::string::npos) << run.err;
  EXPECT_FALSE(fs::exists(folder / "a.mp4"));
}

}  // namespace
}  // namespace toile
