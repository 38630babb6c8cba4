#include "core/paper/paper_cloth.h"

#include <algorithm>

#include "core/geometry/distance.h"
#include "core/paper/bend.h"
#include "core/paper/integrate.h"
#include "core/paper/path.h"
#include "core/sewing/attached_places.h"

namespace toile::paper {

namespace {

/// What struck a triangle stands off by so much: far beyond rounding, and not to be seen.
constexpr double kStandOff = 5e-5;  // m
/// What is farther than this on one side of a plane is not on the other.
constexpr double kRounding = 1e-9;  // m
/// Triangles that a particle may strike one after the other in a step. What has more to strike stays where it
/// was.
constexpr int kMostStrikes = 4;
/// Looks at all of the cloth in a step: what one particle pushes may strike something itself.
constexpr int kClothRounds = 2;

Corners corners_of(const Tri& t, std::span<const Vec3> x) { return {x[t[0]], x[t[1]], x[t[2]]}; }

}  // namespace

double deformation(const Fans& fans, Index fan, std::span<const Vec3> x) {
  if (!(fans.flat[fan] > 0)) return 0;
  double sum = 0;
  for (Index k = fans.first[fan]; k < fans.first[fan + 1]; ++k) {
    const FanAngle& f = fans.angles[k];
    sum += f.stiffness * (angle_between(x[f.apex], x[f.a], x[f.b]) - f.flat);
  }
  return std::abs(sum) / fans.flat[fan];
}

PaperCloth::PaperCloth(Particles particles, Solids solids, const PaperSettings& settings,
                       std::vector<Vec3> positions)
    : particles_(std::move(particles)),
      solids_(std::move(solids)),
      settings_(settings),
      candidates_(particles_, solids_) {
  state_.previous = positions;
  state_.positions = std::move(positions);
  state_.bent.assign(particles_.fans.flat.size(), 0);
  paths_.resize(state_.positions.size());
}

void PaperCloth::set_held(std::vector<Held> held) {
  held_ = std::move(held);
  held_by_seams_.clear();
  for (const std::vector<Index>& members : particles_.sewn) {
    const auto held_member = std::find_if(held_.begin(), held_.end(), [&](const Held& h) {
      return std::find(members.begin(), members.end(), h.particle) != members.end();
    });
    if (held_member == held_.end()) continue;
    for (const Index i : members) held_by_seams_.push_back({i, held_member->height_only, held_member->place});
  }
}

void PaperCloth::step(const StepForces& forces) {
  guess(forces.gravity);
  for (int pass = 0; pass < settings_.passes; ++pass) {
    pull_links(pass % 2 == 1);
    // Of what is left, so that all passes together go the step's share of the way.
    const double share = forces.closing / (settings_.passes - forces.closing * pass);
    sew(share);
    hold(share);
  }
  bend();
  candidates_.cover(state_.previous, state_.positions);
  strike_cloth();
  if (forces.closing >= 1) sew(1);  // what is sewn stays together, and strikes bodies as one
  hold(0);
  if (forces.closing >= 1) keep(held_by_seams_);
  candidates_.cover(state_.previous, state_.positions);
  strike_solids();
}

/// Equations 3 and 4.
void PaperCloth::guess(double gravity) {
  std::vector<Vec3>& x = state_.positions;
  std::vector<Vec3>& previous = state_.previous;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Vec3 next = next_place(x[i], previous[i], {0, -gravity, 0}, settings_.time_step, settings_.damping);
    previous[i] = x[i];
    x[i] = next;
  }
}

/// Equation 5 over the entire particle system, there and back by turns: a row of links hands a pull on in the
/// direction in which it is gone through.
void PaperCloth::pull_links(bool backwards) {
  std::vector<Vec3>& x = state_.positions;
  const std::size_t count = particles_.links.size();
  for (std::size_t k = 0; k < count; ++k) {
    const Link& link = particles_.links[backwards ? count - 1 - k : k];
    pull_together(x[link.a], x[link.b], particles_.weight[link.a], particles_.weight[link.b], link.rest,
                  link.limit);
  }
}

/// "Moving each particle pair on two sewing lines to their midpoint"; the mean where more than two meet.
void PaperCloth::sew(double closing) {
  std::vector<Vec3>& x = state_.positions;
  for (const std::vector<Index>& members : particles_.sewn) {
    Vec3 sum;
    for (const Index i : members) sum += x[i];
    const Vec3 middle = sum * (1.0 / static_cast<double>(members.size()));
    for (const Index i : members) x[i] = closing < 1 ? x[i] + (middle - x[i]) * closing : middle;
  }
}

void PaperCloth::keep(const std::vector<Held>& held) {
  for (const Held& one : held) {
    Vec3& at = state_.positions[one.particle];
    at = one.height_only ? Vec3{at.x, one.place.y, at.z} : one.place;
  }
}

/// "Moving the specified particle to its desired position".
void PaperCloth::hold(double closing) {
  keep(held_);
  std::vector<Vec3>& x = state_.positions;
  for (const Led& led : led_) {
    const Vec3 at = sewing::position_of(led.point, x);
    const Vec3 way = (sewing::nearest_on_goal(*led.goal, at) - at) * closing;
    double squares = 0;
    for (const double s : led.point.share) squares += s * s;
    for (std::size_t k = 0; k < 3; ++k) x[led.point.v[k]] += way * (led.point.share[k] / squares);
  }
}

