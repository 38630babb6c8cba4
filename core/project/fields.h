#pragma once
// The format, said once: which keys an object of the document has, where they go, what they may be.

#include <array>
#include <string>
#include <vector>

#include "core/json/fields/range.h"
#include "core/project/project.h"

namespace toile::fields {

inline constexpr Range kLength{-1e5, 1e5};  // mm or m: every coordinate, so that sums stay far from overflow
inline constexpr Range kStiffness{0.01, 1e6};
inline constexpr Range kFriction{0, 2};
inline constexpr Range kSome{1, 1000};  // elements of a list that must not be empty
inline constexpr Range kMany{0, 1000};

/// By Measure: what a tape may read of anybody. make_mannequin is stricter, and knows what goes together.
inline constexpr Range kMeasureRange_cm[kMeasureCount] = {
    {80, 220}, {30, 250}, {30, 250}, {30, 250}, {30, 250}, {15, 100}, {15, 90},
    {8, 90},   {5, 40},   {15, 120}, {15, 150}, {10, 100}, {20, 150}, {10, 90}};

template <>
inline constexpr Range kElementRange<Vec2> = kLength;
template <>
inline constexpr Range kElementRange<std::array<Vec2, 4>> = kLength;
template <>
inline constexpr Range kElementRange<std::vector<ProjectEdge>> = kSome;

template <typename Visitor>
void describe(Visitor& v, ProjectDxf& dxf) {
  v.field("dxf", dxf.dxf, Need::kRequired);
  v.field("piece", dxf.piece, Need::kRequired);
  v.field("corners", dxf.corners, Need::kOptional, kMany);
  v.choice("units", dxf.units, {"mm", "cm", "inch"});
  v.field("size", dxf.size);
}

template <typename Visitor>
void describe(Visitor& v, ProjectEdge& edge) {
  v.field("id", edge.id, Need::kRequired);
  v.field("points", edge.points, Need::kOptional, Range{2, 100000});
  v.field("curves", edge.curves, Need::kOptional, Range{1, 10000});
  v.exactly_one("points", "curves");
}

template <typename Visitor>
void describe(Visitor& v, ProjectRigid& rigid) {
  v.field("translation", rigid.translation, Need::kOptional, kLength);
  v.field("rotation", rigid.rotation, Need::kOptional, kLength);
  v.field("flipped", rigid.flipped);
}

template <typename Visitor>
void describe(Visitor& v, ProjectWrapped& wrapped) {
  v.field("axis", wrapped.axis, Need::kOptional, kLength);
  v.field("radius", wrapped.radius, Need::kRequired, Range{0.001, 1000});
  v.field("angle", wrapped.angle, Need::kOptional, kLength);
  v.field("height", wrapped.height, Need::kRequired, kLength);
  v.field("anchor", wrapped.anchor, Need::kOptional, kLength);
  v.field("slope", wrapped.slope, Need::kOptional, Range{-0.99, 0.99});
  v.field("axis_height", wrapped.axis_height, Need::kOptional, kLength);
  v.field("up", wrapped.up, Need::kOptional, Range{-1, 1});
  v.field("turn", wrapped.turn, Need::kOptional, kLength);
  v.field("flipped", wrapped.flipped);
}

template <typename Visitor>
void choose_box_side(Visitor& v, std::string& part, std::string& side) {
  v.choice("part", part, {"head", "neck", "torso", "hips", "left_arm", "right_arm", "left_leg", "right_leg"});
  v.choice("side", side, {"front", "back", "left", "right"});
}

template <typename Visitor>
void describe(Visitor& v, ProjectOnBox& box) {
  v.field("body", box.body);
  choose_box_side(v, box.part, box.side);
  v.field("at", box.at, Need::kOptional, kLength);
  v.field("away", box.away, Need::kOptional, Range{-100, 100});
  v.field("turn", box.turn, Need::kOptional, kLength);
  v.field("anchor", box.anchor, Need::kOptional, kLength);
  v.field("flipped", box.flipped);
}

template <typename Visitor>
void describe(Visitor& v, ProjectAround& around) {
  v.field("body", around.body);
  choose_box_side(v, around.part, around.side);
  v.field("at", around.at, Need::kOptional, kLength);
  v.field("away", around.away, Need::kOptional, Range{0, 100});
  v.field("turn", around.turn, Need::kOptional, kLength);
  v.field("slope", around.slope, Need::kOptional, Range{-0.99, 0.99});
  v.field("anchor", around.anchor, Need::kOptional, kLength);
  v.field("flipped", around.flipped);
}

template <typename Visitor>
void describe(Visitor& v, ProjectPlacement& placement) {
  v.field("rigid", placement.rigid);
  v.field("wrapped", placement.wrapped);
  v.field("on_box", placement.on_box);
  v.field("around", placement.around);
  v.exactly_one("rigid", "wrapped", "on_box", "around");
}

template <typename Visitor>
void describe(Visitor& v, ProjectLine& line) {
  v.field("id", line.id, Need::kRequired);
  v.field("points", line.points, Need::kRequired, Range{2, 10000});
  v.field("drawn", line.drawn);
}

template <typename Visitor>
void describe(Visitor& v, ProjectNotch& notch) {
  v.field("at", notch.at, Need::kRequired, kLength);
  v.field("depth_mm", notch.depth_mm, Need::kOptional, Range{-1000, 1000});
  v.field("inwards", notch.inwards, Need::kOptional, kLength);
}

template <typename Visitor>
void describe(Visitor& v, ProjectTexture& texture) {
  v.field("image", texture.image, Need::kRequired);
  v.field("scale_mm", texture.scale_mm, Need::kRequired, Range{0.1, 1e5});
  v.field("offset", texture.offset, Need::kOptional, kLength);
  v.field("angle", texture.angle, Need::kOptional, Range{-360, 360});
}

template <typename Visitor>
void describe(Visitor& v, ProjectPhysical& physical) {
  v.field("areal_mass_g_m2", physical.areal_mass_g_m2, Need::kOptional, Range{1, 10000});
  v.field("stretch_warp_n_m", physical.stretch_warp_n_m, Need::kOptional, kStiffness);
  v.field("stretch_weft_n_m", physical.stretch_weft_n_m, Need::kOptional, kStiffness);
  v.field("stretch_coupling_n_m", physical.stretch_coupling_n_m, Need::kOptional, Range{-1e6, 1e6});
  v.field("stretch_shear_n_m", physical.stretch_shear_n_m, Need::kOptional, kStiffness);
  v.field("bend_warp_un_m", physical.bend_warp_un_m, Need::kOptional, Range{0, 1e6});
  v.field("bend_weft_un_m", physical.bend_weft_un_m, Need::kOptional, Range{0, 1e6});
  v.field("bend_bias_un_m", physical.bend_bias_un_m, Need::kOptional, Range{0, 1e6});
  v.field("thickness_mm", physical.thickness_mm, Need::kOptional, Range{0.01, 50});
  v.field("friction", physical.friction, Need::kOptional, kFriction);
  v.field("particle_distance_mm", physical.particle_distance_mm, Need::kOptional, Range{0.5, 1000});
}

template <typename Visitor>
void describe(Visitor& v, ProjectPiece& piece) {
  v.field("id", piece.id, Need::kRequired);
  v.field("from", piece.from);
  v.field("outline", piece.outline, Need::kOptional, kSome);
  v.exactly_one("from", "outline");
  v.field("holes", piece.holes, Need::kOptional, kMany);
  v.field("edge_names", piece.edge_names);
  v.field("grain", piece.grain, Need::kOptional, kLength);
  v.field("fabric", piece.fabric, Need::kRequired);
  v.field("lines", piece.lines, Need::kOptional, kMany);
  v.field("layer", piece.layer, Need::kOptional, Range{-100, 100});
  v.field("notches", piece.notches, Need::kOptional, kMany);
  v.field("texture", piece.texture);
  v.field("physical", piece.physical);
  v.field("placement", piece.placement, Need::kRequired);
}

template <typename Visitor>
void describe(Visitor& v, ProjectFabric& fabric) {
  v.field("id", fabric.id, Need::kRequired);
  v.field("name", fabric.name);
  v.field("areal_mass_g_m2", fabric.areal_mass_g_m2, Need::kRequired, Range{1, 10000});
  v.field("stretch_warp_n_m", fabric.stretch_warp_n_m, Need::kRequired, kStiffness);
  v.field("stretch_weft_n_m", fabric.stretch_weft_n_m, Need::kRequired, kStiffness);
  v.field("stretch_coupling_n_m", fabric.stretch_coupling_n_m, Need::kOptional, Range{-1e6, 1e6});
  v.field("stretch_shear_n_m", fabric.stretch_shear_n_m, Need::kRequired, kStiffness);
  v.field("limit_warp_percent", fabric.limit_warp_percent, Need::kOptional, Range{0, 500});
  v.field("limit_weft_percent", fabric.limit_weft_percent, Need::kOptional, Range{0, 500});
  v.field("limit_shear_rad", fabric.limit_shear_rad, Need::kOptional, Range{0, 1.5});
  v.field("bend_warp_un_m", fabric.bend_warp_un_m, Need::kRequired, Range{0, 1e6});
  v.field("bend_weft_un_m", fabric.bend_weft_un_m, Need::kRequired, Range{0, 1e6});
  v.field("bend_bias_un_m", fabric.bend_bias_un_m, Need::kRequired, Range{0, 1e6});
  v.field("thickness_mm", fabric.thickness_mm, Need::kRequired, Range{0.01, 50});
  v.field("friction", fabric.friction, Need::kOptional, kFriction);
  v.field("colour", fabric.colour, Need::kOptional, Range{0, 1});
}

template <typename Visitor>
void describe(Visitor& v, ProjectSeamEdge& edge) {
  v.field("piece", edge.piece, Need::kRequired);
  v.field("edge", edge.edge, Need::kRequired);
  v.field("reversed", edge.reversed);
  v.field("from", edge.from, Need::kOptional, Range{0, 1});
  v.field("to", edge.to, Need::kOptional, Range{0, 1});
}

template <typename Visitor>
void describe(Visitor& v, ProjectSeam& seam) {
  v.field("id", seam.id, Need::kRequired);
  v.field("a", seam.a, Need::kRequired, kSome);
  v.field("b", seam.b, Need::kRequired, kSome);
  v.field("same_direction", seam.same_direction);
}

template <typename Visitor>
void describe(Visitor& v, ProjectMannequin& mannequin) {
  v.field("preset", mannequin.preset);
  v.choice("sex", mannequin.sex, {"female", "male", "child"});
  v.choice("pose", mannequin.pose, {"a", "t"});
  v.field("arm_angle", mannequin.arm_angle, Need::kOptional, Range{30, 60});
  for (int i = 0; i < kMeasureCount; ++i) {
    const std::string key = std::string(measure_name(measure_at(i))) + "_cm";
    v.field(key, mannequin.measures_cm[static_cast<std::size_t>(i)], Need::kOptional, kMeasureRange_cm[i]);
  }
  v.field("triangles", mannequin.triangles, Need::kOptional, Range{1000, 60000});
}

template <typename Visitor>
void describe(Visitor& v, ProjectLandmark& landmark) {
  v.field("name", landmark.name, Need::kRequired);
  v.field("triangle", landmark.triangle, Need::kOptional, Range{0, 1e8});
  v.field("share", landmark.share, Need::kOptional, Range{0, 1});
  v.field("near", landmark.near);
  v.field("offset_mm", landmark.offset_mm, Need::kOptional, Range{-1000, 1000});
  v.field("body_height_mm", landmark.body_height_mm, Need::kOptional, Range{100, 10000});
  v.exactly_one("triangle", "near");
}

template <typename Visitor>
void describe(Visitor& v, ProjectBody& body) {
  v.field("id", body.id, Need::kRequired);
  v.field("file", body.file);
  v.choice("unit", body.unit, {"m", "cm", "mm"});
  v.choice("up", body.up, {"y", "z"});
  v.field("mannequin", body.mannequin);
  v.exactly_one("file", "mannequin");
  v.field("friction", body.friction, Need::kOptional, kFriction);
  v.field("skin_offset_mm", body.skin_offset_mm, Need::kOptional, Range{0, 100});
  v.field("restitution", body.restitution, Need::kOptional, Range{0, 1});
  v.field("translation", body.translation, Need::kOptional, kLength);
  v.field("rotation", body.rotation, Need::kOptional, kLength);
  v.field("scale", body.scale, Need::kOptional, Range{1e-4, 1e4});
  v.field("landmarks", body.landmarks, Need::kOptional, kMany);
}

template <typename Visitor>
void describe(Visitor& v, ProjectGoal& goal) {
  v.field("body", goal.body);
  v.field("landmark", goal.landmark);
  v.field("line", goal.line);
  v.field("place", goal.place, Need::kOptional, kLength);
  v.exactly_one("landmark", "line", "place");
  v.field("up_mm", goal.up_mm, Need::kOptional, Range{-1000, 1000});
}

template <typename Visitor>
void describe(Visitor& v, ProjectAttachment& attachment) {
  v.field("id", attachment.id);
  v.field("piece", attachment.piece, Need::kRequired);
  v.field("edges", attachment.edges, Need::kOptional, kMany);
  v.field("points", attachment.points, Need::kOptional, kMany);
  v.choice("hold", attachment.hold, {"height", "place"});
  v.field("to", attachment.to);
  v.field("release_after_s", attachment.release_after_s, Need::kOptional, Range{-1, 3600});
}

template <typename Visitor>
void describe(Visitor& v, ProjectButtonPoint& point) {
  v.field("piece", point.piece, Need::kRequired);
  v.field("at", point.at, Need::kRequired, kLength);
}

template <typename Visitor>
void describe(Visitor& v, ProjectButton& button) {
  v.field("id", button.id, Need::kRequired);
  v.field("a", button.a, Need::kRequired);
  v.field("b", button.b, Need::kRequired);
  v.field("distance_mm", button.distance_mm, Need::kOptional, Range{0, 1000});
}

template <typename Visitor>
void describe(Visitor& v, ProjectElastic& elastic) {
  v.field("id", elastic.id, Need::kRequired);
  v.field("piece", elastic.piece, Need::kRequired);
  v.field("lines", elastic.lines, Need::kRequired, kSome);
  v.field("factor", elastic.factor, Need::kOptional, Range{0.05, 2});
  v.field("stiffness_n", elastic.stiffness_n, Need::kOptional, Range{0.01, 10000});
}

template <typename Visitor>
void describe(Visitor& v, ProjectFold& fold) {
  v.field("id", fold.id, Need::kRequired);
  v.field("piece", fold.piece, Need::kRequired);
  v.field("lines", fold.lines, Need::kRequired, kSome);
  v.field("angle", fold.angle, Need::kRequired, Range{-180, 180});
  v.field("stiffness_mn", fold.stiffness_mn, Need::kOptional, Range{0.001, 10000});
}

template <typename Visitor>
void describe(Visitor& v, ProjectCushion& cushion) {
  v.field("id", cushion.id, Need::kRequired);
  v.field("pieces", cushion.pieces, Need::kRequired, kSome);
  v.field("pressure_pa", cushion.pressure_pa, Need::kOptional, Range{-20000, 20000});
  v.field("volume_l", cushion.volume_l, Need::kOptional, Range{0, 1e6});
}

template <typename Visitor>
void describe(Visitor& v, ProjectAir& air) {
  v.field("density_kg_m3", air.density_kg_m3, Need::kOptional, Range{0, 2000});
  v.field("drag_across", air.drag_across, Need::kOptional, Range{0, 10});
  v.field("drag_along", air.drag_along, Need::kOptional, Range{0, 10});
  v.field("wind_m_s", air.wind_m_s, Need::kOptional, Range{-100, 100});
}

template <typename Visitor>
void describe(Visitor& v, ProjectSettings& settings) {
  v.field("particle_distance_mm", settings.particle_distance_mm, Need::kOptional, Range{0.5, 1000});
  v.field("time_step_s", settings.time_step_s, Need::kOptional, Range{1e-6, 0.1});
  v.field("gravity", settings.gravity, Need::kOptional, Range{0, 1000});
  v.field("sew_time_s", settings.sew_time_s, Need::kOptional, Range{0, 600});
  v.field("settle_speed_mm_s", settings.settle_speed_mm_s, Need::kOptional, Range{0.001, 1e5});
  v.field("max_time_s", settings.max_time_s, Need::kOptional, Range{0, 3600});
  v.field("frame_interval_steps", settings.frame_interval_steps, Need::kOptional, Range{1, 1e6});
  v.choice("mode", settings.mode, {"drape", "dynamic"});
  v.choice("end", settings.end, {"settled", "time"});
  v.field("air", settings.air);
}

template <typename Visitor>
void describe(Visitor& v, Project& project) {
  v.field("toile", project.toile, Need::kRequired, Range{1, 1});
  v.field("name", project.name);
  v.field("pieces", project.pieces, Need::kRequired, kSome);
  v.field("fabrics", project.fabrics, Need::kRequired, kSome);
  v.field("seams", project.seams, Need::kOptional, kMany);
  v.field("bodies", project.bodies, Need::kOptional, kMany);
  v.field("attachments", project.attachments, Need::kOptional, kMany);
  v.field("buttons", project.buttons, Need::kOptional, kMany);
  v.field("elastics", project.elastics, Need::kOptional, kMany);
  v.field("folds", project.folds, Need::kOptional, kMany);
  v.field("cushions", project.cushions, Need::kOptional, kMany);
  v.field("settings", project.settings);
}

}  // namespace toile::fields
