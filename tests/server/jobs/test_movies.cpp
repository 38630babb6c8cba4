#include "server/jobs/movies.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <future>

#include "core/base/run_child.h"
#include "server/movie/film_codec.h"
#include "tests/server/jobs/ended_order.h"
#include "tests/server/jobs/fake_store.h"
#include "tests/server/movie/napkin_film.h"

namespace toile {
namespace {

const store::RequestContext kAnn("ann"), kBob("bob");

class JobMovies : public testing::Test {
 protected:
  JobMovies()
      : store(std::filesystem::path(testing::TempDir()) /
              ("toile_job_movies_" + std::to_string(::getpid()))) {}
  void SetUp() override {
    if (find_program("ffmpeg").empty()) GTEST_SKIP() << "SKIPPED: ffmpeg is not installed";
  }
  /// One that has ended, with its film.
  std::string job_of(const store::RequestContext& owner,
                     store::JobState state = store::JobState::kSucceeded) {
    const std::string id = store.create_job(owner, {}, "").value().id;
    const std::string film = movie::encode_film(test::napkin_film());
    EXPECT_TRUE(store.put_result(owner, id, movie::kFilmFile, film));
    EXPECT_TRUE(store.change_job(owner, id, [&](store::JobRow& row) -> Status {
      row.state = state;
      row.results[movie::kFilmFile] = {static_cast<std::int64_t>(film.size()), ""};
      return {};
    }));
    return id;
  }
  static movie::MovieSettings turn(int fps) {
    return {.kind = movie::MovieKind::kTurntable, .width = 64, .height = 80, .fps = fps, .seconds = 1};
  }
  test::FakeStore store;
};

TEST_F(JobMovies, AreMadeWhenTheyAreAskedForAndKept) {
  const std::string job = job_of(kAnn);
  jobs::Movies movies(store);
  const jobs::Order asked = movies.ask(kAnn, job, turn(2)).value();
  EXPECT_EQ(asked.name, "turntable-64x80-2-1s.mp4");
  EXPECT_EQ(test::ended_order(movies, kAnn, job, asked.name).state, jobs::OrderState::kMade);
  EXPECT_EQ(store.result_bytes(kAnn, job, asked.name).value().substr(4, 4), "ftyp");
  EXPECT_EQ(movies.ask(kAnn, job, turn(2)).value().state, jobs::OrderState::kMade);
  EXPECT_EQ(movies.of_job(kAnn, job).value().size(), 1u);
}

TEST_F(JobMovies, OfOtherLengthsHaveOtherNames) {
  movie::MovieSettings one = turn(2), other = turn(2);
  one.seconds = 2;
  other.seconds = 2.04;
  EXPECT_NE(jobs::movie_name(one), jobs::movie_name(other));
}

TEST_F(JobMovies, AreMadeByTurnsOfOwners) {
  std::promise<void> all_asked;
  std::shared_future<void> go = all_asked.get_future().share();
  const std::string anns = job_of(kAnn), bobs = job_of(kBob);
  std::vector<std::string> made;
  store.on_put_result = [&](const std::string& name) -> Status {
    go.wait();
    made.push_back(name);
    return {};
  };
  jobs::Movies movies(store);
  for (const int fps : {1, 2, 3}) ASSERT_TRUE(movies.ask(kAnn, anns, turn(fps)));
  ASSERT_TRUE(movies.ask(kBob, bobs, turn(4)));
  all_asked.set_value();
  test::ended_order(movies, kAnn, anns, jobs::movie_name(turn(3)));
  ASSERT_EQ(made.size(), 4u);
  EXPECT_EQ(made[1], jobs::movie_name(turn(4))) << "Bob waits for one of Ann's, not for all";
}

TEST_F(JobMovies, ThatFailSaySoHurtNobodyAndAreTriedAgainWhenAskedForAgain) {
  const std::string job = job_of(kAnn);
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", "/nonexistent", 1);
  jobs::Movies movies(store);
  const std::string name = movies.ask(kAnn, job, turn(2)).value().name;
  const jobs::Order failed = test::ended_order(movies, kAnn, job, name);
  ::setenv("PATH", path.c_str(), 1);
  ASSERT_TRUE(failed.error);
  EXPECT_EQ(failed.error->code, "movie.no_ffmpeg");
  EXPECT_EQ(store.job(kAnn, job).value().state, store::JobState::kSucceeded);
  EXPECT_EQ(movies.ask(kAnn, job, turn(2)).value().state, jobs::OrderState::kQueued);
  EXPECT_EQ(test::ended_order(movies, kAnn, job, name).state, jobs::OrderState::kMade);
}

TEST_F(JobMovies, AreTriedOnceMoreWhereTheMachineIsAtFault) {
  const std::string job = job_of(kAnn);
  int tries = 0;
  store.on_put_result = [&](const std::string&) -> Status {
    if (++tries > 1) return {};
    return Error{"store.failed", "the disk coughs", "", ErrorKind::kSystem};
  };
  jobs::Movies movies(store);
  const std::string name = movies.ask(kAnn, job, turn(2)).value().name;
  EXPECT_EQ(test::ended_order(movies, kAnn, job, name).state, jobs::OrderState::kMade);
  EXPECT_EQ(tries, 2);
}

TEST_F(JobMovies, AreNobodyElsesAndNeedADrapeThatHasEnded) {
  const std::string job = job_of(kAnn), running = job_of(kAnn, store::JobState::kRunning);
  jobs::Movies movies(store);
  EXPECT_EQ(movies.ask(kBob, job, turn(2)).error().kind, ErrorKind::kNotFound);
  EXPECT_EQ(movies.ask(kAnn, running, turn(2)).error().code, "movie.no_film");
  movie::MovieSettings large = turn(2);
  large.width = 4096;
  EXPECT_EQ(movies.ask(kAnn, job, large).error().where, "width");
}

TEST_F(JobMovies, AreTakenBack) {
  const std::string job = job_of(kAnn);
  std::promise<void> go;
  std::shared_future<void> gone = go.get_future().share();
  store.on_put_result = [&](const std::string&) -> Status {
    gone.wait();
    return {};
  };
  jobs::Movies movies(store);
  ASSERT_TRUE(movies.ask(kAnn, job, turn(1)));
  ASSERT_TRUE(movies.ask(kAnn, job, turn(2)));
  EXPECT_TRUE(movies.cancel(kAnn, job, jobs::movie_name(turn(2))));
  EXPECT_EQ(movies.cancel(kAnn, job, jobs::movie_name(turn(3))).error().code, "store.not_found");
  go.set_value();
  EXPECT_EQ(test::ended_order(movies, kAnn, job, jobs::movie_name(turn(1))).state, jobs::OrderState::kMade);
  EXPECT_EQ(movies.of_job(kAnn, job).value().size(), 1u);
}

}  // namespace
}  // namespace toile
