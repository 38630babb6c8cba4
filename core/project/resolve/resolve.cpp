#include "core/project/resolve/resolve.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "core/base/names.h"
#include "core/base/units.h"
#include "core/body/mannequin/mannequin.h"
#include "core/json/tree.h"
#include "core/pattern/validate.h"
#include "core/project/bodies.h"
#include "core/project/resolve/body_places.h"
#include "core/project/resolve/pieces.h"

namespace toile::resolve {
namespace {

template <typename T>
std::vector<std::string> ids_of(const std::vector<T>& things) {
  std::vector<std::string> ids;
  ids.reserve(things.size());
  for (const T& thing : things) ids.push_back(thing.id);
  return ids;
}

/// The first id that stands twice, as an error at the later place. An empty id stands for none.
Status check_unique(const std::vector<std::string>& ids, const std::string& list) {
  std::vector<std::pair<std::string_view, std::size_t>> sorted;
  for (std::size_t i = 0; i < ids.size(); ++i) sorted.emplace_back(ids[i], i);
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i].first.empty() || sorted[i].first != sorted[i - 1].first) continue;
    return Error{"project.duplicate_id",
                 "the id " + in_quotes(sorted[i].first) + " stands twice in this list",
                 json::pointer_to(json::pointer_to(list, sorted[i].second), "id")};
  }
  return {};
}

Status check_ids(const project::Project& project) {
  for (const auto& [ids, list] :
       {std::pair{ids_of(project.pieces), "/pieces"}, std::pair{ids_of(project.fabrics), "/fabrics"},
        std::pair{ids_of(project.seams), "/seams"}, std::pair{ids_of(project.bodies), "/bodies"},
        std::pair{ids_of(project.attachments), "/attachments"},
        std::pair{ids_of(project.buttons), "/buttons"}, std::pair{ids_of(project.elastics), "/elastics"},
        std::pair{ids_of(project.folds), "/folds"}, std::pair{ids_of(project.cushions), "/cushions"}}) {
    if (Status unique = check_unique(ids, list); !unique) return unique;
  }
  return {};
}

/// Index of `name`, or an error of `code` that says which names there are.
Result<Index> index_of(const std::string& name, const std::vector<std::string>& names, const char* thing,
                       const std::string& where) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<Index>(found - names.begin());
  return Error{std::string("project.unknown_") + thing,
               std::string("there is no ") + thing + " " + in_quotes(name) + "; " + advice(name, names),
               where};
}

Vec3 radians(Vec3 degrees) {
  return {radians_from_degrees(degrees.x), radians_from_degrees(degrees.y), radians_from_degrees(degrees.z)};
}

Result<material::Fabric> fabric_of(const project::ProjectFabric& given, const std::string& where) {
  // A negative eigenvalue of the stiffness would let the cloth gain energy by stretching.
  if (given.stretch_coupling_n_m * given.stretch_coupling_n_m >=
      given.stretch_warp_n_m * given.stretch_weft_n_m) {
    return Error{"project.unstable_fabric",
                 "stretch_coupling_n_m must be less than the root of stretch_warp_n_m times stretch_weft_n_m",
                 json::pointer_to(where, "stretch_coupling_n_m")};
  }
  constexpr double kKilograms = 1e-3, kNewtonMetres = 1e-6;
  material::Fabric fabric;
  fabric.id = given.id;
  fabric.name = given.name;
  fabric.areal_mass = given.areal_mass_g_m2 * kKilograms;
  fabric.stretch_warp = given.stretch_warp_n_m;
  fabric.stretch_weft = given.stretch_weft_n_m;
  fabric.stretch_coupling = given.stretch_coupling_n_m;
  fabric.stretch_shear = given.stretch_shear_n_m;
  fabric.limit_warp = given.limit_warp_percent / 100;
  fabric.limit_weft = given.limit_weft_percent / 100;
  fabric.limit_shear = given.limit_shear_rad;
  fabric.bend_warp = given.bend_warp_un_m * kNewtonMetres;
  fabric.bend_weft = given.bend_weft_un_m * kNewtonMetres;
  fabric.bend_bias = given.bend_bias_un_m * kNewtonMetres;
  fabric.thickness = metres_from_mm(given.thickness_mm);
  fabric.friction = given.friction;
  std::copy(given.colour.begin(), given.colour.end(), fabric.colour);
  return fabric;
}

