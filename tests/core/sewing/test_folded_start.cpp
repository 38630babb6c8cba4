#include "core/sewing/folded_start.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "core/sewing/assembly.h"

namespace toile {
namespace {

constexpr int kCells = 6;
constexpr double kCell = 0.01;  // m

/// A square of cells, each cut along its diagonal, with a line from below to above at `column`.
mesh::PanelMesh square_with_line(int column, int rows = kCells) {
  mesh::PanelMesh mesh;
  const auto at = [](int i, int j) { return static_cast<Index>(j * (kCells + 1) + i); };
  for (int j = 0; j <= kCells; ++j)
    for (int i = 0; i <= kCells; ++i) mesh.rest.push_back({i * kCell, j * kCell});
  for (int j = 0; j < kCells; ++j) {
    for (int i = 0; i < kCells; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  std::vector<Index>& line = mesh.line_vertices.emplace_back();
  for (int j = 0; j <= rows; ++j) line.push_back(at(column, j));
  return mesh;
}

const std::vector<bool> kFree((kCells + 1) * (kCells + 1), false);

sewing::Crease crease(double degrees) { return {"roll", 0, {}, {0}, radians_from_degrees(degrees), 0.1}; }

TEST(FoldedStart, TurnsTheSmallerPartAboutTheCreaseByItsAngle) {
  const mesh::PanelMesh mesh = square_with_line(4);
  const sewing::RigidPlacement standing{{0, 1, 0.2}, {}, false};
  for (const double degrees : {-150.0, -180.0, 150.0}) {
    const sewing::PlacedPiece placed = sewing::placed_folded(mesh, standing, {crease(degrees)}, kFree);
    EXPECT_EQ(placed.turned.size(), static_cast<std::size_t>(kCells));
    const double a = radians_from_degrees(degrees);
    for (std::size_t v = 0; v < mesh.rest.size(); ++v) {
      const Vec2 flat = mesh.rest[v];
      const double beyond = std::max(0.0, flat.x - 4 * kCell);
      // Positive: the right side, which faces +z, stays outside, so the part goes behind.
      const Vec3 wanted{std::min(flat.x, 4 * kCell) + beyond * std::cos(a), 1 + flat.y,
                        0.2 - beyond * std::sin(a)};
      EXPECT_LT(length(placed.positions[v] - wanted), 1e-9) << degrees << ", vertex " << v;
    }
  }
}

TEST(FoldedStart, OfAFlippedPieceTheRightSideIsTheOther) {
  const mesh::PanelMesh mesh = square_with_line(4);
  const sewing::PlacedPiece placed =
      sewing::placed_folded(mesh, sewing::RigidPlacement{{}, {}, true}, {crease(-150)}, kFree);
  EXPECT_NEAR(placed.positions[kCells].z, -2 * kCell * std::sin(radians_from_degrees(150)), 1e-9)
      << "what turns to the right side goes behind a piece that shows its wrong side";
}

/// Vertices of the columns from `from` on, rising.
std::vector<Index> columns(int from) {
  std::vector<Index> vertices;
  for (int v = 0; v < (kCells + 1) * (kCells + 1); ++v)
    if (v % (kCells + 1) >= from) vertices.push_back(static_cast<Index>(v));
  return vertices;
}

// A collar of one piece stands up to the crease, and its fall, the larger part, is turned down once it is on.
TEST(FoldedStart, ALargerPartThatHangsFreeIsPressedBackLater) {
  const mesh::PanelMesh mesh = square_with_line(2);
  const sewing::RigidPlacement standing{{0, 1, 0}, {}, false};
  std::vector<bool> sewn = kFree;
  sewn[0] = true;
  const sewing::PlacedPiece collar = sewing::placed_folded(mesh, standing, {crease(-170)}, sewn);
  EXPECT_EQ(collar.positions, sewing::place(mesh.rest, standing));
  EXPECT_TRUE(collar.turned.empty());
  ASSERT_EQ(collar.pressed_back.size(), 1u);
  EXPECT_EQ(collar.pressed_back[0].along, mesh.line_vertices[0]);
  EXPECT_EQ(collar.pressed_back[0].fall, columns(3));

  sewn[kCells] = true;  // as a jacket's collar is sewn to its lapels
  const sewing::PlacedPiece held = sewing::placed_folded(mesh, standing, {crease(-170)}, sewn);
  EXPECT_TRUE(held.pressed_back.empty());
  EXPECT_EQ(held.turned.size(), static_cast<std::size_t>(kCells));
}

TEST(FoldedStart, AlongItsEdgesAPieceIsPressedBackWhole) {
  mesh::PanelMesh mesh = square_with_line(2);
  const std::vector<Index> left{0, 7, 14, 21}, on{21, 28, 35, 42};
  mesh.edge_vertices = {left, on};
  sewing::Crease seam = crease(-170);
  seam.edges = {0, 1};
  seam.lines.clear();
  const auto placed = [&] { return sewing::placed_folded(mesh, sewing::RigidPlacement{}, {seam}, kFree); };
  ASSERT_EQ(placed().pressed_back.size(), 1u);
  EXPECT_EQ(placed().pressed_back[0].along, std::vector<Index>({0, 7, 14, 21, 28, 35, 42}));
  EXPECT_EQ(placed().pressed_back[0].fall, columns(1));
  EXPECT_TRUE(placed().pressed_back[0].up_inside);
  seam.edges = {1, 0};
  EXPECT_TRUE(placed().pressed_back.empty()) << "edges that do not follow one another";
  seam.edges = {0};
  seam.angle = radians_from_degrees(-90);
  EXPECT_TRUE(placed().pressed_back.empty()) << "it is pressed up, and not over";
}

TEST(FoldedStart, LeavesFlatWhatIsPressedLessOrPartsNothing) {
  const sewing::RigidPlacement standing{{0, 1, 0}, {}, false};
  const mesh::PanelMesh across = square_with_line(4), ending = square_with_line(4, kCells / 2);
  const std::vector<Vec3> flat = sewing::place(across.rest, standing);
  for (const auto& [mesh, degrees] : {std::pair(across, 120.0), std::pair(ending, 170.0)}) {
    const sewing::PlacedPiece placed = sewing::placed_folded(mesh, standing, {crease(degrees)}, kFree);
    EXPECT_EQ(placed.positions, flat) << degrees;
    EXPECT_TRUE(placed.turned.empty()) << degrees;
  }
  EXPECT_EQ(sewing::placed_folded(across, standing, {crease(170), crease(-170)}, kFree).positions, flat)
      << "one would lift the other off the piece";
}

TEST(FoldedStart, AGarmentKnowsWhereItsPiecesBeginTurnedOver) {
  const mesh::PanelMesh mesh = square_with_line(4);
  sewing::Notions notions;
  notions.creases = {crease(-170)};
  notions.creases[0].panel = 1;
  const sewing::Assembly a =
      sewing::assemble({{mesh, mesh}, {}},
                       {sewing::RigidPlacement{}, sewing::RigidPlacement{{0, 0, 1}, {}, false}}, {}, notions)
          .value();
  ASSERT_EQ(a.turned.size(), static_cast<std::size_t>(kCells));
  const Index first = a.garment.first_vertex[1];
  EXPECT_GE(a.turned[0][0], first);
  EXPECT_GT(a.positions[first + kCells].z, 1.0) << "turned to the right side";
  EXPECT_NEAR(a.positions[kCells].z, 0, 1e-9) << "the other piece has no crease";
}

}  // namespace
}  // namespace toile
