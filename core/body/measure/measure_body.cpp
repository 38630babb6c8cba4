// The tape's way over a standing body: trunk, neck, leg; arm_tape.cpp goes on along the arm.

#include <algorithm>
#include <cmath>

#include "core/body/measure/arm_tape.h"
#include "core/body/measure/cut_points.h"
#include "core/body/measure/measures.h"
#include "core/body/measure/mesh_cut.h"
#include "core/geometry/convex_hull.h"

namespace toile::measure {
namespace {

// Shares of the stature.
constexpr double kLevelStep = 0.0018;
constexpr double kTrunkLow = 0.36, kTrunkHigh = 0.86;
constexpr double kRibs = 0.66;            // below a grown-up's armpit, above any waist that matters here
constexpr double kLowRibs = 0.60;         // the same of small children, who have arms at the former
constexpr double kArmJump = 1.35;         // the trunk's breadth grows so much where arms join it
constexpr double kClearOfArmpit = 0.004;  // below the armpit, where the bust may still be
constexpr double kWaistLow = 0.26, kWaistHigh = 0.54;
// Where waists usually are, and by what share of the girth places farther off must be narrower (per share
// squared): a trunk without a waist would be measured at the ribs else, or anywhere.
constexpr double kUsualWaist = 0.44, kUnusualWaist = 1.0;
constexpr double kHipFrom = 0.012, kHipTo = 0.105;  // above the crotch
constexpr double kThighBelowCrotch = 0.008;
constexpr double kCalfLow = 0.30, kCalfHigh = 0.62;  // of the crotch's height
// Shares of the way from nape to crotch.
constexpr double kChestTop = 0.25, kUnderBust = 0.41;
constexpr double kFoldReach = 0.075;
constexpr double kBustBelow = 0.020, kBustAbove = 0.012;  // about the level of the bust points
constexpr double kBreastFold = 0.0045;                    // how deep the profile turns in below a breast
// Shares of the way from crotch to neck.
constexpr double kHollowAbove = 0.055;  // of the narrowest level, in statures: the nape of the neck is hollow
constexpr double kLumbarLeast = 0.16, kLumbarLow = 0.28, kLumbarHigh = 0.66, kBladeFrom = 0.86,
                 kLumbarDepth = 0.005;
constexpr double kNapeShare = 0.44;  // of the way from the neck's hollow back to the blades
constexpr double kSpine = 0.025;     // of the middle plane, in statures: what counts as mid-back
constexpr double kNeckLeans[] = {0, 0.09, 0.18, 0.27, 0.36, 0.47};  // tangents: the front edge hangs lower

struct Level {
  double y = 0, girth = 0;
  double half = 0;             // half the breadth about the middle
  double front = 0, back = 0;  // extreme z
};

class BodyTape {
 public:
  explicit BodyTape(const geometry::TriangleMesh& mesh) : mesh_(mesh), level_(mesh, {0, 1, 0}) {}

  Status run() {
    stature_ = level_.high();
    take(Measure::kHeight, stature_, stature_);
    find_middle();
    scan_trunk();
    find_armpit();
    TRY(find_crotch());
    find_neck();
    find_nape();
    TRY(find_trunk_girths());
    measure_arm(mesh_, stature_, measures);
    find_leg();
    return {};
  }

  BodyMeasures measures;

 private:
  void take(Measure m, double value, double height, std::vector<Vec3> line = {}) {
    measures.take(m, value, height, std::move(line));
  }
  void take_level(Measure m, const Level& level) {
    const std::vector<Vec3> points = middle_points(level_.at(level.y), measures.points.middle);
    take(m, level.girth, level.y, taut_loop(points, {0, 1, 0}));
  }
  BodyPoints& points() { return measures.points; }

  void find_middle() {
    double least = HUGE_VAL;  // breadth: at one of the levels an arm may have joined the trunk
    for (double share : {kRibs, kLowRibs}) {
      const std::vector<Vec3> ribs = middle_points(level_.at(share * stature_), 0);
      const double x = middle_of(ribs).x;
      double breadth = 0;
      for (const Vec3& p : ribs) breadth = std::max(breadth, std::abs(p.x - x));
      if (!ribs.empty() && breadth < least) {
        least = breadth;
        points().middle = x;
      }
    }
  }