/// A fabric more for each piece that has its own. REQUIRES `input` with the project's fabrics.
Status add_own_fabrics(const project::Project& project, drape::DrapeInput& input) {
  for (std::size_t i = 0; i < project.pieces.size(); ++i) {
    const project::ProjectPiece& piece = project.pieces[i];
    if (!piece.physical) continue;
    const project::ProjectFabric& common =
        project.fabrics[static_cast<std::size_t>(input.fabric_of_panel[i])];
    Result<material::Fabric> own = fabric_of(with_physical(common, *piece.physical),
                                             json::pointer_to(json::pointer_to("/pieces", i), "physical"));
    if (!own) return own.error();
    input.fabric_of_panel[i] = static_cast<Index>(input.fabrics.size());
    input.fabrics.push_back(std::move(*own));
  }
  return {};
}

solver::constraints::AirDrag air_of(const project::ProjectAir& given) {
  return {given.density_kg_m3, given.drag_across, given.drag_along, given.wind_m_s};
}

drape::DrapeSettings settings_of(const project::ProjectSettings& given) {
  drape::DrapeSettings settings;
  settings.particle_distance = metres_from_mm(given.particle_distance_mm);
  settings.time_step = given.time_step_s;
  settings.gravity = given.gravity;
  settings.sew_time = given.sew_time_s;
  settings.settle_speed = metres_from_mm(given.settle_speed_mm_s);
  settings.max_time = given.max_time_s;
  settings.frame_interval = given.frame_interval_steps;
  settings.dress = given.start == "auto";
  settings.ground = given.ground;
  const bool dynamic = given.mode == "dynamic";
  settings.mode = dynamic ? drape::DrapeMode::kDynamic : drape::DrapeMode::kDrape;
  settings.until_settled = given.end.empty() ? !dynamic : given.end == "settled";
  const project::ProjectAir still;
  if (given.air || dynamic) settings.air = air_of(given.air.value_or(still));
  return settings;
}

/// `p` turned about the fixed axes x, then y, then z.
Vec3 turned(Vec3 p, Vec3 angles) {
  const auto turn = [](double& a, double& b, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    const double first = c * a - s * b;
    b = s * a + c * b;
    a = first;
  };
  turn(p.y, p.z, angles.x);
  turn(p.z, p.x, angles.y);
  turn(p.x, p.y, angles.z);
  return p;
}

Result<mesh_import::RepairedMesh> mesh_of(const project::ProjectBody& given, OpenedFiles& files,
                                          const std::string& where) {
  if (given.mannequin) {
    Result<geometry::TriangleMesh> mesh = files.mannequin(*given.mannequin);
    if (!mesh) return json::error_at(json::pointer_to(where, "mannequin"), mesh.error());
    return mesh_import::RepairedMesh{std::move(*mesh), {}};
  }
  const std::string place = json::pointer_to(where, "file");
  if (Status name = check_file_name(given.file); !name) return json::error_at(place, name.error());
  Result<mesh_import::RepairedMesh> mesh = files.body_mesh(given);
  if (!mesh) return json::error_at(place, mesh.error());
  return mesh;
}

bool is_near(Vec3 p) {
  constexpr double kFar = 1000;  // m; crossings are counted on a grid that ends at two kilometres
  return std::abs(p.x) <= kFar && std::abs(p.y) <= kFar && std::abs(p.z) <= kFar;
}

Result<body::Body> body_of(const project::ProjectBody& given, OpenedFiles& files, const std::string& where) {
  mesh_import::RepairedMesh mesh = TRY(mesh_of(given, files, where));
  body::Body body;
  body.id = given.id;
  body.mesh = std::move(mesh.mesh);
  body.friction = given.friction;
  body.skin_offset = metres_from_mm(given.skin_offset_mm);
  body.restitution = given.restitution;
  body.notes = mesh_import::repair_words(mesh.repairs);
  const Vec3 angles = radians(given.rotation);
  for (Vec3& p : body.mesh.vertices) {
    p = turned(p * given.scale, angles) + given.translation;
    if (is_near(p)) continue;
    return Error{"project.body_too_far",
                 "body " + in_quotes(given.id) +
                     " reaches more than a kilometre away; look at its unit, scale and translation",
                 where};
  }
  return body;
}

