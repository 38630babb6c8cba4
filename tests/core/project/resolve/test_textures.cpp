#include "core/project/resolve/textures.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "core/project/resolve/resolve.h"
#include "tests/core/image/pictures.h"

namespace toile {
namespace {

project::Project two_pieces() {
  project::Project project;
  for (const char* id : {"front", "back", "collar"}) {
    project::ProjectPiece piece;
    piece.id = id;
    project.pieces.push_back(piece);
  }
  return project;
}

pattern::Pattern pattern_of(const project::Project& project) {
  pattern::Pattern pattern;
  for (const project::ProjectPiece& piece : project.pieces) {
    pattern.panels.emplace_back();
    pattern.panels.back().id = piece.id;
  }
  return pattern;
}

/// Any file is a wide picture; counts how often one is asked for.
struct Pictures {
  int asked = 0;
  std::string bytes = test::png_of(test::painted(20, 10, [](int, int) { return std::array{9, 9, 9, 255}; }));
  resolve::ProjectFiles files() {
    resolve::ProjectFiles out;
    out.image_bytes = [this](const std::string&) -> Result<std::string> { return ++asked, bytes; };
    return out;
  }
};

TEST(ProjectTextures, ReadEachPictureOnceAndLayItOnEachPiece) {
  project::Project project = two_pieces();
  project.pieces[0].texture = {"a.png", 50, {10, 20}, 90};
  project.pieces[2].texture = {"a.png", 100, {}, 0};
  pattern::Pattern pattern = pattern_of(project);
  pattern.panels[2].grain = {1, 0};
  Pictures pictures;
  const Result<image::Textures> textures = resolve::read_textures(project, pattern, pictures.files());
  ASSERT_TRUE(textures) << to_string(textures.error());
  EXPECT_EQ(pictures.asked, 1);
  ASSERT_EQ(textures->images.size(), 1u);
  EXPECT_EQ(textures->images[0]->name, "a.png");
  EXPECT_EQ(textures->images[0]->bytes, pictures.bytes);
  EXPECT_EQ(image::texture_of(*textures, 1), nullptr);
  // 50 mm wide and 25 high, turned to the left about (10, 20) mm.
  const Vec2 across = image::texture_at(*image::texture_of(*textures, 0), {0.01, 0.07});
  EXPECT_NEAR(across.x, 1, 1e-12);
  EXPECT_NEAR(across.y, 0, 1e-12);
  const Vec2 up = image::texture_at(*image::texture_of(*textures, 0), {0.01 - 0.025, 0.02});
  EXPECT_NEAR(up.x, 0, 1e-12);
  EXPECT_NEAR(up.y, 1, 1e-12);
  EXPECT_NEAR(image::texture_at(*image::texture_of(*textures, 2), {0.05, 0}).y, 1, 1e-12)
      << "along the grain";
}

TEST(ProjectTextures, NameThePlaceOfAPictureThatCannotBeRead) {
  project::Project project = two_pieces();
  project.pieces[1].texture = {"a.png", 50};
  Pictures pictures;
  pictures.bytes = "GIF89a";
  const Result<image::Textures> broken =
      resolve::read_textures(project, pattern_of(project), pictures.files());
  ASSERT_FALSE(broken);
  EXPECT_EQ(broken.error().code, "image.format");
  EXPECT_EQ(broken.error().where, "/pieces/1/texture/image");
  EXPECT_NE(broken.error().message.find("a.png"), std::string::npos);
  EXPECT_EQ(resolve::read_textures(project, pattern_of(project), {}).error().code, "project.file");
}

TEST(ProjectTextures, AreNotManyAndNotLarge) {
  project::Project project;
  for (std::size_t i = 0; i <= resolve::kMostTextureImages; ++i) {
    project.pieces.emplace_back();
    project.pieces.back().texture = {std::to_string(i) + ".png", 50};
  }
  Pictures pictures;
  const Result<image::Textures> many = resolve::read_textures(project, pattern_of(project), pictures.files());
  ASSERT_FALSE(many);
  EXPECT_EQ(many.error().code, "image.too_many");
  EXPECT_EQ(pictures.asked, 0) << "told before any is read";
  project.pieces.resize(4);
  pictures.bytes += std::string((std::size_t{17} << 20), ' ');  // what follows a picture's end is no harm
  EXPECT_EQ(resolve::read_textures(project, pattern_of(project), pictures.files()).error().code,
            "image.too_many");
}

TEST(ProjectTextures, OfADocumentOnDiskLieBesideIt) {
  const auto folder =
      std::filesystem::path(testing::TempDir()) / ("toile_textures_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder / "cloth");
  std::ofstream(folder / "cloth" / "a.png", std::ios::binary) << Pictures{}.bytes;
  std::ofstream(folder / "project.json") << R"({"toile": 1, "name": "a", "pieces": [{"id": "a", "fabric": "f",
    "outline": [{"id": "e", "points": [[0, 0], [50, 0], [25, 60], [0, 0]]}],
    "texture": {"image": "cloth/a.png", "scale_mm": 30},
    "placement": {"rigid": {"translation": [0, 1, 0], "rotation": [0, 0, 0]}}}], "fabrics": [{"id": "f",
    "areal_mass_g_m2": 150, "stretch_warp_n_m": 2000, "stretch_weft_n_m": 1500, "stretch_shear_n_m": 500,
    "bend_warp_un_m": 10, "bend_weft_un_m": 8, "bend_bias_un_m": 7, "thickness_mm": 0.4}], "seams": [],
    "bodies": []})";
  const Result<resolve::ResolvedProject> read = resolve::read_project(folder / "project.json");
  ASSERT_TRUE(read) << to_string(read.error());
  const Result<image::Textures> textures = resolve::read_textures(*read);
  ASSERT_TRUE(textures) << to_string(textures.error());
  EXPECT_EQ(textures->images[0]->read.width, 20);
  std::filesystem::remove(folder / "cloth" / "a.png");
  const Result<image::Textures> gone = resolve::read_textures(*read);
  ASSERT_FALSE(gone);
  EXPECT_EQ(gone.error().code, "project.file");
  EXPECT_NE(gone.error().where.find("/pieces/0/texture/image"), std::string::npos) << gone.error().where;
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace toile
