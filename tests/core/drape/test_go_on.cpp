// Drapes that go on from where another ended.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "core/drape/pipeline.h"
#include "tests/core/arrange/garments.h"
#include "tests/core/dressing/dressed_person.h"

namespace toile {
namespace {

/// A tube around the mannequin's hips that widens by `flare` mm a side down to its hem, `longer` mm lower.
drape::DrapeInput tube(double longer = 0, double flare = 40) {
  drape::DrapeInput input;
  const std::vector<Vec2> corners{{-250 - flare, -longer}, {250 + flare, -longer}, {250, 300}, {-250, 300}};
  input.pattern.panels = {test::polygon("front", corners), test::polygon("back", corners)};
  input.pattern.seams = {test::seam("left", {{0, 1}}, {{1, 3}}), test::seam("right", {{0, 3}}, {{1, 1}})};
  input.fabrics.resize(1);
  input.fabric_of_panel = {0, 0};
  const double height = test::person().figure.waist - 0.3;
  input.placements = {sewing::RigidPlacement{{0, height, 0.2}, {}, false},
                      sewing::RigidPlacement{{0, height, -0.2}, {0, 3.14159265358979, 0}, false}};
  input.attachments = {{"top", 0, {2}, sewing::Attachment::Hold::kHeight, -1, {}, {}},
                       {"top_back", 1, {2}, sewing::Attachment::Hold::kHeight, -1, {}, {}}};
  input.bodies = {*test::person().body};
  input.settings.particle_distance = 0.03;
  return input;
}

drape::DrapeResult draped(const drape::DrapeInput& input) { return drape::drape(input, {}, nullptr).value(); }

/// As tube(), once it hung.
const drape::DrapeResult& hung() {
  static const drape::DrapeResult result = draped(tube());
  return result;
}

drape::DrapeInput going_on(drape::DrapeInput input) {
  input.before = std::make_shared<const warm::HungGarment>(hung().hung);
  return input;
}

bool told(const drape::DrapeResult& r, preflight::FindingKind kind) {
  return std::any_of(r.findings.begin(), r.findings.end(),
                     [&](const preflight::Finding& f) { return f.kind == kind; });
}

double rms(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += dot(a[i] - b[i], a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

TEST(GoingOn, WithNothingChangedComesToRestAtOnceAndHardlyMoves) {
  ASSERT_TRUE(hung().settled());
  const drape::DrapeResult on = draped(going_on(tube()));
  EXPECT_TRUE(told(on, preflight::FindingKind::kGoesOn));
  EXPECT_TRUE(on.settled());
  EXPECT_LT(on.steps, 0.2 * hung().steps);
  EXPECT_LT(rms(on.positions, hung().positions), 2e-3);
  EXPECT_EQ(on.worst.cloth_body + on.worst.cloth_cloth, 0);
}

TEST(GoingOn, WithALongerHemTakesAFractionOfTheStepsAndHangsAsIfDrapedAnew) {
  const drape::DrapeInput longer = tube(20);
  const drape::DrapeResult on = draped(going_on(longer)), anew = draped(longer);
  EXPECT_TRUE(told(on, preflight::FindingKind::kGoesOn));
  EXPECT_TRUE(on.settled());
  EXPECT_LT(on.steps, 0.5 * anew.steps);
  EXPECT_EQ(on.worst.cloth_body + on.worst.cloth_cloth, 0);
  const auto lowest = [](const drape::DrapeResult& r) {
    return std::min_element(r.positions.begin(), r.positions.end(), [](Vec3 a, Vec3 b) { return a.y < b.y; })
        ->y;
  };
  EXPECT_NEAR(lowest(on), lowest(anew), 4e-3);
  EXPECT_NEAR(lowest(on), lowest(hung()) - 0.02, 5e-3);
}

TEST(GoingOn, UndoneAgainComesBackToWhereItHung) {
  drape::DrapeInput back = tube();
  back.before = std::make_shared<const warm::HungGarment>(draped(going_on(tube(20))).hung);
  EXPECT_LT(rms(draped(back).positions, hung().positions), 15e-3);  // folds may part anew
}

TEST(GoingOn, IsBegunFromThePiecesWhereAPieceDidNotHangBefore) {
  drape::DrapeInput renamed = tube();
  renamed.pattern.panels[1].id = "yoke";
  const drape::DrapeResult r = draped(going_on(renamed));
  EXPECT_FALSE(told(r, preflight::FindingKind::kGoesOn));
  ASSERT_TRUE(told(r, preflight::FindingKind::kFromThePieces));
  const auto why = std::find_if(r.findings.begin(), r.findings.end(), [](const preflight::Finding& f) {
    return f.kind == preflight::FindingKind::kFromThePieces;
  });
  EXPECT_NE(why->message.find("piece yoke"), std::string::npos) << why->message;
  EXPECT_EQ(r.positions, draped(renamed).positions);
}

TEST(GoingOn, MovesOutOfABodyThatHasGrownAndNeverThroughIt) {
  drape::DrapeInput grown = tube();
  for (Vec3& p : grown.bodies[0].mesh.vertices) {
    p.x *= 1.02;
    p.z *= 1.02;
  }
  const drape::DrapeResult r = draped(going_on(grown));
  EXPECT_TRUE(told(r, preflight::FindingKind::kGoesOn));
  EXPECT_EQ(r.worst.cloth_body + r.worst.cloth_cloth, 0);
  EXPECT_TRUE(r.settled());
}

TEST(GoingOn, FromAnotherPlaceOfTheBodyIsBegunFromThePiecesRatherThanThroughIt) {
  drape::DrapeInput moved = tube();
  for (Vec3& p : moved.bodies[0].mesh.vertices) p.x += 0.08;
  const drape::DrapeResult r = draped(going_on(moved));
  EXPECT_EQ(r.worst.cloth_body + r.worst.cloth_cloth, 0);
  EXPECT_NE(told(r, preflight::FindingKind::kGoesOn), told(r, preflight::FindingKind::kFromThePieces));
}

TEST(GoingOn, EndsInTheSameBytesHoweverOftenItIsBrokenOff) {
  const drape::DrapeInput input = going_on(tube(20));
  const drape::DrapeResult whole = draped(input);
  auto run = drape::DrapeRun::start(input, {}, nullptr).value();
  while (!run->done()) {
    run->advance(170, {});
    run = drape::DrapeRun::resume(input, run->checkpoint(), {}, nullptr).value();
  }
  const drape::DrapeResult cut = run->conclude();
  EXPECT_EQ(cut.positions, whole.positions);
  EXPECT_TRUE(told(cut, preflight::FindingKind::kGoesOn));
  EXPECT_FALSE(drape::DrapeRun::resume(tube(20), run->checkpoint(), {}, nullptr).ok())
      << "from what it went on is part of the input";
}

TEST(GoingOn, SewsASeamThatIsNewAndShutsOneThatOpened) {
  drape::DrapeInput open = tube();
  open.pattern.seams[0].a[0].to = 0.5;  // a slit at the left side
  open.pattern.seams[0].b[0].from = 0.5;
  drape::DrapeInput shut = tube();
  shut.before = std::make_shared<const warm::HungGarment>(draped(open).hung);
  const drape::DrapeResult r = draped(shut);
  EXPECT_TRUE(told(r, preflight::FindingKind::kGoesOn));
  EXPECT_TRUE(r.open_seams.empty());
  EXPECT_EQ(r.worst.cloth_body + r.worst.cloth_cloth, 0);
}

}  // namespace
}  // namespace toile
