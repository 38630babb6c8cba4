#include "core/collision/contacts.h"

#include <algorithm>
#include <cmath>

#include "core/base/crew.h"

namespace toile::collision {

namespace {

/// Keeps what rounds to the rim of a vertex's free ball within its bounds.
constexpr double kInsideRounding = 1 - 1e-9;

/// Cosine above which two contacts of a vertex count as on the same side.
constexpr double kSameSide = 0.2;

/// Planes that a vertex is led along before it is stopped.
constexpr int kMostTurns = 3;

/// Of a way, what may seem to lead into a plane that it runs along: rounding.
constexpr double kAlong = 1e-12;

/// Vertices that are not worth a helper.
constexpr std::size_t kFewVertices = 512;

/// Largest t in [0, 1] with |start + t·way| within the radius; start lies inside.
double within_ball(Vec3 start, Vec3 way, double radius) {
  const Vec3 end = start + way;
  if (dot(end, end) <= radius * radius) return 1;
  const double a = dot(way, way), b = dot(start, way), c = dot(start, start) - radius * radius;
  const double root = b * b - a * c;
  return root > 0 && a > 0 ? std::clamp((std::sqrt(root) - b) / a, 0.0, 1.0) : 0;
}

double free_squared_of(double trust_radius, std::span<const DivisionPlane> planes) {
  double free = trust_radius;
  for (const DivisionPlane& plane : planes) free = std::min(free, plane.slack);
  free *= kInsideRounding;
  return free < 0 ? -1 : free * free;
}

}  // namespace

void FoundPairs::clear() {
  pairs.clear();
  bounds.clear();
  vertex_contacts.clear();
  rims.clear();
  least_gap = 1;
  least_gap_vertex = kNone;
}

bool Contacts::inside_trust_region(Index v, Vec3 x) const {
  const Vec3 d = x - centre[v];
  return dot(d, d) <= trust_radius[v] * trust_radius[v];
}

bool Contacts::inside_planes(Index v, Vec3 x) const {
  const Vec3 d = x - centre[v];
  return std::all_of(planes[v].begin(), planes[v].end(),
                     [&](const DivisionPlane& plane) { return dot(plane.n, d) >= -plane.slack; });
}

double Contacts::plane_reach(Index v, Vec3 from, Vec3 to) const {
  const Vec3 start = from - centre[v], way = to - from;
  double t = 1;
  for (const DivisionPlane& plane : planes[v]) {
    const double speed = dot(plane.n, way);
    if (speed >= 0) continue;
    const double room = dot(plane.n, start) + plane.slack;
    if (room + t * speed < 0) t = std::max(0.0, room / -speed);
  }
  return t;
}

Vec3 Contacts::reached(Index v, Vec3 from, Vec3 to) const {
  for (int turn = 0; turn < kMostTurns; ++turn) {
    const Vec3 start = from - centre[v], way = to - from;
    const double along = kAlong * length(way);
    const DivisionPlane* met = nullptr;
    double t = 1;
    for (const DivisionPlane& plane : planes[v]) {
      const double inwards = -dot(plane.n, way);
      if (inwards <= along) continue;
      const double free = std::max(0.0, (dot(plane.n, start) + plane.slack) / inwards);
      if (free >= t) continue;
      t = free;
      met = &plane;
    }
    const double ball = within_ball(start, way, trust_radius[v]);
    if (ball < t) return from + way * ball;
    if (!met) return to;
    from += way * t;
    const Vec3 left = to - from;
    to = from + (left - met->n * dot(met->n, left));
  }
  return from;
}

void Contacts::clear(std::size_t vertex_count) {
  centre.resize(vertex_count);
  trust_radius.resize(vertex_count);
  free_squared.resize(vertex_count);
  planes.resize(vertex_count);
  vertex_contacts.resize(vertex_count);
  for (std::vector<DivisionPlane>& of_vertex : planes) of_vertex.clear();
  for (std::vector<VertexContact>& of_vertex : vertex_contacts) of_vertex.clear();
  pairs.clear();
  rims.clear();
  least_gap = 1;
  least_gap_vertex = kNone;
}

void Contacts::forget(std::span<const char> moved, std::span<char> touched) {
  for (ListedPair& pair : pairs) {
    if (pair.gone) continue;
    for (const Index v : pair.v) pair.gone |= v != kNone && moved[v] != 0;
    if (!pair.gone) continue;
    for (const Index v : pair.v) {
      if (v != kNone) touched[v] = 1;
    }
  }
  const auto gone = [&](const auto& entry) { return pairs[entry.pair].gone; };
  for (std::size_t v = 0; v < planes.size(); ++v) {
    if (!touched[v]) continue;
    std::erase_if(planes[v], gone);
    std::erase_if(vertex_contacts[v], gone);
  }
  std::erase_if(rims, gone);
  drop_gone_pairs();
}

/// When they are the greater part: what is left is numbered anew.
void Contacts::drop_gone_pairs() {
  const auto gone = std::count_if(pairs.begin(), pairs.end(), [](const ListedPair& p) { return p.gone; });
  if (2 * static_cast<std::size_t>(gone) <= pairs.size()) return;
  std::vector<Index> number(pairs.size(), kNone);
  Index next = 0;
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    if (!pairs[p].gone) number[p] = next++;
  }
  std::erase_if(pairs, [](const ListedPair& p) { return p.gone; });
  for (std::vector<DivisionPlane>& of_vertex : planes) {
    for (DivisionPlane& plane : of_vertex) plane.pair = number[plane.pair];
  }
  for (std::vector<VertexContact>& of_vertex : vertex_contacts) {
    for (VertexContact& contact : of_vertex) contact.pair = number[contact.pair];
  }
  for (RimContact& rim : rims) rim.pair = number[rim.pair];
}