  Level level_at(double y) const {
    const double middle = measures.points.middle;
    const std::vector<Vec3> ps = middle_points(level_.at(y), middle);
    Level l{y, geometry::hull_perimeter(flat(ps)), 0, -HUGE_VAL, HUGE_VAL};
    for (const Vec3& p : ps) {
      l.half = std::max(l.half, std::abs(p.x - middle));
      l.front = std::max(l.front, p.z);
      l.back = std::min(l.back, p.z);
    }
    return l;
  }

  void scan_trunk() {
    for (double y = kTrunkLow * stature_; y < kTrunkHigh * stature_; y += kLevelStep * stature_)
      trunk_.push_back(level_at(y));
  }

  size_t index_of(double y) const {
    const double i = (y - trunk_.front().y) / (kLevelStep * stature_);
    return static_cast<size_t>(std::clamp(i, 0.0, static_cast<double>(trunk_.size() - 1)));
  }

  // Upwards from the ribs, to where arms join the trunk.
  void find_armpit() {
    size_t ribs = index_of(kRibs * stature_);
    const size_t low_ribs = index_of(kLowRibs * stature_);
    if (trunk_[ribs].half > kArmJump * trunk_[low_ribs].half) ribs = low_ribs;
    size_t i = ribs;
    while (i + 1 < trunk_.size() && trunk_[i + 1].half < kArmJump * trunk_[ribs].half) ++i;
    double low = trunk_[i].y, high = low + kLevelStep * stature_;
    for (int round = 0; round < 5; ++round) {
      const double mid = (low + high) / 2;
      (level_at(mid).half < kArmJump * trunk_[ribs].half ? low : high) = mid;
    }
    const Level last = level_at(low);
    points().armpit = {points().middle + last.half, low, (last.front + last.back) / 2};
    points().armpit_height = low;
  }

  Status find_crotch() {
    const MeshCut cut = plane_cut(mesh_, {points().middle, 0, 0}, {1, 0, 0});
    double low = HUGE_VAL;
    for (const Vec3& p : cut.points)
      if (p.y > 0.25 * stature_ && p.y < low) {
        low = p.y;
        points().crotch = p;
      }
    if (!(low < 0.6 * stature_)) return Error{"body.not_a_body", "There is no crotch to be found.", ""};
    take(Measure::kInseam, low, low, {points().crotch, {points().crotch.x, 0, points().crotch.z}});
    return {};
  }

  template <typename Better>
  Level extreme(double low, double high, Better better) const {
    Level best = level_at(low);
    for (const Level& l : trunk_)
      if (l.y > low && l.y <= high && better(l.girth, best.girth)) best = l;
    return best;
  }

  // The narrowest place, the more so the nearer it is to where waists usually are.
  Level waist_level() const {
    const BodyPoints& p = measures.points;
    const double torso = p.nape.y - p.crotch.y;
    const auto weighed = [&](const Level& l) {
      const double off = (l.y - p.crotch.y) / torso - kUsualWaist;
      return l.girth * (1 + kUnusualWaist * off * off);
    };
    Level best = level_at(p.crotch.y + kWaistLow * torso);
    for (const Level& l : trunk_) {
      const double share = (l.y - p.crotch.y) / torso;
      if (share > kWaistLow && share <= kWaistHigh && weighed(l) < weighed(best)) best = l;
    }
    return best;
  }

  Status find_trunk_girths() {
    const auto wider = [](double a, double b) { return a > b; };
    BodyPoints& p = points();
    const Level hip = extreme(p.crotch.y + kHipFrom * stature_, p.crotch.y + kHipTo * stature_, wider);
    const Level waist = waist_level();
    if (!(p.armpit_height > waist.y + 0.03 * stature_))
      return Error{"body.not_a_body", "There are no armpits to be found above the waist.", ""};
    p.hip_height = hip.y;
    p.waist_height = waist.y;
    take_level(Measure::kHip, hip);
    take_level(Measure::kWaist, waist);
    // A woman's bust is taken at the bust points, a chest at its widest, right below the armpits.
    const double torso = p.nape.y - p.crotch.y;
    const double top = std::min(p.armpit_height - kClearOfArmpit * stature_, p.nape.y - kChestTop * torso);
    const double ribs = p.nape.y - kUnderBust * torso;
    if (!(top > ribs && ribs > p.crotch.y))
      return Error{"body.not_a_body", "There is no chest to be found below the armpits.", ""};
    const BustProfile profile = bust_profile(ribs, top);
    const bool breasts = profile.depth > kBreastFold * stature_;
    const Level bust = breasts ? extreme(profile.apex - kBustBelow * stature_,
                                         std::min(profile.apex + kBustAbove * stature_, top), wider)
                               : extreme(ribs, top, wider);
    const Level under = level_at(ribs);
    p.bust_height = bust.y;
    p.underbust_height = ribs;
    take_level(Measure::kBust, bust);
    take_level(Measure::kUnderbust, under);
    return {};
  }

