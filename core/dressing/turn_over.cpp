#include "core/dressing/turn_over.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/geometry/bvh.h"
#include "core/geometry/distance.h"

namespace toile::dressing {

namespace {

constexpr double kRoom = 4e-3;          // m, that what is turned keeps off the rest …
constexpr double kRoomNearSeam = 0.12;  // … but no more than this share of its way from the seam
constexpr double kLook = 4e-3;          // m, from one place to the next that is asked for room
constexpr double kTurn = kPi / 60;      // from one angle to the next
constexpr double kSticksOut = 0.5 * kPi, kDown = 0.94 * kPi;
constexpr int kEvening = 3;  // passes of evening out along the seam

/// The cloth that stays, and the body, to be kept off.
class Rest {
 public:
  Rest(const sewing::GarmentMesh& g, const std::vector<Index>& fall, const Wearer& wearer,
       std::span<const Vec3> x)
      : body_(wearer.slim(0)), x_(x) {
    std::vector<bool> turned(x.size(), false);
    for (const Index v : fall) turned[v] = true;
    std::vector<geometry::Box3> boxes;
    for (const Tri& t : g.triangles) {
      const auto [a, b, c] = t;
      if (turned[a] || turned[b] || turned[c]) continue;
      triangles_.push_back(t);
      boxes.push_back(geometry::box_around({x[a], x[b], x[c]}, 0));
    }
    tree_ = geometry::Bvh(boxes);
  }

  bool leaves_room(Vec3 p, double room) const {
    if (body_.clearance(p) < room) return false;
    bool free = true;
    tree_.query(geometry::box_around({p}, room), [&](Index t) {
      const auto [a, b, c] = triangles_[static_cast<std::size_t>(t)];
      const geometry::TrianglePoint at = geometry::closest_on_triangle(p, x_[a], x_[b], x_[c]);
      free = free && length(x_[a] * at.a + x_[b] * at.b + x_[c] * at.c - p) >= room;
    });
    return free;
  }

 private:
  SlimFigure body_;
  std::span<const Vec3> x_;
  std::vector<Tri> triangles_;
  geometry::Bvh tree_;
};

/// Where a vertex of the piece lies, seen from the seam: between its vertices `from` and the next, `beyond`
/// its ends, and how far from it in the flat.
struct SeamPlace {
  std::size_t from = 0;
  double share = 0, beyond = 0, far = 0;  ///< of the way to the next; m; m
};

SeamPlace place_from(const std::vector<Vec2>& seam, Vec2 p) {
  SeamPlace best;
  best.far = HUGE_VAL;
  for (std::size_t i = 0; i + 1 < seam.size(); ++i) {
    const Vec2 way = seam[i + 1] - seam[i];
    const double free = dot(p - seam[i], way) / std::max(1e-30, dot(way, way));
    const double share = std::clamp(free, 0.0, 1.0);
    const double far = length(p - (seam[i] + way * share));
    if (far >= best.far) continue;
    const bool end = (free < 0 && i == 0) || (free > 1 && i + 2 == seam.size());
    best = {i, share, end ? (free - share) * length(way) : 0, far};
  }
  if (best.beyond != 0) best.far = std::sqrt(std::max(0.0, best.far * best.far - best.beyond * best.beyond));
  return best;
}

template <typename T>
void even_out(std::vector<T>& values) {
  for (int pass = 0; pass < kEvening; ++pass) {
    const std::vector<T> before = values;
    for (std::size_t i = 1; i + 1 < values.size(); ++i)
      values[i] = (before[i - 1] + before[i] * 2 + before[i + 1]) * 0.25;
  }
}

Vec3 mean_of(const std::vector<Index>& vertices, std::span<const Vec3> x) {
  Vec3 sum;
  for (const Index v : vertices) sum += x[v];
  return sum * (1.0 / static_cast<double>(std::max<std::size_t>(1, vertices.size())));
}

/// Which way the side that is up in the flat piece faces along the seam, summed over what is turned there.
std::vector<Vec3> facing_along(const sewing::GarmentMesh& g, const sewing::PressedBack& pressed,
                               std::span<const Vec3> x) {
  std::vector<Index> place(x.size(), kNone);
  for (std::size_t i = 0; i < pressed.along.size(); ++i) place[pressed.along[i]] = static_cast<Index>(i);
  std::vector<bool> turned(x.size(), false);
  for (const Index v : pressed.fall) turned[v] = true;
  std::vector<Vec3> facing(pressed.along.size());
  for (const auto& [a, b, c] : g.triangles) {
    if (!turned[a] && !turned[b] && !turned[c]) continue;
    for (const Index v : {a, b, c})
      if (place[v] != kNone) facing[place[v]] += cross(x[b] - x[a], x[c] - x[a]);
  }
  return facing;
}

/// The seam on the body: its vertices, and the directions along it, to where the piece is turned, and to
/// where it stands, each across the others.
struct Spine {
  std::vector<Vec2> flat;
  std::vector<Vec3> at, along, out, up;

