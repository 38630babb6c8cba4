#pragma once
// A job service over a store in memory, with tiny garments to drape.

#include <gtest/gtest.h>
#include <unistd.h>

#include <string>

#include "core/base/hash.h"
#include "core/drape/pipeline.h"
#include "core/json/tree.h"
#include "server/jobs/input.h"
#include "server/jobs/service.h"
#include "tests/server/jobs/fake_store.h"
#include "tests/server/jobs/recorder.h"

namespace toile::test {

inline const store::RequestContext kOwner("ann");

/// A box of 10 cm, m.
inline constexpr const char* kBlock =
    "v -0.05 0 -0.05\nv 0.05 0 -0.05\nv 0.05 0 0.05\nv -0.05 0 0.05\n"
    "v -0.05 0.1 -0.05\nv 0.05 0.1 -0.05\nv 0.05 0.1 0.05\nv -0.05 0.1 0.05\n"
    "f 1 2 3 4\nf 8 7 6 5\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n";

inline const std::string kCotton =
    R"({"id": "cotton", "areal_mass_g_m2": 150, "stretch_warp_n_m": 2000, "stretch_weft_n_m": 1500,
        "stretch_shear_n_m": 500, "bend_warp_un_m": 10, "bend_weft_un_m": 8, "bend_bias_un_m": 7, "thickness_mm": 0.4})";

/// A square of cloth of `size` mm over the box. An edge is held until long after the end, so that the drape
/// takes exactly `max_time` s.
inline std::string cloth_over_block(int size, double max_time = 1, const std::string& height = "0.11") {
  const std::string s = std::to_string(size), half = std::to_string(size / 2000.0);
  return R"({"toile": 1, "name": "Cloth )" + s + R"(", "pieces": [{"id": "cloth", "outline": [
    {"id": "south", "points": [[0, 0], [)" +
         s + R"(, 0]]},
    {"id": "east", "points": [[)" +
         s + ", 0], [" + s + ", " + s + R"(]]},
    {"id": "north", "points": [[)" +
         s + ", " + s + "], [0, " + s + R"(]]},
    {"id": "west", "points": [[0, )" +
         s + R"(], [0, 0]]}],
    "fabric": "cotton", "placement": {"rigid": {"translation": [-)" +
         half + ", " + height + ", " + half +
         R"(], "rotation": [-90, 0, 0]}}}],
    "fabrics": [)" +
         kCotton + R"(], "seams": [],
    "bodies": [{"id": "block", "file": "block.obj", "unit": "m"}],
    "attachments": [{"id": "pin", "piece": "cloth", "edges": ["south"], "release_after_s": 3000}],
    "settings": {"particle_distance_mm": 35, "sew_time_s": 0, "max_time_s": )" +
         std::to_string(max_time) + "}}";
}

/// s; takes minutes unless somebody stops it.
inline constexpr double kEndless = 3600;

class JobHouse : public testing::Test {
 protected:
  JobHouse()
      : store(std::filesystem::path(testing::TempDir()) /
              ("toile_jobs_" + test_name() + std::to_string(::getpid()))) {
    settings.still_width = 64;
    settings.still_height = 80;
    settings.heartbeat_s = 3600;  // tests count what is written
    make(2);
  }

  void make(int workers) {
    settings.workers = workers;
    service = jobs::make_job_service(documents, publisher, settings);
  }

  static std::string test_name() { return testing::UnitTest::GetInstance()->current_test_info()->name(); }

  std::string project_of(const std::string& document) {
    if (block.empty()) {
      store::AssetRow row;
      row.kind = "body";
      row.name = "block.obj";
      block = store.put_asset(kOwner, row, kBlock).value().id;
    }
    store::ProjectRow row;
    row.name = "project";
    row.document = document;
    row.files = {{"block.obj", block}};
    return store.create_project(kOwner, row, "").value().id;
  }

  /// The new job's id.
  std::string submit(const std::string& document) {
    const auto job = service->submit(kOwner, project_of(document), "");
    EXPECT_TRUE(job.ok()) << to_string(job.error());
    return job ? job->id : "";
  }

  store::JobRow row(const std::string& id) { return store.job(kOwner, id).value(); }

  /// The drape by itself, in one go and without a service.
  drape::DrapeResult alone(const store::JobRow& job) {
    const drape::DrapeInput input = jobs::drape_input_of(documents, kOwner, job.document, job.files).value();
    return drape::drape(input, {}, nullptr).value();
  }
  std::string hash_of_alone(const store::JobRow& job) { return hash_of(alone(job).positions); }
  static std::string hash_in(const store::JobRow& job) {
    return *json::parse_json(job.report).value().find("hash")->text();
  }

  FakeStore store;
  documents::Documents documents{store};
  Recorder publisher;
  jobs::JobServiceSettings settings;
  std::unique_ptr<jobs::JobService> service;  // last: it uses the others until it goes
  std::string block;
};

}  // namespace toile::test
