#include "core/pattern/fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/units.h"
#include "core/geometry/polygon2.h"
#include "core/pattern/curve.h"
#include "core/pattern/fit_cubic.h"

namespace toile::pattern {
namespace {

// A run of points this close to one line is straight: files carry three decimals of a millimetre, and an arc
// that passes for straight over kStraightLength has a radius of 25 m or more.
constexpr double kStraightDeviation = 0.002;  // mm
// The shortest run kept exactly straight amid a curve: mm, and as a share of the whole. A gentle curve has
// short runs that look straight; as lines they would only cut it up.
constexpr double kStraightLength = 20;
constexpr double kStraightShare = 0.1;
constexpr double kWholeStraight = 0.02;  // mm, deviation of a whole run that is drawn as one line
// A segment this many times longer than its neighbours was drawn as a line, not sampled from a curve.
constexpr double kLongSegment = 3;
// A chord of length s that turns by θ towards the next leaves its arc by about s·θ/8. Nobody samples a curve
// more coarsely than this: such a bend is meant. So is a lesser one that stands out among its neighbours.
constexpr double kCoarsestSagitta = 0.5;           // mm
constexpr double kLeastSagitta = 0.1;              // mm
constexpr double kStandsOut = 3;                   // times the curvature at the neighbours
constexpr double kTangentBend = 10 * (kPi / 180);  // rad, up to here a line runs on into a curve
// Runs of more points, or that halving parts into more curves, are no edges of a garment: one look must do.
constexpr std::size_t kManyPoints = 1500, kManyCurves = 16;

/// How many ways are looked at side by side.
struct Effort {
  std::size_t ways, guesses;
};

using Points = std::span<const Vec2>;
using Indices = std::span<const std::size_t>;  // ascending

/// A way to tell the tangent at a point of a smooth run: over this reach, turned by so much.
struct TangentGuess {
  double reach;  // mm
  double turn;   // rad
};
constexpr double kDegree = kPi / 180;
constexpr std::array<TangentGuess, 8> kTangentGuesses{{{kTangentReach, 0},
                                                       {2, 0},
                                                       {5, 0},
                                                       {10, 0},
                                                       {5, -0.7 * kDegree},
                                                       {5, 0.7 * kDegree},
                                                       {5, -1.5 * kDegree},
                                                       {5, 1.5 * kDegree}}};

Vec2 guessed_tangent(Points p, std::size_t i, const TangentGuess& guess) {
  const Vec2 t = inner_tangent(p, i, guess.reach);
  return guess.turn == 0 ? t : t * std::cos(guess.turn) + perpendicular(t) * std::sin(guess.turn);
}

/// How close cubics must come.
struct Closeness {
  double tolerance;       // mm
  std::size_t* compared;  // counts points held against a cubic
};

std::optional<CubicBezier> tried(Points p, Vec2 t0, Vec2 t1, const Closeness& close, std::size_t& farthest) {
  *close.compared += p.size();
  return fit_cubic(p, t0, t1, close.tolerance, farthest);
}

/// Indices where cubics for the smooth run p meet, by halving it at the worst point; ascending, both ends in.
void halve_smooth(Points p, std::size_t offset, Vec2 t0, Vec2 t1, const Closeness& close,
                  std::vector<std::size_t>& joints) {
  std::size_t farthest = 0;
  if (tried(p, t0, t1, close, farthest)) {
    joints.push_back(offset + p.size() - 1);
    return;
  }
  // Away from the ends, so that the depth of halving stays logarithmic.
  const std::size_t last = p.size() - 1, margin = std::max<std::size_t>(1, last / 10);
  const std::size_t at = std::clamp(farthest, margin, last - margin);
  const Vec2 tangent = inner_tangent(p, at);
  halve_smooth(p.first(at + 1), offset, t0, tangent, close, joints);
  halve_smooth(p.subspan(at), offset + at, tangent, t1, close, joints);
}

/// A place where two cubics meet.
struct Joint {
  std::size_t at = 0;
  Vec2 tangent;
  std::size_t before = 0;  // the one that it was reached from
};

/// How far one cubic reaches from a joint, by each way to guess the tangent at its end: one joint each.
void reach_from(Points p, Indices ends, const std::vector<Joint>& joints, std::size_t from, Vec2 t1,
                const Closeness& close, const Effort& effort, std::vector<Joint>& reached) {
  const std::size_t begin = joints[from].at;
  const auto stop = std::upper_bound(ends.begin(), ends.end(), begin);
  const std::size_t last = stop == ends.end() ? p.size() - 1 : *stop;
  const Vec2 t0 = joints[from].tangent;
  std::size_t farthest = 0, known = begin + 1;
  for (const TangentGuess& guess : std::span(kTangentGuesses).first(effort.guesses)) {
    const auto joint = [&](std::size_t j) {
      return Joint{j, j + 1 == p.size() ? t1 : guessed_tangent(p, j, guess), from};
    };
    const auto fits = [&](std::size_t j) {
      return tried(p.subspan(begin, j - begin + 1), t0, joint(j).tangent, close, farthest).has_value();
    };
    // A longer run is harder to fit, but for exceptions that cost a curve at most.
    std::size_t good = begin + 1, bad = last + 1;
    if (known > good && fits(known))
      good = known;
    else if (known > good)
      bad = known;
    std::size_t step = std::max<std::size_t>(1, good - begin);
    while (bad - good > 1 && good < last) {
      const std::size_t j = bad > last ? std::min(last, good + step) : (good + bad) / 2;
      (fits(j) ? good : bad) = j;
      step *= 2;
    }
    reached.push_back(joint(good));
    known = std::max(known, good);
    if (good + 1 == p.size()) return;
  }
}

/// As few cubics as a look at several ways finds: from each place on as far as a cubic reaches, with several
/// tangents at its end, since those of files whose curves were sampled, rounded or made of arcs are not exact
/// and which one serves best shows only later. Nothing when that takes `most` cubics or more.
std::vector<Joint> reach_on(Points p, Indices ends, Vec2 t0, Vec2 t1, const Closeness& close,
                            const Effort& effort, std::size_t most) {
  const std::size_t last = p.size() - 1;
  std::vector<Joint> joints{{0, t0, 0}};
  std::size_t first = 0;  // of the newest
  for (std::size_t count = 1; count < most; ++count) {
    std::vector<Joint> reached;
    for (std::size_t k = first, end = joints.size(); k < end; ++k)
      reach_from(p, ends, joints, k, t1, close, effort, reached);
    std::stable_sort(reached.begin(), reached.end(),
                     [](const Joint& a, const Joint& b) { return a.at > b.at; });
    if (reached.front().at == last) {
      std::vector<Joint> way{reached.front()};
      while (way.back().at > 0) way.push_back(joints[way.back().before]);
      std::reverse(way.begin(), way.end());
      return way;
    }
    first = joints.size();
    joints.insert(joints.end(), reached.begin(),
                  reached.begin() + std::ptrdiff_t(std::min(effort.ways, reached.size())));
  }
  return {};
}

/// The same from the end on.
std::vector<Joint> reach_back(Points p, Indices ends, Vec2 t0, Vec2 t1, const Closeness& close,
                              const Effort& effort, std::size_t most) {
  const std::vector<Vec2> turned(p.rbegin(), p.rend());
  std::vector<std::size_t> turned_ends;
  for (auto end = ends.rbegin(); end != ends.rend(); ++end) turned_ends.push_back(p.size() - 1 - *end);
  std::vector<Joint> joints = reach_on(turned, turned_ends, -t1, -t0, close, effort, most);
  std::reverse(joints.begin(), joints.end());
  for (Joint& joint : joints) joint = {p.size() - 1 - joint.at, -joint.tangent, 0};
  return joints;
}

/// Appends few cubics for the smooth run p with forward end tangents t0, t1: from the start or from the end
/// as far as each one reaches, or by halving where that takes no fewer. Cubics end at the points `ends`.
void fit_smooth(Points p, Indices ends, Vec2 t0, Vec2 t1, const Closeness& close,
                std::vector<CubicBezier>& out) {
  const std::size_t last = p.size() - 1;
  std::vector<std::size_t> halves{0};
  for (std::size_t k = 0; k <= ends.size(); ++k) {
    const std::size_t i = k == 0 ? 0 : ends[k - 1], j = k == ends.size() ? last : ends[k];
    halve_smooth(p.subspan(i, j - i + 1), i, i == 0 ? t0 : inner_tangent(p, i),
                 j == last ? t1 : inner_tangent(p, j), close, halves);
  }
  std::vector<Joint> joints;
  joints.reserve(halves.size());
  for (const std::size_t i : halves)
    joints.push_back({i, i == 0 ? t0 : i == last ? t1 : inner_tangent(p, i), 0});
  const bool many = p.size() > kManyPoints || joints.size() > kManyCurves + 1;
  const Effort effort = many ? Effort{1, 1} : Effort{4, kTangentGuesses.size()};
  for (const auto& reach : {reach_on, reach_back}) {
    if (joints.size() <= 2 + ends.size() || (many && reach == reach_back)) break;
    std::vector<Joint> fewer = reach(p, ends, t0, t1, close, effort, joints.size() - 1);
    if (!fewer.empty()) joints = std::move(fewer);
  }
  std::size_t farthest = 0;
  for (std::size_t k = 0; k + 1 < joints.size(); ++k) {
    const std::size_t i = joints[k].at, j = joints[k + 1].at;
    // Run backwards a cubic's handles may come out otherwise by the last bit.
    if (const auto curve = fit_cubic(p.subspan(i, j - i + 1), joints[k].tangent, joints[k + 1].tangent,
                                     1.001 * close.tolerance, farthest))
      out.push_back(*curve);
  }
}

/// Last index of the longest run from i whose points lie within kStraightDeviation of one line from p[i] and
/// lead away from it. Keeps the wedge of directions that pass close enough to every point so far.
std::size_t straight_until(Points p, std::size_t i) {
  const Vec2 axis = p[i + 1] - p[i];
  double low = -kPi, high = kPi, far = 0;
  std::size_t j = i + 1;
  for (; j < p.size(); ++j) {
    const Vec2 d = p[j] - p[i];
    const double distance = length(d), angle = std::atan2(cross(axis, d), dot(axis, d));
    if (distance <= far || angle < low || angle > high) break;
    const double slack = std::asin(std::min(1.0, kStraightDeviation / distance));
    low = std::max(low, angle - slack);
    high = std::min(high, angle + slack);
    far = distance;
  }
  return j - 1;
}

bool is_line_run(Points p, std::size_t i, std::size_t j, double least) {
  const double run = length(p[j] - p[i]);
  if (run < least) return false;
  if (j - i >= 2) return true;
  const double before = i > 0 ? length(p[i] - p[i - 1]) : 0;
  const double after = j + 1 < p.size() ? length(p[j + 1] - p[j]) : 0;
  return run >= kLongSegment * std::max(before, after);
}

struct Run {
  std::size_t begin = 0, end = 0;  // indices of the first and last point
  bool straight = false;
};

/// Cuts p into straight runs and the curved ones between them.
std::vector<Run> runs_of(Points p) {
  const double least = std::max(kStraightLength, kStraightShare * geometry::polyline_length(p));
  std::vector<Run> runs;
  std::size_t curve_begin = 0, i = 0;
  while (i + 1 < p.size()) {
    const std::size_t j = straight_until(p, i);
    if (!is_line_run(p, i, j, least)) {
      i += std::max<std::size_t>(1, (j - i) / 8);  // large steps would miss where a line begins
      continue;
    }
    if (i > curve_begin) runs.push_back({curve_begin, i, false});
    runs.push_back({i, j, true});
    curve_begin = i = j;
  }
  if (curve_begin + 1 < p.size()) runs.push_back({curve_begin, p.size() - 1, false});
  return runs;
}

bool is_straight_run(Points p) {
  double along = 0;
  const Vec2 direction = normalized(p.back() - p.front());
  for (Vec2 q : p) {
    if (geometry::distance_to_segment(q, p.front(), p.back()) > kWholeStraight) return false;
    const double s = dot(q - p.front(), direction);
    if (s < along - kWholeStraight) return false;
    along = std::max(along, s);
  }
  return true;
}

/// The direction of the line beside a curve's end when the curve runs on smoothly from it.
Vec2 joined_tangent(Vec2 own, std::optional<Vec2> line) {
  return line && turn_between(own, *line) <= kTangentBend ? *line : own;
}

/// Appends curves for points without sharp bends; curves end at the points `ends`.
void fit_run(Points p, Indices ends, const Closeness& close, std::vector<CubicBezier>& out) {
  const auto inside = [&](std::size_t i, std::size_t j) {
    std::vector<std::size_t> some;
    for (const std::size_t end : ends)
      if (end > i && end < j) some.push_back(end - i);
    return some;
  };
  const auto add_line = [&](std::size_t i, std::size_t j) {
    std::size_t from = i;
    for (const std::size_t end : inside(i, j)) {
      out.push_back(line_segment(p[from], p[i + end]));
      from = i + end;
    }
    out.push_back(line_segment(p[from], p[j]));
  };
  if (p.size() == 2 || is_straight_run(p)) return add_line(0, p.size() - 1);
  const std::vector<Run> runs = runs_of(p);
  const auto direction = [&](const Run& r) { return normalized(p[r.end] - p[r.begin]); };
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const Run& r = runs[k];
    const Points q = p.subspan(r.begin, r.end - r.begin + 1);
    if (r.straight || (q.size() == 2 && runs.size() > 1)) {
      add_line(r.begin, r.end);
      continue;
    }
    std::optional<Vec2> before, after;
    if (k > 0) before = direction(runs[k - 1]);
    if (k + 1 < runs.size()) after = direction(runs[k + 1]);
    fit_smooth(q, inside(r.begin, r.end), joined_tangent(start_tangent(q), before),
               joined_tangent(last_tangent(q), after), close, out);
  }
}

/// Turn per length at an inner point, 0 at the ends.
double curvature(Points p, std::size_t i) {
  if (i == 0 || i + 1 >= p.size()) return 0;
  const Vec2 in = p[i] - p[i - 1], out = p[i + 1] - p[i];
  return 2 * turn_between(in, out) / (length(in) + length(out));
}

/// Whether the polyline bends at its inner point i more than samples of a curve would.
bool is_sharp(Points p, std::size_t i) {
  const Vec2 in = p[i] - p[i - 1], out = p[i + 1] - p[i];
  const double bend = turn_between(in, out), sagitta = std::min(length(in), length(out)) * bend / 8;
  if (bend > kSharpBend || sagitta > kCoarsestSagitta) return true;
  const double around = std::max(curvature(p, i - 1), curvature(p, i + 1));
  return sagitta > kLeastSagitta && curvature(p, i) > kStandsOut * around;
}

}  // namespace

