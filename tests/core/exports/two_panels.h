#pragma once
// A garment of two square pieces sewn along one side, for tests of what is taken out.

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/drape/drape_input.h"
#include "core/drape/drape_result.h"

namespace toile {

struct TwoPanels {
  sewing::GarmentMesh garment;
  std::vector<Vec3> positions;  // folded by a right angle along the seam
  std::vector<material::Fabric> fabrics{2};
  std::vector<Index> fabric_of_panel{1, 0};
  std::vector<std::string> names{"front", "back"};
};

inline TwoPanels two_panels() {
  TwoPanels t;
  // Both pieces lie on top of each other in their own frames.
  t.garment.rest = {{0, 0}, {0.1, 0}, {0.1, 0.2}, {0, 0.2}, {0, 0}, {0.1, 0}, {0.1, 0.2}, {0, 0.2}};
  t.garment.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  t.garment.panel_of_vertex = {0, 0, 0, 0, 1, 1, 1, 1};
  t.garment.panel_of_triangle = {0, 0, 1, 1};
  t.garment.first_vertex = {0, 4, 8};
  t.garment.sewn = {{1, 4}, {2, 7}};
  t.garment.weld = {0, 1, 2, 3, 1, 5, 6, 2};
  t.positions = {{0, 1, 0},   {0.1, 1, 0},    {0.1, 1.2, 0},    {0, 1.2, 0},
                 {0.1, 1, 0}, {0.1, 1, -0.1}, {0.1, 1.2, -0.1}, {0.1, 1.2, 0}};
  t.fabrics[0].id = "linen";
  t.fabrics[0].colour[0] = 0.25;
  t.fabrics[1].id = "wool";
  t.fabrics[1].colour[0] = 0.75;
  return t;
}

/// A tetrahedron.
inline body::Body small_body(const std::string& id) {
  return {id, {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}}};
}

inline std::string file_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A folder of its own for a test, gone after it.
class ExportTest : public testing::Test {
 protected:
  ExportTest() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    directory_ = std::filesystem::path(testing::TempDir()) /
                 (std::string(info->test_suite_name()) + info->name() + std::to_string(::getpid()));
    std::filesystem::remove_all(directory_);
    std::filesystem::create_directories(directory_);
  }
  ~ExportTest() override { std::filesystem::remove_all(directory_); }
  std::filesystem::path directory_;
};

}  // namespace toile
