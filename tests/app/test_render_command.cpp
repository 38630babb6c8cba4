#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "core/base/read_file.h"
#include "core/exports/map_file.h"
#include "core/image/read_picture.h"
#include "server/movie/film_codec.h"
#include "tests/app/program.h"
#include "tests/server/movie/napkin_film.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

class RenderCommand : public testing::Test {
 protected:
  void SetUp() override {
    folder = fresh_folder("toile_render_command");
    write_text(folder / movie::kFilmFile, movie::encode_film(film));
    write_maps({{analysis::MapKind::kWarp, {-9, -9, 9, 9}}});
  }
  void TearDown() override { fs::remove_all(folder); }

  void write_maps(const std::vector<analysis::ClothMap>& maps) const {
    write_text(folder / exports::kMapFile, exports::write_maps(film.garment, {"napkin"}, maps));
  }
  Ran rendered(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"render", folder, "--out", folder / "still.png", "--size", "400x320"};
    words.insert(words.end(), more.begin(), more.end());
    return run_toile(words);
  }
  image::Picture still() const {
    return image::read_picture(read_file(folder / "still.png").value()).value().picture;
  }

  movie::Film film = test::napkin_film();
  fs::path folder;
};

/// Pixels that are as red or as blue as the ends of a map's scale are, in the light of a studio.
int count_of(const image::Picture& picture, std::size_t most, std::size_t least) {
  int count = 0;
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
    count += picture.rgba[i + most] > picture.rgba[i + least] + 60 ? 1 : 0;
  return count;
}

TEST_F(RenderCommand, TakesAStillOfTheSizeThatWasAskedFor) {
  const Ran run = rendered();
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(still().width, 400);
  EXPECT_EQ(still().height, 320);
}

TEST_F(RenderCommand, ColoursTheClothByAMapAndSaysWhatTheColoursAre) {
  ASSERT_EQ(rendered().code, 0);
  const image::Picture plain = still();
  ASSERT_EQ(rendered({"--map", "warp"}).code, 0);
  const image::Picture map = still();
  EXPECT_EQ(count_of(plain, 2, 0), 0) << "the napkin is red";
  EXPECT_GT(count_of(map, 2, 0), 500) << "half of it is pushed together";
  EXPECT_GT(count_of(map, 0, 2), 500) << "half of it is stretched";
  const auto at = [](const image::Picture& picture, int x, int y) {
    return picture.rgba[4 * static_cast<std::size_t>(y * picture.width + x)];
  };
  EXPECT_EQ(at(map, 18, 300), 0x2b) << "the first colour of the legend";
  EXPECT_NE(at(plain, 18, 300), 0x2b);
}

TEST_F(RenderCommand, SaysWhyThereIsNoMap) {
  Ran run = rendered({"--map", "pressure"});
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.err.find("map.absent"), std::string::npos) << run.err;
  run = rendered({"--map", "stress"});
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.err.find("curvature"), std::string::npos) << "what there is: " << run.err;
  write_maps({{analysis::MapKind::kWarp, {1, 2, 3}}});
  EXPECT_NE(rendered({"--map", "warp"}).err.find("map.other_drape"), std::string::npos);
  write_text(folder / exports::kMapFile, "{");
  EXPECT_NE(rendered({"--map", "warp"}).err.find("map.damaged"), std::string::npos);
  fs::remove(folder / exports::kMapFile);
  EXPECT_NE(rendered({"--map", "warp"}).err.find("usage.map"), std::string::npos);
}

}  // namespace
}  // namespace toile
