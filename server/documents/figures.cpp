#include "server/documents/figures.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "core/base/aabb.h"
#include "core/base/hash.h"
#include "core/body/mannequin/proportions.h"
#include "core/body/measure/segments.h"
#include "core/body/measure/stance.h"
#include "core/body/mesh_import/formats.h"
#include "core/geometry/obj_text.h"
#include "core/json/tree.h"
#include "core/project/bodies.h"
#include "core/project/resolve/body_places.h"
#include "server/documents/assets.h"
#include "server/store/file_name.h"

namespace toile::documents {
namespace {

constexpr double kMetres = 1e-2;  // per cm

/// Hundredths of a centimetre, and of a millimetre: finer than any tape.
double cm(double metres) { return std::round(metres / kMetres * 100) / 100 + 0.0; }
double to_hundredth_mm(double metres) { return std::round(metres * 1e5) / 1e5 + 0.0; }

json::JsonValue place_json(Vec3 p) {
  return std::vector<json::JsonValue>{to_hundredth_mm(p.x), to_hundredth_mm(p.y), to_hundredth_mm(p.z)};
}

json::JsonValue measures_json(const measure::MeasureSet& set) {
  std::vector<json::JsonMember> out;
  for (int i = 0; i < measure::kMeasureCount; ++i)
    if (set[measure::measure_at(i)])
      out.push_back(
          {std::string(measure::measure_name(measure::measure_at(i))), cm(*set[measure::measure_at(i)])});
  return out;
}

json::JsonValue taken_json(measure::Measure m, const measure::TakenMeasure& taken,
                           const std::optional<double>& asked, double floor) {
  std::vector<json::JsonValue> line;
  for (const Vec3& p : taken.line) line.push_back(place_json(p + Vec3{0, floor, 0}));
  return std::vector<json::JsonMember>{{"name", std::string(measure::measure_name(m))},
                                       {"girth", measure::is_girth(m)},
                                       {"cm", cm(taken.value)},
                                       {"at_cm", cm(taken.height)},
                                       {"asked_cm", asked ? json::JsonValue(cm(*asked)) : json::JsonValue()},
                                       {"rule", std::string(measure::measure_rule(m))},
                                       {"line", std::move(line)}};
}

json::JsonValue box_json(const measure::PartBox& box) {
  std::vector<json::JsonValue> axes;
  for (const Vec3& axis : box.axis) axes.push_back(place_json(axis));
  return std::vector<json::JsonMember>{{"part", std::string(measure::name_of(box.part))},
                                       {"centre", place_json(box.centre)},
                                       {"axes", std::move(axes)},
                                       {"half", place_json(box.half)}};
}

/// The tape wants the floor at y = 0.
Result<measure::BodyMeasures> measured(const geometry::TriangleMesh& mesh, double floor) {
  if (floor == 0) return measure::measure_body(mesh);
  geometry::TriangleMesh standing = mesh;
  for (Vec3& p : standing.vertices) p.y -= floor;
  return measure::measure_body(standing);
}

struct Parts {
  std::vector<json::JsonValue> measures, landmarks, boxes;
};

Status find_parts(const geometry::TriangleMesh& mesh, const measure::MeasureSet& asked, double floor,
                  Parts& parts) {
  const measure::BodyFigure figure = TRY(measure::find_figure(mesh));
  for (const measure::Landmark& landmark : measure::find_landmarks(mesh, figure)) {
    parts.landmarks.push_back(
        std::vector<json::JsonMember>{{"name", landmark.name}, {"place", place_json(landmark.place)}});
  }
  for (const measure::PartBox& box : measure::part_boxes(mesh, figure)) parts.boxes.push_back(box_json(box));
  const measure::BodyMeasures taken = TRY(measured(mesh, floor));
  for (int i = 0; i < measure::kMeasureCount; ++i) {
    const measure::Measure m = measure::measure_at(i);
    if (taken[m]) parts.measures.push_back(taken_json(m, *taken[m], asked[m], floor));
  }
  return {};
}

/// By what the figure depends on: the mesh and what was asked for.
std::string key_of(const geometry::TriangleMesh& mesh, const measure::MeasureSet& asked) {
  const std::string_view corners(reinterpret_cast<const char*>(mesh.triangles.data()),
                                 mesh.triangles.size() * sizeof(Tri));
  return hash_of(mesh.vertices) + hash_of(corners) + json::write_json_line(measures_json(asked));
}

/// Figures that were found before are not looked for again: that takes seconds on a scan, and a project is
/// looked at after every change of its pattern.
std::shared_ptr<const std::vector<json::JsonMember>> kept_figure(Documents& documents,
                                                                 const geometry::TriangleMesh& mesh,
                                                                 const measure::MeasureSet& asked) {
  const std::string key = key_of(mesh, asked);
  if (auto kept = documents.figures().find(key)) return kept;
  auto made = std::make_shared<const std::vector<json::JsonMember>>(figure_members(mesh, asked));
  documents.figures().keep(key, made, 1);
  return made;
}

/// The bodies alone, so that no pattern is read for them.
Result<drape::DrapeInput> resolve_bodies(const project::Project& project,
                                         const resolve::ProjectFiles& files) {
  project::Project bodies;
  bodies.bodies = project.bodies;
  return resolve::resolve_project(bodies, files);
}

}  // namespace

std::string body_presets_json() {
  std::vector<json::JsonValue> presets, measures, formats;
  for (const mannequin::BodyPreset& preset : mannequin::body_presets()) {
    presets.push_back(std::vector<json::JsonMember>{
        {"name", std::string(preset.name)},
        {"sex", std::string(project::name_of(preset.sex))},
        {"measures_cm", measures_json(mannequin::with_proportions(preset.sex, preset.measures()))}});
  }
  for (int i = 0; i < measure::kMeasureCount; ++i) {
    const measure::Measure m = measure::measure_at(i);
    const auto [least, most] = project::measure_range_cm(m);
    measures.push_back(std::vector<json::JsonMember>{{"name", std::string(measure::measure_name(m))},
                                                     {"rule", std::string(measure::measure_rule(m))},
                                                     {"girth", measure::is_girth(m)},
                                                     {"least_cm", least},
                                                     {"most_cm", most}});
  }
  for (const mesh_import::MeshFormat& format : mesh_import::mesh_formats()) {
    formats.push_back(std::vector<json::JsonMember>{{"name", std::string(format.name)},
                                                    {"ending", std::string(format.ending)}});
  }
  return json::write_json_line(std::vector<json::JsonMember>{{"presets", std::move(presets)},
                                                             {"measures", std::move(measures)},
                                                             {"formats", std::move(formats)}}) +
         "\n";
}

std::vector<json::JsonMember> figure_members(const geometry::TriangleMesh& mesh,
                                             const measure::MeasureSet& asked) {
  const Aabb3 extent = bounding_box(mesh.vertices);
  Parts parts;
  json::JsonValue why;
  const Status found = find_parts(mesh, asked, extent.low.y, parts);
  if (!found) {
    why = std::vector<json::JsonMember>{{"code", found.error().code}, {"detail", found.error().message}};
  }
  return {{"stands", static_cast<bool>(found)},
          {"why", std::move(why)},
          {"vertices", count_of(mesh.vertices.size())},
          {"triangles", count_of(mesh.triangles.size())},
          {"low", place_json(extent.low)},
          {"high", place_json(extent.high)},
          {"measures", std::move(parts.measures)},
          {"landmarks", std::move(parts.landmarks)},
          {"boxes", std::move(parts.boxes)}};
}

/// With those of the document, and which these are.
static json::JsonValue landmarks_json(const project::ProjectBody& body,
                                      const Result<std::vector<measure::Landmark>>& landmarks) {
  std::vector<json::JsonValue> out;
  if (!landmarks) return out;
  for (const measure::Landmark& mark : *landmarks) {
    const bool own = std::any_of(body.landmarks.begin(), body.landmarks.end(),
                                 [&](const project::ProjectLandmark& one) { return one.name == mark.name; });
    std::vector<json::JsonMember> one{{"name", mark.name}, {"place", place_json(mark.place)}};
    if (own) one.push_back({"own", true});
    out.emplace_back(std::move(one));
  }
  return out;
}

Result<std::string> asset_figure_json(Documents& documents, const store::RequestContext& context,
                                      const std::string& asset) {
  const auto read = TRY(documents.bodies().mesh(documents.store(), context, asset, {.unit_in_m = 1}));
  const geometry::TriangleMesh& raw = read->mesh;
  const Result<measure::StandingBody> standing = measure::stand_body(raw);
  std::vector<json::JsonMember> out;
  json::JsonValue stance;
  if (standing) {
    const measure::BodyStance& s = standing->stance;
    stance = std::vector<json::JsonMember>{{"unit_in_m", s.unit_in_m},
                                           {"up", std::string(1, s.up)},
                                           {"upside_down", s.upside_down},
                                           {"turned_degrees", 90.0 * s.quarter_turns}};
  }
  out.push_back({"stance", std::move(stance)});
  for (json::JsonMember& member : figure_members(standing ? standing->mesh : raw, {}))
    out.push_back(std::move(member));
  return json::write_json_line(std::move(out)) + "\n";
}

Result<MadeBody> make_body(Documents& documents, const store::RequestContext& context,
                           const json::JsonValue& wish, const std::string& name) {
  const project::ProjectMannequin given = TRY(project::read_mannequin(wish, "/mannequin"));
  const Result<mannequin::MannequinSettings> settings = project::mannequin_settings(given);
  if (!settings) return json::error_at("/mannequin", settings.error());
  const auto made = documents.mannequins().get(*settings);
  if (!made) return json::error_at("/mannequin", made.error());
  const std::string file = store::ending_of(name) == ".obj" ? name : name + ".obj";
  store::AssetRow asset = TRY(add_asset(documents, context, "body", file,
                                        geometry::obj_text((*made)->mesh, geometry::ObjDigits::kAll)));
  return MadeBody{std::move(asset), figure_members((*made)->mesh, settings->asked)};
}

Result<std::string> project_bodies_json(Documents& documents, const std::string& document,
                                        const resolve::ProjectFiles& files) {
  const project::Project project = TRY(project::parse_project(document));
  const drape::DrapeInput input = TRY(resolve_bodies(project, files));
  resolve::BodyPlaces places(project, input.bodies);
  std::vector<json::JsonValue> bodies;
  for (std::size_t i = 0; i < project.bodies.size(); ++i) {
    const project::ProjectBody& given = project.bodies[i];
    measure::MeasureSet asked;
    if (given.mannequin) {
      if (const Result<mannequin::MannequinSettings> settings = project::mannequin_settings(*given.mannequin))
        asked = settings->asked;
    }
    std::vector<json::JsonMember> body{
        {"id", given.id},
        {"file", given.file.empty() ? json::JsonValue() : json::JsonValue(given.file)},
        {"mannequin", given.mannequin ? project::mannequin_json(*given.mannequin) : json::JsonValue()},
        {"friction", given.friction},
        {"skin_offset_mm", given.skin_offset_mm}};
    for (json::JsonMember member : *kept_figure(documents, input.bodies[i].mesh, asked)) {
      if (member.key == "landmarks" && !given.landmarks.empty())
        member.value = landmarks_json(given, places.landmarks_of(static_cast<Index>(i)));
      body.push_back(std::move(member));
    }
    bodies.emplace_back(std::move(body));
  }
  return json::write_json_line(std::vector<json::JsonMember>{{"bodies", std::move(bodies)}}) + "\n";
}

}  // namespace toile::documents
