#include "core/exports/write_obj.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "tests/core/exports/two_panels.h"

namespace toile {
namespace {

class WriteObj : public ExportTest {};
class WriteCheckData : public ExportTest {};

/// A reader that knows `v` and `f` only, as a checker has.
struct PlainObj {
  std::vector<Vec3> vertices;
  std::vector<Tri> triangles;
  std::vector<std::string> objects, other;
};

PlainObj read_obj(const std::filesystem::path& path) {
  PlainObj obj;
  std::istringstream lines(file_text(path));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      Vec3 p;
      words >> p.x >> p.y >> p.z;
      obj.vertices.push_back(p);
    } else if (kind == "f") {
      Tri t{};
      words >> t[0] >> t[1] >> t[2];
      obj.triangles.push_back({t[0] - 1, t[1] - 1, t[2] - 1});
    } else {
      (kind == "o" ? obj.objects : obj.other).push_back(line);
    }
  }
  return obj;
}

TEST_F(WriteObj, KeepsNineSignificantDecimalsOfAPosition) {
  const std::vector<Vec3> positions{{0.123456789012, -12.3456789012, 1e-7}, {-0.0, 100, 1.0 / 3}};
  ASSERT_TRUE(exports::write_obj(directory_ / "a.obj", positions, {}).ok());
  EXPECT_EQ(file_text(directory_ / "a.obj"), "v 0.123456789 -12.3456789 1e-07\nv 0 100 0.333333333\n");
}

TEST_F(WriteObj, GroupsTrianglesByPanelInTheOrderOfThePanels) {
  const TwoPanels t = two_panels();
  const std::vector<Index> mixed{1, 0, 1, 0};
  ASSERT_TRUE(
      exports::write_obj(directory_ / "a.obj", t.positions, t.garment.triangles, {{"front", "back"}, mixed})
          .ok());
  const std::string text = file_text(directory_ / "a.obj");
  EXPECT_NE(text.find("o front\nf 1 3 4\nf 5 7 8\no back\nf 1 2 3\nf 5 6 7\n"), std::string::npos) << text;
  EXPECT_EQ(read_obj(directory_ / "a.obj").vertices.size(), t.positions.size());
}

TEST_F(WriteObj, GivesFlatPlacesAsTextureCoordinates) {
  const TwoPanels t = two_panels();
  exports::ObjPanels panels{{"front", "back"}, t.garment.panel_of_triangle, t.garment.rest};
  ASSERT_TRUE(exports::write_obj(directory_ / "a.obj", t.positions, t.garment.triangles, panels).ok());
  const PlainObj obj = read_obj(directory_ / "a.obj");
  EXPECT_EQ(obj.other.size(), t.positions.size()) << "a vt line for each vertex";
  EXPECT_NE(file_text(directory_ / "a.obj").find("o front\nf 1/1 2/2 3/3\n"), std::string::npos);
  panels.rest = panels.rest.first(3);
  const Status status = exports::write_obj(directory_ / "b.obj", t.positions, t.garment.triangles, panels);
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, "export.bad_index");
}

TEST_F(WriteObj, CannotBeBrokenByAPanelsName) {
  const TwoPanels t = two_panels();
  ASSERT_TRUE(exports::write_obj(directory_ / "a.obj", t.positions, t.garment.triangles,
                                 {{"left\nv 9 9 9", ""}, t.garment.panel_of_triangle})
                  .ok());
  const PlainObj obj = read_obj(directory_ / "a.obj");
  EXPECT_EQ(obj.vertices.size(), t.positions.size());
  EXPECT_EQ(obj.objects, (std::vector<std::string>{"o left_v_9_9_9", "o _"}));
}

TEST_F(WriteObj, RefusesAPositionThatIsNotANumberAndWritesNothing) {
  std::vector<Vec3> positions = two_panels().positions;
  positions[5].y = std::numeric_limits<double>::quiet_NaN();
  const Status status = exports::write_obj(directory_ / "a.obj", positions, {});
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, "export.not_finite");
  EXPECT_EQ(status.error().where, "vertex 5");
  EXPECT_TRUE(std::filesystem::is_empty(directory_));
}

TEST_F(WriteObj, RefusesATriangleWithoutItsVertex) {
  const std::vector<Tri> triangles{{0, 1, 2}, {0, 1, 8}};
  const Status status = exports::write_obj(directory_ / "a.obj", two_panels().positions, triangles);
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, "export.bad_index");
  EXPECT_EQ(status.error().where, "triangle 1");
}

TEST_F(WriteObj, RefusesATriangleOfAnUnnamedPanel) {
  const TwoPanels t = two_panels();
  const Status status = exports::write_obj(directory_ / "a.obj", t.positions, t.garment.triangles,
                                           {{"front"}, t.garment.panel_of_triangle});
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, "export.bad_index");
}

