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
#include "core/pattern/dxf/read.h"
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

  struct Read {
    pattern::Panel panel;
    bool unfolded = false;
    std::size_t turn_points = 0;
  };

  /// The drawing's pieces as panels that validate, by name.
  static std::map<std::string, Read> panels(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    const Result<dxf::DxfDrawing> drawing = dxf::read_dxf(in);
    std::map<std::string, Read> result;
    if (!drawing) {
      ADD_FAILURE() << path << " " << to_string(drawing.error());
      return result;
    }
    expect_whole_report(drawing->report, path);
    const bool inches = path.string().find("inches") != std::string::npos;
    EXPECT_EQ(drawing->unit.name, inches ? "inch" : "mm") << path;
    EXPECT_GT(drawing->unit.confidence, 0.9) << path;
    for (const dxf::DxfPiece& piece : drawing->pieces) {
      const Result<pattern::Panel> panel = dxf::panel_from_piece(piece);
      EXPECT_TRUE(panel) << path << " " << (panel ? "" : to_string(panel.error()));
      if (!panel) continue;
      const Status status = pattern::validate(*panel);
      EXPECT_TRUE(status) << path << " " << (status ? "" : to_string(status.error()));
      // Curves bulge a little beyond the chords of a sampled outline.
      const double drawn = std::abs(geometry::signed_area(piece.outline));
      EXPECT_NEAR(pattern::signed_area(panel->outline), drawn, 0.002 * drawn + 10)
          << path << " " << piece.name;
      expect_few_close_curves(*panel, piece, path);
      result.emplace(piece.name, Read{*panel, piece.unfolded, piece.turn_points.size()});
    }
    EXPECT_EQ(result.size(), drawing->pieces.size());
    return result;
  }

  static void expect_whole_report(const dxf::DxfReport& report, const fs::path& path) {
    EXPECT_EQ(report.records, report.structure + report.elsewhere + report.vertices + report.entities);
    EXPECT_EQ(report.entities, report.kept + report.converted + report.dropped);
    std::ifstream in(path);
    std::size_t zeros = 0;
    std::string code, value;
    while (std::getline(in, code) && std::getline(in, value)) zeros += std::stoi(code) == 0 ? 1 : 0;
    EXPECT_EQ(report.records, zeros) << path << ": the report's sum is the file";
    for (const dxf::DxfEntityGroup& g : report.groups)
      EXPECT_NE(g.reason, "nothing is made of it") << path << " " << g.type << " on layer " << g.layer;
  }

  /// All vertices of the file lie within 0.1 mm of the curves, and these are few.
  static void expect_few_close_curves(const pattern::Panel& panel, const dxf::DxfPiece& piece,
                                      const fs::path& path) {
    const std::vector<Vec2> curves = pattern::flatten(panel.outline, 0.005);
    for (const Vec2 p : piece.outline) {
      double off = length(p - curves[0]);
      for (std::size_t i = 0; i < curves.size(); ++i)
        off = std::min(off, geometry::distance_to_segment(p, curves[i], curves[(i + 1) % curves.size()]));
      ASSERT_LT(off, 0.11) << path << " " << piece.name << " at " << pattern::place_text(p);
    }
    for (const pattern::PanelEdge& edge : panel.outline.edges) {
      std::size_t ends = 0;  // marks within the edge, where curves end as well
      const auto lies_within = [&](Vec2 p) {
        if (length(p - edge.curves.front().p0) < 0.2 || length(p - edge.curves.back().p3) < 0.2) return false;
        const std::vector<Vec2> line = pattern::flatten(edge, 0.01);
        for (std::size_t i = 0; i + 1 < line.size(); ++i)
          if (geometry::distance_to_segment(p, line[i], line[i + 1]) < 0.2) return true;
        return false;
      };
      for (const pattern::Notch& notch : panel.notches) ends += lies_within(notch.at) ? 1 : 0;
      for (const Vec2 turn : piece.turn_points) ends += lies_within(turn) ? 1 : 0;
      EXPECT_LE(edge.curves.size(), 7 + ends) << path << " " << piece.name << " " << edge.id;
      if (piece.name == "sleeve") {
        EXPECT_LE(edge.curves.size(), 6 + ends) << path << ": the cap " << edge.id;
      }
    }
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
    for (const auto& [id, read] : pieces)
      EXPECT_NE(seams.str().find('"' + id + '"'), std::string::npos) << name << " has no panel " << id;
  }
}

/// mm, from the lower left of the panel's box.
std::vector<Vec2> corners_of(const pattern::Panel& panel) {
  const Vec2 low = bounding_box(pattern::flatten(panel.outline, 0.1)).low;
  std::vector<Vec2> corners;
  for (const pattern::PanelEdge& edge : panel.outline.edges) corners.push_back(edge.curves.front().p0 - low);
  return corners;
}

/// Whether edges end in `panel` wherever they do in `other`, and at most twice as often.
bool has_corners_of(const pattern::Panel& panel, const pattern::Panel& other) {
  const std::vector<Vec2> own = corners_of(panel), asked = corners_of(other);
  return own.size() <= 2 * asked.size() && std::all_of(asked.begin(), asked.end(), [&](Vec2 p) {
           return std::any_of(own.begin(), own.end(), [&](Vec2 q) { return length(p - q) < 1; });
         });
}

TEST_F(DxfShared, FreeSewingDrawingsReadAlikeInEveryForm) {
  const std::map<std::string, std::size_t> counts{
      {"brian", 3}, {"jaeger", 17}, {"penelope", 2}, {"teagan", 3}, {"titan", 2}};
  std::map<std::string, std::map<std::string, Read>> first;  // by design and size
  for (const fs::path& folder : {data_ / "freesewing", data_ / "freesewing" / "variants"}) {
    const std::vector<fs::path> files = drawings(folder);
    EXPECT_GE(files.size(), 10u);
    for (const fs::path& path : files) {
      const std::string stem = path.filename().string(), model = stem.substr(0, stem.find('.'));
      const auto pieces = panels(path);
      EXPECT_EQ(pieces.size(), counts.at(model.substr(0, model.find('-')))) << path;
      const auto& reference = first.emplace(model, pieces).first->second;
      for (const auto& [name, read] : pieces) {
        ASSERT_TRUE(reference.contains(name)) << path << " " << name;
        const Read& other = reference.at(name);
        // Only the AAMA files tell where a half is to be unfolded.
        const double area = pattern::signed_area(other.panel.outline) / (other.unfolded ? 2 : 1);
        EXPECT_NEAR(pattern::signed_area(read.panel.outline) / (read.unfolded ? 2 : 1), area, 1e-3 * area)
            << path << " " << name;
        if (read.unfolded != other.unfolded) continue;
        // Turn points, which only AAMA files have, tell blunt corners beside the sharp ones.
        const bool told = read.turn_points > 0, other_told = other.turn_points > 0;
        EXPECT_TRUE(has_corners_of(told ? read.panel : other.panel, told ? other.panel : read.panel))
            << path << " " << name;
        if (told == other_told) {
          EXPECT_EQ(read.panel.outline.edges.size(), other.panel.outline.edges.size()) << path << " " << name;
        }
      }
    }
  }
}

}  // namespace
}  // namespace toile
