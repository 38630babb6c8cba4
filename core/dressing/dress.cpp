#include "core/dressing/dress.h"

#include <algorithm>
#include <cmath>

#include "core/base/snapped.h"
#include "core/dressing/axis_guard.h"
#include "core/dressing/clearance.h"
#include "core/dressing/cut_on_sleeves.h"
#include "core/dressing/shape_solver.h"
#include "core/dressing/shoulders.h"
#include "core/sewing/rings.h"

namespace toile::dressing {

namespace {

constexpr int kClosing = 110, kLater = 60, kPulling = 50;  // passes in which threads shorten, and are short
constexpr int kSewing = kLater + kClosing + kPulling;
constexpr int kGrowing = 90, kSpreading = 20;
constexpr double kComingBack[] = {0.3,  0.5,  0.7, 0.85,
                                  0.95, 0.98, 0.99};  // shares of its size that cloth keeps
constexpr double kHang = 1.5e-5;                      // as ShapeWishes
constexpr double kOnBody = 0.04;                      // m
constexpr double kFinishing = 0.01;                   // m, that a finer mesh is moved off the body at most
constexpr int kUntangling = 120;
constexpr int kSmoothings = 3;
constexpr double kSmooth = 1;  // bending, as ShapeWishes
/// Share of what crossed that smoothing leaves at most, where cloth that is not tangled is to grow: a step
/// that goes no further is given up, and costs nothing but a part of the size.
constexpr double kLessTangled = 0.9;
/// What finding out what crosses, and the certificate, cost in passes of the shape problem.
constexpr int kLook = 1, kJudging = 20;
constexpr int kWatched = 10;  // passes from one look to the next

struct Sewn {
  std::vector<Index> vertex_of;  ///< shape vertex of each garment vertex
  ShapeMesh mesh;
  std::vector<Vec3> x;
};

double mean_edge(const sewing::GarmentMesh& g) {
  double sum = 0;
  for (const Tri& t : g.triangles) sum += length(g.rest[t[0]] - g.rest[t[1]]);
  return sum / static_cast<double>(std::max<std::size_t>(1, g.triangles.size()));
}

Sewn shape_of(const sewing::Assembly& assembly, std::vector<Index> vertex_of, std::span<const Vec3> x) {
  const sewing::GarmentMesh& g = assembly.garment;
  Sewn s;
  for (const auto& [a, b] : assembly.turned) s.mesh.turned.push_back({vertex_of[a], vertex_of[b]});
  s.mesh.vertex_count = 1 + *std::max_element(vertex_of.begin(), vertex_of.end());
  s.mesh.spacing = mean_edge(g);
  std::vector<int> count(static_cast<std::size_t>(s.mesh.vertex_count), 0);
  s.x.resize(count.size());
  for (std::size_t i = 0; i < vertex_of.size(); ++i) {
    s.x[vertex_of[i]] += x[i];
    ++count[vertex_of[i]];
  }
  for (std::size_t v = 0; v < count.size(); ++v) s.x[v] = s.x[v] * (1.0 / count[v]);
  for (const Tri& t : g.triangles) {
    const Tri w{vertex_of[t[0]], vertex_of[t[1]], vertex_of[t[2]]};
    if (w[0] == w[1] || w[1] == w[2] || w[2] == w[0]) continue;
    s.mesh.triangles.push_back(w);
    s.mesh.rest.push_back({g.rest[t[0]], g.rest[t[1]], g.rest[t[2]]});
  }
  s.vertex_of = std::move(vertex_of);
  return s;
}

std::vector<Vec3> unjoined(const Sewn& s) {
  std::vector<Vec3> x;
  x.reserve(s.vertex_of.size());
  for (const Index v : s.vertex_of) x.push_back(s.x[v]);
  return x;
}

std::vector<Index> each_for_itself(Index count) {
  std::vector<Index> v(static_cast<std::size_t>(count));
  for (Index i = 0; i < count; ++i) v[i] = i;
  return v;
}

std::vector<Index> joined(const sewing::GarmentMesh& g) {
  std::vector<Index> v(static_cast<std::size_t>(g.vertex_count()), kNone);
  Index next = 0;
  for (Index i = 0; i < g.vertex_count(); ++i) v[i] = g.weld[i] == i ? next++ : v[g.weld[i]];
  return v;
}

/// A large skirt would draw the bodice down to it: pieces of the trunk go sideways only, as a whole.
void keep_up(const sewing::GarmentMesh& g, std::span<const Covers> covers, std::span<const Vec3> before,
             std::vector<Vec3>& x) {
  for (std::size_t p = 0; p < covers.size(); ++p) {
    if (covers[p] != Covers::kTrunk) continue;
    const Index from = g.first_vertex[p], to = g.first_vertex[p + 1];
    double sunk = 0;
    for (Index v = from; v < to; ++v) sunk += before[v].y - x[v].y;
    sunk /= std::max<Index>(1, to - from);
    for (Index v = from; v < to; ++v) x[v].y += sunk;
  }
}

/// Nothing holds a garment up yet: it sinks no more than what lies on the trunk does.
void stay_up(const Wearer& wearer, std::span<const Vec3> before, std::vector<Vec3>& x) {
  const measure::BodyFigure& f = wearer.figure();
  const SlimFigure whole = wearer.slim(0);
  double sunk = 0;
  int count = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i].y < f.crotch || x[i].y > f.chin || std::abs(x[i].x - f.middle) > f.armpit[0].x - f.middle)
      continue;
    if (whole.clearance(x[i]) > kOnBody) continue;
    sunk += before[i].y - x[i].y;
    ++count;
  }
  if (count == 0 || sunk <= 0) return;
  for (Vec3& p : x) p.y += sunk / count;
}

