#pragma once
// The fields of pieces, fabrics and seams; see fields.h.

#include <array>
#include <string>
#include <vector>

#include "core/fabric/figure_fields.h"
#include "core/json/fields/range.h"
#include "core/project/project.h"

namespace toile::fields {

inline constexpr Range kLength{
    -1e5, 1e5, "coordinate"};           // mm or m: every coordinate, so that sums stay far from overflow
inline constexpr Range kSome{1, 1000};  // elements of a list that must not be empty
inline constexpr Range kMany{0, 1000};

template <>
inline constexpr ElementRule kElement<Vec2> = {kLength};
template <>
inline constexpr ElementRule kElement<std::array<Vec2, 4>> = {kLength, "Start, two handles, end, mm."};
template <>
inline constexpr ElementRule kElement<std::vector<project::ProjectEdge>> = {
    kSome, "The edges of one hole, as in an outline."};

template <typename Visitor>
void describe(Visitor& v, project::ProjectDxf& dxf) {
  v.object("dxf", "A piece in a DXF file.");
  v.file("dxf", dxf.dxf, "", Need::kRequired);
  v.field("piece", dxf.piece, "The piece's name in the file.", Need::kRequired);
  v.field("corners", dxf.corners,
          "Points (mm) of the outline where edges begin and end, instead of its sharp bends; each within 0.5 "
          "mm of the outline.",
          Need::kOptional, kMany);
  v.choice("units", dxf.units, "Length unit of the file, when the file does not say or says it wrong.",
           {"mm", "cm", "inch"});
  v.field("size", dxf.size, "Size to take of a graded file, instead of its sample size.");
  v.chosen_names(
      "layers", dxf.layers,
      "What layers of the file stand for, by their names there, instead of what their numbers (AAMA) "
      "and names say.",
      {"cut", "sew", "internal", "cutout", "mirror", "grain", "notch", "drill", "turn", "curve", "ignore"});
}

/// An edge as the document has it, and as an edit draws one.
template <typename Visitor, typename Edge>
void describe_drawn_edge(Visitor& v, Edge& edge) {
  v.object("edge", "A run of the outline between two corners: what seams and attachments name.");
  v.field("id", edge.id, "Unique within its piece, and stable when the outline is edited.", Need::kRequired);
  v.field("points", edge.points,
          "The edge passes through these points, mm: smoothly where they bend gently, within 0.1 mm of each.",
          Need::kOptional, Range{2, 100000});
  v.field("curves", edge.curves, "Cubic Béziers, each beginning where the one before it ends.",
          Need::kOptional, Range{1, 10000});
  v.exactly_one("points", "curves");
}

template <typename Visitor>
void describe(Visitor& v, project::ProjectEdge& edge) {
  describe_drawn_edge(v, edge);
}

template <typename Visitor>
void describe(Visitor& v, project::ProjectRigid& rigid) {
  v.object("",
           "The flat point (u, v) goes to translation + R (u, v, 0). The right side of the cloth faces R (0, "
           "0, 1).");
  v.field("translation", rigid.translation, "m; where the piece's origin goes. Default [0, 0, 0].",
          Need::kOptional, kLength);
  v.field("rotation", rigid.rotation, "Degrees about the fixed axes x, then y, then z. Default [0, 0, 0].",
          Need::kOptional, kLength);
  v.field("flipped", rigid.flipped, "Mirror u first: the piece seen from its wrong side. Default false.");
}

template <typename Visitor>
void describe(Visitor& v, project::ProjectWrapped& wrapped) {
  v.object("",
           "The piece rolled without stretching around an axis, upright unless told otherwise: u along the "
           "circle, counter-clockwise seen from above, v upwards.");
  v.field("axis", wrapped.axis, "m; x and z of the axis. Default [0, 0].", Need::kOptional, kLength);
  v.field("radius", wrapped.radius, "m, at the anchor.", Need::kRequired, Range{0.001, 1000});
  v.field("angle", wrapped.angle,
          "Degrees; where the anchor comes to: 0 is the front (+z), 90 is +x. Default 0.", Need::kOptional,
          kLength);
  v.field("height", wrapped.height, "m; y of the anchor.", Need::kRequired, kLength);
  v.field("anchor", wrapped.anchor, "mm; the flat point that angle and height speak of. Default [0, 0].",
          Need::kOptional, kLength);
  v.field("slope", wrapped.slope,
          "Metres by which the radius grows for each metre of cloth downwards: a cone. Default 0.",
          Need::kOptional, Range{-0.99, 0.99});
  v.field("axis_height", wrapped.axis_height,
          "m; y of the axis's point, from which heights count along the axis. Default 0.", Need::kOptional,
          kLength);
  v.field("up", wrapped.up, "Direction of the axis; about one along z, angle 0 is +y. Default [0, 1, 0].",
          Need::kOptional, Range{-1, 1});
  v.field("turn", wrapped.turn,
          "Degrees by which the flat piece is turned about the anchor first. Default 0.", Need::kOptional,
          kLength);
  v.field("flipped", wrapped.flipped,
          "Mirror u about the anchor after the turn: the right side faces the axis. Default false.");
}

template <typename Visitor>
void choose_box_side(Visitor& v, std::string& part, std::string& side) {
  v.shared_choice("body_part", "Whose box. Default torso. Left and right are the wearer's.", "part", part,
                  {"head", "neck", "torso", "hips", "left_arm", "right_arm", "left_leg", "right_leg"});
  v.shared_choice("box_side", "Which side of the box. Default front. Left and right are the wearer's.",
                  "side", side, {"front", "back", "left", "right"});
}

template <typename Visitor>
void describe(Visitor& v, project::ProjectOnBox& box) {
  v.object("",
           "A stiff sheet before a side of the box around a part of the body, along that part. It goes where "
           "the body is.");
  v.field("body", box.body, "Id of a standing body. Default: the first one.");
  choose_box_side(v, box.part, box.side);
  v.field("at", box.at,
          "m from the side's middle: to the right as one looks at it, and up along the part. Default [0, 0].",
          Need::kOptional, kLength);
  v.field("away", box.away, "m before the side. Default 0.03.", Need::kOptional, Range{-100, 100});
  v.field("turn", box.turn, "Degrees, counter-clockwise as one looks at the side. Default 0.",
          Need::kOptional, kLength);
  v.field("anchor", box.anchor,
          "mm; the flat point that comes there. Default: the middle of the piece's bounding box.",
          Need::kOptional, kLength);
  v.field("flipped", box.flipped, "Mirror u first: the right side faces the body. Default false.");
}

template <typename Visitor>
void describe(Visitor& v, project::ProjectAround& around) {
  v.object(
      "",
      "Rolled around a part of the body, along its box, clear of all that stands out of it under the piece.");
  v.field("body", around.body, "Id of a standing body. Default: the first one.");
  choose_box_side(v, around.part, around.side);
  v.field("at", around.at,
          "m from the side's middle: along the circle, and up along the part. Default [0, 0].",
          Need::kOptional, kLength);
  v.field("away", around.away, "m from what stands out farthest. Default 0.02.", Need::kOptional,
          Range{0, 100});
  v.field("turn", around.turn, "Degrees, counter-clockwise as one looks at the side. Default 0.",
          Need::kOptional, kLength);
  v.field("slope", around.slope,
          "Metres by which the radius grows for each metre of cloth downwards: a cone. Default 0.",
          Need::kOptional, Range{-0.99, 0.99});
  v.field("anchor", around.anchor,
          "mm; the flat point that comes there. Default: the middle of the piece's bounding box.",
          Need::kOptional, kLength);
  v.field("flipped", around.flipped, "Mirror u first: the right side faces the body. Default false.");
}

template <typename Visitor>
void describe(Visitor& v, project::ProjectPlacement& placement) {
  v.object("placement",
           "Where the flat piece stands before it is sewn: as a stiff sheet, or rolled around an axis; in "
           "space, or told by a part of the body.");
  v.field("rigid", placement.rigid, "");
  v.field("wrapped", placement.wrapped, "");
  v.field("on_box", placement.on_box, "");
  v.field("around", placement.around, "");
  v.exactly_one("rigid", "wrapped", "on_box", "around");
}

template <typename Visitor>
void describe(Visitor& v, project::ProjectLine& line) {
  v.object("line",
           "A line on a piece, straight from point to point. An end at the outline joins it; elsewhere lines "
           "may meet each other only in points that both have.");
  v.field("id", line.id, "Unique within its piece, beside the ids of the edges.", Need::kRequired);
  v.field("points", line.points, "mm; inside the outline, or on it at the ends.", Need::kRequired,
          Range{2, 10000});
  v.field("drawn", line.drawn,
          "Only drawn: the mesh takes no notice of it, and it may run anywhere, until an elastic or a fold "
          "lies on it. Default false.");
}

template <typename Visitor>
void describe(Visitor& v, project::ProjectNotch& notch) {
  v.object("notch", "A mark on the outline, where two pieces meet when they are sewn.");
  v.field("at", notch.at, "mm.", Need::kRequired, kLength);
  v.field("depth_mm", notch.depth_mm, "Of the cut into the allowance. Default 0: not told.", Need::kOptional,
          Range{-1000, 1000});
  v.field("inwards", notch.inwards, "Direction of the cut; its length does not matter.", Need::kOptional,
          kLength);
}

template <typename Visitor>
void describe(Visitor& v, project::ProjectTexture& texture) {
  v.object("texture",
           "A picture on the cloth, repeated over the piece; it turns with the grain. Looks alone: a drape "
           "comes out the same with it.");
  v.file("image", texture.image,
         "A PNG or JPEG file of at most 20 MiB and 64 million pixels, beside the document.", Need::kRequired);
  v.field("scale_mm", texture.scale_mm,
          "Width of one repeat on the flat piece; its height goes by the picture's form.", Need::kRequired,
          Range{0.1, 1e5});
  v.field("offset", texture.offset, "mm; where a lower left corner of the picture lies. Default [0, 0].",
          Need::kOptional, kLength);
  v.field("angle", texture.angle,
          "Degrees, counter-clockwise, from the warp to the upright of the picture. Default 0.",
          Need::kOptional, Range{-360, 360});
}

template <typename Visitor>
void describe(Visitor& v, project::ProjectPhysical& physical) {
  v.object("physical",
           "What the piece has otherwise than its fabric (interlined, pressed, of another lot; keys as of a "
           "fabric), and how finely it is meshed.");
  v.field(
      "interlining", physical.interlining,
      "Name of a fabric of the library that is fused to the piece: both masses, both stiffnesses, and as a "
      "laminate far stiffer in bending. What else stands here holds for the two together.");
  describe_areal_mass(v, physical);
  v.field("stretch_warp_n_m", physical.stretch_warp_n_m, "N/m along the warp.", Need::kOptional, kStiffness);
  v.field("stretch_weft_n_m", physical.stretch_weft_n_m, "N/m along the weft.", Need::kOptional, kStiffness);
  v.field("stretch_coupling_n_m", physical.stretch_coupling_n_m, "N/m between warp and weft.",
          Need::kOptional, Range{-1e6, 1e6});
  describe_shear(v, physical);
  describe_bending(v, physical);
  describe_thickness(v, physical);
  v.field("friction", physical.friction, "Coefficient against anything.", Need::kOptional, kFriction);
  v.field("particle_distance_mm", physical.particle_distance_mm,
          "mm; wanted edge length of the piece's own triangles. On a seam the finer of both sides counts.",
          Need::kOptional, Range{0.5, 1000});
}

template <typename Visitor>
void describe(Visitor& v, project::ProjectPiece& piece) {
  v.object("piece", "One piece of cloth. Its outline stands here or in a DXF file.");
  v.field("id", piece.id, "Name that seams and attachments use.", Need::kRequired);
  v.field("from", piece.from, "");
  v.field("outline", piece.outline,
          "The edges one after the other, counter-clockwise with y up (a clockwise one is run the other "
          "way); each begins where the one before it ends, the first where the last ends, to 0.01 mm.",
          Need::kOptional, kSome);
  v.exactly_one("from", "outline");
  v.field("holes", piece.holes,
          "Closed lines inside the outline, run clockwise. Only beside an inline outline.", Need::kOptional,
          kMany);
  v.field("edge_names", piece.edge_names,
          "Other ids for the edges of a piece from a file, e.g. {\"e0\": \"waist\"}. `toile check` lists the "
          "ids.");
  v.field("grain", piece.grain,
          "Direction of the warp in the flat piece; its length does not matter. Without it, the file's grain "
          "line, or [0, 1].",
          Need::kOptional, kLength);
  v.field(
      "fabric", piece.fabric,
      "Id of a fabric of this document, or the name of one of the library (`toile fabric list`). Default: "
      "the project's.");
  v.field("lines", piece.lines,
          "Lines on the piece, beside those that stand in its file. Edges of the mesh lie on those that are "
          "not only drawn.",
          Need::kOptional, kMany);
  v.field("layer", piece.layer,
          "Order outwards: a piece of a higher layer is worn over those of lower ones. Default 0.",
          Need::kOptional, Range{-100, 100});
  v.field("notches", piece.notches,
          "Marks on the outline. Only beside an inline outline; those of a file stand there.",
          Need::kOptional, kMany);
  v.field("texture", piece.texture, "");
  v.field("physical", piece.physical, "");
  v.field("placement", piece.placement, "", Need::kRequired);
}

template <typename Visitor>
void describe(Visitor& v, project::ProjectCoefficients& coefficients) {
  v.object("coefficients",
           "Coefficients from 0 to 1 in place of figures; figures that stand here go before them.");
  v.field("elasticity_warp", coefficients.elasticity_warp,
          "Largest strain along the warp: 0.05 is 5 %; 1 is soft. The stiffness becomes 60 N/m over it.",
          Need::kOptional, Range{0.001, 1});
  v.field("elasticity_weft", coefficients.elasticity_weft, "The same along the weft.", Need::kOptional,
          Range{0.001, 1});
  v.field(
      "bending_warp", coefficients.bending_warp,
      "Bending length (B / w)^(1/3) along the warp over 50 mm, w the weight per area: 0 is limp, 1 stiff. "
      "Of the bias, where both stand here: the radius at 45° of the ellipse with these half axes.",
      Need::kOptional, Range{0, 1});
  v.field("bending_weft", coefficients.bending_weft, "The same along the weft.", Need::kOptional,
          Range{0, 1});
}

template <typename Visitor>
void describe(Visitor& v, project::ProjectFabric& fabric) {
  v.object("fabric",
           "A fabric in measured units: figures of its own, or those of a fabric of the library where it has "
           "none.");
  v.field("id", fabric.id, "Name that pieces use.", Need::kRequired);
  v.field("name", fabric.name, "What people call the fabric.");
  v.field(
      "like", fabric.like,
      "Name of a fabric of the library (`toile fabric list`): it has the figures that do not stand here.");
  v.field("coefficients", fabric.coefficients, "");
  v.unless("like", {"areal_mass_g_m2", "stretch_warp_n_m", "stretch_weft_n_m", "stretch_shear_n_m",
                    "bend_warp_un_m", "bend_weft_un_m", "bend_bias_un_m", "thickness_mm"});
  describe_areal_mass(v, fabric);
  v.field("stretch_warp_n_m", fabric.stretch_warp_n_m, "N/m; tension per strain along the warp.",
          Need::kOptional, kStiffness);
  v.field("stretch_weft_n_m", fabric.stretch_weft_n_m, "N/m; tension per strain along the weft.",
          Need::kOptional, kStiffness);
  v.field("stretch_coupling_n_m", fabric.stretch_coupling_n_m,
          "N/m; tension along one per strain along the other; its square is less than warp times weft. "
          "Default 600.",
          Need::kOptional, Range{-1e6, 1e6});
  describe_shear(v, fabric);
  v.field("limit_warp_percent", fabric.limit_warp_percent,
          "%; strain along the warp beyond which the cloth is much stiffer. 0, the default: never.",
          Need::kOptional, Range{0, 500});
  v.field("limit_weft_percent", fabric.limit_weft_percent, "%; the same along the weft.", Need::kOptional,
          Range{0, 500});
  v.field("limit_shear_rad", fabric.limit_shear_rad, "Radians; the same for shear.", Need::kOptional,
          Range{0, 1.5});
  describe_bending(v, fabric);
  describe_thickness(v, fabric);
  v.field("friction", fabric.friction, "Coulomb's coefficient, cloth on cloth. Default 0.3.", Need::kOptional,
          kFriction);
  describe_colour(v, fabric);
}

template <typename Visitor>
void describe(Visitor& v, project::ProjectSeamEdge& edge) {
  v.object("seam_edge", "An edge of a piece, or a part of one.");
  v.field("piece", edge.piece, "Id of a piece.", Need::kRequired);
  v.field("edge", edge.edge, "Id of one of its edges.", Need::kRequired);
  v.field("reversed", edge.reversed, "Traversed against the outline's own direction. Default false.");
  v.field("from", edge.from,
          "Where the sewn part begins: a fraction of the edge's length, in the outline's own direction. "
          "Default 0.",
          Need::kOptional, Range{0, 1});
  v.field("to", edge.to, "Where it ends. Default 1.", Need::kOptional, Range{0, 1});
}

template <typename Visitor>
void describe(Visitor& v, project::ProjectSeam& seam) {
  v.object("seam",
           "Sews the path that series a makes to the path that series b makes. Two outlines that both run "
           "counter-clockwise meet with their edges against each other: the start of a meets the end of b.");
  v.field("id", seam.id, "Name that messages use.", Need::kRequired);
  v.field("a", seam.a, "Edges in the order in which they are sewn.", Need::kRequired, kSome);
  v.field("b", seam.b, "Edges in the order in which they are sewn.", Need::kRequired, kSome);
  v.field("same_direction", seam.same_direction, "The start of a meets the start of b. Default false.");
}

}  // namespace toile::fields
