// How even triangles are over many random outlines, each figure where the outline itself allows it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "core/mesh/quality.h"
#include "core/mesh/topology.h"
#include "core/mesh/triangulate.h"
#include "tests/core/mesh/shapes.h"

namespace toile {
namespace {

constexpr double kStep = 0.015;  // m, the asked distance

struct Outline {
  mesh::Polygon corners;
  mesh::Polygon points;
};

/// 5 to 14 corners around a centre, 15 cm to 60 cm away.
Outline random_outline(std::uint64_t seed) {
  Sequence random(seed);
  const int n = 5 + static_cast<int>(random.next() * 10);
  Outline outline;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * kPi * (i + 0.5 * random.next()) / n, r = 0.15 + 0.45 * random.next();
    outline.corners.push_back({r * std::cos(a), r * std::sin(a)});
  }
  outline.points = sampled(outline.corners, kStep);
  return outline;
}

/// Whether a corner that is sharper than 60° forces the triangles here: as far as it is narrower than two and
/// a half distances.
bool forced(const Outline& o, Vec2 at) {
  const std::size_t n = o.corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 p = o.corners[i], before = o.corners[(i + n - 1) % n] - p, after = o.corners[(i + 1) % n] - p;
    const double angle = std::abs(degrees_from_radians(std::atan2(cross(after, before), dot(after, before))));
    if (angle < 60 && length(at - p) < 2.5 * kStep / (2 * std::sin(radians_from_degrees(angle) / 2)))
      return true;
  }
  return false;
}

TEST(TriangleFigures, OfRandomOutlinesAreAsEvenAsAsked) {
  int angles = 0, wide = 0, edges = 0, even = 0, inverted = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const Outline outline = random_outline(seed);
    const std::vector<mesh::Polygon> loops{outline.points};
    const Result<mesh::FlatMesh> mesh = mesh::triangulate(loops, kStep, {});
    ASSERT_TRUE(mesh.ok()) << "seed " << seed << ": " << to_string(mesh.error());
    const mesh::MeshQuality quality = mesh::quality_of(mesh->points, mesh->triangles);
    inverted += quality.inverted;
    EXPECT_NEAR(quality.area / mesh::enclosed_area(loops), 1, 1e-6) << "seed " << seed;
    for (const Tri& t : mesh->triangles) {
      const Vec2 p[] = {mesh->points[t[0]], mesh->points[t[1]], mesh->points[t[2]]};
      if (forced(outline, (p[0] + p[1] + p[2]) * (1.0 / 3))) continue;
      for (int k = 0; k < 3; ++k) {
        const Vec2 u = p[(k + 1) % 3] - p[k], v = p[(k + 2) % 3] - p[k];
        ++angles;
        wide += degrees_from_radians(std::atan2(cross(u, v), dot(u, v))) >= 25;
      }
    }
    for (const mesh::MeshEdge& e : mesh::edges_of(mesh->triangles, static_cast<Index>(mesh->points.size()))) {
      const Vec2 a = mesh->points[e.v0], b = mesh->points[e.v1];
      if (forced(outline, (a + b) * 0.5)) continue;
      ++edges;
      even += length(b - a) >= 0.65 * kStep && length(b - a) <= 1.35 * kStep;
    }
  }
  std::printf("%d angles, %.4f %% of 25 degrees or more; %d edges, %.3f %% within 35 %%\n", angles,
              100.0 * wide / angles, edges, 100.0 * even / edges);
  EXPECT_EQ(inverted, 0);
  EXPECT_GE(wide, 0.999 * angles);
  EXPECT_GE(even, 0.99 * edges);
}

TEST(TriangleFigures, HoldForSliversAndForPiecesOfAMillimetreAndOfThreeMetres) {
  for (const mesh::Polygon& corners : {rectangle(0.3, 1e-5), rectangle(1e-3, 1e-3), rectangle(3, 0.5)}) {
    const std::vector<mesh::Polygon> loops{sampled(corners, kStep)};
    const Result<mesh::FlatMesh> mesh = mesh::triangulate(loops, kStep, {});
    ASSERT_TRUE(mesh.ok()) << to_string(mesh.error());
    const mesh::MeshQuality quality = mesh::quality_of(mesh->points, mesh->triangles);
    EXPECT_EQ(quality.inverted, 0);
    EXPECT_NEAR(quality.area / mesh::enclosed_area(loops), 1, 1e-6);
  }
}

}  // namespace
}  // namespace toile
