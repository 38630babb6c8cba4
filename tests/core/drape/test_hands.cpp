// Hands on cloth that drapes: pulls, pins, their log, and what never happens whatever they do.

#include "core/drape/hands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "core/base/hash.h"
#include "core/drape/checkpoint.h"
#include "core/drape/pipeline.h"
#include "tests/core/drape/garments.h"
#include "tests/core/drape/runs.h"

namespace toile {
namespace {

using drape::Touch;
using drape::TouchKind;
using test::tablecloth;
using test::tube;

/// What is done to a drape, by the step after which it is done.
using Doings = std::vector<std::pair<int, std::function<void(drape::DrapeRun&)>>>;

drape::DrapeInput watched(drape::DrapeInput input) {
  input.settings.frame_interval = 10;  // crossings are counted in each frame
  return input;
}

/// The triangle whose middle, flat, is nearest to a place of a panel (m), held by its middle.
drape::TouchedPoint nearest(const drape::DrapeRun& run, Index panel, Vec2 flat) {
  const sewing::GarmentMesh& garment = run.session().garment();
  Index best = kNone;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    if (garment.panel_of_triangle[t] != panel) continue;
    Vec2 middle;
    for (const Index v : garment.triangles[t]) middle = middle + garment.rest[v] * (1.0 / 3);
    if (length(middle - flat) >= least) continue;
    least = length(middle - flat);
    best = static_cast<Index>(t);
  }
  return {best, {0.25, 0.25, 0.5}};
}

Vec3 place_of(const drape::DrapeRun& run, const drape::TouchedPoint& at) {
  const Tri& corners = run.session().garment().triangles[static_cast<std::size_t>(at.triangle)];
  return sewing::position_of({corners, at.share}, run.session().positions());
}

Touch pull(int id, drape::TouchedPoint at, Vec3 to) { return {0, TouchKind::kPull, id, at, to}; }
Touch let_go(int id) { return {0, TouchKind::kLetGo, id, {}, {}}; }
Touch pin(drape::TouchedPoint at) { return {0, TouchKind::kPin, 0, at, {}}; }
Touch unpin(int id) { return {0, TouchKind::kUnpin, id, {}, {}}; }

drape::DrapeResult draped(drape::DrapeRun& run, const Doings& doings) {
  for (const auto& [step, doing] : doings) {
    run.advance(step - run.session().steps(), {});
    EXPECT_EQ(run.session().steps(), step) << "it ended before";
    doing(run);
  }
  run.advance(kToTheEnd, {});
  return run.conclude();
}

void expect_never_through(const drape::DrapeResult& result) {
  EXPECT_EQ(result.worst.cloth_body, 0) << "in frame of step " << result.worst_frame_step;
  EXPECT_EQ(result.worst.cloth_cloth, 0) << "in frame of step " << result.worst_frame_step;
  EXPECT_GT(result.frames_checked, 100);
}

std::string hash_at_end(const drape::DrapeResult& result) { return hash_of(result.positions); }

/// A hand takes a corner of the tablecloth, draws it through the column to its other side, and lets go.
Doings through_the_column() {
  return {{1000,
           [](drape::DrapeRun& run) {
             const auto corner = nearest(run, 0, {-0.12, 0});
             EXPECT_TRUE(run.touch(pull(7, corner, {0.5, 0.1, -0.5})).ok());
           }},
          {2500,
           [](drape::DrapeRun& run) {
             EXPECT_TRUE(run.touch(pull(7, {}, {-0.4, 0.25, 0.4})).ok());
           }},
          {3500, [](drape::DrapeRun& run) { EXPECT_TRUE(run.touch(let_go(7)).ok()); }}};
}

TEST(Hands, DrawClothAgainstTheBodyAndNeverThrough) {
  const drape::DrapeInput input = watched(tablecloth());
  const auto run = begun(input);
  const drape::DrapeResult result = draped(*run, through_the_column());
  expect_never_through(result);
  EXPECT_TRUE(result.settled()) << to_string(result.stop_reason);
  EXPECT_GT(result.steps, 3500);
}

TEST(Hands, PressClothOntoABodyAndNeverThrough) {
  const drape::DrapeInput input = watched(tablecloth());
  const auto run = begun(input);
  drape::TouchedPoint middle;
  const drape::DrapeResult result =
      draped(*run, {{800,
                     [&](drape::DrapeRun& now) {
                       middle = nearest(now, 0, {0, 0.12});
                       EXPECT_TRUE(now.touch(pull(1, middle, {0, -0.5, 0})).ok());
                     }},
                    {2800, [&](drape::DrapeRun& now) {
                       EXPECT_GT(place_of(now, middle).y, 0.3) << "it is in the column";
                       EXPECT_TRUE(now.touch(let_go(1)).ok());
                     }}});
  expect_never_through(result);
  EXPECT_TRUE(result.settled()) << to_string(result.stop_reason);
}

TEST(Hands, DrawClothThroughNoClothEither) {
  const drape::DrapeInput input = watched(tube());
  const auto run = begun(input);
  const drape::DrapeResult result =
      draped(*run, {{2600,
                     [](drape::DrapeRun& now) {  // both hems, each to where the other's back is
                       EXPECT_TRUE(now.touch(pull(1, nearest(now, 0, {0, 0}), {0, 0.3, -0.6})).ok());
                       EXPECT_TRUE(now.touch(pull(2, nearest(now, 1, {0, 0}), {0, 0.3, 0.6})).ok());
                       EXPECT_TRUE(now.touch(pull(3, nearest(now, 0, {0.1, 0.02}), {-0.6, 0.2, 0})).ok());
                     }},
                    {4600, [](drape::DrapeRun& now) {
                       for (const int id : {1, 2, 3}) EXPECT_TRUE(now.touch(let_go(id)).ok());
                     }}});
  expect_never_through(result);
  EXPECT_TRUE(result.settled()) << to_string(result.stop_reason);
}

TEST(Hands, LeadAPointToWhereTheyAreAtALimitedSpeed) {
  const drape::DrapeInput input = tablecloth();
  const auto run = begun(input);
  run->advance(1500, {});
  const auto corner = nearest(*run, 0, {-0.12, 0});
  const Vec3 from = place_of(*run, corner), to = from + Vec3{-0.06, 0.05, 0.06};
  ASSERT_TRUE(run->touch(pull(1, corner, to)).ok());
  run->advance(40, {});  // 20 ms
  EXPECT_LT(length(place_of(*run, corner) - from), 0.03);
  run->advance(2000, {});
  EXPECT_LT(length(place_of(*run, corner) - to), 0.015);
}

/// Wherever a hand pulls to, its force has a limit: cloth that hangs on a pin stretches by no more.
TEST(Hands, PullNoHarderThanClothCanTake) {
  const drape::DrapeInput input = tablecloth();
  const auto run = begun(input);
  run->advance(1000, {});
  const auto corner = nearest(*run, 0, {-0.12, 0});
  ASSERT_TRUE(run->touch(pin(corner)).ok());
  const auto opposite = nearest(*run, 0, {0.12, 0.24});
  ASSERT_TRUE(run->touch(pull(1, opposite, place_of(*run, opposite) + Vec3{50, 0, -50})).ok());
  run->advance(4000, {});
  const double flat = std::sqrt(2) * 0.24;
  EXPECT_LT(length(place_of(*run, opposite) - place_of(*run, corner)), 1.25 * flat);
  EXPECT_LT(length(place_of(*run, corner)), 1);
}

TEST(Hands, KeepADrapeFromEndingWhileTheyHoldIt) {
  drape::DrapeInput input = tablecloth();
  input.settings.max_time = 1;
  const auto run = begun(input);
  run->advance(1000, {});
  const auto corner = nearest(*run, 0, {-0.12, 0});
  ASSERT_TRUE(run->touch(pull(1, corner, place_of(*run, corner))).ok());
  run->advance(6000, {});  // 3.5 s: it would have rested, or run out of time
  EXPECT_FALSE(run->done());
  ASSERT_TRUE(run->touch(let_go(1)).ok());
  run->advance(kToTheEnd, {});
  EXPECT_LE(run->session().time(), 3.5 + 1 + 1e-3);
}

TEST(Hands, EndWithATrueMotionsTime) {
  drape::DrapeInput input = tablecloth();
  input.settings.mode = drape::DrapeMode::kDynamic;
  input.settings.max_time = 1;
  const auto run = begun(input);
  run->advance(1000, {});
  ASSERT_TRUE(run->touch(pull(1, nearest(*run, 0, {-0.12, 0}), {0, 1, 0})).ok());
  run->advance(kToTheEnd, {});
  EXPECT_EQ(run->conclude().stop_reason.kind, drape::Stop::kTime);
}

TEST(Pins, HoldAPointWhereItIsUntilTheyAreRemoved) {
  const drape::DrapeInput input = watched(tablecloth());
  const auto run = begun(input);
  run->advance(100, {});
  const auto corner = nearest(*run, 0, {-0.12, 0});
  const Vec3 at = place_of(*run, corner);
  ASSERT_TRUE(run->touch(pin(corner)).ok());
  ASSERT_EQ(run->session().hands().pins.size(), 1U);
  EXPECT_EQ(run->session().hands().pins[0].id, 1);
  run->advance(1500, {});
  EXPECT_LT(length(place_of(*run, corner) - at), 2e-3);
  ASSERT_TRUE(run->touch(unpin(1)).ok());
  EXPECT_TRUE(run->session().hands().pins.empty());
  run->advance(kToTheEnd, {});
  const drape::DrapeResult result = run->conclude();
  EXPECT_TRUE(result.settled());
  EXPECT_LT(place_of(*run, corner).y, at.y - 0.05) << "it hangs down now";
  expect_never_through(result);
}

TEST(Pins, StayWhenADrapeComesToRest) {
  const drape::DrapeInput input = tablecloth();
  const auto run = begun(input);
  run->advance(300, {});
  const auto corner = nearest(*run, 0, {-0.12, 0});
  const Vec3 at = place_of(*run, corner);
  ASSERT_TRUE(run->touch(pin(corner)).ok());
  run->advance(kToTheEnd, {});
  EXPECT_TRUE(run->conclude().settled());
  EXPECT_EQ(run->session().hands().pins.size(), 1U);
  EXPECT_LT(length(place_of(*run, corner) - at), 2e-3);
}

TEST(Touches, AreLoggedAndReplayToTheSameBytes) {
  const drape::DrapeInput input = watched(tablecloth());
  const auto run = begun(input);
  const drape::DrapeResult result = draped(*run, through_the_column());
  ASSERT_EQ(result.touches.size(), 3U);
  EXPECT_EQ(result.touches[0].step, 1000);
  EXPECT_EQ(result.touches[2].kind, TouchKind::kLetGo);

  const auto again = begun(input);
  ASSERT_TRUE(again->replay(result.touches).ok());
  again->advance(kToTheEnd, {});
  const drape::DrapeResult replayed = again->conclude();
  EXPECT_EQ(hash_at_end(replayed), hash_at_end(result));
  EXPECT_EQ(replayed.steps, result.steps);
  EXPECT_EQ(replayed.touches, result.touches);

  const auto untouched = begun(input);
  untouched->advance(kToTheEnd, {});
  EXPECT_NE(hash_at_end(untouched->conclude()), hash_at_end(result)) << "the hand moved something";
}

TEST(Touches, GoOnWithACheckpoint) {
  const drape::DrapeInput input = tablecloth();
  const auto whole = begun(input);
  const drape::DrapeResult result = draped(*whole, through_the_column());

  const auto first = begun(input);
  const Doings doings = through_the_column();
  first->advance(1000, {});
  doings[0].second(*first);
  first->advance(731, {});
  const auto second = drape::DrapeRun::resume(input, first->checkpoint(), {}, nullptr).value();
  EXPECT_EQ(second->session().hands().pulls.size(), 1U);
  const drape::DrapeResult resumed = draped(*second, {doings[1], doings[2]});
  EXPECT_EQ(hash_at_end(resumed), hash_at_end(result));
  EXPECT_EQ(resumed.touches, result.touches);
}

TEST(Touches, AreToldInTheFindings) {
  const drape::DrapeInput input = tablecloth();
  const auto run = begun(input);
  const drape::DrapeResult result = draped(*run, through_the_column());
  const auto told = std::find_if(result.findings.begin(), result.findings.end(), [](const auto& finding) {
    return finding.kind == preflight::FindingKind::kTouched;
  });
  ASSERT_NE(told, result.findings.end());
  EXPECT_NE(told->message.find("pulls: 1, pins set: 0"), std::string::npos) << told->message;
}

TEST(Touches, ThatCannotBeAreRefusedAndChangeNothing) {
  const drape::DrapeInput input = tablecloth();
  const auto run = begun(input);
  run->advance(100, {});
  const auto corner = nearest(*run, 0, {-0.12, 0});
  const auto refused = [&](const Touch& touch) {
    const Status taken = run->touch(touch);
    return taken ? std::string("taken") : taken.error().code;
  };
  const auto triangles = static_cast<Index>(run->session().garment().triangles.size());
  EXPECT_EQ(refused(pull(1, {triangles, {1, 0, 0}}, {})), "live.point");
  EXPECT_EQ(refused(pull(1, {-1, {1, 0, 0}}, {})), "live.point");
  EXPECT_EQ(refused(pull(1, {0, {0.5, 0.5, 0.5}}, {})), "live.point");
  EXPECT_EQ(refused(pull(1, {0, {1.5, -0.5, 0}}, {})), "live.point");
  EXPECT_EQ(refused(pin({0, {NAN, 0, 1}})), "live.point");
  EXPECT_EQ(refused(pull(1, corner, {NAN, 0, 0})), "live.target");
  EXPECT_EQ(refused(pull(1, corner, {0, 1e9, 0})), "live.target");
  EXPECT_EQ(refused(unpin(1)), "live.no_pin");
  EXPECT_EQ(refused(let_go(1)), "taken") << "whoever holds nothing may let go";
  EXPECT_TRUE(run->session().hands().log.empty());
  for (int id = 1; id <= static_cast<int>(drape::Hands::kMostPulls); ++id)
    EXPECT_EQ(refused(pull(id, corner, {})), "taken");
  EXPECT_EQ(refused(pull(99, corner, {})), "live.too_many");
  EXPECT_EQ(refused(pull(1, {}, {0, 1, 0})), "taken") << "it holds already";
  EXPECT_EQ(run->session().hands().log.size(), drape::Hands::kMostPulls + 1);
}

TEST(Touches, ComeTooLateOnceTheClothRests) {
  const drape::DrapeInput input = tablecloth();
  const auto run = begun(input);
  run->advance(kToTheEnd, {});
  const Status taken = run->touch(pin({0, {1, 0, 0}}));
  ASSERT_FALSE(taken.ok());
  EXPECT_EQ(taken.error().code, "live.over");
}

TEST(Touches, AreNotForThePapersMethod) {
  drape::DrapeInput input = tablecloth();
  input.settings.method = drape::DrapeMethod::kPaper;
  const auto run = begun(input);
  EXPECT_EQ(run->touch(pin({0, {1, 0, 0}})).error().code, "live.method");
  EXPECT_EQ(run->replay({pin({0, {1, 0, 0}})}).error().code, "live.method");
  EXPECT_TRUE(run->session().hands().log.empty());
}

TEST(Touches, OfALogThatDoesNotFitAreRefusedBeforeItBegins) {
  const drape::DrapeInput input = tablecloth();
  const auto refused = [&](std::vector<Touch> touches) {
    const Status taken = begun(input)->replay(std::move(touches));
    return taken ? std::string() : taken.error().code + " " + taken.error().where;
  };
  Touch late = pin({0, {1, 0, 0}});
  late.step = 5;
  EXPECT_EQ(refused({late, pin({0, {1, 0, 0}})}), "live.order touch 1");
  EXPECT_EQ(refused({pin({100000, {1, 0, 0}})}), "live.point touch 0");
  EXPECT_EQ(refused({late, unpin(2)}), "live.order touch 1");
  EXPECT_EQ(refused({unpin(2)}), "live.no_pin touch 0");
  EXPECT_EQ(refused({late}), "");
}

TEST(Touches, ThatDrawOnAtOneStepAreOneInTheLog) {
  const drape::DrapeInput input = tablecloth();
  const auto run = begun(input);
  const auto corner = nearest(*run, 0, {-0.12, 0});
  for (const double y : {0.1, 0.2, 0.3, 0.4}) ASSERT_TRUE(run->touch(pull(1, corner, {0, y, 0})).ok());
  ASSERT_EQ(run->session().hands().log.size(), 1U);
  EXPECT_EQ(run->session().hands().log[0].target.y, 0.4);
  EXPECT_EQ(run->session().hands().log[0].at, corner);
}

TEST(Touches, OfADamagedCheckpointAreNotTakenUp) {
  const drape::DrapeInput input = tablecloth();
  const auto run = begun(input);
  ASSERT_TRUE(run->touch(pin(nearest(*run, 0, {-0.12, 0}))).ok());
  drape::RunState state = drape::decode_checkpoint(run->checkpoint(), run->start_hash()).value();
  state.session.hands.pins[0].at.triangle = 1 << 20;
  const auto resumed =
      drape::DrapeRun::resume(input, drape::encode_checkpoint(run->start_hash(), state), {}, nullptr);
  ASSERT_FALSE(resumed.ok());
  EXPECT_EQ(resumed.error().code, "checkpoint.damaged");
}

}  // namespace
}  // namespace toile
