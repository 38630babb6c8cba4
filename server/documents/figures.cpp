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

namespace toile {
namespace {

constexpr double kMetres = 1e-2;  // per cm

/// Hundredths of a centimetre, and of a millimetre: finer than any tape.
double cm(double metres) { return std::round(metres / kMetres * 100) / 100 + 0.0; }
double fine(double metres) { return std::round(metres * 1e5) / 1e5 + 0.0; }

JsonValue count_of(std::size_t count) { return static_cast<double>(count); }
JsonValue vector_json(Vec3 p) { return std::vector<JsonValue>{fine(p.x), fine(p.y), fine(p.z)}; }

JsonValue measures_json(const MeasureSet& set) {
  std::vector<JsonMember> out;
  for (int i = 0; i < kMeasureCount; ++i)
    if (set[measure_at(i)])
      out.push_back({std::string(measure_name(measure_at(i))), cm(*set[measure_at(i)])});
  return out;
}

JsonValue taken_json(Measure m, const TakenMeasure& taken, const std::optional<double>& asked, double floor) {
  std::vector<JsonValue> line;
  for (const Vec3& p : taken.line) line.push_back(vector_json(p + Vec3{0, floor, 0}));
  return std::vector<JsonMember>{{"name", std::string(measure_name(m))},
                                 {"girth", is_girth(m)},
                                 {"cm", cm(taken.value)},
                                 {"at_cm", cm(taken.height)},
                                 {"asked_cm", asked ? JsonValue(cm(*asked)) : JsonValue()},
                                 {"rule", std::string(measure_rule(m))},
                                 {"line", std::move(line)}};
}

JsonValue box_json(const PartBox& box) {
  std::vector<JsonValue> axes;
  for (const Vec3& axis : box.axis) axes.push_back(vector_json(axis));
  return std::vector<JsonMember>{{"part", std::string(name_of(box.part))},
                                 {"centre", vector_json(box.centre)},
                                 {"axes", std::move(axes)},
                                 {"half", vector_json(box.half)}};
}

/// The tape wants the floor at y = 0.
Result<BodyMeasures> measured(const TriangleMesh& mesh, double floor) {
  if (floor == 0) return measure_body(mesh);
  TriangleMesh standing = mesh;
  for (Vec3& p : standing.vertices) p.y -= floor;
  return measure_body(standing);
}

struct Parts {
  std::vector<JsonValue> measures, landmarks, boxes;
};

Status find_parts(const TriangleMesh& mesh, const MeasureSet& asked, double floor, Parts& parts) {
  const BodyFigure figure = TRY(find_figure(mesh));
  for (const Landmark& landmark : find_landmarks(mesh, figure)) {
    parts.landmarks.push_back(
        std::vector<JsonMember>{{"name", landmark.name}, {"place", vector_json(landmark.place)}});
  }
  for (const PartBox& box : part_boxes(mesh, figure)) parts.boxes.push_back(box_json(box));
  const BodyMeasures taken = TRY(measured(mesh, floor));
  for (int i = 0; i < kMeasureCount; ++i) {
    const Measure m = measure_at(i);
    if (taken[m]) parts.measures.push_back(taken_json(m, *taken[m], asked[m], floor));
  }
  return {};
}

/// By what the figure depends on: the mesh and what was asked for.
std::string key_of(const TriangleMesh& mesh, const MeasureSet& asked) {
  const std::string_view corners(reinterpret_cast<const char*>(mesh.triangles.data()),
                                 mesh.triangles.size() * sizeof(Tri));
  return hash_of(mesh.vertices) + hash_of(corners) + write_json_line(measures_json(asked));
}

/// Figures that were found before are not looked for again: that takes seconds on a scan, and a project is
/// looked at after every change of its pattern.
std::shared_ptr<const std::vector<JsonMember>> kept_figure(Documents& documents, const TriangleMesh& mesh,
                                                           const MeasureSet& asked) {
  const std::string key = key_of(mesh, asked);
  if (auto kept = documents.figures().find(key)) return kept;
  auto made = std::make_shared<const std::vector<JsonMember>>(figure_members(mesh, asked));
  documents.figures().keep(key, made, 1);
  return made;
}

/// The bodies alone, so that no pattern is read for them.
Result<DrapeInput> resolve_bodies(const Project& project, const ProjectFiles& files) {
  Project bodies;
  bodies.bodies = project.bodies;
  return resolve_project(bodies, files);
}

}  // namespace

std::string body_presets_json() {
  std::vector<JsonValue> presets, measures, formats;
  for (const BodyPreset& preset : body_presets()) {
    presets.push_back(std::vector<JsonMember>{
        {"name", std::string(preset.name)},
        {"sex", std::string(name_of(preset.sex))},
        {"measures_cm", measures_json(with_proportions(preset.sex, preset.measures()))}});
  }
  for (int i = 0; i < kMeasureCount; ++i) {
    const Measure m = measure_at(i);
    const auto [least, most] = measure_range_cm(m);
    measures.push_back(std::vector<JsonMember>{{"name", std::string(measure_name(m))},
                                               {"rule", std::string(measure_rule(m))},
                                               {"girth", is_girth(m)},
                                               {"least_cm", least},
                                               {"most_cm", most}});
  }
  for (const MeshFormat& format : mesh_formats()) {
    formats.push_back(
        std::vector<JsonMember>{{"name", std::string(format.name)}, {"ending", std::string(format.ending)}});
  }
  return write_json_line(std::vector<JsonMember>{{"presets", std::move(presets)},
                                                 {"measures", std::move(measures)},
                                                 {"formats", std::move(formats)}}) +
         "\n";
}

std::vector<JsonMember> figure_members(const TriangleMesh& mesh, const MeasureSet& asked) {
  const Aabb3 extent = bounding_box(mesh.vertices);
  Parts parts;
  JsonValue why;
  const Status found = find_parts(mesh, asked, extent.low.y, parts);
  if (!found) {
    why = std::vector<JsonMember>{{"code", found.error().code}, {"detail", found.error().message}};
  }
  return {{"stands", static_cast<bool>(found)},
          {"why", std::move(why)},
          {"vertices", count_of(mesh.vertices.size())},
          {"triangles", count_of(mesh.triangles.size())},
          {"low", vector_json(extent.low)},
          {"high", vector_json(extent.high)},
          {"measures", std::move(parts.measures)},
          {"landmarks", std::move(parts.landmarks)},
          {"boxes", std::move(parts.boxes)}};
}

/// With those of the document, and which these are.
static JsonValue landmarks_json(const ProjectBody& body, const Result<std::vector<Landmark>>& landmarks) {
  std::vector<JsonValue> out;
  if (!landmarks) return out;
  for (const Landmark& mark : *landmarks) {
    const bool own = std::any_of(body.landmarks.begin(), body.landmarks.end(),
                                 [&](const ProjectLandmark& one) { return one.name == mark.name; });
    std::vector<JsonMember> one{{"name", mark.name}, {"place", vector_json(mark.place)}};
    if (own) one.push_back({"own", true});
    out.emplace_back(std::move(one));
  }
  return out;
}

Result<std::string> asset_figure_json(Documents& documents, const RequestContext& context,
                                      const std::string& asset) {
  const auto read = TRY(documents.bodies().mesh(documents.store(), context, asset, {.unit_in_m = 1}));
  const TriangleMesh& raw = read->mesh;
  const Result<StandingBody> standing = stand_body(raw);
  std::vector<JsonMember> out;
  JsonValue stance;
  if (standing) {
    const BodyStance& s = standing->stance;
    stance = std::vector<JsonMember>{{"unit_in_m", s.unit_in_m},
                                     {"up", std::string(1, s.up)},
                                     {"upside_down", s.upside_down},
                                     {"turned_degrees", 90.0 * s.quarter_turns}};
  }
  out.push_back({"stance", std::move(stance)});
  for (JsonMember& member : figure_members(standing ? standing->mesh : raw, {}))
    out.push_back(std::move(member));
  return write_json_line(std::move(out)) + "\n";
}

Result<MadeBody> make_body(Documents& documents, const RequestContext& context, const JsonValue& wish,
                           const std::string& name) {
  const ProjectMannequin given = TRY(read_mannequin(wish, "/mannequin"));
  const Result<MannequinSettings> settings = mannequin_settings(given);
  if (!settings) return error_at("/mannequin", settings.error());
  const auto made = documents.mannequins().get(*settings);
  if (!made) return error_at("/mannequin", made.error());
  const std::string file = ending_of(name) == ".obj" ? name : name + ".obj";
  AssetRow asset = TRY(add_asset(documents, context, "body", file, obj_text((*made)->mesh, ObjDigits::kAll)));
  return MadeBody{std::move(asset), figure_members((*made)->mesh, settings->asked)};
}

Result<std::string> project_bodies_json(Documents& documents, const std::string& document,
                                        const ProjectFiles& files) {
  const Project project = TRY(parse_project(document));
  const DrapeInput input = TRY(resolve_bodies(project, files));
  BodyPlaces places(project, input.bodies);
  std::vector<JsonValue> bodies;
  for (std::size_t i = 0; i < project.bodies.size(); ++i) {
    const ProjectBody& given = project.bodies[i];
    MeasureSet asked;
    if (given.mannequin) {
      if (const Result<MannequinSettings> settings = mannequin_settings(*given.mannequin))
        asked = settings->asked;
    }
    std::vector<JsonMember> body{
        {"id", given.id},
        {"file", given.file.empty() ? JsonValue() : JsonValue(given.file)},
        {"mannequin", given.mannequin ? mannequin_json(*given.mannequin) : JsonValue()},
        {"friction", given.friction},
        {"skin_offset_mm", given.skin_offset_mm}};
    for (JsonMember member : *kept_figure(documents, input.bodies[i].mesh, asked)) {
      if (member.key == "landmarks" && !given.landmarks.empty())
        member.value = landmarks_json(given, places.landmarks_of(static_cast<Index>(i)));
      body.push_back(std::move(member));
    }
    bodies.emplace_back(std::move(body));
  }
  return write_json_line(std::vector<JsonMember>{{"bodies", std::move(bodies)}}) + "\n";
}

}  // namespace toile
