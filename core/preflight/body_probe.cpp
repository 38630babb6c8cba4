#include "core/preflight/body_probe.h"

#include <algorithm>

#include "core/geometry/polygon2.h"

namespace toile::preflight {

namespace {

constexpr double kStride = 0.06;  // m; a long slanting line is asked for in pieces, whose boxes are small

double volume(Vec3 a, Vec3 b, Vec3 c, Vec3 p) { return dot(cross(b - a, c - a), p - a); }

}  // namespace

BodyProbe::BodyProbe(const body::Body& body)
    : body_(&body),
      crossing_(collision::make_crossing_body(body.mesh.vertices, body.mesh.triangles)),
      cutter_(body.mesh),
      box_(bounding_box(body.mesh.vertices)) {}

/// Calls visit(triangle) for every triangle that the segment passes through, some of them more than once,
/// until it returns false.
template <typename Visit>
void BodyProbe::visit_hits(Vec3 from, Vec3 to, Visit&& visit) const {
  const collision::ExactPoint p = collision::to_grid(from), q = collision::to_grid(to);
  const int strides = 1 + static_cast<int>(length(to - from) / kStride);
  bool going = true;
  for (int k = 0; k < strides && going; ++k) {
    const Vec3 a = from + (to - from) * (static_cast<double>(k) / strides);
    const Vec3 b = from + (to - from) * (static_cast<double>(k + 1) / strides);
    crossing_.groups.query(geometry::box_around({a, b}, 2e-6), [&](Index t) {
      if (!going) return;
      const Tri& tri = crossing_.triangles[t];
      if (collision::segment_crosses_triangle(p, q, crossing_.points[tri[0]], crossing_.points[tri[1]],
                                              crossing_.points[tri[2]])) {
        going = visit(t);
      }
    });
  }
}

std::vector<double> BodyProbe::hits(Vec3 from, Vec3 to) const {
  std::vector<Index> met;
  visit_hits(from, to, [&](Index t) {
    met.push_back(t);
    return true;
  });
  std::sort(met.begin(), met.end());
  met.erase(std::unique(met.begin(), met.end()), met.end());
  std::vector<double> at;
  for (const Index t : met) {
    const Tri& tri = crossing_.triangles[t];
    const std::vector<Vec3>& x = body_->mesh.vertices;
    const double a = volume(x[tri[0]], x[tri[1]], x[tri[2]], from);
    const double b = volume(x[tri[0]], x[tri[1]], x[tri[2]], to);
    at.push_back(a != b ? std::clamp(a / (a - b), 0.0, 1.0) : 0.5);
  }
  std::sort(at.begin(), at.end());
  return at;
}

bool BodyProbe::meets(Vec3 from, Vec3 to) const {
  bool met = false;
  visit_hits(from, to, [&](Index) {
    met = true;
    return false;
  });
  return met;
}

bool BodyProbe::contains(Vec3 p) const {
  if (!box_.contains(p)) return false;
  // Slanted, so that a ray hardly runs along an edge of a body that is built on axes.
  constexpr Vec3 kWays[3] = {{0.0131, 1, 0.0217}, {1, 0.0173, -0.0291}, {-0.0253, 0.0119, 1}};
  const double far = 1.1 * length(box_.size()) + 0.01;
  return std::all_of(kWays, kWays + 3, [&](Vec3 way) { return hits(p, p + way * far).size() % 2 == 1; });
}

std::vector<BodyProbe> make_probes(std::span<const body::Body> bodies) {
  std::vector<BodyProbe> probes;
  probes.reserve(bodies.size());
  for (const body::Body& body : bodies) probes.emplace_back(body);
  return probes;
}

PlaneFrame make_plane_frame(Vec3 origin, Vec3 normal) {
  const Vec3 n = normalized(normal);
  const Vec3 aside = std::abs(n.x) <= std::abs(n.y) && std::abs(n.x) <= std::abs(n.z) ? Vec3{1, 0, 0}
                     : std::abs(n.y) <= std::abs(n.z)                                 ? Vec3{0, 1, 0}
                                                                                      : Vec3{0, 0, 1};
  const Vec3 u = normalized(cross(aside, n));
  return {origin, u, cross(n, u), n};
}

std::vector<SlicePart> slice_parts(const measure::PlaneCutter& cutter, const PlaneFrame& plane) {
  const measure::MeshCut cut = cutter.cut(plane.origin, plane.normal);
  std::vector<SlicePart> parts(static_cast<std::size_t>(cut.part_count));
  for (std::size_t i = 0; i < cut.points.size(); ++i)
    parts[cut.part[i]].points.push_back(plane.flat(cut.points[i]));
  for (SlicePart& part : parts) {
    const Aabb2 box = bounding_box(part.points);
    part.centre = box.middle();
  }
  return parts;
}

}  // namespace toile::preflight