void Contacts::take(const FoundPairs& found, std::span<char> touched) {
  const auto first = static_cast<Index>(pairs.size());
  for (const ListedPair& pair : found.pairs) {
    pairs.push_back(pair);
    for (const Index v : pair.v) {
      if (v != kNone) touched[v] = 1;
    }
  }
  for (const FoundPairs::Bound& bound : found.bounds) {
    planes[bound.vertex].push_back(bound.plane);
    planes[bound.vertex].back().pair += first;
  }
  for (const VertexContact& near : found.vertex_contacts) {
    std::vector<VertexContact>& of_vertex = vertex_contacts[near.contact.v[0]];
    of_vertex.push_back(near);
    of_vertex.back().pair += first;
  }
  for (const RimContact& rim : found.rims) {
    rims.push_back(rim);
    rims.back().pair += first;
  }
  if (found.least_gap >= least_gap) return;
  least_gap = found.least_gap;
  least_gap_vertex = found.least_gap_vertex;
}

void Contacts::follow(std::span<const char> touched, Crew& crew) {
  crew.ranges(planes.size(), kFewVertices, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      if (!touched[v]) continue;
      free_squared[v] = free_squared_of(trust_radius[v], planes[v]);
      hide_behind_nearest(vertex_contacts[v]);
    }
  });
  contacts.clear();
  for (std::size_t v = 0; v < planes.size(); ++v) {
    for (const VertexContact& near : vertex_contacts[v]) {
      if (!near.hidden) contacts.push_back(near.contact);
    }
  }
  for (const RimContact& rim : rims) contacts.push_back(rim.contact);
}

/// A vertex rests on what is nearest on each side. The rim of a neighbouring face, seen at a slant, is
/// further away in about the same direction; pushing off from it would hold the vertex back as it slides
/// there.
void Contacts::hide_behind_nearest(std::vector<VertexContact>& near) const {
  std::stable_sort(near.begin(), near.end(),
                   [](const VertexContact& a, const VertexContact& b) { return a.gap < b.gap; });
  for (auto mine = near.begin(); mine != near.end(); ++mine) {
    mine->hidden = std::any_of(near.begin(), mine, [&](const VertexContact& nearer) {
      return !nearer.hidden && dot(mine->contact.n, nearer.contact.n) > kSameSide &&
             mine->gap > 1.05 * nearer.gap + kContactFloor;
    });
  }
}

}  // namespace toile::collision