/// Whether something goes around one leg alone, as trousers do: the crotch then says how high they hang.
bool has_legs(const sewing::GarmentMesh& g, std::span<const Vec3> x, const Skeleton& skeleton) {
  for (const std::vector<Index>& ring : sewing::rings_of(g)) {
    std::vector<Vec3> line;
    line.reserve(ring.size());
    for (const Index v : ring) line.push_back(x[v]);
    const std::optional<Enclosure> around = enclosed_by(line, skeleton);
    if (around && (around->times[kLeftLeg] != 0) != (around->times[kRightLeg] != 0)) return true;
  }
  return false;
}

/// Bodice and skirt, sleeves and legs become tubes first; what joins them to each other comes later.
std::vector<Thread> threads_of(const sewing::GarmentMesh& g, std::span<const Covers> covers,
                               std::span<const Vec3> x) {
  std::vector<Thread> threads;
  for (const auto& [i, j] : g.sewn) {
    const bool late = covers[static_cast<std::size_t>(g.panel_of_vertex[i])] !=
                      covers[static_cast<std::size_t>(g.panel_of_vertex[j])];
    threads.push_back({i, j, length(x[i] - x[j]), late});
  }
  return threads;
}

ShapeWishes rubber(const DressingWay& way) {
  return {way.least_stretch, way.give.growing, way.bending, 1, 0.05, 0};
}

Shrunk shrunk_at(int pass) {
  const auto share = [](int since) { return std::max(0.0, 1 - static_cast<double>(since) / kClosing); };
  return {share(pass), pass < kLater ? std::nullopt : std::optional(share(pass - kLater))};
}

}  // namespace

