#include "core/arrange/sleeve_places.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace toile::arrange {

namespace {

constexpr double kMostTaper =
    0.3;  // m that the cone's radius changes by at most for each metre along the arm

struct Chord {
  Vec2 first, last;
  bool any = false;
  void add(Vec2 p) {
    if (!any) {
      first = p;
      any = true;
    }
    last = p;
  }
};

using Chords = std::map<std::array<Index, 3>, Chord>;  // by seam, other piece and side of the seam

/// m that the sides come nearer by for each metre along them.
double taper_of(const Chords& chords, Vec2 across, double long_seam) {
  if (chords.size() < 2 || long_seam <= 0) return 0;
  double least[2] = {HUGE_VAL, HUGE_VAL}, most[2] = {-HUGE_VAL, -HUGE_VAL};
  for (const auto& [key, c] : chords) {
    const double at[2] = {dot(c.first, across), dot(c.last, across)};
    for (const int end : {0, 1}) {
      least[end] = std::min(least[end], at[end]);
      most[end] = std::max(most[end], at[end]);
    }
  }
  return ((most[0] - least[0]) - (most[1] - least[1])) / long_seam;
}

bool is_in(const std::vector<Index>& list, Index p) {
  return std::find(list.begin(), list.end(), p) != list.end();
}

}  // namespace

SleeveLine line_of_sleeve(const GarmentGraph& graph, Index piece, const std::vector<Index>& limb) {
  const GarmentPiece& p = graph.pieces[piece];
  Vec2 cap;
  int caps = 0;
  Chords chords;
  for (const GarmentTie& tie : graph.ties) {
    for (const int side : {0, 1}) {
      const Index mine = side == 0 ? tie.a : tie.b, other = side == 0 ? tie.b : tie.a;
      if (mine != piece) continue;
      const Vec2 at = side == 0 ? tie.at_a : tie.at_b;
      if (!is_in(limb, other)) {
        cap = cap + at;
        ++caps;
      } else if (graph.pieces[other].cover == Cover::kSleeve) {
        chords[{tie.seam, other, side}].add(at);
      }
    }
  }
  // Without a garment above it the end that is drawn up is the cap's.
  cap = caps > 0 ? cap * (1.0 / caps) : p.centroid + p.grain * 0.1;
  SleeveLine line;
  line.along = normalized(p.centroid - cap);
  Vec2 sum;
  for (auto& [key, c] : chords) {
    if (length(c.first - cap) > length(c.last - cap)) std::swap(c.first, c.last);
    sum = sum + (c.last - c.first);
  }
  if (length(sum) > 0.02) line.along = normalized(sum);
  const Vec2 across = perpendicular(line.along);
  double left = HUGE_VAL, right = -HUGE_VAL, begin = HUGE_VAL;
  Vec2 middle;
  for (const auto& [key, c] : chords) {
    middle = middle + (c.first + c.last) * 0.5;
    begin = std::min(begin, dot(c.first, line.along));
    line.length = std::max(line.length, length(c.last - c.first));
  }
  middle = chords.empty() ? p.centroid : middle * (1.0 / static_cast<double>(chords.size()));
  if (chords.empty()) begin = dot(p.centroid, line.along);
  for (const Vec2 q : p.outline) {
    left = std::min(left, dot(q, across));
    right = std::max(right, dot(q, across));
  }
  line.breadth = right - left;
  line.taper = taper_of(chords, across, line.length);
  line.begin = line.along * begin + across * dot(middle, across);
  return line;
}

FlatMove sleeve_pose(const SleeveLine& line, const measure::ArmLine& arm, double out, bool mirrored) {
  const Vec3 along3 = arm.along();
  const Vec2 along = normalized(Vec2{along3.x, along3.y});
  const Vec2 seen = turn_by(0, mirrored).turned(line.along);
  FlatMove pose = turn_by(std::atan2(along.y, along.x) - std::atan2(seen.y, seen.x), mirrored);
  pose.t = Vec2{arm.root.x, arm.root.y} + along * out - pose.turned(line.begin);
  return pose;
}

sewing::WrappedPlacement around_arm(const SleeveLine& line, const measure::ArmLine& arm,
                                    measure::BodySide side, double radius, double out, bool flipped) {
  sewing::WrappedPlacement w;
  w.axis = arm.root;
  w.up = -arm.along();
  w.radius = radius;
  if (line.breadth > 0) w.slope = std::clamp(-line.taper * radius / line.breadth, -kMostTaper, kMostTaper);
  w.height = -out;
  w.anchor = line.begin;
  w.flipped = flipped;
  // Opposite the seam, so that it closes below.
  w.angle = (side == measure::kWearersLeft ? 0.5 : -0.5) * std::numbers::pi;
  w.turn = std::numbers::pi / 2 - std::atan2(-line.along.y, -line.along.x);
  return w;
}

}  // namespace toile::arrange
