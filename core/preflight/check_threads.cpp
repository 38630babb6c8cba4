#include "core/preflight/check_threads.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace toile::preflight {

namespace {

/// m, how far aside a thread is tried; beyond the last there is no coming off on that side.
constexpr double kAside[] = {0.005, 0.01, 0.015, 0.02, 0.03, 0.04, 0.05,
                             0.065, 0.08, 0.10,  0.13, 0.17, 0.22, 0.3};
constexpr double kNoWay = 0.4;
constexpr double kNearLimb = 0.02;  ///< m
constexpr double kSlim = 0.13;      ///< m, from side to side
/// A thread deeper than this in a body's middle stays there.
constexpr double kDeep = 0.02;
/// Share of the breadth that the nearer side is away: 0.5 is the very middle.
constexpr double kMiddle = 0.3;

struct BodyThread {
  Vec3 a, b;
  double inside = 0;  ///< m that run through the body
};

/// How far aside a thread must go to come off the body.
struct Clearance {
  double nearer = 0, opposite = 0;  ///< m, on the nearest side and on the one across
  Vec3 way;                         ///< unit vector to the nearest side
  double breadth() const { return nearer + opposite; }
  bool is_stuck() const { return nearer > kDeep && nearer > kMiddle * breadth(); }
};

/// A line that runs exactly along an edge passes through no triangle's inside, and bodies and threads are
/// often built on the same planes: a twin a tenth of a millimetre aside is asked, too. A short line may
/// lie inside as a whole.
constexpr Vec3 kTwin{1.13e-4, 1.71e-4, 0.93e-4};

bool meets_body(const BodyProbe& probe, Vec3 a, Vec3 b) {
  return probe.meets(a, b) || probe.meets(a + kTwin, b + kTwin) || probe.contains((a + b) * 0.5 + kTwin);
}

double inside_length(const BodyProbe& probe, Vec3 a, Vec3 b) {
  double most = 0;
  for (const Vec3 aside : {Vec3{}, kTwin}) {
    const auto hits = probe.hits(a + aside, b + aside);
    double sum = 0;
    for (std::size_t i = 0; i + 1 < hits.size(); i += 2) sum += hits[i + 1] - hits[i];
    most = std::max(most, sum);
  }
  return most * length(b - a);
}

/// Unit vectors at right angles to a direction, evenly around it; opposite ones are kWays / 2 apart.
std::array<Vec3, kWays> ways_across(Vec3 direction) {
  const PlaneFrame f = make_plane_frame({}, direction);
  constexpr double kHalf = 0.70710678118654752;
  return {f.u,  (f.u + f.v) * kHalf,  f.v,  (f.v - f.u) * kHalf,
          -f.u, (f.u + f.v) * -kHalf, -f.v, (f.u - f.v) * kHalf};
}

double aside_until_clear(const BodyProbe& probe, const BodyThread& t, Vec3 way) {
  for (const double d : kAside) {
    if (!meets_body(probe, t.a + way * d, t.b + way * d)) return d;
  }
  return kNoWay;
}

Clearance clearance_of(const BodyProbe& probe, const BodyThread& t) {
  const auto ways = ways_across(t.b - t.a);
  double away[kWays];
  int best = 0;
  for (int k = 0; k < kWays; ++k) {
    away[k] = aside_until_clear(probe, t, ways[k]);
    if (away[k] < away[best]) best = k;
  }
  return {away[best], away[(best + kWays / 2) % kWays], ways[best]};
}

/// Whether a slim limb stands within kNearLimb of a thread that does not meet it.
bool is_near_limb(const BodyProbe& probe, const BodyThread& t) {
  const auto ways = ways_across(t.b - t.a);
  for (const Vec3 way : ways) {
    const BodyThread beside{t.a + way * kNearLimb, t.b + way * kNearLimb, 0};
    if (!meets_body(probe, beside.a, beside.b)) continue;
    if (kNearLimb + aside_until_clear(probe, beside, way) <= kSlim) return true;
  }
  return false;
}

std::string count_text(std::size_t count, std::size_t of) {
  return std::to_string(count) + " of " + std::to_string(of) + " threads";
}

class SeamThreads {
 public:
  SeamThreads(const sewing::Assembly& assembly, Index seam) {
    for (std::size_t k = 0; k < assembly.garment.sewn.size(); ++k) {
      if (assembly.garment.seam_of_sewn[k] != seam) continue;
      const auto [i, j] = assembly.garment.sewn[k];
      threads_.push_back({assembly.positions[i], assembly.positions[j], 0});
    }
  }

