#include "core/body/measure/neck_tape.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/body/measure/cut_points.h"

namespace toile::measure {
namespace {

// Shares of the way from crotch to neck.
constexpr double kLumbarLeast = 0.16, kLumbarLow = 0.28, kLumbarHigh = 0.66, kBladeFrom = 0.86;
// Shares of the stature.
constexpr double kHollowAbove = 0.055;  // of the narrowest level: the nape of the neck is hollow
constexpr double kLumbarDepth = 0.005;
constexpr double kSpine = 0.025;     // of the middle plane: what counts as mid-back
constexpr double kNapeShare = 0.44;  // of the way from the neck's hollow back to the blades
constexpr double kNeckLeans[] = {0, 0.09, 0.18, 0.27, 0.36, 0.47};  // tangents: the front edge hangs lower

using Profile = std::vector<Vec3>;  ///< upwards, in the middle plane

/// Height of the narrowest level between armpits and head, and its girth; infinite where no level is cut.
struct Narrowest {
  double y = 0, girth = HUGE_VAL;
};

Narrowest narrowest_level(const TrunkLevels& levels, double armpit_height) {
  Narrowest found;
  for (double y = armpit_height; y < 0.95 * levels.stature(); y += 2 * levels.step()) {
    const TrunkLevel l = levels.at(y);
    if (l.girth > 0 && l.girth < found.girth) found = {y, l.girth};
  }
  return found;
}

std::vector<Index> triangles_near(const geometry::TriangleMesh& mesh, double y, double reach) {
  std::vector<Index> near;
  for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t)
    if (std::abs(mesh.vertices[mesh.triangles[t][0]].y - y) < reach) near.push_back(t);
  return near;
}

/// The neck's tape leans: the least girth of cuts about the narrowest level, level or hanging at the front.
void take_neck(const geometry::TriangleMesh& mesh, const TrunkLevels& levels, const Narrowest& level,
               BodyMeasures& measures) {
  const double stature = levels.stature();
  const std::vector<Index> near = triangles_near(mesh, level.y, 0.09 * stature);
  double best = level.girth, best_y = level.y;
  std::vector<Vec3> line = taut_loop(levels.points_at(level.y), {0, 1, 0});
  for (double y = level.y - 0.025 * stature; y <= level.y + 0.02 * stature; y += 0.005 * stature) {
    const Vec3 centre = middle_of(levels.points_at(y));
    for (const double lean : kNeckLeans) {
      const Vec3 normal = normalized(Vec3{0, 1, lean});
      const std::vector<Vec3> points = middle_points(plane_cut(mesh, centre, normal, near), levels.middle());
      const double girth = around(points, normal);
      if (points.size() > 5 && girth < best) {
        best = girth;
        best_y = y;
        line = taut_loop(points, normal);
      }
    }
  }
  measures.take(Measure::kNeck, best, best_y, std::move(line));
}

/// The hindmost point near the middle plane; z is infinite where the cut has none.
Vec3 mid_back_at(const TrunkLevels& levels, double y) {
  const std::vector<Vec3> points = levels.points_at(y);
  const double half_way = middle_of(points).z;
  Vec3 best{levels.middle(), y, HUGE_VAL};
  for (const Vec3& q : points) {
    const bool is_mid = std::abs(q.x - levels.middle()) < kSpine * levels.stature();
    if (is_mid && q.z < std::min(best.z, half_way)) best.z = q.z;
  }
  return best;
}

/// Half-way between the two levels at which the back has come out a little from its hollow: the hollow itself
/// is too flat for a sharp place.
double small_of_back(const TrunkLevels& levels, double crotch_y, double neck_y) {
  const std::vector<TrunkLevel>& trunk = levels.all();
  const double torso = neck_y - crotch_y;
  const std::size_t low = levels.index_of(crotch_y + kLumbarLow * torso),
                    high = levels.index_of(crotch_y + kLumbarHigh * torso);
  std::size_t hollow = low;
  for (std::size_t i = low; i <= high; ++i)
    if (trunk[i].back > trunk[hollow].back) hollow = i;
  const double edge = trunk[hollow].back - kLumbarDepth * levels.stature();
  const std::size_t least = levels.index_of(crotch_y + kLumbarLeast * torso);
  const auto reach = [&](int step) {
    std::size_t i = hollow;
    while (i > least && i < high && trunk[i].back > edge) i += static_cast<std::size_t>(step);
    return trunk[i].y;
  };
  return (reach(1) + reach(-1)) / 2;
}

/// Where on a profile the nape is: the last point still behind it, and the place itself, between two levels,
/// so that it moves evenly.
struct Nape {
  std::size_t below = 0;
  Vec3 place;
};

Nape nape_of(const Profile& profile, double ribs) {
  std::size_t blade = 0, hollow = profile.size() - 1;
  for (std::size_t i = 0; i < profile.size(); ++i)
    if (profile[i].z < profile[blade].z && profile[i].y < ribs) blade = i;
  for (std::size_t i = blade; i < profile.size(); ++i)
    if (profile[i].z > profile[hollow].z) hollow = i;
  const double turn = profile[hollow].z + kNapeShare * (profile[blade].z - profile[hollow].z);
  std::size_t nape = hollow;
  while (nape > blade && profile[nape].z > turn) --nape;
  if (nape == hollow) return {nape, profile[nape]};
  const Vec3 &a = profile[nape], &b = profile[nape + 1];
  return {nape, a + (b - a) * ((turn - a.z) / (b.z - a.z))};
}

/// A tape over the profile, which spans hollows.
Profile taut(const Profile& profile) {
  Profile tape;
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

double length_of(const Profile& tape) {
  double sum = 0;
  for (std::size_t i = 1; i < tape.size(); ++i) sum += length(tape[i] - tape[i - 1]);
  return sum;
}

/// Along the back's profile, from the small of the back up to the nape.
void take_back(const TrunkLevels& levels, double neck_y, BodyMeasures& measures) {
  BodyPoints& p = measures.points;
  Profile profile;
  const double low = small_of_back(levels, p.crotch.y, neck_y);
  const double ribs = p.crotch.y + kBladeFrom * (neck_y - p.crotch.y);
  for (double y = low; y <= neck_y + kHollowAbove * levels.stature(); y += levels.step())
    if (const Vec3 q = mid_back_at(levels, y); q.z < HUGE_VAL) profile.push_back(q);
  if (profile.size() < 10) return;
  const Nape nape = nape_of(profile, ribs);
  p.nape = nape.place;
  profile.resize(nape.below + 1);
  profile.push_back(p.nape);
  Profile tape = taut(profile);
  const double along = length_of(tape);
  measures.take(Measure::kBackLength, along, low, std::move(tape));
}

}  // namespace

void measure_neck_and_back(const geometry::TriangleMesh& mesh, const TrunkLevels& levels,
                           BodyMeasures& measures) {
  const Narrowest level = narrowest_level(levels, measures.points.armpit_height);
  if (level.girth < HUGE_VAL) take_neck(mesh, levels, level, measures);
  take_back(levels, level.y, measures);  // without a neck its height is 0, and no profile is found
}

}  // namespace toile::measure
