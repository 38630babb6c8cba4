#include <gtest/gtest.h>

#include "core/geometry/obj_text.h"

namespace toile {
namespace {

TEST(ObjText, WritesAMeshLineByLineWithCornersCountedFromOne) {
  const geometry::TriangleMesh mesh{{{0, -0.0, 1.0 / 3}, {1, 0, 0}, {0, 2e-7, 0}}, {{0, 1, 2}}};
  EXPECT_EQ(geometry::obj_text(mesh, geometry::ObjDigits::kNine),
            "v 0 0 0.333333333\nv 1 0 0\nv 0 2e-07 0\nf 1 2 3\n");
  EXPECT_EQ(geometry::obj_text(mesh, geometry::ObjDigits::kAll),
            "v 0 -0 0.3333333333333333\nv 1 0 0\nv 0 2e-07 0\nf 1 2 3\n");
}

TEST(ObjText, KeepsNamesToOneWord) {
  geometry::ObjText text;
  text.object("left front\n");
  text.texture_place({0.5, 0});
  text.textured_face({0, 1, 2});
  text.object("");
  EXPECT_EQ(text.take(), "o left_front_\nvt 0.5 0\nf 1/1 2/2 3/3\no _\n");
}

}  // namespace
}  // namespace toile