/// Looks up pieces and edges by name.
class Names {
 public:
  explicit Names(const pattern::Pattern& pattern) : panels_(ids_of(pattern.panels)) {
    for (const pattern::Panel& panel : pattern.panels) {
      std::vector<std::string>& ids = edges_.emplace_back();
      for (const pattern::PanelEdge* edge : pattern::edges_of(panel)) ids.push_back(edge->id);
      lines_.push_back(ids_of(panel.lines));
    }
  }

  Result<Index> panel(const std::string& name, const std::string& where) const {
    return index_of(name, panels_, "piece", where);
  }
  Result<Index> edge(Index panel, const std::string& name, const std::string& where) const {
    Result<Index> found = index_of(name, edges_[static_cast<std::size_t>(panel)], "edge", where);
    if (found) return found;
    return in_piece(panel, found.error());
  }
  Result<Index> line(Index panel, const std::string& name, const std::string& where) const {
    Result<Index> found = index_of(name, lines_[static_cast<std::size_t>(panel)], "line", where);
    if (found) return found;
    return in_piece(panel, found.error());
  }
  /// Whether the panel has an edge of that name.
  bool has_edge(Index panel, const std::string& name) const {
    const std::vector<std::string>& ids = edges_[static_cast<std::size_t>(panel)];
    return std::find(ids.begin(), ids.end(), name) != ids.end();
  }

 private:
  Error in_piece(Index panel, Error error) const {
    error.message =
        "piece " + in_quotes(panels_[static_cast<std::size_t>(panel)]) + ": " + std::move(error.message);
    return error;
  }

  std::vector<std::string> panels_;
  std::vector<std::vector<std::string>> edges_;  // of each panel, as SeamEdge::edge counts
  std::vector<std::vector<std::string>> lines_;
};

Result<std::vector<pattern::SeamEdge>> series_of(const std::vector<project::ProjectSeamEdge>& given,
                                                 const Names& names, const std::string& where) {
  std::vector<pattern::SeamEdge> series;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const std::string place = json::pointer_to(where, i);
    const Index panel = TRY(names.panel(given[i].piece, json::pointer_to(place, "piece")));
    const Index edge = TRY(names.edge(panel, given[i].edge, json::pointer_to(place, "edge")));
    series.push_back({panel, edge, given[i].reversed, given[i].from, given[i].to});
  }
  return series;
}

Result<pattern::Seam> seam_of(const project::ProjectSeam& given, const Names& names,
                              const std::string& where) {
  std::vector<pattern::SeamEdge> a = TRY(series_of(given.a, names, json::pointer_to(where, "a")));
  std::vector<pattern::SeamEdge> b = TRY(series_of(given.b, names, json::pointer_to(where, "b")));
  return pattern::Seam{given.id, std::move(a), std::move(b), given.same_direction};
}

Result<sewing::Attachment> attachment_of(const project::ProjectAttachment& given, const Names& names,
                                         BodyPlaces& places, const std::string& where) {
  const Index panel = TRY(names.panel(given.piece, json::pointer_to(where, "piece")));
  sewing::Attachment attachment;
  attachment.id = given.id;
  attachment.panel = panel;
  for (std::size_t i = 0; i < given.edges.size(); ++i) {
    const Index edge =
        TRY(names.edge(panel, given.edges[i], json::pointer_to(json::pointer_to(where, "edges"), i)));
    attachment.edges.push_back(edge);
  }
  for (const Vec2 p : given.points) attachment.points.push_back({metres_from_mm(p.x), metres_from_mm(p.y)});
  attachment.release_after = given.release_after_s;
  attachment.hold =
      given.hold == "place" ? sewing::Attachment::Hold::kPlace : sewing::Attachment::Hold::kHeight;
  if (!given.to) return attachment;
  if (!given.hold.empty()) {
    return Error{"project.two_ways", "only one of \"hold\" or \"to\" may stand here",
                 json::pointer_to(where, "hold")};
  }
  std::vector<Vec3> goal = TRY(places.goal(*given.to, json::pointer_to(where, "to")));
  if (goal.size() > 1 && given.edges.empty() && given.points.empty()) {
    return Error{"project.attached_whole",
                 "a whole piece cannot lie on a line; name the edges or points that do", where};
  }
  attachment.hold = sewing::Attachment::Hold::kGoal;
  attachment.goal = std::move(goal);
  return attachment;
}

