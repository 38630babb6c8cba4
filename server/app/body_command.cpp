#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>

#include "core/base/text.h"
#include "core/body/mannequin/mannequin.h"
#include "core/body/mannequin/proportions.h"
#include "core/body/measure/stance.h"
#include "core/exports/write_obj.h"
#include "core/json/tree.h"
#include "core/project/bodies.h"
#include "server/app/commands.h"
#include "server/app/console.h"
#include "server/app/mesh_reader.h"

namespace toile::app {
namespace {

constexpr double kMetres = 1e-2;  // per cm

/// Centimetres with a tenth of a millimetre.
double cm(double metres) { return std::round(metres / kMetres * 100) / 100; }

std::vector<json::JsonMember> measures_json(const measure::BodyMeasures& taken,
                                            const measure::MeasureSet& asked) {
  std::vector<json::JsonMember> out;
  for (int i = 0; i < measure::kMeasureCount; ++i) {
    const measure::Measure m = measure::measure_at(i);
    if (!taken[m]) continue;
    std::vector<json::JsonMember> one{{"cm", cm(taken[m]->value)}};
    if (asked[m]) one.push_back({"asked_cm", cm(*asked[m])});
    one.push_back({"at_cm", cm(taken[m]->height)});
    one.push_back({"rule", std::string(measure::measure_rule(m))});
    out.push_back({std::string(measure::measure_name(m)), one});
  }
  return out;
}

void print_measures(const measure::BodyMeasures& taken, const measure::MeasureSet& asked) {
  for (int i = 0; i < measure::kMeasureCount; ++i) {
    const measure::Measure m = measure::measure_at(i);
    if (!taken[m]) continue;
    const std::string wanted = asked[m] ? fixed_text(cm(*asked[m]), 1) : "-";
    std::printf("  %-15s %7.1f cm  asked %6s  at %6.1f cm\n", std::string(measure::measure_name(m)).c_str(),
                taken[m]->value / kMetres, wanted.c_str(), taken[m]->height / kMetres);
  }
}

/// What a document would say, so that both make the same body.
project::ProjectMannequin document_of(const BodyMakeOptions& options) {
  project::ProjectMannequin out;
  out.preset = options.preset;
  out.sex = options.sex.empty() && options.preset.empty() ? "female" : options.sex;
  out.pose = options.pose;
  out.arm_angle = options.arm_angle;
  out.measures_cm = options.measures_cm;
  out.triangles = options.triangles;
  return out;
}

/// A mesh is read by the ending of its name, so that another one would lie.
bool may_be_obj(const std::string& file) {
  const std::string ending = lower_case(std::filesystem::path(file).extension().string());
  return ending.empty() || ending == ".obj";
}

}  // namespace

ExitCode body_make_command(const BodyMakeOptions& options) {
  if (!may_be_obj(options.out))
    return fail(
        {"export.format", "a mannequin is written as OBJ; give its file the ending .obj", options.out},
        options.json);
  const Result<mannequin::MannequinSettings> settings = project::mannequin_settings(document_of(options));
  if (!settings) return fail(settings.error(), options.json);
  const Result<mannequin::Mannequin> made = mannequin::make_mannequin(*settings);
  if (!made) return fail(made.error(), options.json);
  const geometry::TriangleMesh& mesh = made->mesh;
  if (Status written = exports::write_obj(options.out, mesh.vertices, mesh.triangles); !written) {
    return fail(written.error(), options.json);
  }
  const std::size_t vertices = mesh.vertices.size(), triangles = mesh.triangles.size();
  if (options.json) {
    const std::vector<json::JsonMember> out{{"file", options.out},
                                            {"sex", std::string(project::name_of(settings->sex))},
                                            {"pose", options.pose},
                                            {"vertices", static_cast<double>(vertices)},
                                            {"triangles", static_cast<double>(triangles)},
                                            {"measures", measures_json(made->measures, settings->asked)}};
    std::printf("%s", json::write_json(out).c_str());
  } else {
    std::printf("%s: %zu vertices, %zu triangles, metres\n", options.out.c_str(), vertices, triangles);
    print_measures(made->measures, settings->asked);
  }
  return kDone;
}

ExitCode body_measure_command(const BodyMeasureOptions& options) {
  Result<mesh_import::RepairedMesh> file = own_mesh_importer().file(options.file, {.unit_in_m = 1});
  if (!file) return fail(file.error(), options.json);
  const Result<measure::StandingBody> body = measure::stand_body(std::move(file->mesh));
  if (!body) return fail(placed_at(body.error(), options.file), options.json);
  const Result<measure::BodyMeasures> taken = measure::measure_body(body->mesh);
  if (!taken) return fail(placed_at(taken.error(), options.file), options.json);
  const measure::BodyStance& s = body->stance;
  const std::vector<std::string> notes = mesh_import::repair_words(file->repairs);
  if (options.json) {
    const std::vector<json::JsonMember> out{
        {"file", options.file},
        {"triangles", static_cast<double>(body->mesh.triangles.size())},
        {"unit_in_m", s.unit_in_m},
        {"up", std::string(1, s.up)},
        {"upside_down", s.upside_down},
        {"turned_degrees", 90.0 * s.quarter_turns},
        {"notes", std::vector<json::JsonValue>(notes.begin(), notes.end())},
        {"measures", measures_json(*taken, {})}};
    std::printf("%s", json::write_json(out).c_str());
  } else {
    std::printf("%s: %zu triangles, unit %g m, %c up%s, turned by %d°\n", options.file.c_str(),
                body->mesh.triangles.size(), s.unit_in_m, s.up, s.upside_down ? ", upside down" : "",
                90 * s.quarter_turns);
    for (const std::string& note : notes) std::printf("note: %s\n", note.c_str());
    print_measures(*taken, {});
  }
  return kDone;
}

ExitCode body_presets_command(const BodyPresetsOptions& options) {
  std::vector<json::JsonValue> list;
  for (const mannequin::BodyPreset& p : mannequin::body_presets()) {
    if (!options.json) {
      std::printf("%-9s %-7s height %5.1f  bust %5.1f  waist %5.1f  hip %5.1f\n", std::string(p.name).c_str(),
                  project::name_of(p.sex), p.height / kMetres, p.bust / kMetres, p.waist / kMetres,
                  p.hip / kMetres);
    }
    list.push_back(std::vector<json::JsonMember>{{"name", std::string(p.name)},
                                                 {"sex", std::string(project::name_of(p.sex))},
                                                 {"height_cm", cm(p.height)},
                                                 {"bust_cm", cm(p.bust)},
                                                 {"waist_cm", cm(p.waist)},
                                                 {"hip_cm", cm(p.hip)}});
  }
  if (options.json)
    std::printf("%s", json::write_json(std::vector<json::JsonMember>{{"presets", list}}).c_str());
  return kDone;
}

}  // namespace toile::app
