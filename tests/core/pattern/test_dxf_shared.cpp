// Real drawings from outside. They are no part of the project: TOILE_SHARED names the folder that holds
// data/garmentcode and data/freesewing; without it these tests are skipped.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "core/geometry/polygon2.h"
#include "core/pattern/curve.h"
#include "core/pattern/dxf_read.h"
#include "core/pattern/validate.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

class DxfShared : public testing::Test {
 protected:
  void SetUp() override {
    const char* shared = std::getenv("TOILE_SHARED");
    if (shared == nullptr) GTEST_SKIP() << "TOILE_SHARED is not set: no outside drawing was read";
    data_ = fs::path(shared) / "data";
    ASSERT_TRUE(fs::is_directory(data_)) << data_;
  }

  static std::vector<fs::path> drawings(const fs::path& folder) {
    std::set<fs::path> found;
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.path().extension() == ".dxf") found.insert(entry.path());
    return {found.begin(), found.end()};
  }

  /// The drawing's pieces as panels that validate, by name.
  static std::map<std::string, Panel> panels(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    const Result<DxfDrawing> drawing = read_dxf(in);
    std::map<std::string, Panel> result;
    if (!drawing) {
      ADD_FAILURE() << path << " " << to_string(drawing.error());
      return result;
    }
    for (const DxfPiece& piece : drawing->pieces) {
      const Result<Panel> panel = panel_from_piece(piece);
      EXPECT_TRUE(panel) << path << " " << (panel ? "" : to_string(panel.error()));
      if (!panel) continue;
      const Status status = validate(*panel);
      EXPECT_TRUE(status) << path << " " << (status ? "" : to_string(status.error()));
      // Curves bulge a little beyond the chords of a sampled outline.
      const double drawn = std::abs(signed_area(piece.outline));
      EXPECT_NEAR(signed_area(panel->outline), drawn, 0.002 * drawn + 10) << path << " " << piece.name;
      result.emplace(piece.name, *panel);
    }
    EXPECT_EQ(result.size(), drawing->pieces.size());
    return result;
  }

  fs::path data_;
};

TEST_F(DxfShared, GarmentCodeDrawingsHaveThePanelsOfTheirStitches) {
  const std::map<std::string, std::size_t> counts{
      {"fitted_blouse_long", 8}, {"hoody", 10}, {"pants", 6}, {"skirt_2panel", 4}, {"tshirt", 8}};
  for (const auto& [name, count] : counts) {
    const auto pieces = panels(data_ / "garmentcode" / (name + ".dxf"));
    EXPECT_EQ(pieces.size(), count) << name;
    std::ifstream in(data_ / "garmentcode" / (name + ".seams.json"));
    std::stringstream seams;
    seams << in.rdbuf();
    for (const auto& [id, panel] : pieces)
      EXPECT_NE(seams.str().find('"' + id + '"'), std::string::npos) << name << " has no panel " << id;
  }
}

TEST_F(DxfShared, FreeSewingDrawingsReadAlikeInEveryForm) {
  const std::map<std::string, std::size_t> counts{
      {"brian", 3}, {"jaeger", 17}, {"penelope", 2}, {"teagan", 3}, {"titan", 2}};
  std::map<std::string, std::map<std::string, Panel>> first;  // by design and size
  for (const fs::path& folder : {data_ / "freesewing", data_ / "freesewing" / "variants"}) {
    const std::vector<fs::path> files = drawings(folder);
    EXPECT_GE(files.size(), 10u);
    for (const fs::path& path : files) {
      const std::string stem = path.filename().string(), model = stem.substr(0, stem.find('.'));
      const auto pieces = panels(path);
      EXPECT_EQ(pieces.size(), counts.at(model.substr(0, model.find('-')))) << path;
      const auto& reference = first.emplace(model, pieces).first->second;
      for (const auto& [name, panel] : pieces) {
        ASSERT_TRUE(reference.contains(name)) << path << " " << name;
        const double area = signed_area(reference.at(name).outline);
        EXPECT_NEAR(signed_area(panel.outline), area, 1e-3 * area) << path << " " << name;
        EXPECT_EQ(panel.outline.edges.size(), reference.at(name).outline.edges.size()) << path << " " << name;
      }
    }
  }
}

}  // namespace
}  // namespace toile