Result<sewing::PanelPoint> point_of(const project::ProjectButtonPoint& given, const Names& names,
                                    const std::string& where) {
  const Index panel = TRY(names.panel(given.piece, json::pointer_to(where, "piece")));
  return sewing::PanelPoint{panel, {metres_from_mm(given.at.x), metres_from_mm(given.at.y)}};
}

Result<sewing::Button> button_of(const project::ProjectButton& given, const Names& names,
                                 const std::string& where) {
  const sewing::PanelPoint a = TRY(point_of(given.a, names, json::pointer_to(where, "a")));
  const sewing::PanelPoint b = TRY(point_of(given.b, names, json::pointer_to(where, "b")));
  return sewing::Button{given.id, a, b, metres_from_mm(given.distance_mm)};
}

Result<sewing::Elastic> elastic_of(const project::ProjectElastic& given, const Names& names,
                                   const std::string& where) {
  const Index panel = TRY(names.panel(given.piece, json::pointer_to(where, "piece")));
  sewing::Elastic elastic{given.id, panel, {}, {}, given.factor, given.stiffness_n};
  for (std::size_t i = 0; i < given.lines.size(); ++i) {
    const std::string place = json::pointer_to(json::pointer_to(where, "lines"), i);
    const bool edge = names.has_edge(panel, given.lines[i]);
    const Result<Index> found =
        edge ? names.edge(panel, given.lines[i], place) : names.line(panel, given.lines[i], place);
    if (!found) return found.error();
    (edge ? elastic.edges : elastic.lines).push_back(*found);
  }
  return elastic;
}

Result<sewing::Crease> crease_of(const project::ProjectFold& given, const Names& names,
                                 const std::string& where) {
  const Index panel = TRY(names.panel(given.piece, json::pointer_to(where, "piece")));
  constexpr double kNewtons = 1e-3;
  sewing::Crease crease{
      given.id, panel, {}, radians_from_degrees(given.angle), given.stiffness_mn * kNewtons};
  for (std::size_t i = 0; i < given.lines.size(); ++i) {
    const Index line =
        TRY(names.line(panel, given.lines[i], json::pointer_to(json::pointer_to(where, "lines"), i)));
    crease.lines.push_back(line);
  }
  return crease;
}

Result<sewing::Cushion> cushion_of(const project::ProjectCushion& given, const Names& names,
                                   const std::string& where) {
  constexpr double kCubicMetres = 1e-3;
  sewing::Cushion cushion{given.id, {}, given.pressure_pa, given.volume_l * kCubicMetres};
  for (std::size_t i = 0; i < given.pieces.size(); ++i) {
    const Index panel =
        TRY(names.panel(given.pieces[i], json::pointer_to(json::pointer_to(where, "pieces"), i)));
    cushion.panels.push_back(panel);
  }
  return cushion;
}

/// Appends make(thing, pointer of the thing) for each of `things`; stops at the first error.
template <typename Given, typename Made, typename Make>
Status make_all(const std::vector<Given>& things, const std::string& list, std::vector<Made>& made,
                Make make) {
  for (std::size_t i = 0; i < things.size(); ++i) {
    auto result = TRY(make(things[i], json::pointer_to(list, i)));
    made.push_back(std::move(result));
  }
  return {};
}

Status add_notions(const project::Project& project, const Names& names, sewing::Notions& notions) {
  const auto named = [&](auto make) {
    return [&names, make](const auto& given, const std::string& at) { return make(given, names, at); };
  };
  TRY(make_all(project.buttons, "/buttons", notions.buttons, named(button_of)));
  TRY(make_all(project.elastics, "/elastics", notions.elastics, named(elastic_of)));
  TRY(make_all(project.folds, "/folds", notions.creases, named(crease_of)));
  return make_all(project.cushions, "/cushions", notions.cushions, named(cushion_of));
}

