#include "core/drape/input_hash.h"

#include <variant>

#include "core/base/hash.h"
#include "core/base/state_bytes.h"

namespace toile::drape {
namespace {

// Each function takes its struct apart with a structured binding that names every field. A field that is
// added to a struct does not compile here until it is named and written too: none can be forgotten.

template <typename... Fields>
void write(StateWriter& out, const Fields&... fields);

void write_one(StateWriter& out, const pattern::CubicBezier& curve) {
  const auto& [p0, p1, p2, p3] = curve;
  write(out, p0, p1, p2, p3);
}
void write_one(StateWriter& out, const pattern::PanelEdge& edge) {
  const auto& [id, curves] = edge;
  write(out, id, curves);
}
void write_one(StateWriter& out, const pattern::Loop& loop) {
  const auto& [edges] = loop;
  write(out, edges);
}
void write_one(StateWriter& out, const pattern::InnerLine& line) {
  const auto& [id, points, drawn] = line;
  write(out, id, points, drawn);
}
void write_one(StateWriter& out, const pattern::Notch& notch) {
  const auto& [at, depth, inwards] = notch;
  write(out, at, depth, inwards);
}
void write_one(StateWriter& out, const pattern::Panel& panel) {
  const auto& [id, outline, holes, grain, fabric, lines, layer, notches, spacing] = panel;
  write(out, id, outline, holes, grain, fabric, lines, layer, notches, spacing);
}
void write_one(StateWriter& out, const pattern::SeamEdge& at) {
  const auto& [panel, edge, reversed, from, to] = at;
  write(out, panel, edge, reversed, from, to);
}
void write_one(StateWriter& out, const pattern::Seam& seam) {
  const auto& [id, a, b, same_direction] = seam;
  write(out, id, a, b, same_direction);
}
void write_one(StateWriter& out, const pattern::Pattern& pattern) {
  const auto& [panels, seams] = pattern;
  write(out, panels, seams);
}
void write_one(StateWriter& out, const sewing::RigidPlacement& placement) {
  const auto& [translation, rotation, flipped] = placement;
  write(out, translation, rotation, flipped);
}
void write_one(StateWriter& out, const sewing::WrappedPlacement& placement) {
  const auto& [axis, radius, angle, height, anchor, slope, up, turn, flipped] = placement;
  write(out, axis, radius, angle, height, anchor, slope, up, turn, flipped);
}
void write_one(StateWriter& out, const sewing::Placement& placement) {
  out.size(placement.index());
  std::visit([&](const auto& kind) { write(out, kind); }, placement);
}
void write_one(StateWriter& out, const material::Fabric& fabric) {
  const auto& [id, name, areal_mass, stretch_warp, stretch_weft, stretch_coupling, stretch_shear, limit_warp,
               limit_weft, limit_shear, bend_warp, bend_weft, bend_bias, thickness, friction, colour] =
      fabric;
  write(out, id, name, areal_mass, stretch_warp, stretch_weft, stretch_coupling, stretch_shear, limit_warp,
        limit_weft, limit_shear, bend_warp, bend_weft, bend_bias, thickness, friction, colour[0], colour[1],
        colour[2]);
}
void write_one(StateWriter& out, const geometry::TriangleMesh& mesh) {
  const auto& [vertices, triangles] = mesh;
  write(out, vertices, triangles);
}
void write_one(StateWriter& out, const body::Keyframe& keyframe) {
  const auto& [at, vertices] = keyframe;
  write(out, at, vertices);
}
void write_one(StateWriter& out, const body::Body& body) {
  const auto& [id, mesh, friction, skin_offset, restitution, motion, notes] = body;  // notes are words
  write(out, id, mesh, friction, skin_offset, restitution);
  if (!motion.empty()) write(out, motion);  // all others keep their hash
}
void write_one(StateWriter& out, const sewing::Attachment& attachment) {
  const auto& [id, panel, edges, hold, release_after, points, goal] = attachment;
  write(out, id, panel, edges, hold, release_after, points, goal);
}
void write_one(StateWriter& out, const sewing::PanelPoint& point) {
  const auto& [panel, at] = point;
  write(out, panel, at);
}
void write_one(StateWriter& out, const sewing::Button& button) {
  const auto& [id, a, b, distance] = button;
  write(out, id, a, b, distance);
}
void write_one(StateWriter& out, const sewing::Elastic& elastic) {
  const auto& [id, panel, edges, lines, factor, stiffness] = elastic;
  write(out, id, panel, edges, lines, factor, stiffness);
}
void write_one(StateWriter& out, const sewing::Crease& crease) {
  const auto& [id, panel, edges, lines, angle, stiffness] = crease;
  write(out, id, panel, lines, angle, stiffness);
  if (!edges.empty()) write(out, edges);  // all others keep their hash
}
void write_one(StateWriter& out, const sewing::Cushion& cushion) {
  const auto& [id, panels, pressure, full_volume] = cushion;
  write(out, id, panels, pressure, full_volume);
}
void write_one(StateWriter& out, const sewing::Notions& notions) {
  const auto& [buttons, elastics, creases, cushions] = notions;
  write(out, buttons, elastics, creases, cushions);
}
void write_one(StateWriter& out, const sewing::ClothPoint& point) {
  const auto& [v, share] = point;
  write(out, v, share);
}
void write_one(StateWriter& out, const sewing::NotionPlaces& places) {
  const auto& [buttons, elastics, creases] = places;
  write(out, buttons, elastics, creases);
}
void write_one(StateWriter& out, const solver::constraints::AirDrag& air) {
  const auto& [density, across, along, wind] = air;
  write(out, density, across, along, wind);
}
void write_one(StateWriter& out, const paper::PaperSettings& settings) {
  const auto& [time_step, damping, passes, reflection, load, clearance] = settings;
  write(out, time_step, damping, passes, reflection, load, clearance);
}
void write_one(StateWriter& out, const DrapeSettings& settings) {
  const auto& [particle_distance, time_step, gravity, sew_time, settle_speed, max_time, frame_interval, mode,
               dress, ground, until_settled, air, method, paper] = settings;
  write(out, particle_distance, time_step, gravity, sew_time, settle_speed, max_time, frame_interval, mode,
        dress, ground, until_settled, air, method, paper);
}
void write_one(StateWriter& out, const LeftOut& piece) {
  const auto& [id, layer, place, tried, tied] = piece;
  write(out, id, layer, place, tried);
  if (tied) write(out, tied);  // all others keep their hash
}
void write_one(StateWriter& out, const DrapeInput& input) {
  const auto& [name, pattern, placements, fabrics, fabric_of_panel, bodies, attachments, notions, settings,
               before, left_out, left_open] = input;
  write(out, name, pattern, placements, fabrics, fabric_of_panel, bodies, attachments, notions, settings,
        before ? warm::encode_hung(*before) : std::string(), left_out);
  if (!left_open.empty()) write(out, left_open);  // all others keep their hash
}
void write_one(StateWriter& out, const sewing::GarmentMesh& garment) {
  const auto& [rest, triangles, panel_of_vertex, panel_of_triangle, first_vertex, sewn, seam_of_sewn, weld] =
      garment;
  write(out, rest, triangles, panel_of_vertex, panel_of_triangle, first_vertex, sewn, seam_of_sewn, weld);
}
void write_one(StateWriter& out, const sewing::Assembly& assembly) {
  const auto& [garment, positions, attached, led, notions, turned, pressed_back] =
      assembly;  // the last by notions
  write(out, garment, positions, attached, led, notions);
  if (!turned.empty()) write(out, turned);  // all others keep their hash
}

template <typename T>
requires requires(StateWriter& out, const T& v) {
  out.value(v);
} &&(!requires(const T& v) { v.begin(); }) void write_one(StateWriter& out, const T& value) {
  out.value(value);
}
void write_one(StateWriter& out, const std::string& text) { out.value(text); }
template <typename T, std::size_t N>
void write_one(StateWriter& out, const std::array<T, N>& list) {
  for (const T& v : list) write(out, v);
}
template <typename T>
void write_one(StateWriter& out, const std::vector<T>& list) {
  out.size(list.size());
  for (const T& v : list) write(out, v);
}

template <typename... Fields>
void write(StateWriter& out, const Fields&... fields) {
  (write_one(out, fields), ...);
}

}  // namespace

std::string input_hash(const DrapeInput& input, const sewing::Assembly& start) {
  StateWriter out;
  write(out, input, start);
  return hash_of(std::string_view(out.bytes()));
}

}  // namespace toile::drape
