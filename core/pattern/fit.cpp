#include "core/pattern/fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/units.h"
#include "core/geometry/polygon2.h"
#include "core/pattern/curve.h"

namespace toile {
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
constexpr double kSharpBend = 35 * (kPi / 180);    // rad
constexpr double kTangentBend = 10 * (kPi / 180);  // rad, up to here a line runs on into a curve
constexpr double kTangentReach = 0.5;              // mm, nearer points would show rounding
constexpr std::size_t kReparametrisations = 250;   // chord length starts far off where a curve bends unevenly
constexpr std::size_t kMostWork = 500'000;         // points times reparametrisations for one cubic
constexpr double kHopeless = 0.1;                  // of the run, an error that Newton does not mend
constexpr double kLeastGain = 0.9998;  // factor on the error per Newton step; above, splitting is quicker

using Points = std::span<const Vec2>;

double turn(Vec2 from, Vec2 to) { return std::abs(std::atan2(cross(from, to), dot(from, to))); }

/// The first index from i in direction `step` whose point is kTangentReach away, or the last one in range.
std::size_t reach(Points p, std::size_t i, int step) {
  std::size_t j = i;
  do {
    j += static_cast<std::size_t>(step);
  } while (j > 0 && j + 1 < p.size() && length(p[j] - p[i]) < kTangentReach);
  return j;
}

/// Unit tangent at the middle of three points, of the parabola in chord length through them.
Vec2 middle_tangent(Vec2 a, Vec2 b, Vec2 c) {
  const double h0 = length(b - a), h1 = length(c - b);
  if (!(h0 > 0) || !(h1 > 0)) return normalized(c - a);
  return normalized((b - a) * (h1 / h0) + (c - b) * (h0 / h1));
}

/// Unit tangent at a of the parabola through a, b, c; the chord where it bends too sharply to trust.
Vec2 end_tangent(Vec2 a, Vec2 b, Vec2 c) {
  const double h0 = length(b - a), h1 = length(c - b);
  if (!(h0 > 0) || !(h1 > 0) || turn(b - a, c - b) > kSharpBend) return normalized(b - a);
  const Vec2 f0 = (b - a) * (1 / h0), f1 = (c - b) * (1 / h1);
  return normalized(f0 - (f1 - f0) * (h0 / (h0 + h1)));
}

Vec2 start_tangent(Points p) {
  const std::size_t b = reach(p, 0, 1);
  return b + 1 < p.size() ? end_tangent(p[0], p[b], p[reach(p, b, 1)]) : normalized(p[b] - p[0]);
}

/// Forward tangent at the last point.
Vec2 last_tangent(Points p) {
  const std::size_t n = p.size() - 1, b = reach(p, n, -1);
  return b > 0 ? -end_tangent(p[n], p[b], p[reach(p, b, -1)]) : normalized(p[n] - p[b]);
}

Vec2 inner_tangent(Points p, std::size_t i) {
  return middle_tangent(p[reach(p, i, -1)], p[i], p[reach(p, i, 1)]);
}

std::vector<double> chord_parameters(Points p) {
  std::vector<double> u(p.size(), 0);
  for (std::size_t i = 1; i < p.size(); ++i) u[i] = u[i - 1] + length(p[i] - p[i - 1]);
  for (double& v : u) v /= u.back();
  return u;
}

/// Schneider's least squares: the handle lengths along the given forward tangents.
CubicBezier fit_handles(Points p, const std::vector<double>& u, Vec2 t0, Vec2 t1, double run_length) {
  const Vec2 a = p.front(), b = p.back();
  double c00 = 0, c01 = 0, c11 = 0, x0 = 0, x1 = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double t = u[i], s = 1 - t;
    const double b0 = s * s * s, b1 = 3 * s * s * t, b2 = 3 * s * t * t, b3 = t * t * t;
    const Vec2 a0 = t0 * b1, a1 = -t1 * b2, rest = p[i] - (a * (b0 + b1) + b * (b2 + b3));
    c00 += dot(a0, a0), c01 += dot(a0, a1), c11 += dot(a1, a1);
    x0 += dot(a0, rest), x1 += dot(a1, rest);
  }
  const double det = c00 * c11 - c01 * c01;
  double h0 = (x0 * c11 - x1 * c01) / det, h1 = (c00 * x1 - c01 * x0) / det;
  // Negative, tiny or huge handles make hooks and loops; the heuristic of a third makes none.
  const auto sound = [&](double h) { return h > 1e-3 * run_length && h < run_length; };
  if (!(std::abs(det) > 1e-12 * c00 * c11) || !sound(h0) || !sound(h1)) h0 = h1 = run_length / 3;
  return {a, a + t0 * h0, b - t1 * h1, b};
}