std::vector<CubicBezier> fit_polyline(std::span<const Vec2> p, double tolerance_mm,
                                      std::span<const std::size_t> ends, std::size_t* compared) {
  std::vector<CubicBezier> curves;
  std::size_t begin = 0, uncounted = 0;
  const Closeness close{tolerance_mm, compared == nullptr ? &uncounted : compared};
  for (std::size_t i = 1; i < p.size(); ++i) {
    if (i + 1 < p.size() && !is_sharp(p, i)) continue;
    std::vector<std::size_t> inner;
    for (const std::size_t end : ends)
      if (end > begin && end < i) inner.push_back(end - begin);
    fit_run(p.subspan(begin, i - begin + 1), inner, close, curves);
    begin = i;
  }
  return curves;
}

std::vector<CubicBezier> fit_smooth_loop(std::span<const Vec2> loop, double tolerance_mm,
                                         std::span<const std::size_t> ends) {
  const std::size_t n = loop.size();
  std::vector<Vec2> points(loop.begin(), loop.end());
  points.push_back(loop[0]);
  for (std::size_t i = 1; i < n; ++i)
    if (is_sharp(points, i)) return fit_polyline(points, tolerance_mm, ends);
  // Quarters by length: one cubic cannot go all the way round, and four draw an ellipse well.
  std::vector<std::size_t> cuts{0};
  const double whole = geometry::polyline_length(points);
  double s = 0;
  for (std::size_t i = 1; i < n; ++i) {
    s += length(points[i] - points[i - 1]);
    if (cuts.size() < 4 && s >= whole * double(cuts.size()) / 4) cuts.push_back(i);
  }
  cuts.insert(cuts.end(), ends.begin(), ends.end());
  cuts.push_back(n);
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  const auto tangent = [&](std::size_t i) {
    return middle_tangent(loop[(i + n - 1) % n], loop[i % n], loop[(i + 1) % n]);
  };
  std::size_t uncounted = 0;
  const Closeness close{tolerance_mm, &uncounted};
  std::vector<CubicBezier> curves;
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    const Points q(points.data() + cuts[k], cuts[k + 1] - cuts[k] + 1);
    fit_smooth(q, {}, tangent(cuts[k]), tangent(cuts[k + 1]), close, curves);
  }
  return curves;
}

}  // namespace toile::pattern
