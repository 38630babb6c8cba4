#include "core/pattern/corners.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/geometry/polygon2.h"

namespace toile::pattern {
namespace {

using Points = std::span<const Vec2>;

/// The point at distance `window` along the closed polyline from vertex i, forwards or backwards.
Vec2 point_along(Points loop, std::size_t i, double window, bool forward) {
  const std::size_t n = loop.size();
  Vec2 at = loop[i];
  for (std::size_t step = 0; step < n; ++step) {
    i = (i + (forward ? 1 : n - 1)) % n;
    const double l = length(loop[i] - at);
    if (l >= window) return at + (loop[i] - at) * (window / l);
    window -= l;
    at = loop[i];
  }
  return at;
}

/// Turn from the one way to the other, radians; to the right it is negative.
double turn_to_left(Vec2 in, Vec2 out) { return std::atan2(cross(in, out), dot(in, out)); }

double turn_at(Points loop, std::size_t i, double window) {
  const Vec2 in = loop[i] - point_along(loop, i, window, false);
  const Vec2 out = point_along(loop, i, window, true) - loop[i];
  return std::abs(turn_to_left(in, out));
}

/// Whether another vertex within the window turns more sharply (or as sharply, and comes first).
bool outdone(Points loop, const std::vector<double>& turns, std::size_t i, double window) {
  const std::size_t n = loop.size();
  for (const std::size_t step : {std::size_t{1}, n - 1}) {
    double walked = 0;
    for (std::size_t j = i, k = (i + step) % n; k != i; j = k, k = (k + step) % n) {
      walked += length(loop[k] - loop[j]);
      if (walked >= window) break;
      if (turns[k] > turns[i] || (turns[k] == turns[i] && k < i)) return true;
    }
  }
  return false;
}

/// Turn from the segment that ends at vertex i to the one that begins there, radians, to the left.
double signed_turn(Points loop, std::size_t i) {
  const std::size_t n = loop.size();
  return turn_to_left(loop[i] - loop[(i + n - 1) % n], loop[(i + 1) % n] - loop[i]);
}

double vertex_turn(Points loop, std::size_t i) { return std::abs(signed_turn(loop, i)); }

constexpr double kShort = 3, kLine = 20;  // mm: too short for a direction; long enough for a line

/// Lengths of the segments before and after vertex i, mm.
std::array<double, 2> sides_of(Points loop, std::size_t i) {
  const std::size_t n = loop.size();
  return {length(loop[i] - loop[(i + n - 1) % n]), length(loop[(i + 1) % n] - loop[i])};
}

/// Vertices after i (`step` 1) or before it (n - 1) that turn about as much or more, up to a sharp corner.
std::size_t turning_alike(Points loop, std::size_t i, std::size_t step, double sharp) {
  constexpr double kStandsOut = 2.5;  // times the turn at a sample of a curve
  const double turn = vertex_turn(loop, i);
  std::size_t count = 0;
  for (std::size_t k = (i + step) % loop.size(); k != i; k = (k + step) % loop.size(), ++count) {
    const double other = vertex_turn(loop, k);
    if (other > sharp || turn > kStandsOut * other) break;
  }
  return count;
}

/// Whether vertex i lies on a curve in samples: between the sharp corners before and after it the outline has
/// many vertices, about evenly apart. However far they are, none of its chords is a line of its own.
bool evenly_sampled(Points loop, std::size_t i, double sharp) {
  constexpr std::size_t kSamples = 5;
  constexpr double kEven = 1.6;  // times the shortest chord
  const std::size_t n = loop.size();
  std::size_t samples = 1;
  double shortest = std::min(sides_of(loop, i)[0], sides_of(loop, i)[1]);
  double longest = std::max(sides_of(loop, i)[0], sides_of(loop, i)[1]);
  for (const std::size_t step : {std::size_t{1}, n - 1})
    for (std::size_t k = (i + step) % n; k != i && vertex_turn(loop, k) <= sharp; k = (k + step) % n) {
      const double chord = sides_of(loop, k)[step == 1 ? 1 : 0];
      shortest = std::min(shortest, chord);
      longest = std::max(longest, chord);
      ++samples;
    }
  return samples >= kSamples && longest <= kEven * shortest;
}

/// Whether a straight line ends at vertex i, and the outline turns there far more than at the vertices beside
/// it, but for sharp corners and one blunt corner more.
bool ends_line(Points loop, std::size_t i, const OutlineSettings& settings) {
  const auto [a, b] = sides_of(loop, i);
  if (std::max(a, b) < kLine || std::min(a, b) < kShort) return false;
  if (vertex_turn(loop, i) < settings.blunt_corner_angle) return false;
  const double sharp = settings.corner_angle;
  if (evenly_sampled(loop, i, sharp)) return false;
  return turning_alike(loop, i, 1, sharp) + turning_alike(loop, i, loop.size() - 1, sharp) <= 1;
}

/// Whether two curves meet at vertex i by an angle: it turns as no sample beside it does.
bool parts_curves(Points loop, std::size_t i, const OutlineSettings& settings) {
  constexpr double kBetweenCurves = 5.0 / 3;  // times the turn at the end of a line
  constexpr double kStandsOut = 3;            // times the turn at each of two samples on both sides
  const auto [a, b] = sides_of(loop, i);
  const double turn = vertex_turn(loop, i);
  if (std::min(a, b) < kShort || turn < kBetweenCurves * settings.blunt_corner_angle) return false;
  const std::size_t n = loop.size();
  for (const std::size_t k : {i + 1, i + 2, i + n - 1, i + n - 2})
    if (kStandsOut * vertex_turn(loop, k % n) > turn) return false;
  return n > 4;
}

/// The first vertex so far along from vertex i at least, mm; vertex i where there is none.
std::size_t vertex_beyond(Points loop, std::size_t i, std::size_t step, double least) {
  const std::size_t n = loop.size();
  double walked = 0;
  for (std::size_t j = i, k = (i + step) % n; k != i; j = k, k = (k + step) % n) {
    walked += length(loop[k] - loop[j]);
    if (walked >= least) return k;
  }
  return i;
}

/// Whether a straight line meets a curve at vertex i by an angle. Half of the turn at a sample belongs to
/// each of the chords that meet there; the rest is the corner's. Of curves in finer samples every so many
/// count.
bool parts_line_and_curve(Points loop, std::size_t i, const OutlineSettings& settings) {
  constexpr double kLineOverChord = 3, kCorner = 0.5;  // times the chord; of the turn at the end of a line
  const std::size_t n = loop.size();
  const auto [a, b] = sides_of(loop, i);
  if (std::max(a, b) < kLine) return false;
  const std::size_t step = a > b ? 1 : n - 1;
  const std::size_t line = (i + n - step) % n, next = vertex_beyond(loop, i, step, kShort),
                    after = vertex_beyond(loop, next, step, kShort),
                    beyond = vertex_beyond(loop, after, step, kShort);
  const Vec2 chord = loop[next] - loop[i], second = loop[after] - loop[next];
  if (length(chord) == 0 || length(second) == 0) return false;
  if (std::max(a, b) < kLineOverChord * length(chord)) return false;
  const double here = turn_to_left(loop[i] - loop[line], chord), there = turn_to_left(chord, second),
               on = turn_to_left(second, loop[beyond] - loop[after]);
  if (std::max(std::abs(there), std::abs(on)) > settings.corner_angle) return false;
  // A curve may tighten towards its end.
  const double at_end = std::max(std::abs(there), std::abs(2 * there - on));
  const double own = std::copysign(at_end, there) * length(chord) / (length(chord) + length(second));
  return std::abs(here - own) > kCorner * settings.blunt_corner_angle;
}

}  // namespace

std::vector<Vec2> blunt_corners(Points loop, const OutlineSettings& settings) {
  std::vector<Vec2> blunt;
  for (std::size_t i = 0; i < loop.size(); ++i)
    if (ends_line(loop, i, settings) || parts_curves(loop, i, settings) ||
        parts_line_and_curve(loop, i, settings))
      blunt.push_back(loop[i]);
  return blunt;
}

std::vector<std::size_t> find_corners(std::span<const Vec2> loop, double corner_angle) {
  // An eighth of the way round keeps the two sides of the window apart on tiny loops.
  const double around = geometry::polyline_length(loop) + length(loop.front() - loop.back());
  const double window = std::min(kCornerWindow, around / 8);
  std::vector<double> turns(loop.size());
  for (std::size_t i = 0; i < loop.size(); ++i) turns[i] = turn_at(loop, i, window);
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < loop.size(); ++i)
    if (turns[i] > corner_angle && !outdone(loop, turns, i, window)) corners.push_back(i);
  return corners;
}

}  // namespace toile::pattern