  struct BustProfile {
    double apex = 0;   ///< height of the most prominent place
    double depth = 0;  ///< how far the profile below lies behind the line from there to the waist
  };

  BustProfile bust_profile(double ribs, double top) const {
    size_t apex = index_of(ribs);
    for (size_t i = apex; i < index_of(top); ++i)
      if (trunk_[i].front > trunk_[apex].front) apex = i;
    const size_t waist = index_of(measures.points.waist_height);
    const Level &a = trunk_[waist], &b = trunk_[apex];
    BustProfile out{b.y, 0};
    for (size_t i = std::max(waist, index_of(b.y - kFoldReach * stature_)); i + 1 < apex; ++i) {
      const double s = (trunk_[i].y - a.y) / (b.y - a.y);
      out.depth = std::max(out.depth, a.front + (b.front - a.front) * s - trunk_[i].front);
    }
    return out;
  }

  void find_neck() {
    const double middle = points().middle;
    double least = HUGE_VAL, place = 0;
    for (double y = points().armpit_height; y < 0.95 * stature_; y += 2 * kLevelStep * stature_) {
      const Level l = level_at(y);
      if (l.girth > 0 && l.girth < least) {
        least = l.girth;
        place = y;
      }
    }
    if (!(least < HUGE_VAL)) return;
    neck_y_ = place;
    std::vector<Index> near;
    for (Index t = 0; t < static_cast<Index>(mesh_.triangles.size()); ++t)
      if (std::abs(mesh_.vertices[mesh_.triangles[t][0]].y - place) < 0.09 * stature_) near.push_back(t);
    double best = least, best_y = place;
    std::vector<Vec3> line = taut_loop(middle_points(level_.at(place), middle), {0, 1, 0});
    for (double y = place - 0.025 * stature_; y <= place + 0.02 * stature_; y += 0.005 * stature_) {
      const Vec3 centre = middle_of(middle_points(level_.at(y), middle));
      for (double lean : kNeckLeans) {
        const Vec3 normal = normalized(Vec3{0, 1, lean});
        const std::vector<Vec3> ps = middle_points(plane_cut(mesh_, centre, normal, near), middle);
        const double g = around(ps, normal);
        if (ps.size() > 5 && g < best) {
          best = g;
          best_y = y;
          line = taut_loop(ps, normal);
        }
      }
    }
    take(Measure::kNeck, best, best_y, std::move(line));
  }

  // The back's profile in the middle plane, from the small of the back up to the neck's hollow.
  void find_nape() {
    BodyPoints& p = points();
    std::vector<Vec3> profile;
    const double low = small_of_back(), ribs = p.crotch.y + kBladeFrom * (neck_y_ - p.crotch.y);
    for (double y = low; y <= neck_y_ + kHollowAbove * stature_; y += kLevelStep * stature_)
      if (const Vec3 q = mid_back_at(y); q.z < HUGE_VAL) profile.push_back(q);
    if (profile.size() < 10) return;
    size_t blade = 0, hollow = profile.size() - 1;
    for (size_t i = 0; i < profile.size(); ++i)
      if (profile[i].z < profile[blade].z && profile[i].y < ribs) blade = i;
    for (size_t i = blade; i < profile.size(); ++i)
      if (profile[i].z > profile[hollow].z) hollow = i;
    const double turn = profile[hollow].z + kNapeShare * (profile[blade].z - profile[hollow].z);
    size_t nape = hollow;
    while (nape > blade && profile[nape].z > turn) --nape;
    // Between two levels, so that it moves evenly.
    p.nape = profile[nape];
    if (nape < hollow) {
      const Vec3 &a = profile[nape], &b = profile[nape + 1];
      p.nape = a + (b - a) * ((turn - a.z) / (b.z - a.z));
    }
    profile.resize(nape + 1);
    profile.push_back(p.nape);
    std::vector<Vec3> tape = taut(profile);
    const double along = length_of(tape);
    take(Measure::kBackLength, along, low, std::move(tape));
  }