namespace {

/// Whether every ring goes around a limb. What no limb came out of yet is worth guarding; where one is wrong
/// once the body is whole, no untangling helps, and the next way is tried sooner.
bool rings_right(const sewing::GarmentMesh& g, std::span<const Vec3> x, const Skeleton& skeleton) {
  const std::vector<WornRing> rings = worn_rings(g, x, skeleton);
  return std::all_of(rings.begin(), rings.end(), [](const WornRing& r) { return r.right; });
}

/// Threads draw the pieces together around the slim figure.
std::vector<Vec3> drawn_together(const sewing::Assembly& assembly, const Wearer& wearer,
                                 const DressingWay& way, const RunContext& context, const ShapeWatch& watch) {
  const sewing::GarmentMesh& g = assembly.garment;
  const std::vector<Covers> covers = covers_of(assembly, wearer.figure(), way.staging.sleeves);
  const std::vector<Vec3> start = staged(assembly, covers, wearer.figure(), way.staging);
  const SlimFigure slim = wearer.slim(way.slim);
  Sewn open = shape_of(assembly, each_for_itself(g.vertex_count()), start);
  ShapeSolver solver(open.mesh, threads_of(g, covers, start), rubber(way));
  AxisGuard guard(axes_of(wearer.skeleton()), open.mesh.triangles, open.x,
                  rings_right(g, start, wearer.skeleton()) ? gaps_of(g, covers, wearer.skeleton()) : Gaps{});
  std::optional<KeptOnArms> on_arms;
  if (are_along_arms(covers, way.staging.sleeves)) on_arms.emplace(assembly, covers, wearer.figure(), open.x);
  for (int i = 0; i < kSewing && !context.cancelled(); ++i) {
    if (watch && i % kWatched == 0) watch(open.x);
    const std::vector<Vec3> before = open.x;
    solver.pass(open.x, shrunk_at(i), &slim);
    keep_up(g, covers, before, open.x);
    if (on_arms) on_arms->keep(before, open.x);
    guard.keep(before, open.x);
    context.progress("dress", 0.5 * i / kSewing);
  }
  return open.x;
}

/// The figure grows to the body within the sewn garment.
void grow(const sewing::Assembly& assembly, const Wearer& wearer, const DressingWay& way,
          const RunContext& context, const ShapeWatch& watch, Sewn& sewn) {
  // A crotch says how high trousers hang; all else needs something to keep it up, and down.
  const bool hangs = !has_legs(assembly.garment, assembly.positions, wearer.skeleton());
  ShapeWishes growing = rubber(way);
  if (hangs) {
    growing.stay = 0.02;
    growing.hang = kHang;
  }
  const OnShoulders shoulders(assembly, wearer, sewn.vertex_of, sewn.mesh.vertex_count);
  ShapeSolver solver(sewn.mesh, {}, growing);
  AxisGuard guard(axes_of(wearer.skeleton()), sewn.mesh.triangles, sewn.x);
  for (int i = 0; i <= kGrowing && !context.cancelled(); ++i) {
    if (watch && i % kWatched == 0) watch(unjoined(sewn));
    const SlimFigure figure = wearer.slim(way.slim * (1 - static_cast<double>(i) / kGrowing));
    const std::vector<Vec3> before = sewn.x;
    shoulders.hold_in(sewn.x);
    shoulders.centre(sewn.x);
    solver.pass(sewn.x, {}, &figure);
    if (hangs) stay_up(wearer, before, sewn.x);
    guard.keep(before, sewn.x);
    context.progress("dress", 0.5 + 0.3 * i / kGrowing);
  }
}

/// Gaps that contact can begin with.
void make_room(const Wearer& wearer, Sewn& sewn) {
  open_gaps(collision::make_surface(sewn.mesh.triangles, sewn.mesh.vertex_count), wearer.obstacles(), sewn.x);
}

void judge(const sewing::Assembly& assembly, const Wearer& wearer, Dressed& dressed) {
  dressed.certificate = certify(assembly.garment, dressed.positions, wearer.slim(0), wearer.crossing(),
                                wearer.obstacles(), wearer.skeleton());
  dressed.bared_shoulders =
      bared_shoulders(assembly, wearer.figure(), dressed.certificate.rings, dressed.positions);
}

/// The cloth comes back to its shape, as far as that makes no new tangle: its shapes on the way, the fullest
/// last. None where it is tangled as it is; `sewn` is then as far apart as it came.
std::vector<std::vector<Vec3>> come_back(const sewing::Assembly& assembly, const Wearer& wearer,
                                         const DressingWay& way, const RunContext& context, Effort& effort,
                                         Sewn& sewn) {
  const OnShoulders shoulders(assembly, wearer, sewn.vertex_of, sewn.mesh.vertex_count);
  const SlimFigure whole = wearer.slim(0);
  const collision::Surface surface = collision::make_surface(sewn.mesh.triangles, sewn.mesh.vertex_count);
  AxisGuard guard(axes_of(wearer.skeleton()), sewn.mesh.triangles, sewn.x);
  const auto pass = [&](std::vector<Vec3>& x, AxisGuard& of_x, double least, double bending) {
    ShapeSolver solver(sewn.mesh, {}, {least, way.give.coming_back, bending, 0, 0.05, 0});
    for (int i = 0; i < kSpreading; ++i) {
      const std::vector<Vec3> before = x;
      shoulders.hold_in(x);
      shoulders.centre(x);
      shoulders.let_down(x);
      solver.pass(x, {}, &whole);
      of_x.keep(before, x);
    }
    effort.spend(sewn.mesh.vertex_count, kSpreading);
  };
  // What is caught in a fold comes free as the fold is smoothed, as long as that makes less of it.
  const auto parted = [&](std::vector<Vec3>& x, AxisGuard& of_x, double least, double progress) {
    double before = HUGE_VAL;
    for (int round = 0;; ++round) {
      const Untangled u =
          untangle(surface, whole, wearer.crossing(), sewn.mesh.spacing, kUntangling, x, &of_x);
      effort.spend(sewn.mesh.vertex_count, kLook * (1 + u.passes));
      if (u.left.none()) return true;
      if (round == kSmoothings || u.left.all() > progress * before || effort.spent() || context.cancelled())
        return false;
      before = u.left.all();
      pass(x, of_x, least, kSmooth);
    }
  };
  if (!parted(sewn.x, guard, way.least_stretch, HUGE_VAL)) return {};
  std::vector<std::vector<Vec3>> shapes{sewn.x};
  for (const double wanted : kComingBack) {
    if (effort.spent() || context.cancelled()) break;
    const double least = std::max(wanted, way.least_stretch);
    std::vector<Vec3> x = shapes.back();
    AxisGuard of_x = guard;
    pass(x, of_x, least, 0.5 * way.bending);
    if (!parted(x, of_x, least, kLessTangled)) break;
    shapes.push_back(std::move(x));
    guard = std::move(of_x);
  }
  return shapes;
}

std::vector<Vec3> placed_at(const Sewn& sewn) {
  std::vector<Vec3> positions = unjoined(sewn);
  for (Vec3& p : positions) p = snapped(p);
  return positions;
}

/// The fullest of these shapes that is certified: fuller cloth may lie too close to itself or to the body for
/// contact to begin with where it is tight, and smaller cloth has room. Where none is, the fullest. `dressed`
/// has what the garment is without them.
void take_fullest(const sewing::Assembly& assembly, const Wearer& wearer,
                  std::vector<std::vector<Vec3>> shapes, Sewn& sewn, Dressed& dressed) {
  std::optional<Dressed> fullest;
  for (; !shapes.empty(); shapes.pop_back()) {
    sewn.x = std::move(shapes.back());
    make_room(wearer, sewn);
    dressed.positions = placed_at(sewn);
    dressed.effort.spend(assembly.garment.vertex_count(), kJudging);
    judge(assembly, wearer, dressed);
    if (dressed.certificate.holds()) return;
    if (!fullest) fullest = dressed;
    if (dressed.certificate.wrong_rings() > 0 || dressed.effort.spent()) break;
  }
  fullest->effort = dressed.effort;
  dressed = std::move(*fullest);
}

}  // namespace

