#include "core/body/mannequin/mannequin.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/base/hash.h"
#include "core/base/units.h"
#include "core/body/mannequin/proportions.h"
#include "core/body/measure/tape.h"
#include "tests/core/body/mannequin/random_measures.h"
#include "tests/core/body/mesh_checks.h"

namespace toile {
namespace {

void expect_proper(const geometry::TriangleMesh& mesh) {
  EXPECT_EQ(open_edges(mesh), 0);
  EXPECT_TRUE(fans_are_whole(mesh));
  EXPECT_EQ(self_crossings(mesh), 0);
  EXPECT_GT(volume(mesh), 0);
  // Euler's number of one closed surface without handles.
  EXPECT_EQ(static_cast<int>(mesh.vertices.size()) - static_cast<int>(mesh.triangles.size()) / 2, 2);
}

void expect_met(const mannequin::Mannequin& made, const measure::MeasureSet& asked) {
  for (int i = 0; i < measure::kMeasureCount; ++i) {
    const measure::Measure m = measure::measure_at(i);
    if (!asked[m]) continue;
    ASSERT_TRUE(made.measures[m]) << measure::measure_name(m);
    EXPECT_NEAR(made.measures[m]->value, *asked[m], measure::is_girth(m) ? 0.005 : 0.010)
        << measure::measure_name(m);
  }
}

mannequin::MannequinSettings woman(double height, double bust, double waist, double hip) {
  mannequin::MannequinSettings s;
  s.asked[measure::Measure::kHeight] = height;
  s.asked[measure::Measure::kBust] = bust;
  s.asked[measure::Measure::kWaist] = waist;
  s.asked[measure::Measure::kHip] = hip;
  return s;
}

TEST(Mannequin, IsClosedManifoldOutwardAndDoesNotCrossItself) {
  const Result<mannequin::Mannequin> made = mannequin::make_mannequin({});
  ASSERT_TRUE(made) << to_string(made.error());
  expect_proper(made->mesh);
  EXPECT_EQ(made->mesh.triangles.size(), 4562u);
  EXPECT_GT(degrees_from_radians(least_angle(made->mesh)), 9);
  EXPECT_GT(volume(made->mesh), 0.040);  // m³: a person of 1.68 m weighs 45 to 75 kg
  EXPECT_LT(volume(made->mesh), 0.075);
}

TEST(Mannequin, StandsOnTheFloorAsTallAsAskedAndFacesFront) {
  const Result<mannequin::Mannequin> made = mannequin::make_mannequin(woman(1.62, 0.85, 0.68, 0.93));
  ASSERT_TRUE(made) << to_string(made.error());
  double low = 1e9, high = -1e9, left = 0, right = 0, toes = 0, heels = 0;
  for (const Vec3& p : made->mesh.vertices) {
    low = std::min(low, p.y);
    high = std::max(high, p.y);
    left = std::max(left, p.x);
    right = std::max(right, -p.x);
    if (p.y < 0.05) {
      toes = std::max(toes, p.z);
      heels = std::max(heels, -p.z);
    }
  }
  EXPECT_NEAR(low, 0, 1e-12);
  EXPECT_NEAR(high, 1.62, 1e-9);
  EXPECT_NEAR(left, right, 0.01);
  EXPECT_GT(toes, heels) << "the feet point along +z";
}

TEST(Mannequin, IsAsWideAsAskedByAPlainTapeToo) {
  const mannequin::MannequinSettings s = woman(1.68, 0.92, 0.74, 0.99);
  const Result<mannequin::Mannequin> made = mannequin::make_mannequin(s);
  ASSERT_TRUE(made) << to_string(made.error());
  expect_met(*made, s.asked);
  EXPECT_NEAR(measure::narrowest_girth(made->mesh, 0.56 * 1.68, 0.68 * 1.68).girth, 0.74, 0.005);
  EXPECT_NEAR(measure::widest_girth(made->mesh, 0.48 * 1.68, 0.56 * 1.68).girth, 0.99, 0.005);
}

class MannequinOfAnySex : public testing::TestWithParam<mannequin::Sex> {};

TEST_P(MannequinOfAnySex, MeetsWhatWasAskedOfPeopleByChance) {
  PeopleByChance people(6);
  for (int i = 0; i < 3; ++i) {
    const mannequin::MannequinSettings s = people.next(GetParam());
    const Result<mannequin::Mannequin> made = mannequin::make_mannequin(s);
    ASSERT_TRUE(made) << i << ": " << to_string(made.error());
    expect_met(*made, s.asked);
    expect_proper(made->mesh);
    EXPECT_EQ(made->mesh.triangles.size(), static_cast<size_t>(s.triangle_count));
  }
}

INSTANTIATE_TEST_SUITE_P(Sexes, MannequinOfAnySex,
                         testing::Values(mannequin::Sex::kFemale, mannequin::Sex::kMale,
                                         mannequin::Sex::kChild));

TEST(Mannequin, HoldsItsArmsAsAsked) {
  mannequin::MannequinSettings s;
  s.arm_angle = mannequin::kQuarterTurn;
  const Result<mannequin::Mannequin> level = mannequin::make_mannequin(s);
  ASSERT_TRUE(level) << to_string(level.error());
  expect_proper(level->mesh);
  EXPECT_NEAR(level->joints.hand_tip.y, level->joints.shoulder.y, 0.03);
  s.arm_angle = radians_from_degrees(35);
  const Result<mannequin::Mannequin> low = mannequin::make_mannequin(s);
  ASSERT_TRUE(low) << to_string(low.error());
  expect_proper(low->mesh);
  const Vec3 arm = low->joints.wrist - low->joints.shoulder;
  EXPECT_NEAR(arm.x / -arm.y, 0.70, 0.05) << "the tangent of 35°";
}

TEST(Mannequin, HasAsManyTrianglesAsAsked) {
  for (Index count : {2000, 3301, 9000}) {
    mannequin::MannequinSettings s;
    s.triangle_count = count;
    const Result<mannequin::Mannequin> made = mannequin::make_mannequin(s);
    ASSERT_TRUE(made) << to_string(made.error());
    EXPECT_NEAR(static_cast<double>(made->mesh.triangles.size()), count, 1);
    expect_proper(made->mesh);
  }
}

TEST(Mannequin, GivesTheSameBytesEachTime) {
  const Result<mannequin::Mannequin> a = mannequin::make_mannequin({}), b = mannequin::make_mannequin({});
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->mesh.triangles, b->mesh.triangles);
  EXPECT_EQ(hash_of(a->mesh.vertices), hash_of(b->mesh.vertices));
}

TEST(Mannequin, RefusesMeasuresThatNoBodyHas) {
  for (double waist : {0.0, 5.0, -0.7, std::numeric_limits<double>::quiet_NaN()}) {
    mannequin::MannequinSettings s;
    s.asked[measure::Measure::kWaist] = waist;
    const Result<mannequin::Mannequin> made = mannequin::make_mannequin(s);
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().code, "mannequin.setting");
    EXPECT_EQ(made.error().where, "waist");
  }
  mannequin::MannequinSettings few, stiff, giant;
  few.triangle_count = 10;
  stiff.arm_angle = 0;
  giant.asked[measure::Measure::kHeight] = 3;
  EXPECT_EQ(mannequin::make_mannequin(few).error().where, "triangles");
  EXPECT_EQ(mannequin::make_mannequin(stiff).error().where, "arm_angle");
  EXPECT_EQ(mannequin::make_mannequin(giant).error().where, "height");
}

