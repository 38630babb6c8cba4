// Jobs whose bodies move.

#include <sstream>

#include "server/documents/used_files.h"
#include "server/documents/views.h"
#include "server/jobs/end_bodies.h"
#include "server/jobs/input.h"
#include "tests/server/jobs/house.h"

namespace toile {
namespace {

using test::cloth_over_block;
using test::kOwner;

constexpr double kRise = 0.02;  // m

/// An OBJ file's mesh, higher up.
std::string raised(const std::string& obj) {
  std::istringstream in(obj);
  std::string out, word;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    double x = 0, y = 0, z = 0;
    if (words >> word && word == "v" && words >> x >> y >> z)
      line = "v " + std::to_string(x) + " " + std::to_string(y + kRise) + " " + std::to_string(z);
    out += line + "\n";
  }
  return out;
}

class MovingBodyJobs : public test::JobHouse {
 protected:
  void SetUp() override { ASSERT_TRUE(service->start()); }

  /// Its block rises under the cloth.
  std::string project() {
    std::string document = cloth_over_block(200, 0.2);
    const std::string still = R"("file": "block.obj", "unit": "m")";
    document.replace(document.find(still), still.size(),
                     still + R"(, "motion": [{"after_s": 0.1, "file": "raised.obj"}])");
    store::ProjectRow row = store.project(kOwner, project_of(document)).value();
    store::AssetRow asset;
    asset.kind = "body";
    asset.name = "raised.obj";
    row.files["raised.obj"] = store.put_asset(kOwner, asset, raised(test::kBlock)).value().id;
    return store.create_project(kOwner, row, "").value().id;
  }
};

TEST_F(MovingBodyJobs, LeaveTheirBodiesWhereTheyCameTo) {
  const auto made = service->submit(kOwner, project(), "");
  ASSERT_TRUE(made) << to_string(made.error());
  ASSERT_TRUE(publisher.wait_for_end(made->id));
  const store::JobRow job = row(made->id);
  ASSERT_TRUE(jobs::has_end_bodies(job)) << job.report;
  EXPECT_TRUE(documents::has_moving_bodies(job.document));
  const drape::DrapeInput input = jobs::drape_input_of(documents, kOwner, job.document, job.files).value();
  const auto bodies = jobs::end_bodies(store, kOwner, job);
  ASSERT_TRUE(bodies) << to_string(bodies.error());
  ASSERT_EQ(bodies->size(), 1u);
  const std::vector<Vec3>& before = input.bodies[0].mesh.vertices;
  ASSERT_EQ((*bodies)[0].vertices.size(), before.size());
  for (std::size_t v = 0; v < before.size(); ++v)
    EXPECT_NEAR((*bodies)[0].vertices[v].y, before[v].y + kRise, 1e-5);
  EXPECT_EQ(alone(job).worst.cloth_body, 0);
}

TEST_F(MovingBodyJobs, NameEachKeyframesFile) {
  const store::ProjectRow row = store.project(kOwner, project()).value();
  const std::vector<documents::UsedFile> used =
      documents::used_files(project::parse_project(row.document).value());
  const auto named = std::find_if(used.begin(), used.end(),
                                  [](const documents::UsedFile& f) { return f.name == "raised.obj"; });
  ASSERT_NE(named, used.end());
  EXPECT_EQ(named->where, "/bodies/0/motion/0/file");
}

TEST(MovingBodies, AreNoneOfWhatIsNoDocumentOrStandsStill) {
  EXPECT_FALSE(documents::has_moving_bodies("{"));
  EXPECT_FALSE(documents::has_moving_bodies(cloth_over_block(200)));
}

}  // namespace
}  // namespace toile
