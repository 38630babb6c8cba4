// Any input that validates settles or stops with a reason, whatever it is. TOILE_SEED=7, or a range such as
// TOILE_SEED=100-149, runs just those; TOILE_DUMP=folder writes their starts and ends as OBJ.

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

#include "core/geometry/triangle_mesh.h"
#include "core/mesh/topology.h"
#include "tests/garments/random_forms.h"
#include "tests/garments/random_garment.h"
#include "tests/garments/random_trial.h"

namespace toile {
namespace {

struct Seeds {
  std::uint64_t first = 0, last = 0;
};

Seeds seeds_or(Seeds usual) {
  const char* asked = std::getenv("TOILE_SEED");
  if (asked == nullptr || *asked == '\0') return usual;
  const std::string text = asked;
  const std::size_t dash = text.find('-');
  const std::uint64_t first = std::strtoull(text.c_str(), nullptr, 10);
  return {first, dash == std::string::npos ? first : std::strtoull(text.c_str() + dash + 1, nullptr, 10)};
}

/// Runs them all, prints a line each, and fails for each fault.
void expect_all_end_well(Seeds usual) {
  const Seeds seeds = seeds_or(usual);
  const char* dump = std::getenv("TOILE_DUMP");
  std::map<std::string, int> ends;
  int refused = 0, total = 0;
  double cpu = 0;
  for (std::uint64_t seed = seeds.first; seed <= seeds.last; ++seed) {
    const test::RandomGarment garment = test::random_garment(seed);
    const test::TrialReport report = test::try_garment(garment, dump ? dump : "");
    const std::string line = test::line_of(seed, garment, report);
    std::printf("%s\n", line.c_str());
    std::fflush(stdout);
    EXPECT_TRUE(report.faults.empty()) << "TOILE_SEED=" << seed << "\n" << line;
    ++total;
    refused += report.refused();
    cpu += report.cpu_s;
    ++ends[report.end.substr(0, report.end.find(" s"))];
  }
  for (const auto& [end, count] : ends) std::printf("%4d %s\n", count, end.c_str());
  std::printf("%d of %d refused (%.0f %%), %.1f s of CPU\n", refused, total, 100.0 * refused / total, cpu);
  if (total >= 20) {
    EXPECT_LE(3 * refused, total) << "too many refusals to learn much from the rest";
  }
}

TEST(RandomGarments, SettleOrStopWithAReasonWithoutACrossingOrAnExplosion) { expect_all_end_well({0, 19}); }

TEST(LongRandomGarments, SettleOrStopWithAReasonWithoutACrossingOrAnExplosion) {
  expect_all_end_well({0, 499});
}

TEST(RandomGarments, OfOneSeedAreTheSameGarment) {
  const test::RandomGarment a = test::random_garment(0), b = test::random_garment(0);
  const test::TrialReport x = test::try_garment(a, ""), y = test::try_garment(b, "");
  EXPECT_EQ(x.steps, y.steps);
  EXPECT_EQ(x.speed, y.speed);
  EXPECT_EQ(x.stretch, y.stretch);
  EXPECT_NE(test::random_garment(1).input.settings.particle_distance, a.input.settings.particle_distance);
}

double signed_volume(const geometry::TriangleMesh& mesh) {
  double six = 0;
  for (const Tri& t : mesh.triangles)
    six += dot(mesh.vertices[t[0]], cross(mesh.vertices[t[1]], mesh.vertices[t[2]]));
  return six / 6;
}

TEST(RandomGarments, LieOnClosedSolidsWhoseSkinFacesOutwards) {
  test::Chance chance(1);
  for (int k = 0; k < 60; ++k) {
    const test::Form form = test::make_form(chance, k % 2 ? 0.1 : 0.6);
    for (const body::Body& body : form.bodies) {
      const auto count = static_cast<Index>(body.mesh.vertices.size());
      ASSERT_TRUE(mesh::check_manifold(body.mesh.triangles, count)) << form.kind;
      for (const mesh::MeshEdge& e : mesh::edges_of(body.mesh.triangles, count))
        ASSERT_NE(e.t1, kNone) << form.kind;
      EXPECT_GT(signed_volume(body.mesh), 0) << form.kind;
    }
  }
}

}  // namespace
}  // namespace toile
