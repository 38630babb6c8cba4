// Drapes that go on from where another ended.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "core/drape/pipeline.h"
#include "tests/core/arrange/garments.h"
#include "tests/core/drape/runs.h"
#include "tests/core/dressing/dressed_person.h"

namespace toile {
namespace {

/// A tube around the mannequin's hips that widens by `flare` mm a side down to its hem, `longer` mm lower.
drape::DrapeInput flared_tube(double longer = 0, double flare = 40) {
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

/// As flared_tube(), once it hung.
const drape::DrapeResult& hung() {
  static const drape::DrapeResult result = draped(flared_tube());
  return result;
}

drape::DrapeInput going_on(drape::DrapeInput input) {
  input.before = std::make_shared<const warm::HungGarment>(hung().hung);
  return input;
}

double rms(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += dot(a[i] - b[i], a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

TEST(GoingOn, WithNothingChangedComesToRestAtOnceAndHardlyMoves) {
  ASSERT_TRUE(hung().settled());
  const drape::DrapeResult on = draped(going_on(flared_tube()));
  EXPECT_TRUE(told(on.findings, preflight::FindingKind::kGoesOn));
  EXPECT_TRUE(on.settled());
  EXPECT_LT(on.steps, 0.2 * hung().steps);
  EXPECT_LT(rms(on.positions, hung().positions), 2e-3);
  EXPECT_EQ(on.worst.cloth_body + on.worst.cloth_cloth, 0);
}

TEST(GoingOn, WithALongerHemTakesAFractionOfTheStepsAndHangsAsIfDrapedAnew) {
  const drape::DrapeInput longer = flared_tube(20);
  const drape::DrapeResult on = draped(going_on(longer)), anew = draped(longer);
  EXPECT_TRUE(told(on.findings, preflight::FindingKind::kGoesOn));
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
  drape::DrapeInput back = flared_tube();
  back.before = std::make_shared<const warm::HungGarment>(draped(going_on(flared_tube(20))).hung);
  EXPECT_LT(rms(draped(back).positions, hung().positions), 15e-3);  // folds may part anew
}

TEST(GoingOn, IsBegunFromThePiecesWhereAPieceDidNotHangBefore) {
  drape::DrapeInput renamed = flared_tube();
  renamed.pattern.panels[1].id = "yoke";
  const drape::DrapeResult r = draped(going_on(renamed));
  EXPECT_FALSE(told(r.findings, preflight::FindingKind::kGoesOn));
  ASSERT_TRUE(told(r.findings, preflight::FindingKind::kFromThePieces));
  const auto why = std::find_if(r.findings.begin(), r.findings.end(), [](const preflight::Finding& f) {
    return f.kind == preflight::FindingKind::kFromThePieces;
  });
  EXPECT_NE(why->message.find("piece yoke"), std::string::npos) << why->message;
  EXPECT_EQ(r.positions, draped(renamed).positions);
}

TEST(GoingOn, MovesOutOfABodyThatHasGrownAndNeverThroughIt) {
  drape::DrapeInput grown = flared_tube();
  for (Vec3& p : grown.bodies[0].mesh.vertices) {
    p.x *= 1.02;
    p.z *= 1.02;
  }
  const drape::DrapeResult r = draped(going_on(grown));
  EXPECT_TRUE(told(r.findings, preflight::FindingKind::kGoesOn));
  EXPECT_EQ(r.worst.cloth_body + r.worst.cloth_cloth, 0);
  EXPECT_TRUE(r.settled());
}

TEST(GoingOn, FromAnotherPlaceOfTheBodyIsBegunFromThePiecesRatherThanThroughIt) {
  drape::DrapeInput moved = flared_tube();
  for (Vec3& p : moved.bodies[0].mesh.vertices) p.x += 0.08;
  const drape::DrapeResult r = draped(going_on(moved));
  EXPECT_EQ(r.worst.cloth_body + r.worst.cloth_cloth, 0);
  EXPECT_NE(told(r.findings, preflight::FindingKind::kGoesOn),
            told(r.findings, preflight::FindingKind::kFromThePieces));
}

TEST(GoingOn, EndsInTheSameBytesHoweverOftenItIsBrokenOff) {
  const drape::DrapeInput input = going_on(flared_tube(20));
  const drape::DrapeResult whole = draped(input);
  auto run = drape::DrapeRun::start(input, {}, nullptr).value();
  while (!run->done()) {
    run->advance(170, {});
    run = drape::DrapeRun::resume(input, run->checkpoint(), {}, nullptr).value();
  }
  const drape::DrapeResult cut = run->conclude();
  EXPECT_EQ(cut.positions, whole.positions);
  EXPECT_TRUE(told(cut.findings, preflight::FindingKind::kGoesOn));
  EXPECT_FALSE(drape::DrapeRun::resume(flared_tube(20), run->checkpoint(), {}, nullptr).ok())
      << "from what it went on is part of the input";
}

/// The triangle of the front whose middle is lowest and farthest to the left, in the flat.
Index low_corner(const sewing::GarmentMesh& garment) {
  Index best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    if (garment.panel_of_triangle[t] != 0) continue;
    double sum = 0;
    for (const Index v : garment.triangles[t]) sum += garment.rest[v].x + 2 * garment.rest[v].y;
    if (sum >= least) continue;
    least = sum;
    best = static_cast<Index>(t);
  }
  return best;
}

Vec3 middle(const sewing::GarmentMesh& garment, const std::vector<Vec3>& x, Index triangle) {
  Vec3 sum;
  for (const Index v : garment.triangles[static_cast<std::size_t>(triangle)]) sum += x[v];
  return sum * (1.0 / 3);
}

/// As flared_tube() hung with its lower corner held 8 cm up.
const drape::DrapeResult& held_up() {
  static const drape::DrapeResult result = [] {
    const drape::DrapeInput input = going_on(flared_tube());
    const auto run = drape::DrapeRun::start(input, {}, nullptr).value();
    const sewing::GarmentMesh& garment = run->session().garment();
    const drape::TouchedPoint at{low_corner(garment), {0.25, 0.25, 0.5}};
    const Vec3 place = middle(garment, run->session().positions(), at.triangle);
    EXPECT_TRUE(run->touch({0, drape::TouchKind::kPull, 1, at, place + Vec3{0, 0.08, 0}}));
    run->advance(3000, {});
    EXPECT_TRUE(run->touch({0, drape::TouchKind::kPin, 0, at, {}}));
    EXPECT_TRUE(run->touch({0, drape::TouchKind::kLetGo, 1, {}, {}}));
    run->advance(std::numeric_limits<int>::max(), {});
    return run->conclude();
  }();
  return result;
}

double height_of_corner(const drape::DrapeResult& r) {
  return middle(r.garment, r.positions, low_corner(r.garment)).y;
}

TEST(GoingOn, KeepsThePinsThatHeldTheClothInAnEditedPattern) {
  ASSERT_EQ(held_up().hung.pins.size(), 1U);
  EXPECT_GT(height_of_corner(held_up()), height_of_corner(hung()) + 0.04);
  drape::DrapeInput longer = flared_tube(20);
  longer.before = std::make_shared<const warm::HungGarment>(held_up().hung);
  const drape::DrapeResult on = draped(longer);
  EXPECT_TRUE(told(on.findings, preflight::FindingKind::kGoesOn));
  EXPECT_TRUE(told(on.findings, preflight::FindingKind::kTouched));
  EXPECT_GT(height_of_corner(on), height_of_corner(hung()) + 0.02) << "it is held up";
  ASSERT_EQ(on.touches.size(), 1U);
  EXPECT_EQ(on.touches[0].kind, drape::TouchKind::kPin);
  EXPECT_EQ(on.touches[0].step, 0);
  EXPECT_EQ(on.touches[0].id, 1);
  EXPECT_EQ(on.hung.pins.size(), 1U) << "and in the next";

  auto loose = std::make_shared<warm::HungGarment>(held_up().hung);
  loose->pins.clear();
  longer.before = loose;
  EXPECT_LT(height_of_corner(draped(longer)), height_of_corner(on) - 0.02) << "for it falls without";
}

TEST(GoingOn, WithPinsDrapesTheSameAgainFromItsLogAndHoweverOftenItIsBrokenOff) {
  drape::DrapeInput longer = flared_tube(20);
  longer.before = std::make_shared<const warm::HungGarment>(held_up().hung);
  auto run = drape::DrapeRun::start(longer, {}, nullptr).value();
  run->advance(200, {});
  ASSERT_TRUE(run->touch({0, drape::TouchKind::kUnpin, 1, {}, {}})) << "the pin of before";
  while (!run->done()) {
    run->advance(170, {});
    run = drape::DrapeRun::resume(longer, run->checkpoint(), {}, nullptr).value();
  }
  const drape::DrapeResult cut = run->conclude();
  ASSERT_EQ(cut.touches.size(), 2U);
  const auto again = drape::DrapeRun::start(longer, {}, nullptr).value();
  ASSERT_TRUE(again->replay(cut.touches));
  again->advance(std::numeric_limits<int>::max(), {});
  EXPECT_EQ(again->conclude().positions, cut.positions);
  const auto other = drape::DrapeRun::start(longer, {}, nullptr).value();
  EXPECT_EQ(other->replay({cut.touches[1]}).error().code, "live.no_pin");
  drape::Touch elsewhere = cut.touches[0];
  elsewhere.at.triangle += 1;
  EXPECT_EQ(other->replay({elsewhere}).error().code, "live.order") << "a log of another garment";
}

TEST(GoingOn, SewsASeamThatIsNewAndShutsOneThatOpened) {
  drape::DrapeInput open = flared_tube();
  open.pattern.seams[0].a[0].to = 0.5;  // a slit at the left side
  open.pattern.seams[0].b[0].from = 0.5;
  drape::DrapeInput shut = flared_tube();
  shut.before = std::make_shared<const warm::HungGarment>(draped(open).hung);
  const drape::DrapeResult r = draped(shut);
  EXPECT_TRUE(told(r.findings, preflight::FindingKind::kGoesOn));
  EXPECT_TRUE(r.open_seams.empty());
  EXPECT_EQ(r.worst.cloth_body + r.worst.cloth_cloth, 0);
}

}  // namespace
}  // namespace toile