Dressed dress(const sewing::Assembly& assembly, const Wearer& wearer, const DressingWay& way,
              const RunContext& context, const ShapeWatch& watch, Effort effort) {
  const sewing::GarmentMesh& g = assembly.garment;
  Dressed dressed{{}, {}, way, 0, 0, effort};
  const std::vector<Vec3> open = drawn_together(assembly, wearer, way, context, watch);
  for (const auto& [i, j] : g.sewn) dressed.seam_gap = std::max(dressed.seam_gap, length(open[i] - open[j]));
  Sewn sewn = shape_of(assembly, joined(g), open);
  grow(assembly, wearer, way, context, watch, sewn);
  dressed.effort.spend(g.vertex_count(), kSewing + kGrowing);
  if (rings_right(g, unjoined(sewn), wearer.skeleton())) {
    auto shapes = come_back(assembly, wearer, way, context, dressed.effort, sewn);
    if (!shapes.empty()) {
      take_fullest(assembly, wearer, std::move(shapes), sewn, dressed);
      return dressed;
    }
  }
  dressed.positions = placed_at(sewn);  // no room makes good what is not on
  dressed.effort.spend(g.vertex_count(), kJudging);
  judge(assembly, wearer, dressed);
  return dressed;
}

void finish(const sewing::Assembly& assembly, const Wearer& wearer, Dressed& dressed) {
  const sewing::GarmentMesh& g = assembly.garment;
  const SlimFigure whole = wearer.slim(0);
  Sewn sewn = shape_of(assembly, joined(g), dressed.positions);
  for (Vec3& p : sewn.x) p = whole.moved_out(p, kFinishing);
  untangle(collision::make_surface(sewn.mesh.triangles, sewn.mesh.vertex_count), whole, wearer.crossing(),
           sewn.mesh.spacing, kUntangling, sewn.x);
  make_room(wearer, sewn);
  for (std::size_t i = 0; i < dressed.positions.size(); ++i)
    dressed.positions[i] = snapped(sewn.x[sewn.vertex_of[i]]);
  judge(assembly, wearer, dressed);
}

