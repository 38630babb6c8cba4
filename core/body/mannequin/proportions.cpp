#include "core/body/mannequin/proportions.h"

#include <algorithm>
#include <cmath>

namespace toile::mannequin {
namespace {

constexpr BodyPreset kPresets[] = {
    {"eu34", Sex::kFemale, 1.68, 0.80, 0.64, 0.88},      {"eu36", Sex::kFemale, 1.68, 0.84, 0.68, 0.92},
    {"eu38", Sex::kFemale, 1.68, 0.88, 0.72, 0.96},      {"eu40", Sex::kFemale, 1.68, 0.92, 0.76, 1.00},
    {"eu42", Sex::kFemale, 1.68, 0.96, 0.80, 1.04},      {"eu44", Sex::kFemale, 1.68, 1.00, 0.84, 1.08},
    {"eu46", Sex::kFemale, 1.68, 1.04, 0.88, 1.12},      {"eu48", Sex::kFemale, 1.68, 1.10, 0.94, 1.17},
    {"m44", Sex::kMale, 1.68, 0.88, 0.76, 0.92},         {"m46", Sex::kMale, 1.71, 0.92, 0.80, 0.95},
    {"m48", Sex::kMale, 1.74, 0.96, 0.84, 0.98},         {"m50", Sex::kMale, 1.77, 1.00, 0.88, 1.01},
    {"m52", Sex::kMale, 1.80, 1.04, 0.92, 1.04},         {"m54", Sex::kMale, 1.82, 1.08, 0.96, 1.08},
    {"m56", Sex::kMale, 1.84, 1.12, 1.00, 1.12},         {"m58", Sex::kMale, 1.86, 1.16, 1.04, 1.16},
    {"child92", Sex::kChild, 0.92, 0.54, 0.510, 0.550},  {"child98", Sex::kChild, 0.98, 0.55, 0.520, 0.570},
    {"child104", Sex::kChild, 1.04, 0.56, 0.530, 0.590}, {"child110", Sex::kChild, 1.10, 0.58, 0.540, 0.615},
    {"child116", Sex::kChild, 1.16, 0.60, 0.550, 0.640}, {"child122", Sex::kChild, 1.22, 0.62, 0.565, 0.665},
    {"child128", Sex::kChild, 1.28, 0.64, 0.580, 0.690}, {"child134", Sex::kChild, 1.34, 0.67, 0.595, 0.720},
    {"child140", Sex::kChild, 1.40, 0.70, 0.610, 0.750}, {"child146", Sex::kChild, 1.46, 0.73, 0.625, 0.780},
    {"child152", Sex::kChild, 1.52, 0.76, 0.640, 0.810}, {"child158", Sex::kChild, 1.58, 0.79, 0.655, 0.840},
    {"child164", Sex::kChild, 1.64, 0.82, 0.670, 0.870}, {"child170", Sex::kChild, 1.70, 0.85, 0.685, 0.900},
};

double default_height(Sex sex) { return sex == Sex::kFemale ? 1.68 : sex == Sex::kMale ? 1.78 : 1.28; }

// Trunk girths of a body of this height when nothing else is known.
BodyPreset usual_body(Sex sex, double height) {
  if (sex == Sex::kFemale) {
    const double s = height / 1.68;
    return {"", sex, height, 0.88 * s, 0.72 * s, 0.96 * s};
  }
  if (sex == Sex::kMale) {
    const double s = height / 1.78;
    return {"", sex, height, 1.00 * s, 0.88 * s, 1.01 * s};
  }
  const BodyPreset *below = find_preset("child92"), *last = find_preset("child170");
  while (below + 1 < last && below[1].height < height) ++below;
  const BodyPreset &a = below[0], &b = below[1];
  const double s = (height - a.height) / (b.height - a.height);
  const auto at = [s](double x, double y) { return x + (y - x) * s; };
  return {"", sex, height, at(a.bust, b.bust), at(a.waist, b.waist), at(a.hip, b.hip)};
}

void fill(measure::MeasureSet& set, measure::Measure m, double value) {
  if (!set[m]) set[m] = value;
}

void fill_trunk(Sex sex, measure::MeasureSet& m) {
  const BodyPreset usual = usual_body(sex, *m[measure::Measure::kHeight]);
  const std::pair<measure::Measure, double> table[] = {{measure::Measure::kBust, usual.bust},
                                                       {measure::Measure::kWaist, usual.waist},
                                                       {measure::Measure::kHip, usual.hip}};
  double shift = 0;
  int known = 0;
  for (const auto& [measure, value] : table)
    if (m[measure]) {
      shift += *m[measure] - value;
      ++known;
    }
  if (known > 0) shift /= known;
  for (const auto& [measure, value] : table) fill(m, measure, value + shift);
  const double bust = *m[measure::Measure::kBust], waist = *m[measure::Measure::kWaist];
  // A B cup lies about 13 cm over the underbust; a straight trunk leaves less.
  if (sex == Sex::kFemale)
    fill(m, measure::Measure::kUnderbust,
         std::max({bust - 0.13, 0.6 * bust + 0.4 * waist - 0.04, waist + 0.05}));
  if (sex != Sex::kFemale) fill(m, measure::Measure::kUnderbust, 0.5 * bust + 0.5 * waist);
}

struct Ratios {
  double neck, neck_per_bust, upper_arm, upper_per_bust, wrist, wrist_per_bust;  // girths: at `bust`
  double bust, thigh, calf;                                                      // the latter per hip
};

constexpr Ratios kFemaleRatios{0.325, 0.13, 0.275, 0.32, 0.157, 0.05, 0.90, 0.578, 0.370};
constexpr Ratios kMaleRatios{0.378, 0.18, 0.310, 0.30, 0.172, 0.06, 1.00, 0.575, 0.378};

}  // namespace

measure::MeasureSet BodyPreset::measures() const {
  measure::MeasureSet m;
  m[measure::Measure::kHeight] = height;
  m[measure::Measure::kBust] = bust;
  m[measure::Measure::kWaist] = waist;
  m[measure::Measure::kHip] = hip;
  return m;
}

std::span<const BodyPreset> body_presets() { return kPresets; }

const BodyPreset* find_preset(std::string_view name) {
  for (const BodyPreset& p : kPresets)
    if (p.name == name) return &p;
  return nullptr;
}

double head_size(Sex sex, double height) {
  if (sex != Sex::kChild) return 1;
  // A head grows from 18 cm at 0.98 m to 22 cm at 1.7 m.
  const double x = std::max(0.0, (1.70 - height) / 0.72);
  return 1 + 0.25 * x + 0.17 * x * x;
}

measure::MeasureSet with_proportions(Sex sex, const measure::MeasureSet& asked) {
  measure::MeasureSet m = asked;
  fill(m, measure::Measure::kHeight, default_height(sex));
  fill_trunk(sex, m);
  const Figure& f = figure_of(sex);
  const Ratios& r = sex == Sex::kFemale ? kFemaleRatios : kMaleRatios;
  const double h = *m[measure::Measure::kHeight], bust = *m[measure::Measure::kBust],
               hip = *m[measure::Measure::kHip];
  const bool child = sex == Sex::kChild;
  const auto girth = [&](double at, double per_bust) {
    return child ? at * (0.35 + 0.65 * bust / r.bust) : std::max(at + per_bust * (bust - r.bust), 0.6 * at);
  };
  fill(m, measure::Measure::kNeck, girth(r.neck, r.neck_per_bust) * (child ? 0.98 : 1));
  const double broad = 0.28 * (bust - h * f.of(measure::Measure::kBust));
  fill(m, measure::Measure::kShoulderWidth,
       h * f.of(measure::Measure::kShoulderWidth) * (child ? 0.96 : 1) + broad);
  fill(m, measure::Measure::kUpperArm, child ? 0.29 * bust : girth(r.upper_arm, r.upper_per_bust));
  fill(m, measure::Measure::kWrist, child ? 0.075 + 0.090 * bust : girth(r.wrist, r.wrist_per_bust));
  fill(m, measure::Measure::kArmLength, h * f.of(measure::Measure::kArmLength) * (child ? 0.95 : 1));
  fill(m, measure::Measure::kThigh, r.thigh * hip);
  fill(m, measure::Measure::kCalf, r.calf * hip);
  fill(m, measure::Measure::kInseam,
       h * (child ? std::clamp(0.395 + 0.055 * h / 1.28, 0.42, 0.46) : f.of(measure::Measure::kInseam)));
  fill(m, measure::Measure::kBackLength, h * f.of(measure::Measure::kBackLength) * (child ? 0.97 : 1));
  return m;
}

}  // namespace toile::mannequin