struct Worst {
  double distance = 0;
  std::size_t index = 0;
};

Worst worst_point(Points p, const std::vector<double>& u, const CubicBezier& c) {
  Worst worst{0, p.size() / 2};
  for (std::size_t i = 1; i + 1 < p.size(); ++i) {
    const double d = length(evaluate(c, u[i]) - p[i]);
    if (d > worst.distance) worst = {d, i};
  }
  return worst;
}

/// One Newton step of every parameter towards the foot of its point.
void reparametrise(Points p, std::vector<double>& u, const CubicBezier& c) {
  for (std::size_t i = 1; i + 1 < p.size(); ++i) {
    const Vec2 d = evaluate(c, u[i]) - p[i], d1 = derivative(c, u[i]), d2 = second_derivative(c, u[i]);
    const double slope = dot(d1, d1) + dot(d, d2);
    if (slope > 0) u[i] = std::clamp(u[i] - dot(d, d1) / slope, 0.0, 1.0);
  }
}

/// One cubic for the smooth run p with forward end tangents t0, t1; nothing when none comes close enough, and
/// then the point farthest off it.
std::optional<CubicBezier> fit_one(Points p, Vec2 t0, Vec2 t1, double tolerance, std::size_t& farthest) {
  const double run_length = polyline_length(p);
  std::vector<double> u = chord_parameters(p);
  Worst worst{std::numeric_limits<double>::max(), 0};
  const std::size_t rounds = std::min(kReparametrisations, 8 + kMostWork / p.size());
  for (std::size_t i = 0; i <= rounds; ++i) {
    const CubicBezier curve = fit_handles(p, u, t0, t1, run_length);
    const double before = worst.distance;
    worst = worst_point(p, u, curve);
    if (p.size() == 2 || worst.distance <= tolerance) return curve;
    if (worst.distance > std::max(tolerance, kHopeless * run_length) || worst.distance > kLeastGain * before)
      break;
    reparametrise(p, u, curve);
  }
  farthest = worst.index;
  return std::nullopt;
}

/// Indices where cubics for the smooth run p meet, by halving it at the worst point; ascending, both ends in.
void halve_smooth(Points p, std::size_t offset, Vec2 t0, Vec2 t1, double tolerance,
                  std::vector<std::size_t>& joints) {
  std::size_t farthest = 0;
  if (fit_one(p, t0, t1, tolerance, farthest)) {
    joints.push_back(offset + p.size() - 1);
    return;
  }
  // Away from the ends, so that the depth of halving stays logarithmic.
  const std::size_t last = p.size() - 1, margin = std::max<std::size_t>(1, last / 10);
  const std::size_t at = std::clamp(farthest, margin, last - margin);
  const Vec2 tangent = inner_tangent(p, at);
  halve_smooth(p.first(at + 1), offset, t0, tangent, tolerance, joints);
  halve_smooth(p.subspan(at), offset + at, tangent, t1, tolerance, joints);
}

/// Appends few cubics for the smooth run p with forward end tangents t0, t1: as far as each one reaches, from
/// the start on. Where that takes no fewer, the halves stay.
void fit_smooth(Points p, Vec2 t0, Vec2 t1, double tolerance, std::vector<CubicBezier>& out) {
  std::vector<std::size_t> halves{0};
  halve_smooth(p, 0, t0, t1, tolerance, halves);
  const std::size_t last = p.size() - 1;
  const auto tangent = [&](std::size_t i) { return i == 0 ? t0 : i == last ? t1 : inner_tangent(p, i); };
  std::size_t farthest = 0;
  const auto fit = [&](std::size_t i, std::size_t j) {
    return fit_one(p.subspan(i, j - i + 1), tangent(i), tangent(j), tolerance, farthest);
  };
  std::vector<std::size_t> reached{0};
  while (reached.back() < last && reached.size() < halves.size()) {
    const std::size_t i = reached.back();
    std::size_t good = i + 1, bad = last + 1;
    while (bad - good > 1) {  // a longer run is harder to fit, but for exceptions that cost a curve at most
      const std::size_t j = bad > last ? std::min(last, i + 2 * (good - i)) : (good + bad) / 2;
      if (fit(i, j)) {
        good = j;
        if (j == last) break;
      } else {
        bad = j;
      }
    }
    reached.push_back(good);
  }
  const std::vector<std::size_t>& joints =
      reached.back() == last && reached.size() < halves.size() ? reached : halves;
  for (std::size_t k = 0; k + 1 < joints.size(); ++k)
    if (const auto curve = fit(joints[k], joints[k + 1])) out.push_back(*curve);
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
    low = std::max(low, angle - slack), high = std::min(high, angle + slack), far = distance;
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
  const double least = std::max(kStraightLength, kStraightShare * polyline_length(p));
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
    if (distance_to_segment(q, p.front(), p.back()) > kWholeStraight) return false;
    const double s = dot(q - p.front(), direction);
    if (s < along - kWholeStraight) return false;
    along = std::max(along, s);
  }
  return true;
}