bool same_way(const sewing::Assembly& assembly, const Wearer& wearer, const DressingWay& a,
              const DressingWay& b) {
  if (a.slim != b.slim || a.least_stretch != b.least_stretch || a.bending != b.bending || a.give != b.give)
    return false;
  const auto start = [&](const Staging& staging) {
    return staged(assembly, covers_of(assembly, wearer.figure(), staging.sleeves), wearer.figure(), staging);
  };
  return start(a.staging) == start(b.staging);
}

// Folding comes after drawing in: it leaves the hems of light cloth turned up, which drawing in as a whole
// does not. Trousers, which hang from nothing that could be folded, are put on as long as they are where they
// were placed. Wide necks slide off a shoulder where cloth gives much; tight garments go through the body
// where it gives little, since a coarse ring of their girth cuts through a limb's bulges: much is tried
// second.
const std::vector<DressingWay>& dressing_ways() {
  using enum CutOn;
  constexpr Give kMuch{1.2, 1.04};
  static const std::vector<DressingWay> kWays{
      {{0.12, 0, true, false, Wide::kSmaller, kAlongFreeArms}, 0.5, 0.3, 0.3},
      {{0.12, 0, true, false, Wide::kSmaller, kAsPlaced}, 0.5, 0.3, 0.3},
      {{0.12, 0, true, false, Wide::kFolded, kAsPlaced}, 0.5, 0.3, 0.3, kMuch},
      {{0.08, 0.08, false, false, Wide::kAsPlaced, kAsPlaced}, 0.65, 0.3, 0.1, kMuch},
      {{0.12, 0.05, false, false, Wide::kSmaller, kAsPlaced}, 0.5, 0.3, 0.3, kMuch},
      {{0.07, 0.07, true, true, Wide::kSmaller, kAsPlaced}, 0.5, 0.3, 0.3, kMuch},
      {{0.05, 0.05, true, false, Wide::kSmaller, kAsPlaced}, 0.3, 0.3, 0.3, kMuch},
      {{0, 0, true, false, Wide::kSmaller, kAsPlaced}, 0.3, 0.9, 0.3, kMuch},
      {{0.05, 0.05, true, false, Wide::kSmaller, kAsPlaced}, 0.5, 0.9, 0.03, kMuch},
      {{0, 0.12, true, false, Wide::kSmaller, kAsPlaced}, 0.5, 0.3, 0.3, kMuch},
      {{0, 0, true, false, Wide::kSmaller, kAsPlaced}, 0.5, 0.9, 0.03, kMuch},
      {{0.12, 0, true, false, Wide::kSmaller, kAlongArms}, 0.5, 0.3, 0.3, kMuch}};
  return kWays;
}

}  // namespace toile::dressing
