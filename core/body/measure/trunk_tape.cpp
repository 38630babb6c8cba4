#include "core/body/measure/trunk_tape.h"

#include <algorithm>

#include "core/body/measure/cut_points.h"

namespace toile::measure {
namespace {

// Shares of the stature.
constexpr double kClearOfArmpit = 0.004;            // below the armpit, where the bust may still be
constexpr double kHipFrom = 0.012, kHipTo = 0.105;  // above the crotch
constexpr double kFoldReach = 0.075;
constexpr double kBustBelow = 0.020, kBustAbove = 0.012;  // about the level of the bust points
constexpr double kBreastFold = 0.0045;                    // how deep the profile turns in below a breast
// Shares of the way from crotch to nape.
constexpr double kWaistLow = 0.26, kWaistHigh = 0.54;
// Where waists usually are, and by what share of the girth places farther off must be narrower (per share
// squared): a trunk without a waist would be measured at the ribs else, or anywhere.
constexpr double kUsualWaist = 0.44, kUnusualWaist = 1.0;
// Shares of the way from nape to crotch.
constexpr double kChestTop = 0.25, kUnderBust = 0.41;

void take_level(Measure m, const TrunkLevel& level, const TrunkLevels& levels, BodyMeasures& measures) {
  measures.take(m, level.girth, level.y, taut_loop(levels.points_at(level.y), {0, 1, 0}));
}

/// The narrowest place, the more so the nearer it is to where waists usually are.
TrunkLevel waist_of(const TrunkLevels& levels, const BodyPoints& p) {
  const double torso = p.nape.y - p.crotch.y;
  const auto weighed = [&](const TrunkLevel& l) {
    const double off = (l.y - p.crotch.y) / torso - kUsualWaist;
    return l.girth * (1 + kUnusualWaist * off * off);
  };
  TrunkLevel best = levels.at(p.crotch.y + kWaistLow * torso);
  for (const TrunkLevel& l : levels.all()) {
    const double share = (l.y - p.crotch.y) / torso;
    if (share > kWaistLow && share <= kWaistHigh && weighed(l) < weighed(best)) best = l;
  }
  return best;
}

struct BustProfile {
  double apex = 0;   ///< height of the most prominent place
  double depth = 0;  ///< how far the profile below lies behind the line from there to the waist
};

BustProfile bust_profile(const TrunkLevels& levels, double waist_height, double ribs, double top) {
  const std::vector<TrunkLevel>& trunk = levels.all();
  std::size_t apex = levels.index_of(ribs);
  for (std::size_t i = apex; i < levels.index_of(top); ++i)
    if (trunk[i].front > trunk[apex].front) apex = i;
  const std::size_t waist = levels.index_of(waist_height);
  const TrunkLevel &a = trunk[waist], &b = trunk[apex];
  BustProfile out{b.y, 0};
  const std::size_t fold = levels.index_of(b.y - kFoldReach * levels.stature());
  for (std::size_t i = std::max(waist, fold); i + 1 < apex; ++i) {
    const double s = (trunk[i].y - a.y) / (b.y - a.y);
    out.depth = std::max(out.depth, a.front + (b.front - a.front) * s - trunk[i].front);
  }
  return out;
}

constexpr auto kWider = [](double a, double b) { return a > b; };

/// A woman's bust is taken at the bust points, a chest at its widest, right below the armpits.
Status take_chest(const TrunkLevels& levels, BodyMeasures& measures) {
  BodyPoints& p = measures.points;
  const double torso = p.nape.y - p.crotch.y, stature = levels.stature();
  const double top = std::min(p.armpit_height - kClearOfArmpit * stature, p.nape.y - kChestTop * torso);
  const double ribs = p.nape.y - kUnderBust * torso;
  if (!(top > ribs && ribs > p.crotch.y))
    return Error{"body.not_a_body", "There is no chest to be found below the armpits.", ""};
  const BustProfile profile = bust_profile(levels, p.waist_height, ribs, top);
  const bool breasts = profile.depth > kBreastFold * stature;
  const TrunkLevel bust = breasts ? levels.extreme(profile.apex - kBustBelow * stature,
                                                   std::min(profile.apex + kBustAbove * stature, top), kWider)
                                  : levels.extreme(ribs, top, kWider);
  p.bust_height = bust.y;
  p.underbust_height = ribs;
  take_level(Measure::kBust, bust, levels, measures);
  take_level(Measure::kUnderbust, levels.at(ribs), levels, measures);
  return {};
}

}  // namespace

Status measure_trunk(const TrunkLevels& levels, BodyMeasures& measures) {
  BodyPoints& p = measures.points;
  const double stature = levels.stature();
  const TrunkLevel hip =
      levels.extreme(p.crotch.y + kHipFrom * stature, p.crotch.y + kHipTo * stature, kWider);
  const TrunkLevel waist = waist_of(levels, p);
  if (!(p.armpit_height > waist.y + 0.03 * stature))
    return Error{"body.not_a_body", "There are no armpits to be found above the waist.", ""};
  p.hip_height = hip.y;
  p.waist_height = waist.y;
  take_level(Measure::kHip, hip, levels, measures);
  take_level(Measure::kWaist, waist, levels, measures);
  return take_chest(levels, measures);
}

}  // namespace toile::measure
