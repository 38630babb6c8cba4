#include "core/preflight/start_field.h"

#include <algorithm>
#include <cmath>

#include "core/preflight/triangle_gap.h"

namespace toile::preflight {

namespace {

/// Two features of one piece that lie nearer than this in the flat are neighbours and no layers.
constexpr double kSameFold = 3e-3;  // m

geometry::Box3 moved(const geometry::Box3& box, Vec3 by, double grown) {
  geometry::Box3 out;
  const double d[3] = {by.x, by.y, by.z};
  for (int k = 0; k < 3; ++k) {
    out.lo[k] = std::nextafter(static_cast<float>(box.lo[k] + d[k] - grown), -1e30f);
    out.hi[k] = std::nextafter(static_cast<float>(box.hi[k] + d[k] + grown), 1e30f);
  }
  return out;
}

Vec3 middle(const GapTriangle& t) { return (t.x[0] + t.x[1] + t.x[2]) * (1.0 / 3); }

Vec3 on_exact_grid(Vec3 p) {
  constexpr double kGrid = 0x1p20;
  return {std::nearbyint(p.x * kGrid) / kGrid, std::nearbyint(p.y * kGrid) / kGrid,
          std::nearbyint(p.z * kGrid) / kGrid};
}

}  // namespace

StartField::StartField(const sewing::Assembly& assembly, std::span<const BodyProbe> probes)
    : assembly_(assembly), probes_(probes) {
  pieces_.resize(assembly.garment.first_vertex.size() - 1);
  for (Index t = 0; t < static_cast<Index>(assembly.garment.triangles.size()); ++t) {
    pieces_[assembly.garment.panel_of_triangle[t]].triangles.push_back(t);
  }
  for (Index i = 0; i < piece_count(); ++i) add_piece(i);
}

void StartField::add_piece(Index piece) {
  Piece& p = pieces_[piece];
  std::vector<geometry::Box3> boxes;
  for (const Index t : p.triangles) {
    const Tri& tri = assembly_.garment.triangles[t];
    const Vec3 a = assembly_.positions[tri[0]], b = assembly_.positions[tri[1]],
               c = assembly_.positions[tri[2]];
    boxes.push_back(geometry::box_around({a, b, c}, 1e-6));
    p.box = geometry::join(p.box, boxes.back());
    const Vec3 twice = cross(b - a, c - a);
    p.normal += twice;
    p.area += 0.5 * length(twice);
  }
  p.tree = geometry::Bvh(boxes);
  p.normal = normalized(p.normal);
  const Vec3 lo{p.box.lo[0], p.box.lo[1], p.box.lo[2]}, hi{p.box.hi[0], p.box.hi[1], p.box.hi[2]};
  p.centre = (lo + hi) * 0.5;
  p.half_size = (hi - lo) * 0.5;
  p.inner_vertex = assembly_.garment.first_vertex[piece];
}

void StartField::set_shift(Index piece, Vec3 shift) { pieces_[piece].shift = on_exact_grid(shift); }

Nearness StartField::nearness(Index piece, Vec3 extra, const Opponent& opponent, double reach,
                              double enough) const {
  const Piece& p = pieces_[piece];
  const Vec3 at = on_exact_grid(p.shift + extra);
  if (opponent.is_body) return to_body(p, at, probes_[opponent.index], reach, enough);
  return to_piece(p, at, pieces_[opponent.index], reach, enough);
}

/// A body's corners bear classes that no cloth vertex has.
Nearness StartField::to_body(const Piece& p, Vec3 at, const BodyProbe& probe, double reach,
                             double enough) const {
  Nearness near;
  near.gap = reach;
  const geometry::TriangleMesh& mesh = probe.body().mesh;
  for (const Index t : p.triangles) {
    const Tri& tri = assembly_.garment.triangles[t];
    const GapTriangle a{{position(tri[0], at), position(tri[1], at), position(tri[2], at)}, {0, 1, 2}};
    probe.crossing().groups.query(geometry::box_around({a.x[0], a.x[1], a.x[2]}, reach), [&](Index s) {
      if (near.gap < enough || near.crosses) return;
      const Tri& face = mesh.triangles[s];
      const GapTriangle b{{mesh.vertices[face[0]], mesh.vertices[face[1]], mesh.vertices[face[2]]},
                          {-2, -3, -4}};
      const double gap = triangle_gap(a, b);
      const bool crosses = gap == 0 && !near.crosses && triangles_cross(a, b);
      if (gap < near.gap || crosses) {
        near.gap = gap;
        near.crosses |= crosses;
        near.place = middle(a);
      }
    });
    if (near.gap < enough || near.crosses) return near;
  }
  // A piece that does not cross the skin lies on one side of it as a whole.
  if (p.inner_vertex != kNone && probe.contains(position(p.inner_vertex, at))) {
    near.gap = 0;
    near.inside = true;
    near.place = position(p.inner_vertex, at);
  }
  return near;
}

double StartField::cloth_gap(Index s, Vec3 at_s, Index t, Vec3 at_t, bool& crosses) const {
  const Tri &a = assembly_.garment.triangles[s], &b = assembly_.garment.triangles[t];
  const GapTriangle ga{{position(a[0], at_s), position(a[1], at_s), position(a[2], at_s)},
                       {class_of(a[0]), class_of(a[1]), class_of(a[2])}};
  const GapTriangle gb{{position(b[0], at_t), position(b[1], at_t), position(b[2], at_t)},
                       {class_of(b[0]), class_of(b[1]), class_of(b[2])}};
  const double gap = triangle_gap(ga, gb);
  crosses = gap == 0 && triangles_cross(ga, gb);
  return gap;
}

Nearness StartField::to_piece(const Piece& p, Vec3 at, const Piece& q, double reach, double enough) const {
  Nearness near;
  near.gap = reach;
  if (!geometry::overlap(moved(p.box, at - q.shift, reach), q.box)) return near;
  for (const Index t : p.triangles) {
    const Tri& tri = assembly_.garment.triangles[t];
    const Vec3 to_q = at - q.shift;
    const geometry::Box3 box =
        geometry::box_around({position(tri[0], to_q), position(tri[1], to_q), position(tri[2], to_q)}, reach);
    q.tree.query(box, [&](Index k) {
      if (near.gap < enough || near.crosses) return;
      bool crosses = false;
      const double gap = cloth_gap(t, at, q.triangles[k], q.shift, crosses);
      if (gap < near.gap || (crosses && !near.crosses)) near = {gap, crosses, false, position(tri[0], at)};
    });
    if (near.gap < enough || near.crosses) return near;
  }
  return near;
}

/// A piece against itself: only what crosses or touches without being neighbours in the flat.
Nearness StartField::look_at_itself(const Piece& p) const {
  Nearness near;
  const sewing::GarmentMesh& g = assembly_.garment;
  p.tree.self_pairs([&](Index i, Index j) {
    const Index s = p.triangles[i], t = p.triangles[j];
    bool crosses = false;
    const double gap = cloth_gap(s, {}, t, {}, crosses);
    const double flat = length(g.rest[g.triangles[s][0]] - g.rest[g.triangles[t][0]]);
    if (crosses || (gap < near.gap && flat > kSameFold && !near.crosses)) {
      near = {gap, crosses, false, assembly_.positions[g.triangles[s][0]]};
    }
  });
  return near;
}

Nearness StartField::to_itself(Index piece) {
  Piece& p = pieces_[piece];
  if (!p.to_itself) p.to_itself = look_at_itself(p);
  Nearness near = *p.to_itself;
  near.place += p.shift;
  return near;
}

std::vector<Opponent> StartField::neighbours(Index piece, Vec3 extra, double reach) const {
  std::vector<Opponent> found;
  const geometry::Box3 box = moved(pieces_[piece].box, pieces_[piece].shift + extra, reach);
  for (Index b = 0; b < static_cast<Index>(probes_.size()); ++b) {
    const geometry::Box3 body = geometry::box_around({probes_[b].box().low, probes_[b].box().high}, 0);
    if (geometry::overlap(box, body)) found.push_back({true, b});
  }
  for (Index q = 0; q < piece_count(); ++q) {
    if (q != piece && geometry::overlap(box, moved(pieces_[q].box, pieces_[q].shift, 0)))
      found.push_back({false, q});
  }
  return found;
}

}  // namespace toile::preflight
