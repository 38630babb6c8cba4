#include "core/project/bodies.h"

#include <vector>

#include "core/base/names.h"
#include "core/base/units.h"
#include "core/body/mannequin/proportions.h"
#include "core/json/fields/reader.h"
#include "core/json/fields/writer.h"
#include "core/project/fields.h"

namespace toile {
namespace {

constexpr double kMetres = 1e-2;  // per cm
constexpr const char* kSexNames[] = {"female", "male", "child"};

Error unknown_preset(const std::string& name) {
  std::vector<std::string> names;
  for (const BodyPreset& preset : body_presets()) names.emplace_back(preset.name);
  return {"project.unknown_preset", "there is no preset " + in_quotes(name) + "; " + advice(name, names),
          "/preset"};
}

template <typename T>
Result<T> read_alone(const JsonValue& object, const std::string& where) {
  std::optional<Error> error;
  T out;
  fields::read(fields::FieldPlace{object, where, error}, out, fields::kAnything);
  if (error) return *std::move(error);
  return out;
}

MeasureSet first_measures() {
  MeasureSet set;
  set[Measure::kHeight] = 170 * kMetres;
  set[Measure::kBust] = 90 * kMetres;
  set[Measure::kWaist] = 72 * kMetres;
  set[Measure::kHip] = 96 * kMetres;
  return set;
}

}  // namespace

const char* name_of(Sex sex) { return kSexNames[static_cast<int>(sex)]; }

Result<MannequinSettings> mannequin_settings(const ProjectMannequin& given) {
  MannequinSettings settings;
  if (!given.preset.empty()) {
    const BodyPreset* preset = find_preset(given.preset);
    if (!preset) return unknown_preset(given.preset);
    settings.sex = preset->sex;
    settings.asked = preset->measures();
  } else if (given.sex.empty()) {
    settings.asked = first_measures();
  }
  for (int i = 0; i < 3; ++i)
    if (given.sex == kSexNames[i]) settings.sex = static_cast<Sex>(i);
  for (int i = 0; i < kMeasureCount; ++i)
    if (const auto& cm = given.measures_cm[static_cast<std::size_t>(i)])
      settings.asked[measure_at(i)] = *cm * kMetres;
  if (given.arm_angle) settings.arm_angle = radians_from_degrees(*given.arm_angle);
  if (given.pose == "t") settings.arm_angle = kQuarterTurn;
  settings.triangle_count = given.triangles;
  return settings;
}

Result<ProjectMannequin> read_mannequin(const JsonValue& object, const std::string& where) {
  return read_alone<ProjectMannequin>(object, where);
}

Result<ProjectBody> read_body(const JsonValue& object, const std::string& where) {
  return read_alone<ProjectBody>(object, where);
}

JsonValue mannequin_json(const ProjectMannequin& mannequin) {
  ProjectMannequin written = mannequin;
  return fields::json_of(written);
}

Project without_bodies(Project project) {
  project.bodies.clear();
  for (ProjectPiece& piece : project.pieces) {
    if (!piece.placement.on_box && !piece.placement.around) continue;
    piece.placement = {};
    piece.placement.rigid.emplace();
  }
  std::erase_if(project.attachments, [](const ProjectAttachment& a) { return a.to.has_value(); });
  return project;
}

std::pair<double, double> measure_range_cm(Measure m) {
  const fields::Range range = fields::kMeasureRange_cm[static_cast<int>(m)];
  return {range.least, range.most};
}

}  // namespace toile