  Spine(const sewing::GarmentMesh& g, const sewing::PressedBack& pressed, std::span<const Vec3> x) {
    for (const Index v : pressed.along) {
      flat.push_back(g.rest[v]);
      at.push_back(x[v]);
    }
    for (std::size_t i = 0; i < at.size(); ++i)
      along.push_back(at[std::min(i + 1, at.size() - 1)] - at[i > 0 ? i - 1 : 0]);
    even_out(along);
    const Vec3 standing = mean_of(pressed.fall, x) - mean_of(pressed.along, x);
    const std::vector<Vec3> facing = facing_along(g, pressed, x);
    double to_facing = 0;
    for (std::size_t i = 0; i < at.size(); ++i) {
      along[i] = normalized(along[i]);
      out.push_back(normalized(cross(along[i], standing)));
      to_facing += dot(out[i], facing[i]);
    }
    const bool other_way = (to_facing > 0) != pressed.up_inside;
    for (std::size_t i = 0; i < at.size(); ++i) {
      if (other_way) out[i] = -out[i];
      up.push_back(normalized(cross(out[i], along[i])));
      if (dot(up[i], standing) < 0) up[i] = -up[i];
    }
  }

  Vec3 turned(std::size_t i, double far, double angle) const {
    return at[i] + (up[i] * std::cos(angle) + out[i] * std::sin(angle)) * far;
  }
};

/// How far each place along the seam turns, radians; `width` is how far the piece reaches from there, m.
std::vector<double> angles_at(const Spine& spine, const std::vector<double>& width, const Rest& rest) {
  std::vector<double> angles;
  const auto free = [&](std::size_t i, double angle) {
    for (double far = kLook; far < width[i] + kLook; far += kLook)
      if (!rest.leaves_room(spine.turned(i, far, angle), std::min(kRoom, kRoomNearSeam * far))) return false;
    return true;
  };
  for (std::size_t i = 0; i < spine.at.size(); ++i) {
    // A fall that stands may touch the jaw: the way down is looked for from where it sticks out.
    double angle = 0;
    for (double begun = kSticksOut; angle == 0 && begun > 0; begun -= kTurn)
      if (free(i, begun)) angle = begun;
    while (angle + kTurn <= kDown && free(i, angle + kTurn)) angle += kTurn;
    angles.push_back(angle);
  }
  // Beside what stands in the way nothing goes much farther.
  const std::vector<double> alone = angles;
  for (std::size_t i = 0; i < angles.size(); ++i)
    for (std::size_t j = i > 0 ? i - 1 : 0; j <= std::min(i + 1, angles.size() - 1); ++j)
      angles[i] = std::min(angles[i], alone[j]);
  even_out(angles);
  return angles;
}

void turn(const sewing::GarmentMesh& g, const sewing::PressedBack& pressed, const Wearer& wearer,
          double share, std::vector<Vec3>& x) {
  const Spine spine(g, pressed, x);
  std::vector<SeamPlace> places;
  std::vector<double> width(spine.at.size(), 0);
  for (const Index v : pressed.fall) {
    const SeamPlace& place = places.emplace_back(place_from(spine.flat, g.rest[v]));
    for (const std::size_t i : {place.from, place.from + 1}) width[i] = std::max(width[i], place.far);
  }
  const std::vector<double> angles = angles_at(spine, width, Rest(g, pressed.fall, wearer, x));
  for (std::size_t k = 0; k < places.size(); ++k) {
    const SeamPlace& p = places[k];
    const std::size_t i = p.from, j = i + 1;
    const double angle = share * (angles[i] * (1 - p.share) + angles[j] * p.share);
    x[pressed.fall[k]] = spine.turned(i, p.far, angle) * (1 - p.share) +
                         spine.turned(j, p.far, angle) * p.share +
                         spine.along[p.beyond < 0 ? i : j] * p.beyond;
  }
}

}  // namespace

std::vector<Vec3> turned_over(const sewing::Assembly& assembly, const Wearer& wearer, std::span<const Vec3> x,
                              double share) {
  std::vector<Vec3> over(x.begin(), x.end());
  for (const sewing::PressedBack& pressed : assembly.pressed_back)
    turn(assembly.garment, pressed, wearer, share, over);
  return sewing::together_at_means(assembly.garment, over);  // where halves of a collar meet
}

}  // namespace toile::dressing