  /// What there is to say about the seam and one body.
  std::optional<Finding> look(const BodyProbe& probe, const std::string& seam) const {
    std::vector<BodyThread> through;
    for (BodyThread t : threads_) {
      t.inside = inside_length(probe, t.a, t.b);
      if (t.inside > 0) through.push_back(t);
    }
    const Concerns about{seam_named(seam), body_named(probe.body().id)};
    const std::string body = "body " + probe.body().id;
    if (through.empty()) return near_limb(probe, body, about);
    std::stable_sort(through.begin(), through.end(),
                     [](const BodyThread& s, const BodyThread& t) { return s.inside > t.inside; });
    const std::size_t looked_at = std::min(kLookedAt, through.size());  // the deepest
    Finding f = found(FindingKind::kThreadThroughBody, "", about, middle(through[0]));
    Clearance worst;
    for (std::size_t i = 0; i < looked_at; ++i) {
      const BodyThread& t = through[i * (through.size() - 1) / std::max<std::size_t>(1, looked_at - 1)];
      const Clearance c = clearance_of(probe, t);
      if (!c.is_stuck() || c.nearer <= worst.nearer) continue;
      worst = c;
      f.place = middle(t);
      f.severity = Severity::kError;
    }
    f.message = count_text(through.size(), threads_.size()) + " run through " + body;
    f.message += f.severity == Severity::kNote
                     ? "; they can slide off it as they shorten"
                     : ", through its middle, and cannot slide off: the seam would stay open; move its "
                       "pieces by about " +
                           length_text(worst.nearer) + " towards " + way_text(worst.way);
    return f;
  }

 private:
  static Vec3 middle(const BodyThread& t) { return (t.a + t.b) * 0.5; }

  std::optional<Finding> near_limb(const BodyProbe& probe, const std::string& body,
                                   const Concerns& about) const {
    const std::size_t stride = std::max<std::size_t>(1, threads_.size() / kLookedAt);
    for (std::size_t i = 0; i < threads_.size(); i += stride) {
      if (length(threads_[i].b - threads_[i].a) < kNearLimb || !is_near_limb(probe, threads_[i])) continue;
      return found(FindingKind::kThreadNearLimb,
                   "a slim limb of " + body + " stands within " + length_text(kNearLimb) +
                       " of the thread, beside it; the seam closes if that is its right side",
                   about, middle(threads_[i]));
    }
    return std::nullopt;
  }

  std::vector<BodyThread> threads_;
};

}  // namespace

std::string way_text(Vec3 way) {
  const double x = std::abs(way.x), y = std::abs(way.y), z = std::abs(way.z);
  if (x >= y && x >= z) return way.x > 0 ? "the body's left" : "the body's right";
  if (y >= z) return way.y > 0 ? "the top" : "the floor";
  return way.z > 0 ? "the front" : "the back";
}

void check_threads(const PreflightInput& input, std::span<const BodyProbe> probes,
                   const sewing::Assembly& assembly, Findings& findings) {
  for (Index s = 0; s < static_cast<Index>(input.pattern.seams.size()); ++s) {
    const SeamThreads threads(assembly, s);
    for (const BodyProbe& probe : probes) {
      if (auto finding = threads.look(probe, input.pattern.seams[s].id)) {
        findings.push_back(std::move(*finding));
      }
    }
  }
}

}  // namespace toile::preflight