/// The direction of the line beside a curve's end when the curve runs on smoothly from it.
Vec2 joined_tangent(Vec2 own, std::optional<Vec2> line) {
  return line && turn(own, *line) <= kTangentBend ? *line : own;
}

/// Appends curves for points without sharp bends; ends have the given tangents where there are any.
void fit_run(Points p, std::optional<Vec2> t0, std::optional<Vec2> t1, double tolerance,
             std::vector<CubicBezier>& out) {
  if (p.size() == 2 || is_straight_run(p)) {
    out.push_back(line_segment(p.front(), p.back()));
    return;
  }
  const std::vector<Run> runs = runs_of(p);
  const auto direction = [&](const Run& r) { return normalized(p[r.end] - p[r.begin]); };
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const Run& r = runs[k];
    const Points q = p.subspan(r.begin, r.end - r.begin + 1);
    if (r.straight || (q.size() == 2 && runs.size() > 1)) {
      out.push_back(line_segment(q.front(), q.back()));
      continue;
    }
    std::optional<Vec2> before = t0, after = t1;
    if (k > 0) before = direction(runs[k - 1]);
    if (k + 1 < runs.size()) after = direction(runs[k + 1]);
    fit_smooth(q, joined_tangent(start_tangent(q), before), joined_tangent(last_tangent(q), after), tolerance,
               out);
  }
}

/// Turn per length at an inner point, 0 at the ends.
double curvature(Points p, std::size_t i) {
  if (i == 0 || i + 1 >= p.size()) return 0;
  const Vec2 in = p[i] - p[i - 1], out = p[i + 1] - p[i];
  return 2 * turn(in, out) / (length(in) + length(out));
}

/// Whether the polyline bends at its inner point i more than samples of a curve would.
bool is_sharp(Points p, std::size_t i) {
  const Vec2 in = p[i] - p[i - 1], out = p[i + 1] - p[i];
  const double bend = turn(in, out), sagitta = std::min(length(in), length(out)) * bend / 8;
  if (bend > kSharpBend || sagitta > kCoarsestSagitta) return true;
  const double around = std::max(curvature(p, i - 1), curvature(p, i + 1));
  return sagitta > kLeastSagitta && curvature(p, i) > kStandsOut * around;
}

}  // namespace

std::vector<CubicBezier> fit_polyline(std::span<const Vec2> p, double tolerance_mm,
                                      std::span<const std::size_t> ends) {
  std::vector<CubicBezier> curves;
  std::size_t begin = 0;
  std::optional<Vec2> tangent;  // at begin, where the line runs on smoothly
  for (std::size_t i = 1; i < p.size(); ++i) {
    const bool last = i + 1 == p.size(), sharp = last || is_sharp(p, i);
    if (!sharp && !std::binary_search(ends.begin(), ends.end(), i)) continue;
    const std::optional<Vec2> here = sharp ? std::optional<Vec2>() : inner_tangent(p, i);
    fit_run(p.subspan(begin, i - begin + 1), tangent, here, tolerance_mm, curves);
    begin = i, tangent = here;
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
  const double whole = polyline_length(points);
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
  std::vector<CubicBezier> curves;
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    const Points q(points.data() + cuts[k], cuts[k + 1] - cuts[k] + 1);
    fit_smooth(q, tangent(cuts[k]), tangent(cuts[k + 1]), tolerance_mm, curves);
  }
  return curves;
}

}  // namespace toile
