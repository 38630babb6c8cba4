#include "server/jobs/job_stills.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "server/movie/film_codec.h"
#include "tests/server/jobs/ended_order.h"
#include "tests/server/jobs/fake_store.h"
#include "tests/server/movie/napkin_film.h"

namespace toile {
namespace {

const store::RequestContext kAnn("ann"), kBob("bob");

class StillsOfJobs : public testing::Test {
 protected:
  StillsOfJobs()
      : store(std::filesystem::path(testing::TempDir()) /
              ("toile_job_stills_" + std::to_string(::getpid()))) {}
  std::string job_of(const store::RequestContext& owner, const std::string& maps = "") {
    const std::string id = store.create_job(owner, {}, "").value().id;
    EXPECT_TRUE(store.put_result(owner, id, movie::kFilmFile, movie::encode_film(test::napkin_film())));
    if (!maps.empty()) {
      EXPECT_TRUE(store.put_result(owner, id, "maps.json", maps));
    }
    EXPECT_TRUE(store.change_job(owner, id, [&](store::JobRow& row) -> Status {
      row.state = store::JobState::kSucceeded;
      row.results[movie::kFilmFile] = {1, ""};
      return {};
    }));
    return id;
  }
  static movie::StillWish small(render::View view) {
    movie::StillWish wish;
    wish.from = view;
    wish.settings = {.width = 64, .height = 80};
    return wish;
  }
  test::FakeStore store;
};

TEST_F(StillsOfJobs, AreTakenWhenTheyAreAskedForAndKept) {
  const std::string job = job_of(kAnn);
  jobs::JobStills stills(store);
  const jobs::Order asked = stills.ask(kAnn, job, small(render::View::kFront)).value();
  EXPECT_EQ(asked.name, "still-front-64x80.png");
  ASSERT_EQ(test::ended_order(stills, kAnn, job, asked.name).state, jobs::OrderState::kMade);
  const std::string bytes = store.result_bytes(kAnn, job, asked.name).value();
  EXPECT_EQ(bytes.substr(1, 3), "PNG");
  EXPECT_EQ(stills.ask(kAnn, job, small(render::View::kFront)).value().state, jobs::OrderState::kMade);
}

TEST_F(StillsOfJobs, FromElsewhereAreOtherPictures) {
  const std::string job = job_of(kAnn);
  jobs::JobStills stills(store);
  movie::StillWish near = small(render::View::kFront), far = near;
  near.from = render::Viewpoint{{0.25, 1.2, 2}};
  far.from = render::Viewpoint{{0.25, 1.2, 8}};
  EXPECT_NE(jobs::still_name(near), jobs::still_name(far));
  for (const movie::StillWish& wish : {near, far}) ASSERT_TRUE(stills.ask(kAnn, job, wish));
  for (const movie::StillWish& wish : {near, far})
    ASSERT_EQ(test::ended_order(stills, kAnn, job, jobs::still_name(wish)).state, jobs::OrderState::kMade);
  EXPECT_NE(store.result_bytes(kAnn, job, jobs::still_name(near)).value(),
            store.result_bytes(kAnn, job, jobs::still_name(far)).value());
}

TEST_F(StillsOfJobs, HaveNamesThatTellThemApart) {
  movie::StillWish wish = small(render::View::kBack);
  wish.map = "ease";
  EXPECT_EQ(jobs::still_name(wish), "still-back-ease-64x80.png");
  wish.settings.transparent = true;
  EXPECT_EQ(jobs::still_name(wish), "still-back-ease-64x80-clear.png");
  wish.settings.samples = 16;
  EXPECT_EQ(jobs::still_name(wish), "still-back-ease-64x80-16s-clear.png");
  wish.from = render::Viewpoint{{0, 1, 2}, Vec3{0, 1, 0}, 30};
  EXPECT_EQ(jobs::still_name(wish).substr(0, 11), "still-from-");
}

TEST_F(StillsOfJobs, ColouredByAMapThatIsMissingSayWhy) {
  const std::string damaged = job_of(kAnn, "{");
  jobs::JobStills stills(store);
  movie::StillWish wish = small(render::View::kFront);
  wish.map = "ease";
  ASSERT_TRUE(stills.ask(kAnn, damaged, wish));
  const jobs::Order failed = test::ended_order(stills, kAnn, damaged, jobs::still_name(wish));
  ASSERT_TRUE(failed.error);
  EXPECT_EQ(failed.error->code, "map.damaged");
}

TEST_F(StillsOfJobs, AreRefusedBeforeTheyAreTakenWhereTheyCannotBe) {
  const std::string job = job_of(kAnn);
  jobs::JobStills stills(store, {.side = 128});
  EXPECT_EQ(stills.ask(kBob, job, small(render::View::kFront)).error().kind, ErrorKind::kNotFound);
  movie::StillWish wish = small(render::View::kFront);
  wish.settings.width = 129;
  EXPECT_EQ(stills.ask(kAnn, job, wish).error().code, "render.settings");
  wish = small(render::View::kFront);
  wish.map = "warmth";
  EXPECT_EQ(stills.ask(kAnn, job, wish).error().code, "map.unknown");
  wish = small(render::View::kFront);
  wish.from = render::Viewpoint{{0, 1, 2}, Vec3{0, 1, 2}};
  EXPECT_EQ(stills.ask(kAnn, job, wish).error().code, "render.camera");
}

}  // namespace
}  // namespace toile