TEST_F(WriteObj, SaysWhyTheSystemRefused) {
  const auto path = directory_ / "missing" / "a.obj";
  const Status status = exports::write_obj(path, two_panels().positions, {});
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, "export.write");
  EXPECT_EQ(status.error().where, path.string());
}

TEST_F(WriteCheckData, KeepsVerticesAndTrianglesInOneOrder) {
  const TwoPanels t = two_panels();
  ASSERT_TRUE(exports::write_check_data(directory_ / "new", t.garment, t.positions, {}).ok());
  const PlainObj rest = read_obj(directory_ / "new" / "rest.obj"),
                 end = read_obj(directory_ / "new" / "final.obj");
  EXPECT_EQ(rest.triangles, t.garment.triangles);
  EXPECT_EQ(end.triangles, t.garment.triangles);
  ASSERT_EQ(rest.vertices.size(), t.positions.size());
  EXPECT_EQ(end.vertices, t.positions);
  EXPECT_TRUE(rest.objects.empty() && rest.other.empty() && end.objects.empty() && end.other.empty());
}

TEST_F(WriteCheckData, LaysPiecesFlatSideBySideWithoutOverlap) {
  const TwoPanels t = two_panels();
  ASSERT_TRUE(exports::write_check_data(directory_, t.garment, t.positions, {}).ok());
  const PlainObj rest = read_obj(directory_ / "rest.obj");
  double front_end = -1e9, back_start = 1e9;
  for (int v = 0; v < 8; ++v) {
    EXPECT_EQ(rest.vertices[v].z, 0);
    (v < 4 ? front_end : back_start) =
        v < 4 ? std::max(front_end, rest.vertices[v].x) : std::min(back_start, rest.vertices[v].x);
  }
  EXPECT_LT(front_end, back_start);
  for (const Tri& tri : t.garment.triangles) {  // congruent with the pattern
    for (int i = 0; i < 3; ++i) {
      const Index a = tri[i], b = tri[(i + 1) % 3];
      EXPECT_NEAR(length(rest.vertices[a] - rest.vertices[b]), length(t.garment.rest[a] - t.garment.rest[b]),
                  1e-9);
    }
  }
}

TEST_F(WriteCheckData, JoinsAllBodies) {
  const TwoPanels t = two_panels();
  const std::vector<body::Body> bodies{small_body("a"), small_body("b")};
  ASSERT_TRUE(exports::write_check_data(directory_, t.garment, t.positions, bodies).ok());
  const PlainObj body = read_obj(directory_ / "body.obj");
  EXPECT_EQ(body.vertices.size(), 8u);
  ASSERT_EQ(body.triangles.size(), 8u);
  EXPECT_EQ(body.triangles[4], (Tri{4, 6, 5}));
}

TEST_F(WriteCheckData, ListsSewnPairsAsJson) {
  const TwoPanels t = two_panels();
  ASSERT_TRUE(exports::write_check_data(directory_, t.garment, t.positions, {}).ok());
  std::string text = file_text(directory_ / "sewn.json");
  std::erase_if(text, [](char c) { return std::isspace(static_cast<unsigned char>(c)); });
  EXPECT_EQ(text, "[[1,4],[2,7]]");
  sewing::GarmentMesh unsewn = t.garment;
  unsewn.sewn.clear();
  ASSERT_TRUE(exports::write_check_data(directory_, unsewn, t.positions, {}).ok());
  EXPECT_EQ(file_text(directory_ / "sewn.json"), "[]\n");
}

TEST_F(WriteCheckData, RefusesAGarmentThatDisagreesWithItself) {
  TwoPanels t = two_panels();
  EXPECT_EQ(
      exports::write_check_data(directory_, t.garment, std::span(t.positions).first(7), {}).error().code,
      "export.bad_garment");
  t.garment.panel_of_vertex[3] = 2'000'000'000;
  EXPECT_EQ(exports::write_check_data(directory_, t.garment, t.positions, {}).error().code,
            "export.bad_garment");
  t = two_panels();
  t.garment.sewn[1][0] = -1;
  EXPECT_EQ(exports::write_check_data(directory_, t.garment, t.positions, {}).error().code,
            "export.bad_index");
}

TEST_F(WriteCheckData, SaysWhyTheFolderCannotBeMade) {
  std::ofstream(directory_ / "taken") << "a file";
  const TwoPanels t = two_panels();
  const Status status =
      exports::write_check_data(directory_ / "taken" / "inside", t.garment, t.positions, {});
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, "export.write");
}

}  // namespace
}  // namespace toile
