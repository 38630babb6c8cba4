#include "tests/garments/random_forms.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/body/mannequin/mannequin.h"

namespace toile::test {
namespace {

/// Rings of `sides` points between two poles, from below upwards; radius and height of each ring given.
geometry::TriangleMesh lathe(const std::vector<Vec2>& rings, double bottom, double top, int sides) {
  geometry::TriangleMesh mesh;
  for (const Vec2& ring : rings) {
    for (int i = 0; i < sides; ++i) {
      const double a = 2 * kPi * i / sides;
      mesh.vertices.push_back({ring.x * std::sin(a), ring.y, ring.x * std::cos(a)});
    }
  }
  const auto last = static_cast<Index>(mesh.vertices.size());
  mesh.vertices.push_back({0, bottom, 0});
  mesh.vertices.push_back({0, top, 0});
  const Index count = static_cast<Index>(rings.size());
  for (Index i = 0; i < sides; ++i) {
    const Index j = (i + 1) % sides;
    for (Index r = 0; r + 1 < count; ++r) {
      const Index a = r * sides + i, b = r * sides + j;
      mesh.triangles.push_back({a, b, a + sides});
      mesh.triangles.push_back({b, b + sides, a + sides});
    }
    mesh.triangles.push_back({last, j, i});
    mesh.triangles.push_back({last + 1, (count - 1) * sides + i, (count - 1) * sides + j});
  }
  return mesh;
}

geometry::TriangleMesh ball(double radius, double height, int sides) {
  std::vector<Vec2> rings;
  const int count = std::max(3, sides / 2);
  for (int r = 1; r < count; ++r) {
    const double a = kPi * r / count;
    rings.push_back({radius * std::sin(a), height - radius * std::cos(a)});
  }
  return lathe(rings, height - radius, height + radius, sides);
}

geometry::TriangleMesh block(Vec3 low, Vec3 high) {
  geometry::TriangleMesh mesh;
  for (int k = 0; k < 8; ++k) {
    mesh.vertices.push_back({k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z});
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

/// Turned about z, which leans an upright thing to the side, then moved.
void lean(geometry::TriangleMesh& mesh, double angle, Vec3 by) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (Vec3& p : mesh.vertices) p = Vec3{c * p.x - s * p.y, s * p.x + c * p.y, p.z} + by;
}

const geometry::TriangleMesh& mannequin() {
  static const geometry::TriangleMesh mesh = [] {
    mannequin::MannequinSettings settings;
    settings.triangle_count = 1500;
    return mannequin::make_mannequin(settings).value().mesh;
  }();
  return mesh;
}

void measure(Form& form) {
  if (form.bodies.empty()) {
    form.box.add({0, 1, 0});
    return;
  }
  for (const body::Body& body : form.bodies) {
    for (const Vec3& p : body.mesh.vertices) form.box.add(p);
  }
}

void add(Form& form, Chance& chance, geometry::TriangleMesh mesh) {
  body::Body body;
  body.id = form.kind + std::to_string(form.bodies.size());
  body.mesh = std::move(mesh);
  body.friction = chance.happens(0.2) ? 0 : chance.between(0, 1);
  body.skin_offset = chance.happens(0.2) ? 0 : chance.log_between(0.2e-3, 4e-3);
  form.bodies.push_back(std::move(body));
}

void add_limbs(Form& form, Chance& chance, double size, int count) {
  const double radius = chance.between(0.01, 0.03), gap = chance.log_between(0.003, 0.05);
  const double angle = chance.happens(0.5) ? 0 : chance.between(-kPi / 2, kPi / 2);
  const double length = size * chance.between(1, 2.5) + 4 * radius;
  for (int k = 0; k < count; ++k) {
    const double top = radius * chance.between(0.4, 1);
    geometry::TriangleMesh limb = lathe({{radius, -length / 2}, {top, length / 2}}, -length / 2 - radius / 2,
                                        length / 2 + top / 2, chance.whole(5, 20));
    lean(limb, angle, {0, 1, count == 1 ? 0 : (k - 0.5) * (2 * radius + gap)});
    add(form, chance, std::move(limb));
  }
}

}  // namespace

double Form::reach() const { return std::max({-box.low.x, box.high.x, -box.low.z, box.high.z}); }

Form make_form(Chance& chance, double size) {
  static const char* const kKinds[] = {"sphere", "box", "limb", "cone", "slab", "limbs", "none", "mannequin"};
  Form form;
  form.kind = kKinds[size > 0.35 ? chance.whole(0, 7) : chance.whole(0, 6)];
  const std::string& k = form.kind;
  const double s = size * chance.between(0.3, 1.2);
  if (k == "sphere") add(form, chance, ball(s / 2, 1, chance.whole(5, 28)));
  if (k == "box") {
    const Vec3 half{s * chance.between(0.1, 0.6), s * chance.between(0.1, 0.8), s * chance.between(0.1, 0.6)};
    geometry::TriangleMesh box = block(-half, half);
    lean(box, chance.happens(0.5) ? 0 : chance.between(-kPi, kPi), {0, 1, 0});
    add(form, chance, std::move(box));
  }
  if (k == "cone") {
    const double foot = s * chance.between(0.2, 0.7), tip = foot * chance.between(0.01, 0.3);
    add(form, chance, lathe({{foot, 1 - s}, {tip, 1}}, 1 - s, 1 + tip, chance.whole(3, 24)));
  }
  if (k == "slab") {
    const double thick = chance.between(0.001, 0.005);
    geometry::TriangleMesh slab = block({-s * 0.6, -thick, -s * 0.6}, {s * 0.6, thick, s * 0.6});
    lean(slab, chance.happens(0.4) ? 0 : chance.between(-kPi / 2, kPi / 2), {0, 1, 0});
    add(form, chance, std::move(slab));
  }
  if (k == "limb") add_limbs(form, chance, size, 1);
  if (k == "limbs") add_limbs(form, chance, size, 2);
  if (k == "mannequin") add(form, chance, mannequin());
  measure(form);
  return form;
}

Form make_pole(Chance& chance, double radius, double height) {
  Form form;
  form.kind = "pole";
  add(form, chance,
      lathe({{radius, 1 - height}, {radius * chance.between(0.5, 1), 1}}, 1 - height, 1 + radius / 3,
            chance.whole(5, 24)));
  measure(form);
  return form;
}

}  // namespace toile::test
