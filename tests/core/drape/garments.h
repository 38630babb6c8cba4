#pragma once
// Small drapes for tests: little cloth, little body, done in a second.

#include "core/drape/drape_input.h"

namespace toile::test {

inline pattern::CubicBezier line(Vec2 a, Vec2 b) {
  return {a, a + (b - a) * (1.0 / 3), a + (b - a) * (2.0 / 3), b};
}

/// A rectangle around the origin of the panel, mm; edges e0 (bottom), e1 (right), e2 (top), e3 (left).
inline pattern::Panel rectangle(const std::string& id, double width, double height) {
  pattern::Panel panel;
  panel.id = id;
  const Vec2 c[4] = {{-width / 2, 0}, {width / 2, 0}, {width / 2, height}, {-width / 2, height}};
  for (int k = 0; k < 4; ++k)
    panel.outline.edges.push_back({"e" + std::to_string(k), {line(c[k], c[(k + 1) % 4])}});
  return panel;
}

/// An upright prism with `sides` sides, closed, y from `low` to `high`.
inline body::Body column(double radius, double low, double high, int sides = 16) {
  body::Body body;
  body.id = "column";
  auto& x = body.mesh.vertices;
  auto& t = body.mesh.triangles;
  x = {{0, low, 0}, {0, high, 0}};
  for (int i = 0; i < sides; ++i) {
    const double a = 2 * 3.14159265358979 * i / sides;
    x.push_back({radius * std::sin(a), low, radius * std::cos(a)});
    x.push_back({radius * std::sin(a), high, radius * std::cos(a)});
  }
  for (Index i = 0; i < sides; ++i) {
    const Index a = 2 + 2 * i, b = 2 + 2 * ((i + 1) % sides);
    t.push_back({a, b, a + 1});
    t.push_back({b, b + 1, a + 1});
    t.push_back({0, b, a});
    t.push_back({1, a + 1, b + 1});
  }
  return body;
}

/// As `body`, with all of it elsewhere after so many seconds.
template <typename Place>
void move_to(body::Body& body, double after, Place place) {
  body::Keyframe& keyframe = body.motion.emplace_back();
  keyframe.at = after;
  for (const Vec3& p : body.mesh.vertices) keyframe.vertices.push_back(place(p));
}

/// A sheet that falls on a column's head.
inline drape::DrapeInput tablecloth() {
  drape::DrapeInput input;
  input.name = "tablecloth";
  input.pattern.panels = {rectangle("sheet", 240, 240)};
  sewing::RigidPlacement flat;
  flat.translation = {0, 0.305, 0.12};
  flat.rotation = {-1.5707963267948966, 0, 0};  // v runs to −z
  input.placements = {flat};
  input.fabrics = {material::Fabric{}};
  input.fabric_of_panel = {0};
  input.bodies = {column(0.06, 0, 0.3)};
  input.settings.particle_distance = 0.02;
  input.settings.time_step = 1.0 / 2000;
  return input;
}

/// A tube of two panels before and behind a column, sewn at its sides.
inline drape::DrapeInput tube() {
  drape::DrapeInput input;
  input.name = "tube";
  input.pattern.panels = {rectangle("front", 260, 120), rectangle("back", 260, 120)};
  // Both face the same way, so the right edge of one meets the right edge of the other, running the same way.
  input.pattern.seams = {{"left", {{0, 3, false}}, {{1, 3, false}}, true},
                         {"right", {{0, 1, false}}, {{1, 1, false}}, true}};
  input.placements = {sewing::RigidPlacement{{0, 0.15, 0.1}, {}, false},
                      sewing::RigidPlacement{{0, 0.15, -0.1}, {}, false}};
  input.fabrics = {material::Fabric{}};
  input.fabric_of_panel = {0, 0};
  input.bodies = {column(0.07, 0, 0.3)};
  sewing::Attachment top;
  top.id = "top";
  top.panel = 0;
  top.edges = {2};
  top.release_after = -1;
  input.attachments = {top};
  input.settings.particle_distance = 0.02;
  input.settings.time_step = 1.0 / 2000;
  return input;
}

}  // namespace toile::test