TEST(BodyProportions, FillTheGapsAndKeepWhatWasAsked) {
  measure::MeasureSet asked;
  asked[measure::Measure::kHeight] = 1.75;
  asked[measure::Measure::kWaist] = 0.80;
  const measure::MeasureSet all = mannequin::with_proportions(mannequin::Sex::kFemale, asked);
  for (int i = 0; i < measure::kMeasureCount; ++i)
    EXPECT_TRUE(all[measure::measure_at(i)]) << measure::measure_name(measure::measure_at(i));
  EXPECT_EQ(*all[measure::Measure::kWaist], 0.80);
  EXPECT_GT(*all[measure::Measure::kHip], *all[measure::Measure::kWaist]);
  EXPECT_GT(*all[measure::Measure::kBust], *all[measure::Measure::kUnderbust]);
}

TEST(Mannequin, SaysWhatWasAskedWhatThereIsAndWhatWouldDo) {
  mannequin::MannequinSettings s = woman(1.68, 0.92, 0.74, 0.99);
  s.asked[measure::Measure::kWaist] = 0.30;
  EXPECT_EQ(mannequin::make_mannequin(s).error().message,
            "waist is 30 cm; for a height of 168 cm it must lie between 52.1 and 124.3 cm.");
  // A bust as narrow as the ribs below it are asked to be wide.
  s = woman(1.68, 0.80, 0.74, 0.99);
  s.asked[measure::Measure::kUnderbust] = 0.98;
  s.triangle_count = 1500;
  const Error refused = mannequin::make_mannequin(s).error();
  EXPECT_EQ(refused.code, "mannequin.measures");
  EXPECT_NE(refused.message.find(refused.where + " was asked at "), std::string::npos) << refused.message;
  EXPECT_NE(refused.message.find(" cm, or leave it out, or ask for 2000 triangles or more."),
            std::string::npos)
      << refused.message;
}