/// Equation 6.
void PaperCloth::bend() {
  std::vector<Vec3>& x = state_.positions;
  const Fans& fans = particles_.fans;
  std::vector<double> alpha(fans.flat.size());
  for (std::size_t f = 0; f < alpha.size(); ++f) {
    const double now = deformation(fans, static_cast<Index>(f), x);
    alpha[f] = now > state_.bent[f] ? recovery(now) : 0;
    state_.bent[f] = now;
  }
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = recovered(x[i], state_.previous[i], alpha[fans.of[i]]);
}

void PaperCloth::note_path(Index i) {
  paths_[i] = geometry::box_around({state_.previous[i], state_.positions[i]}, 0);
}

/// Inter-fabric and intra-fabric collision.
void PaperCloth::strike_cloth() {
  for (int round = 0; round < kClothRounds; ++round) {
    bool struck = false;
    for (std::size_t i = 0; i < paths_.size(); ++i) note_path(static_cast<Index>(i));
    for (Index i = 0; i < static_cast<Index>(state_.positions.size()); ++i) struck |= strike_triangle(i);
    if (!struck) return;
  }
}

/// The first triangle of cloth that the particle strikes on its way: both are moved, by their masses, so that
/// it ends where it is reflected to.
bool PaperCloth::strike_triangle(Index particle) {
  std::vector<Vec3>& x = state_.positions;
  const std::vector<Vec3>& before = state_.previous;
  const auto near = [&](const Tri& t) {
    return geometry::overlap(geometry::join(geometry::join(paths_[t[0]], paths_[t[1]]), paths_[t[2]]),
                             paths_[particle]);
  };
  PathHit first;
  Index struck = kNone;
  for (const Index t : candidates_.cloth(particle)) {
    const Tri& tri = particles_.triangles[t];
    if (!near(tri)) continue;
    const auto hit = path_hit(before[particle], x[particle], corners_of(tri, before), corners_of(tri, x));
    if (!hit || (struck != kNone && (hit->at > first.at || (hit->at == first.at && t > struck)))) continue;
    first = *hit;
    struck = t;
  }
  if (struck == kNone) return false;
  const Tri& tri = particles_.triangles[struck];
  const Corners now = corners_of(tri, x);
  const Vec3 normal = normalized(area_normal(now)) * first.side;
  const Vec3 place = now[0] * first.share[0] + now[1] * first.share[1] + now[2] * first.share[2];
  const Vec3 aim = reflected(place, x[particle], normal, settings_.reflection) + normal * kStandOff;
  double mobility = particles_.weight[particle];
  for (std::size_t k = 0; k < 3; ++k) mobility += particles_.weight[tri[k]] * first.share[k] * first.share[k];
  if (!(mobility > 0)) return false;
  const Vec3 push = (aim - x[particle]) * (1 / mobility);
  x[particle] += push * particles_.weight[particle];
  note_path(particle);
  for (std::size_t k = 0; k < 3; ++k) {
    x[tri[k]] -= push * (particles_.weight[tri[k]] * first.share[k]);
    note_path(tri[k]);
  }
  return true;
}

/// Where a particle ends that goes straight from a place outside all bodies, and its way from there on.
PaperCloth::Stopped PaperCloth::stopped_by_solids(Index particle, Vec3 from, Vec3 aim) const {
  Stopped end{aim, aim - from, false};
  for (int strike = 0; strike < kMostStrikes; ++strike) {
    double first = 2;
    Index struck = kNone;
    for (const Index t : candidates_.solids(particle)) {
      const Vec3 corner = solids_.triangles[t][0], outwards = solids_.normals[t];
      if (dot(outwards, end.place - corner) > kRounding || dot(outwards, from - corner) < -kRounding)
        continue;
      const auto hit = path_hit_outside(from, end.place, solids_.triangles[t]);
      if (!hit || hit->at > first || (hit->at == first && t > struck)) continue;
      first = hit->at;
      struck = t;
    }
    if (struck == kNone) return end;
    const Vec3 normal = solids_.normals[struck];
    const Vec3 at = from + (end.place - from) * first;
    end.place = reflected(at, end.place, normal, settings_.reflection) + normal * kStandOff;
    end.way = mirrored(end.way, normal) * settings_.reflection;
    end.struck = true;
  }
  return {from, {}, true};
}

void PaperCloth::strike_solids() {
  std::vector<Vec3>& x = state_.positions;
  for (Index i = 0; i < static_cast<Index>(x.size()); ++i) {
    const Stopped end = stopped_by_solids(i, state_.previous[i], x[i]);
    x[i] = end.place;
    if (end.struck) state_.previous[i] = end.place - end.way;
  }
}

void PaperCloth::come_out() {
  std::vector<Vec3>& x = state_.positions;
  candidates_.cover(x, x);
  for (Index i = 0; i < static_cast<Index>(x.size()); ++i) {
    double least = 1e300;
    Vec3 out;
    for (const Index t : candidates_.solids(i)) {
      if (solids_.skin[t]) continue;
      const Corners& c = solids_.triangles[t];
      const geometry::TrianglePoint p = geometry::closest_on_triangle(x[i], c[0], c[1], c[2]);
      const Vec3 on = c[0] * p.a + c[1] * p.b + c[2] * p.c;
      const double squared = dot(x[i] - on, x[i] - on);
      if (squared >= least) continue;
      least = squared;
      out = dot(x[i] - on, solids_.normals[t]) > 0 ? x[i] : on + solids_.normals[t] * kStandOff;
    }
    if (least < 1e300) x[i] = stopped_by_solids(i, x[i], out).place;
  }
  state_.previous = x;
}

bool PaperCloth::finite() const {
  return std::all_of(state_.positions.begin(), state_.positions.end(), [](Vec3 p) { return is_finite(p); });
}

}  // namespace toile::paper
