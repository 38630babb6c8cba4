#include "core/solver/constraints/preload.h"

#include <algorithm>
#include <cmath>

namespace toile::solver::constraints {

namespace {

/// Steps from one look at the strains to the next: seldom enough to cost little.
constexpr int kInterval = 64;
/// How fast is learnt, over the damping.
constexpr double kPerDamping = 0.5;
/// How much is learnt before the shares shrink.
constexpr double kSoon = 2;
/// How much is learnt at all. Cloth whose triangles are taut and slack by turns would learn and forget for
/// ever, and never come to rest.
constexpr double kEnough = 3.5;
/// Triangles that differ from their neighbours do so by their place in the order of the pass. What they
/// differ by moves no mass, so it is learnt faster by this.
constexpr double kApart = 2, kMostApart = 0.3;
/// Share of its preload that a slack triangle forgets at each look.
constexpr double kForgotten = 0.25;
/// Strain that a preload comes to at most.
constexpr double kMost = 0.5;

/// Cloth that is strained by more is out of shape, and nothing can be learnt from it.
constexpr double kOutOfShape = 0.3;
/// Strain beyond the limit from which cloth gives way, and the share of what is beyond that is given at a
/// look.
constexpr double kBeyond = 0.02, kGiven = 0.25;

/// What is around a vertex.
struct Around {
  Vec3 off;
  double tension = 0, buckling = 0;  ///< J, sums over its triangles
  int count = 0;
};

double over(double value, double from) { return std::max(0.0, value - from); }

/// What buckling adds to the strain; as buckle() in core/solver/lanes/membrane_kernel.h does. `c`:
/// compliances over h².
Vec3 buckled(const double (&c)[4], double from, Vec3 l) {
  constexpr double kSlack = 1 / kBuckledStiffness - 1;
  const double along = 0.25 * (c[0] + c[1] + 2 * c[2] + c[3]);
  const double bias = kSlack * along * over(0.5 * (l.x + l.y) + std::abs(l.z), from);
  return {kSlack * c[0] * over(l.x, from) + 0.5 * bias, kSlack * c[1] * over(l.y, from) + 0.5 * bias,
          l.z < 0 ? -bias : bias};
}

/// What limits take off the strain; as keep_limits() there does.
Vec3 limited(const MembraneTriangle& t, const double (&c)[4], Vec3 plain) {
  const double weft = t.stop[0] * over(-plain.x, t.limit[0]), warp = t.stop[1] * over(-plain.y, t.limit[1]);
  const double shear = t.stop[2] * c[3] * over(std::abs(plain.z), t.limit[2]);
  return {c[0] * weft + c[2] * warp, c[2] * weft + c[1] * warp, plain.z < 0 ? shear : -shear};
}

/// The strain that λ asks for, with its sign turned.
Vec3 strain_against(const MembraneTriangle& t, double h, Vec3 l) {
  double c[4];
  for (int k = 0; k < 4; ++k) c[k] = t.compliance[k] / (h * h);
  const Vec3 plain{c[0] * l.x + c[2] * l.y, c[2] * l.x + c[1] * l.y, c[3] * l.z};
  return plain + limited(t, c, plain) + buckled(c, t.buckling * h * h, l);
}

/// As the pass measures it.
Vec3 strain_at(const MembraneTriangle& t, std::span<const Vec3> x) {
  const Vec3 e1 = x[t.v[1]] - x[t.v[0]], e2 = x[t.v[2]] - x[t.v[0]];
  const Vec3 fu = e1 * t.b[0] + e2 * t.b[1], fv = e1 * t.b[2] + e2 * t.b[3];
  return {length(fu) - 1, length(fv) - 1, dot(fu, fv)};
}

/// What a strain beyond where cloth with such a limit (0: none) gives way has to give, by what of it the pass
/// feels through its preload.
double to_give(double strain, double felt, double limit) {
  const double from = limit + kBeyond;
  return limit > 0 && strain > from ? over(felt, from) : 0;
}

Vec3 held_within(Vec3 p, double most) {
  return {std::clamp(p.x, -most, most), std::clamp(p.y, -most, most), std::clamp(p.z, -most, most)};
}

}  // namespace

bool LearningPace::due(double damping) {
  if (damping <= 0 || ended()) return false;
  return ++steps >= kInterval;
}

bool LearningPace::ended() const { return learnt >= kEnough; }

double LearningPace::next_share(double damping, double h) {
  const double sooner = learnt / kSoon;
  const double share = std::min(1.0, kPerDamping * damping * steps * h) / (1 + sooner * sooner);
  learnt += share;
  steps = 0;
  return share;
}

void learn_preloads(std::span<const MembraneTriangle> triangles, std::span<const Vec3> noted, double h,
                    double share, bool at_last, std::span<const Vec3> x, std::vector<Vec3>& preloads) {
  std::vector<Around> around(x.size());
  std::vector<Vec3> off(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const MembraneTriangle& t = triangles[i];
    off[i] = strain_at(t, x) + strain_against(t, h, noted[i]);
    for (const Index v : t.v) {
      around[v].off += off[i];
      around[v].tension -= (noted[i].x + noted[i].y) / (h * h);
      around[v].buckling += t.buckling;
      ++around[v].count;
    }
  }
  const double forgotten = at_last ? 1 : kForgotten;
  const double apart = std::min(kApart * share, kMostApart);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    double tautness = 0;
    Vec3 mean;
    for (const Index v : triangles[i].v) {
      tautness += around[v].tension - around[v].buckling;
      mean += around[v].off * (1.0 / (3 * around[v].count));
    }
    if (off[i].x > kOutOfShape || off[i].y > kOutOfShape) {
      preloads[i] = {};
      continue;
    }
    const Vec3 change = tautness > 0 ? off[i] * share + (off[i] - mean) * apart : preloads[i] * -forgotten;
    preloads[i] = held_within(preloads[i] + change, kMost);
  }
}

bool give_way(std::span<const MembraneTriangle> triangles, std::span<const Vec3> x, const MayGive& may,
              std::vector<Vec3>& preloads) {
  bool some = false;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const MembraneTriangle& t = triangles[i];
    const Vec3 strain = strain_at(t, x), felt = strain + preloads[i];
    const Vec3 beyond{to_give(strain.x, felt.x, t.limit[0]), to_give(strain.y, felt.y, t.limit[1]),
                      std::copysign(to_give(std::abs(strain.z), std::abs(felt.z), t.limit[2]), felt.z)};
    if (beyond == Vec3{} || !may((x[t.v[0]] + x[t.v[1]] + x[t.v[2]]) * (1.0 / 3))) continue;
    preloads[i] += beyond * -kGiven;
    some = true;
  }
  return some;
}

std::vector<Vec3> preloads_at_rest(std::span<const MembraneTriangle> triangles, std::span<const Vec3> x) {
  std::vector<Vec3> preloads;
  preloads.reserve(triangles.size());
  for (const MembraneTriangle& t : triangles) preloads.push_back(-strain_at(t, x));
  return preloads;
}

}  // namespace toile::solver::constraints