struct SizeRow {
  const char* name;
  int first, second, third;  // cm
};

TEST(BodyProportions, HaveTheWomensScaleOfEn13402) {
  const SizeRow rows[] = {{"eu34", 80, 64, 88},   {"eu36", 84, 68, 92},  {"eu38", 88, 72, 96},
                          {"eu40", 92, 76, 100},  {"eu42", 96, 80, 104}, {"eu44", 100, 84, 108},
                          {"eu46", 104, 88, 112}, {"eu48", 110, 94, 117}};
  for (const SizeRow& row : rows) {
    const mannequin::BodyPreset* p = mannequin::find_preset(row.name);
    ASSERT_NE(p, nullptr) << row.name;
    EXPECT_EQ(p->sex, mannequin::Sex::kFemale);
    EXPECT_NEAR(p->bust * 100, row.first, 1e-9) << row.name;
    EXPECT_NEAR(p->waist * 100, row.second, 1e-9) << row.name;
    EXPECT_NEAR(p->hip * 100, row.third, 1e-9) << row.name;
  }
}

TEST(BodyProportions, HaveMensChestsOfTwiceTheSizeAndWaistsOf12CmLess) {
  for (int size = 44; size <= 58; size += 2) {
    const mannequin::BodyPreset* p = mannequin::find_preset("m" + std::to_string(size));
    ASSERT_NE(p, nullptr) << size;
    EXPECT_EQ(p->sex, mannequin::Sex::kMale);
    EXPECT_NEAR(p->bust * 100, 2 * size, 1e-9);
    EXPECT_NEAR(p->waist * 100, 2 * size - 12, 1e-9);
  }
}

TEST(BodyProportions, HaveChildrenInStepsOf6Cm) {
  double bust = 0, waist = 0, hip = 0;
  for (int height = 92; height <= 170; height += 6) {
    const mannequin::BodyPreset* p = mannequin::find_preset("child" + std::to_string(height));
    ASSERT_NE(p, nullptr) << height;
    EXPECT_EQ(p->sex, mannequin::Sex::kChild);
    EXPECT_NEAR(p->height * 100, height, 1e-9);
    EXPECT_GT(p->bust, bust);
    EXPECT_GT(p->waist, waist);
    EXPECT_GT(p->hip, hip);
    bust = p->bust;
    waist = p->waist;
    hip = p->hip;
  }
  EXPECT_EQ(mannequin::body_presets().size(), 8u + 8u + 14u);
  EXPECT_EQ(mannequin::find_preset("eu37"), nullptr);
}

class LongMannequin : public testing::TestWithParam<mannequin::Sex> {};

TEST_P(LongMannequin, MeetsWhatWasAskedOfTwoHundredPeople) {
  PeopleByChance people(3);
  int unmet = 0, improper = 0;
  for (int i = 0; i < 200; ++i) {
    const mannequin::MannequinSettings s = people.next(GetParam());
    const Result<mannequin::Mannequin> made = mannequin::make_mannequin(s);
    if (!made) {
      ++unmet;
      std::printf("person %d: %s\n", i, to_string(made.error()).c_str());
      continue;
    }
    expect_met(*made, s.asked);
    if (open_edges(made->mesh) + self_crossings(made->mesh) + !fans_are_whole(made->mesh) > 0) {
      ++improper;
      std::printf("person %d: %d crossings\n", i, self_crossings(made->mesh));
    }
  }
  EXPECT_EQ(unmet, 0);
  EXPECT_EQ(improper, 0);
}

TEST_P(LongMannequin, MakesEverySizeOfTheTables) {
  for (const mannequin::BodyPreset& p : mannequin::body_presets()) {
    if (p.sex != GetParam()) continue;
    mannequin::MannequinSettings s;
    s.sex = p.sex;
    s.asked = p.measures();
    const Result<mannequin::Mannequin> made = mannequin::make_mannequin(s);
    ASSERT_TRUE(made) << p.name << ": " << to_string(made.error());
    expect_met(*made, s.asked);
    expect_proper(made->mesh);
  }
}

INSTANTIATE_TEST_SUITE_P(Long, LongMannequin,
                         testing::Values(mannequin::Sex::kFemale, mannequin::Sex::kMale,
                                         mannequin::Sex::kChild));

}  // namespace
}  // namespace toile
