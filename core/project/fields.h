#pragma once
// The format, said once: which keys an object of the document has, where they go, what they may be. Those of
// cloth stand in cloth_fields.h.

#include <string>

#include "core/body/measure/measures.h"
#include "core/json/fields/range.h"
#include "core/project/cloth_fields.h"
#include "core/project/project.h"

namespace toile::fields {

/// By Measure: what a tape may read of anybody. make_mannequin is stricter, and knows what goes together.
inline constexpr Range kMeasureRangeCm[measure::kMeasureCount] = {
    {80, 220}, {30, 250}, {30, 250}, {30, 250}, {30, 250}, {15, 100}, {15, 90},
    {8, 90},   {5, 40},   {15, 120}, {15, 150}, {10, 100}, {20, 150}, {10, 90}};
inline constexpr const char* kMeasureMeaning[measure::kMeasureCount] = {
    "cm, from the floor to the top of the head.",
    "cm; a woman's bust at the bust points, a chest at its widest below the armpits.",
    "cm around the ribs below the breasts.",
    "cm around the narrowest place.",
    "cm around the widest place.",
    "cm around the narrowest place of the neck.",
    "cm from shoulder point to shoulder point, straight.",
    "cm around the upper arm.",
    "cm around the narrowest place of the wrist.",
    "cm from the shoulder point over the elbow to the wrist.",
    "cm around the thigh, right below the crotch.",
    "cm around the widest place of the calf.",
    "cm from the crotch to the floor.",
    "cm from the nape to the waist, along the back."};

template <typename Visitor>
void describe(Visitor& v, project::ProjectMannequin& mannequin) {
  v.object("mannequin", "A standing figure made from measures.");
  v.field("preset", mannequin.preset,
          "Of a size table: \"eu34\" to \"eu48\", \"m44\" to \"m58\", \"child92\" to \"child170\". Its sex "
          "and measures hold where no other stand here.");
  v.choice("sex", mannequin.sex,
           "Default: the preset's, or female. With neither preset nor sex, height, bust, waist and hip are "
           "170, 90, 72 and 96 where they are not given; else what is not given follows from proportions.",
           {"female", "male", "child"});
  v.choice("pose", mannequin.pose, "a: the arms hang at an angle (default); t: they stand out level.",
           {"a", "t"});
  v.field("arm_angle", mannequin.arm_angle,
          "Degrees between a hanging arm and the arm in pose a. Default 45.", Need::kOptional, Range{30, 60});
  for (int i = 0; i < measure::kMeasureCount; ++i) {
    const std::string key = std::string(measure::measure_name(measure::measure_at(i))) + "_cm";
    v.field(key, mannequin.measures_cm[static_cast<std::size_t>(i)], kMeasureMeaning[i], Need::kOptional,
            kMeasureRangeCm[i]);
  }
  v.field("triangles", mannequin.triangles, "How many triangles the figure has. Default 3300.",
          Need::kOptional, Range{1000, 60000});
}

template <typename Visitor>
void describe(Visitor& v, project::ProjectLandmark& landmark) {
  v.object("landmark",
           "A named place on a body, beside those that every standing body has, or in place of the one of "
           "that name: a point of a triangle of a mesh file, or told from another landmark (for a mannequin "
           "always: its triangles change with its measures).");
  v.field("name", landmark.name, "Unlike those of the other landmarks here.", Need::kRequired);
  v.field("triangle", landmark.triangle, "Of the mesh as it is read, counted from 0.", Need::kOptional,
          Range{0, 1e8});
  v.field("share", landmark.share, "Of the triangle's three corners, summing to 1. Default: its middle.",
          Need::kOptional, Range{0, 1});
  v.field("near", landmark.near,
          "Name of a landmark of this body that stands before it; of one that is moved, its own.");
  v.field("offset_mm", landmark.offset_mm,
          "mm from that one; the skin nearest to there is meant. Default [0, 0, 0].", Need::kOptional,
          Range{-1000, 1000});
  v.field("body_height_mm", landmark.body_height_mm,
          "mm; the body's height when the offset was told. On a taller body it is longer in proportion. "
          "Default: it stays.",
          Need::kOptional, Range{100, 10000});
  v.exactly_one("triangle", "near");
}

template <typename Visitor>
void describe(Visitor& v, project::ProjectKeyframe& keyframe) {
  v.object("keyframe",
           "A shape that a body comes to while the cloth hangs on it: another pose or size of its mesh, with "
           "the same vertices and triangles in the same order.");
  v.field("after_s", keyframe.after_s,
          "s after the body begins to move; later than the keyframe before it. Default 1.", Need::kOptional,
          Range{1e-3, 600});
  v.file("file", keyframe.file, "Read and placed as the body's own.");
  v.field("mannequin", keyframe.mannequin, "");
  v.exactly_one("file", "mannequin");
}

template <typename Visitor>
void describe(Visitor& v, project::ProjectBody& body) {
  v.object("body",
           "Something solid that cloth meets, a person as well as a table or a cushion: a mesh from a file, "
           "or the program's own mannequin. There may be several.");
  v.field("id", body.id, "Name that messages use.", Need::kRequired);
  v.file("file", body.file, "");
  v.choice("unit", body.unit, "Length unit of the file. Without it, the mesh's size decides.",
           {"m", "cm", "mm"});
  v.choice("up", body.up, "Which axis of the file points upwards. Default y.", {"y", "z"});
  v.field("mannequin", body.mannequin, "");
  v.exactly_one("file", "mannequin");
  v.field("friction", body.friction, "Coulomb's coefficient, cloth on this body. Default 0.4.",
          Need::kOptional, kFriction);
  v.field("skin_offset_mm", body.skin_offset_mm, "mm; distance that cloth keeps from the skin. Default 1.",
          Need::kOptional, Range{0, 100});
  v.field("restitution", body.restitution,
          "Reflection coefficient: the share of its speed towards the skin that cloth keeps, turned round, "
          "when it strikes. 0: none (default); 1: all.",
          Need::kOptional, Range{0, 1});
  v.field("translation", body.translation, "m; applied last. Default [0, 0, 0].", Need::kOptional, kLength);
  v.field("rotation", body.rotation,
          "Degrees about the fixed axes x, then y, then z; applied after the scale. Default [0, 0, 0].",
          Need::kOptional, kLength);
  v.field("scale", body.scale, "Applied first. Default 1.", Need::kOptional, Range{1e-4, 1e4});
  v.field("landmarks", body.landmarks, "Named places on it, beside those that the program finds.",
          Need::kOptional, kMany);
  v.field("motion", body.motion,
          "How it moves once the cloth hangs on it: straight from each of these shapes to the next. It waits "
          "where the cloth cannot give way. The cloth then comes to rest anew.",
          Need::kOptional, Range{0, 100});
}

template <typename Visitor>
void describe(Visitor& v, project::ProjectGoal& goal) {
  v.object("goal",
           "A place to which cloth is led while the seams close. Contact is stronger than the hold: what is "
           "in the way makes it wait.");
  v.field("body", goal.body, "Id of a body. Default: the first that stands, or that bears the landmark.");
  v.field("landmark", goal.landmark,
          "Name of a landmark, e.g. neck_front, waist_left, or one of the body's own. Points go there; of "
          "edges their middle.");
  v.field("line", goal.line,
          "A line around the body, as a tape lies: neck, neckline, bust, underbust, waist, high_hip, hip, "
          "and with _left or _right upper_arm, elbow, wrist, thigh, knee, ankle. Points and whole edges come "
          "to lie on it, and may slide along it.");
  v.field("place", goal.place, "m; a fixed place in space. Points go there; of edges their middle.",
          Need::kOptional, kLength);
  v.exactly_one("landmark", "line", "place");
  v.field("up_mm", goal.up_mm, "mm by which a line is shifted up, along limbs towards the trunk. Default 0.",
          Need::kOptional, Range{-1000, 1000});
}

template <typename Visitor>
void describe(Visitor& v, project::ProjectAttachment& attachment) {
  v.object("attachment",
           "Holds part of a piece, e.g. a waistband at its height until friction carries it, or leads it to "
           "a place on the body.");
  v.field("id", attachment.id, "Name that messages use.");
  v.field("piece", attachment.piece, "Id of a piece.", Need::kRequired);
  v.field("edges", attachment.edges, "Ids of its edges; neither edges nor points: the whole piece.",
          Need::kOptional, kMany);
  v.field("points", attachment.points, "mm; points of the flat piece.", Need::kOptional, kMany);
  v.choice("hold", attachment.hold,
           "height: keeps its height and may move sideways (default); place: does not move. Not beside to.",
           {"height", "place"});
  v.field("to", attachment.to, "");
  v.field("release_after_s", attachment.release_after_s,
          "s after gravity has come to its full strength; negative: never. Default 1.", Need::kOptional,
          Range{-1, 3600});
}

template <typename Visitor>
void describe(Visitor& v, project::ProjectButtonPoint& point) {
  v.object("button_point", "A point of a flat piece.");
  v.field("piece", point.piece, "Id of a piece.", Need::kRequired);
  v.field("at", point.at, "mm; on the piece.", Need::kRequired, kLength);
}

template <typename Visitor>
void describe(Visitor& v, project::ProjectButton& button) {
  v.object("button",
           "A short thread from a point of a piece to another point. Cloth and body between are stronger "
           "than it.");
  v.field("id", button.id, "Name that messages use.", Need::kRequired);
  v.field("a", button.a, "One end.", Need::kRequired);
  v.field("b", button.b, "The other end.", Need::kRequired);
  v.field("distance_mm", button.distance_mm, "mm; the thread's length once it is closed. Default 2.",
          Need::kOptional, Range{0, 1000});
}

template <typename Visitor>
void describe(Visitor& v, project::ProjectElastic& elastic) {
  v.object("elastic",
           "A band that pulls with stiffness times strain where it is longer than its own length, and never "
           "pushes.");
  v.field("id", elastic.id, "Name that messages use.", Need::kRequired);
  v.field("piece", elastic.piece, "Id of a piece.", Need::kRequired);
  v.field("lines", elastic.lines, "Ids of edges or lines of the piece.", Need::kRequired, kSome);
  v.field("factor", elastic.factor,
          "Length of the band without load, per length of the flat cloth: under 1 it gathers. Default 1.",
          Need::kOptional, Range{0.05, 2});
  v.field("stiffness_n", elastic.stiffness_n, "N; tension per strain of the band. Default 20.",
          Need::kOptional, Range{0.01, 10000});
}

template <typename Visitor>
void describe(Visitor& v, project::ProjectFold& fold) {
  v.object("fold", "Presses the cloth to an angle along lines or seams.");
  v.field("id", fold.id, "Name that messages use.", Need::kRequired);
  v.field("piece", fold.piece, "Id of a piece.", Need::kRequired);
  v.field("lines", fold.lines,
          "Ids of lines of the piece, or of edges along which it is pressed to what they are sewn to.",
          Need::kRequired, kSome);
  v.field("angle", fold.angle,
          "Degrees from flat: 180 folds the piece onto itself with the side outside that is up in the flat "
          "piece, -180 with that side inside.",
          Need::kRequired, Range{-180, 180});
  v.field("stiffness_mn", fold.stiffness_mn,
          "mN·m per radian and metre of line. The cloth's own bending holds against it. Default 20.",
          Need::kOptional, Range{0.001, 10000});
}

template <typename Visitor>
void describe(Visitor& v, project::ProjectCushion& cushion) {
  v.object("cushion", "Pieces that hold air. Openings that seams leave count as closed by a lid.");
  v.field("id", cushion.id, "Name that messages use.", Need::kRequired);
  v.field("pieces", cushion.pieces,
          "Ids of pieces. The side of the first that is up in the flat piece is the outside.",
          Need::kRequired, kSome);
  v.field("pressure_pa", cushion.pressure_pa, "Pa above the air outside; negative sucks. Default 100.",
          Need::kOptional, Range{-20000, 20000});
  v.field("volume_l", cushion.volume_l,
          "l; the amount of air is fixed, and has that pressure at this volume (pressure times volume stays "
          "the same). 0, the default: pumped at constant pressure.",
          Need::kOptional, Range{0, 1e6});
}

template <typename Visitor>
void describe(Visitor& v, project::ProjectAir& air) {
  v.object("air", "Air that resists the cloth, by the speed between them.");
  v.field("density_kg_m3", air.density_kg_m3, "kg/m³. Default 1.2.", Need::kOptional, Range{0, 2000});
  v.field("drag_across", air.drag_across, "Drag coefficient of cloth that moves face-on. Default 1.2.",
          Need::kOptional, Range{0, 10});
  v.field("drag_along", air.drag_along, "Of cloth that slides in its own plane. Default 0.05.",
          Need::kOptional, Range{0, 10});
  v.field("wind_m_s", air.wind_m_s, "m/s; the air's own speed. Default [0, 0, 0].", Need::kOptional,
          Range{-100, 100});
}

template <typename Visitor>
void describe(Visitor& v, project::ProjectPaper& paper) {
  v.object(
      "paper",
      "What the method of Kim and Park 2003 leaves to its user (docs/paper.md). What is absent is the best "
      "that a search over samples found.");
  v.field("time_step_s", paper.time_step_s, "s; one step of its integrator.", Need::kOptional,
          Range{1e-5, 0.1});
  v.field("damping", paper.damping, "Share of its way that a particle loses with each step.", Need::kOptional,
          Range{0, 0.999});
  v.field("passes", paper.passes, "Over all links, seams and held particles, a step.", Need::kOptional,
          Range{1, 1000});
  v.field("reflection", paper.reflection,
          "Share of its way that a particle keeps, mirrored, where it strikes a surface.", Need::kOptional,
          Range{0, 1});
  v.field(
      "load_n_m", paper.load_n_m,
      "N/m; a link's largest elastic strain is what its fabric is stretched by under this load, its limit "
      "at most. 490 gives the fabric's coefficients.",
      Need::kOptional, Range{0, 1e5});
  v.field("clearance_mm", paper.clearance_mm,
          "mm; bodies are met so far outside their skin at least, since of a link only the ends are tried.",
          Need::kOptional, Range{0, 20});
}

template <typename Visitor>
void describe(Visitor& v, project::ProjectSettings& settings) {
  v.object("settings", "How to drape. Every key has a default that suits a garment.");
  v.choice(
      "solver", settings.solver,
      "toile: the engine that lets nothing through (default); paper: the method of Kim and Park 2003, to "
      "compare with, whose crossings are counted and told. It takes gravity, sew_time_s, settle_speed_mm_s, "
      "max_time_s, start, ground and end from here, and its time step from paper.",
      {"toile", "paper"});
  v.field("particle_distance_mm", settings.particle_distance_mm,
          "mm; wanted edge length of the triangles. Default 15.", Need::kOptional, Range{0.5, 1000});
  v.field("time_step_s", settings.time_step_s, "s; one substep of the solver. Default 1/3000.",
          Need::kOptional, Range{1e-6, 0.1});
  v.field("gravity", settings.gravity, "m/s², downwards. Default 9.81.", Need::kOptional, Range{0, 1000});
  v.field("sew_time_s", settings.sew_time_s, "s in which the seams close, without gravity. Default 1.",
          Need::kOptional, Range{0, 600});
  v.field("settle_speed_mm_s", settings.settle_speed_mm_s,
          "mm/s; root mean square speed under which the cloth counts as at rest. Default 5.", Need::kOptional,
          Range{0.001, 1e5});
  v.field("max_time_s", settings.max_time_s,
          "s of simulated time after which a drape that has not settled ends. Default 15.", Need::kOptional,
          Range{0, 3600});
  v.field("frame_interval_steps", settings.frame_interval_steps,
          "Substeps between frames that viewers see, at most. Default 50.", Need::kOptional, Range{1, 1e6});
  v.choice(
      "start", settings.start,
      "auto: the garment is put on the body first, where that can be certified (default); sewn: the pieces "
      "are sewn together from where they stand.",
      {"auto", "sewn"});
  v.field("ground", settings.ground, "Whether a person stands on ground that cloth lies on. Default true.",
          Need::kOptional);
  v.choice("mode", settings.mode,
           "drape: only the end matters, and added damping brings the cloth to rest (default); dynamic: true "
           "time once the garment is sewn, slowed by air and friction only.",
           {"drape", "dynamic"});
  v.choice("end", settings.end,
           "settled: when the cloth is at rest, at max_time_s at the latest; time: at max_time_s. Default "
           "settled in mode drape, time in mode dynamic.",
           {"settled", "time"});
  v.field("paper", settings.paper, "Of solver paper. Without it: its defaults.");
  v.field("air", settings.air,
          "The air around the cloth. Without it: still air in mode dynamic, none in mode drape.");
}

template <typename Visitor>
void describe(Visitor& v, project::Project& project) {
  v.object("",
           "A garment to drape: flat pieces, what they are made of, how they are sewn, what they hang on. "
           "Millimetres in the pattern, metres in space (y up, right-handed, the body looks along +z), "
           "degrees for angles. A document has at most 4 MiB and nests at most 32 levels deep.");
  v.field("toile", project.toile, "Version of this format.", Need::kRequired, Range{1, 1});
  v.field("name", project.name, "What people call the project.");
  v.field("pieces", project.pieces, "The pieces of cloth, as they are cut. Their ids are unique.",
          Need::kRequired, kSome);
  v.field(
      "fabric", project.fabric,
      "What the pieces are made of that name no fabric: the id of one of this document, or the name of one "
      "of the library (`toile fabric list`).");
  v.field("fabrics", project.fabrics,
          "Fabrics with figures of their own, for the pieces to name. Their ids are unique.", Need::kOptional,
          kSome);
  v.field("seams", project.seams, "What is sewn to what. Their ids are unique.", Need::kOptional, kMany);
  v.field("bodies", project.bodies,
          "Bodies and objects that the cloth hangs on or falls on. Their ids are unique.", Need::kOptional,
          kMany);
  v.field("attachments", project.attachments, "Parts of pieces that are held while the drape begins.",
          Need::kOptional, kMany);
  v.field("buttons", project.buttons,
          "Points that are tied to each other; closed while the seams are sewn. Their ids are unique.",
          Need::kOptional, kMany);
  v.field("elastics", project.elastics,
          "Bands sewn along edges and lines; they draw in once the garment is sewn. Their ids are unique.",
          Need::kOptional, kMany);
  v.field("folds", project.folds, "Creases pressed in along lines and seams of pieces. Their ids are unique.",
          Need::kOptional, kMany);
  v.field("cushions", project.cushions,
          "Closed or nearly closed shapes with air inside. Their ids are unique.", Need::kOptional, kMany);
  v.field("settings", project.settings, "");
}

}  // namespace toile::fields
