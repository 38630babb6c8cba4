#pragma once
// The project document (proto/schema/project.schema.json) as plain values, in the document's own units:
// millimetres in the pattern, metres in space, degrees for angles. Reading it is pure; making a DrapeInput of
// it (resolve/resolve.h) opens the files that it names.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/base/types.h"
#include "core/body/measure/measures.h"
#include "core/pattern/pattern.h"

namespace toile::project {

/// A piece taken from a DXF file that lies beside the document.
struct ProjectDxf {
  std::string dxf;            ///< file name, relative to the document
  std::string piece;          ///< name of the piece in the file
  std::vector<Vec2> corners;  ///< mm; where edges begin; empty: wherever the outline bends sharply
  std::string units;          ///< "mm", "cm", "inch"; empty: what the file says
  std::string size = {};      ///< of a graded file; empty: its sample size
  /// What layers of the file stand for ("sew", "cut", …), by their names; the others as usual.
  std::vector<std::pair<std::string, std::string>> layers = {};
  friend bool operator==(const ProjectDxf&, const ProjectDxf&) = default;
};

/// An edge of an inline outline: either a line through points or a chain of cubic Béziers.
struct ProjectEdge {
  std::string id;
  std::vector<Vec2> points;                 ///< mm; two or more
  std::vector<std::array<Vec2, 4>> curves;  ///< mm; control points
  friend bool operator==(const ProjectEdge&, const ProjectEdge&) = default;
};

struct ProjectRigid {
  Vec3 translation;  ///< m
  Vec3 rotation;     ///< degrees about x, then y, then z
  bool flipped = false;
  friend bool operator==(const ProjectRigid&, const ProjectRigid&) = default;
};

struct ProjectWrapped {
  Vec2 axis;            ///< m, (x, z)
  double radius = 0.3;  ///< m
  double angle = 0;     ///< degrees; 0 is +z (front), 90 is +x
  double height = 1;    ///< m
  Vec2 anchor;          ///< mm
  double slope = 0;
  double axis_height = 0;  ///< m; y of the axis's point, from which heights count along the axis
  Vec3 up{0, 1, 0};        ///< along the axis
  double turn = 0;         ///< degrees by which the flat piece is turned about the anchor first
  bool flipped = false;
  friend bool operator==(const ProjectWrapped&, const ProjectWrapped&) = default;
};

/// Flat before a side of the box around a part of the body. What it means in space follows from the body.
struct ProjectOnBox {
  std::string body;  ///< id; empty: the first that stands
  std::string part = "torso", side = "front";
  Vec2 at;                          ///< m from the side's middle: to the right as one looks at it, and up
  double away = 0.03;               ///< m from the side
  double turn = 0;                  ///< degrees, counter-clockwise as one looks at it
  std::optional<Vec2> anchor = {};  ///< mm; the flat point that comes there; without it the piece's middle
  bool flipped = false;             ///< the right side faces the body
  friend bool operator==(const ProjectOnBox&, const ProjectOnBox&) = default;
};

/// Rolled around a part of the body.
struct ProjectAround {
  std::string body;
  std::string part = "torso", side = "front";
  Vec2 at;             ///< m from the side's middle: along the circle, and up along the part
  double away = 0.02;  ///< m from what stands out farthest of the part under the piece
  double turn = 0;     ///< degrees by which the flat piece is turned about the anchor first
  double slope = 0;    ///< of a cone, as ProjectWrapped's
  std::optional<Vec2> anchor = {};
  bool flipped = false;
  friend bool operator==(const ProjectAround&, const ProjectAround&) = default;
};

/// One of the four.
struct ProjectPlacement {
  std::optional<ProjectRigid> rigid = {};
  std::optional<ProjectWrapped> wrapped = {};
  std::optional<ProjectOnBox> on_box = {};
  std::optional<ProjectAround> around = {};
  friend bool operator==(const ProjectPlacement&, const ProjectPlacement&) = default;
};

/// A line on a piece, for folds and elastic.
struct ProjectLine {
  std::string id;
  std::vector<Vec2> points;  ///< mm; two or more
  bool drawn = false;        ///< only drawn, unless an elastic or a fold lies on it
  friend bool operator==(const ProjectLine&, const ProjectLine&) = default;
};

/// A mark on the outline of an inline piece.
struct ProjectNotch {
  Vec2 at;                      ///< mm
  double depth_mm = 0;          ///< into the allowance
  std::optional<Vec2> inwards;  ///< its direction; its length does not matter
  friend bool operator==(const ProjectNotch&, const ProjectNotch&) = default;
};

/// A picture on the cloth, repeated over it; it turns with the grain.
struct ProjectTexture {
  std::string image;      ///< file name, relative to the document
  double scale_mm = 100;  ///< width of one repeat on the flat piece; its height goes by the picture's form
  Vec2 offset = {};       ///< mm; where a lower left corner of the picture lies
  double angle = 0;       ///< degrees, counter-clockwise, from the warp to the picture's upright
  friend bool operator==(const ProjectTexture&, const ProjectTexture&) = default;
};

/// What a piece has otherwise than its fabric: interlined, pressed, cut from another lot. Units as there;
/// what is given here holds for the piece with its interlining.
struct ProjectPhysical {
  std::string interlining = {};  ///< name of a fabric of the library, fused to the piece
  std::optional<double> areal_mass_g_m2 = {};
  std::optional<double> stretch_warp_n_m = {}, stretch_weft_n_m = {}, stretch_coupling_n_m = {};
  std::optional<double> stretch_shear_n_m = {};
  std::optional<double> bend_warp_un_m = {}, bend_weft_un_m = {}, bend_bias_un_m = {};
  std::optional<double> thickness_mm = {};
  std::optional<double> friction = {};
  std::optional<double> particle_distance_mm = {};
  friend bool operator==(const ProjectPhysical&, const ProjectPhysical&) = default;
};

struct ProjectPiece {
  std::string id;
  std::optional<ProjectDxf> from;
  std::vector<ProjectEdge> outline;
  std::vector<std::vector<ProjectEdge>> holes;
  std::vector<std::pair<std::string, std::string>> edge_names;  ///< id that the file gives → id used here
  std::optional<Vec2> grain;  ///< direction of the warp; without it what the DXF says, or (0, 1)
  std::string fabric;         ///< id in the document or name in the library; empty: the project's
  std::vector<ProjectLine> lines = {};
  int layer = 0;
  ProjectPlacement placement;
  std::vector<ProjectNotch> notches = {};  ///< of an inline outline
  std::optional<ProjectTexture> texture = {};
  std::optional<ProjectPhysical> physical = {};
  friend bool operator==(const ProjectPiece&, const ProjectPiece&) = default;
};

/// A fabric's view by coefficients from 0 to 1; their map to real units stands in
/// core/material/coefficients.h.
struct ProjectCoefficients {
  std::optional<double> elasticity_warp = {}, elasticity_weft = {};  ///< 1: soft
  std::optional<double> bending_warp = {}, bending_weft = {};        ///< 1: stiff
  friend bool operator==(const ProjectCoefficients&, const ProjectCoefficients&) = default;
};

/// Units as the keys name them; what each figure means stands in core/material/fabric.h. What is not given is
/// as in the fabric of the library that it is like, or else as there.
struct ProjectFabric {
  std::string id, name;
  std::string like;  ///< name of a fabric of the library
  std::optional<ProjectCoefficients> coefficients = {};
  std::optional<double> areal_mass_g_m2 = {};
  std::optional<double> stretch_warp_n_m = {}, stretch_weft_n_m = {}, stretch_coupling_n_m = {};
  std::optional<double> stretch_shear_n_m = {};
  std::optional<double> limit_warp_percent = {}, limit_weft_percent = {}, limit_shear_rad = {};
  std::optional<double> bend_warp_un_m = {}, bend_weft_un_m = {}, bend_bias_un_m = {};
  std::optional<double> thickness_mm = {};
  std::optional<double> friction = {};
  std::optional<std::array<double, 3>> colour = {};
  friend bool operator==(const ProjectFabric&, const ProjectFabric&) = default;
};

struct ProjectSeamEdge {
  std::string piece, edge;
  bool reversed = false;
  double from = 0, to = 1;  ///< fractions of the edge's length, in the outline's direction
  friend bool operator==(const ProjectSeamEdge&, const ProjectSeamEdge&) = default;
};

struct ProjectSeam {
  std::string id;
  std::vector<ProjectSeamEdge> a, b;
  bool same_direction = false;
  friend bool operator==(const ProjectSeam&, const ProjectSeam&) = default;
};

/// What is not said follows from the preset, or else from proportions; bodies.h says how.
struct ProjectMannequin {
  std::string preset = {};               ///< of a size table: "eu38", "m50", "child116"
  std::string sex = {};                  ///< "female", "male", "child"; empty: the preset's, or female
  std::string pose = {};                 ///< "a", "t"; empty: a
  std::optional<double> arm_angle = {};  ///< degrees between a hanging arm and this one in pose a
  std::array<std::optional<double>, measure::kMeasureCount> measures_cm = {};  ///< in the order of Measure
  int triangles = 3300;
  friend bool operator==(const ProjectMannequin&, const ProjectMannequin&) = default;
};

/// A named place on a body, beside those that the program finds by itself, or in place of one of them: a
/// point of a triangle of a mesh file, or told from another landmark.
struct ProjectLandmark {
  std::string name;
  std::optional<int> triangle = {};                 ///< of the mesh, as the file counts, from 0
  std::optional<std::array<double, 3>> share = {};  ///< of its corners; without it its middle
  std::string near = {};                            ///< name of another landmark
  std::optional<Vec3> offset_mm = {};               ///< from that one
  /// The body's when the offset was told: on a taller body it is longer in proportion. Nothing: it stays.
  std::optional<double> body_height_mm = {};
  friend bool operator==(const ProjectLandmark&, const ProjectLandmark&) = default;
};

/// A shape that a body comes to: its mesh in another pose or size, with the same triangles.
struct ProjectKeyframe {
  double after_s = 1;  ///< since it began to move
  std::string file;    ///< read as the body's own
  std::optional<ProjectMannequin> mannequin;
  friend bool operator==(const ProjectKeyframe&, const ProjectKeyframe&) = default;
};

/// A body or an object: a mesh file beside the document, or the program's own mannequin.
struct ProjectBody {
  std::string id;
  std::string file;
  std::string unit;  ///< of the file: "m", "cm", "mm"; empty: guessed from its size
  std::string up;    ///< of the file: "y", "z"; empty: y
  std::optional<ProjectMannequin> mannequin;
  double friction = 0.4;
  double skin_offset_mm = 1;
  double restitution = 0;
  Vec3 translation;  ///< m, after scale and rotation
  Vec3 rotation;     ///< degrees about x, then y, then z
  double scale = 1;
  std::vector<ProjectLandmark> landmarks = {};
  std::vector<ProjectKeyframe> motion = {};
  friend bool operator==(const ProjectBody&, const ProjectBody&) = default;
};

/// Where an attachment leads: one of landmark, line, place.
struct ProjectGoal {
  std::string body;                  ///< id; empty: the first that stands
  std::string landmark;              ///< its name
  std::string line;                  ///< of core/body/measure/lines.h: "waist", "neckline", …
  std::optional<Vec3> place = {};    ///< m
  std::optional<double> up_mm = {};  ///< of a line: shifts it up, along limbs towards the trunk
  friend bool operator==(const ProjectGoal&, const ProjectGoal&) = default;
};

struct ProjectAttachment {
  std::string id, piece;
  std::vector<std::string> edges;  ///< no edges and no points: the whole piece
  std::string hold = {};           ///< "height", "place"; empty: height, or what `to` says
  double release_after_s = 1;      ///< negative: never
  std::vector<Vec2> points = {};   ///< mm
  std::optional<ProjectGoal> to = {};
  friend bool operator==(const ProjectAttachment&, const ProjectAttachment&) = default;
};

struct ProjectButtonPoint {
  std::string piece;
  Vec2 at;  ///< mm
  friend bool operator==(const ProjectButtonPoint&, const ProjectButtonPoint&) = default;
};

struct ProjectButton {
  std::string id;
  ProjectButtonPoint a, b;
  double distance_mm = 2;
  friend bool operator==(const ProjectButton&, const ProjectButton&) = default;
};

struct ProjectElastic {
  std::string id, piece;
  std::vector<std::string> lines;  ///< ids of edges or lines of the piece
  double factor = 1;
  double stiffness_n = 20;
  friend bool operator==(const ProjectElastic&, const ProjectElastic&) = default;
};

struct ProjectFold {
  std::string id, piece;
  std::vector<std::string> lines;
  double angle = 0;  ///< degrees
  double stiffness_mn = 20;
  friend bool operator==(const ProjectFold&, const ProjectFold&) = default;
};

struct ProjectCushion {
  std::string id;
  std::vector<std::string> pieces;
  double pressure_pa = 100;
  double volume_l = 0;  ///< 0: pumped
  friend bool operator==(const ProjectCushion&, const ProjectCushion&) = default;
};

/// Defaults stand in core/solver/constraints/air.h.
struct ProjectAir {
  double density_kg_m3 = 1.2;
  double drag_across = 1.2, drag_along = 0.05;
  Vec3 wind_m_s;
  friend bool operator==(const ProjectAir&, const ProjectAir&) = default;
};

/// What is not said is as in core/paper/settings.h.
struct ProjectPaper {
  std::optional<double> time_step_s, damping, reflection, load_n_m, clearance_mm;
  std::optional<int> passes;
  friend bool operator==(const ProjectPaper&, const ProjectPaper&) = default;
};

struct ProjectSettings {
  std::string solver = "toile";  ///< or "paper"
  double particle_distance_mm = 15;
  double time_step_s = 1.0 / 3000;
  double gravity = 9.81;  ///< m/s²
  double sew_time_s = 1;
  double settle_speed_mm_s = 5;
  double max_time_s = 15;
  int frame_interval_steps = 50;
  std::string start = "auto";  ///< or "sewn"
  bool ground = true;
  std::string mode = "drape";  ///< or "dynamic"
  std::string end;             ///< "settled", "time"; empty: settled in mode drape, time in mode dynamic
  std::optional<ProjectPaper> paper;  ///< of solver "paper"; none: the defaults
  std::optional<ProjectAir> air;      ///< none: still air in mode dynamic, none in mode drape
  friend bool operator==(const ProjectSettings&, const ProjectSettings&) = default;
};

struct Project {
  int toile = 1;  ///< version of the format
  std::string name;
  std::vector<ProjectPiece> pieces;
  std::string fabric;  ///< of the pieces that name none: id, or name in the library
  std::vector<ProjectFabric> fabrics;
  std::vector<ProjectSeam> seams;
  std::vector<ProjectBody> bodies;
  std::vector<ProjectAttachment> attachments;
  std::vector<ProjectButton> buttons;
  std::vector<ProjectElastic> elastics;
  std::vector<ProjectFold> folds;
  std::vector<ProjectCushion> cushions;
  ProjectSettings settings;
  friend bool operator==(const Project&, const Project&) = default;
};

/// Reads a document's text: at most 4 MiB, at most 32 levels deep. Keys that the format does not know, values
/// of the wrong type or out of range, and names that nothing bears are errors: json.*, project.*; `where` is
/// a JSON pointer, or line and column where the text is no JSON.
Result<Project> parse_project(std::string_view text);

/// The document's text; parse_project gives the same Project back.
std::string write_project(const Project& project);
/// The same on one line, without the line feed.
std::string write_project_line(const Project& project);

/// A document's text on one line, and what parse_project makes of it: where nothing is said, the default.
struct WrittenProject {
  std::string line;
  Project read_back;
};

/// For a document that was changed: says what parse_project would say, without parsing the text. Errors:
/// json.too_large, project.*.
Result<WrittenProject> write_checked(const Project& project);

}  // namespace toile::project