/// Placements and attachments: what may be told by a body. REQUIRES `input` with panels and bodies.
Status add_told_by_bodies(const project::Project& project, const Names& names, drape::DrapeInput& input) {
  BodyPlaces places(project, input.bodies);
  TRY(places.check_landmarks());
  for (std::size_t i = 0; i < project.pieces.size(); ++i) {
    const std::string where = json::pointer_to(json::pointer_to("/pieces", i), "placement");
    Result<sewing::Placement> placement =
        places.placement(project.pieces[i].placement, input.pattern.panels[i], where);
    if (!placement) return placement.error();
    input.placements.push_back(*placement);
  }
  const auto hold = [&](const project::ProjectAttachment& given, const std::string& at) {
    return attachment_of(given, names, places, at);
  };
  return make_all(project.attachments, "/attachments", input.attachments, hold);
}

}  // namespace

Status check_file_name(const std::string& name) {
  const auto refused = [&](const char* reason) {
    return Error{"project.path", "the file name " + in_quotes(name) + " " + reason, ""};
  };
  if (name.empty()) return refused("is empty");
  if (std::any_of(name.begin(), name.end(), [](char c) { return c >= 0 && c < 0x20; })) {
    return refused("has a control character in it");
  }
  if (name.find('\\') != std::string::npos) return refused("has a \\ in it; write / between folders");
  if (name.front() == '/' || (name.size() > 1 && name[1] == ':')) {
    return refused("is absolute; a document names files in its own folder or below");
  }
  const std::filesystem::path path(name);
  for (const std::filesystem::path& part : path) {
    if (part == "..") return refused("leaves the document's folder");
  }
  return {};
}

Result<drape::DrapeInput> resolve_project(const project::Project& project, OpenedFiles& files) {
  TRY(check_ids(project));
  drape::DrapeInput input;
  input.name = project.name;
  input.settings = settings_of(project.settings);

  const std::vector<std::string> fabrics = ids_of(project.fabrics);
  for (std::size_t i = 0; i < project.pieces.size(); ++i) {
    const project::ProjectPiece& piece = project.pieces[i];
    const Result<Index> fabric =
        index_of(piece.fabric, fabrics, "fabric", json::pointer_to(json::pointer_to("/pieces", i), "fabric"));
    if (!fabric) return fabric.error();
    input.fabric_of_panel.push_back(*fabric);
  }
  TRY(make_all(project.fabrics, "/fabrics", input.fabrics, fabric_of));
  TRY(add_own_fabrics(project, input));

  std::vector<pattern::Panel> panels = TRY(panels_of(project.pieces, files));
  input.pattern.panels = std::move(panels);
  const Names names(input.pattern);
  const auto seam = [&](const project::ProjectSeam& given, const std::string& at) {
    return seam_of(given, names, at);
  };
  TRY(make_all(project.seams, "/seams", input.pattern.seams, seam));
  if (Status valid = pattern::validate(input.pattern); !valid) {
    return json::error_at("/seams", valid.error());  // each piece by itself has been found valid
  }
  TRY(add_notions(project, names, input.notions));
  TRY(follow_used_lines(input.notions, input.pattern));
  const auto body = [&](const project::ProjectBody& given, const std::string& at) {
    return body_of(given, files, at);
  };
  TRY(make_all(project.bodies, "/bodies", input.bodies, body));
  TRY(add_told_by_bodies(project, names, input));
  return input;
}

Result<drape::DrapeInput> resolve_project(const project::Project& project, const ProjectFiles& files) {
  OpenedFiles opened(files);
  return resolve_project(project, opened);
}

Result<ResolvedProject> read_project(const std::filesystem::path& path,
                                     const mesh_import::MeshImporter& importer) {
  const auto in_document = [&](const Error& error) {
    return json::error_at(clipped(path.string(), 300), error);
  };
  const std::string text = TRY(read_project_text(path));
  Result<project::Project> project = project::parse_project(text);
  if (!project) return in_document(project.error());
  ProjectFiles files = files_in(path.parent_path(), importer);
  Result<drape::DrapeInput> input = resolve_project(*project, files);
  if (!input) return in_document(input.error());
  return ResolvedProject{std::move(*project), std::move(*input), std::move(files), path};
}

Result<image::Textures> read_textures(const ResolvedProject& read) {
  Result<image::Textures> textures = read_textures(read.project, read.input.pattern, read.files);
  if (!textures) return json::error_at(clipped(read.path.string(), 300), textures.error());
  return textures;
}

}  // namespace toile::resolve