  // The hindmost point near the middle plane; z is infinite where the cut has none.
  Vec3 mid_back_at(double y) const {
    const double middle = measures.points.middle;
    const std::vector<Vec3> around = middle_points(level_.at(y), middle);
    const double half_way = middle_of(around).z;
    Vec3 best{middle, y, HUGE_VAL};
    for (const Vec3& q : around)
      if (std::abs(q.x - middle) < kSpine * stature_ && q.z < std::min(best.z, half_way)) best.z = q.z;
    return best;
  }

  // Half-way between the two levels at which the back has come out a little from its hollow: the hollow
  // itself is too flat for a sharp place.
  double small_of_back() const {
    const BodyPoints& p = measures.points;
    const double torso = neck_y_ - p.crotch.y;
    const size_t low = index_of(p.crotch.y + kLumbarLow * torso),
                 high = index_of(p.crotch.y + kLumbarHigh * torso);
    size_t hollow = low;
    for (size_t i = low; i <= high; ++i)
      if (trunk_[i].back > trunk_[hollow].back) hollow = i;
    const double edge = trunk_[hollow].back - kLumbarDepth * stature_;
    const size_t least = index_of(p.crotch.y + kLumbarLeast * torso);
    const auto reach = [&](int step) {
      size_t i = hollow;
      while (i > least && i < high && trunk_[i].back > edge) i += static_cast<size_t>(step);
      return trunk_[i].y;
    };
    return (reach(1) + reach(-1)) / 2;
  }

  // A tape over the profile, which spans hollows.
  static std::vector<Vec3> taut(const std::vector<Vec3>& profile) {
    std::vector<Vec3> tape;
    for (const Vec3& q : profile) {
      while (tape.size() > 1) {
        const Vec3 &a = tape[tape.size() - 2], &b = tape.back();
        if ((b.y - a.y) * (q.z - a.z) - (b.z - a.z) * (q.y - a.y) > 0) break;
        tape.pop_back();
      }
      tape.push_back(q);
    }
    return tape;
  }

  static double length_of(const std::vector<Vec3>& tape) {
    double sum = 0;
    for (size_t i = 1; i < tape.size(); ++i) sum += length(tape[i] - tape[i - 1]);
    return sum;
  }

  void find_leg();

  const geometry::TriangleMesh& mesh_;
  MeshCutter level_;
  double stature_ = 0, neck_y_ = 0;
  std::vector<Level> trunk_;
};

void BodyTape::find_leg() {
  const double middle = points().middle, crotch = points().crotch.y;
  const auto leg_at = [&](double y) {
    std::vector<Vec3> one;
    for (const Vec3& q : middle_points(level_.at(y), middle))
      if (q.x >= middle) one.push_back(q);
    return one;
  };
  const auto girth = [&](double y) { return geometry::hull_perimeter(flat(leg_at(y))); };
  const double thigh = crotch - kThighBelowCrotch * stature_;
  take(Measure::kThigh, girth(thigh), thigh, taut_loop(leg_at(thigh), {0, 1, 0}));
  double most = 0, place = 0;
  for (double y = kCalfLow * crotch; y <= kCalfHigh * crotch; y += 2 * kLevelStep * stature_)
    if (const double g = girth(y); g > most) {
      most = g;
      place = y;
    }
  take(Measure::kCalf, most, place, taut_loop(leg_at(place), {0, 1, 0}));
}

}  // namespace

Result<BodyMeasures> measure_body(const geometry::TriangleMesh& standing) {
  if (standing.triangles.empty()) return Error{"body.not_a_body", "The mesh has no triangles.", ""};
  BodyTape tape(standing);
  TRY(tape.run());
  return tape.measures;
}

}  // namespace toile::measure
