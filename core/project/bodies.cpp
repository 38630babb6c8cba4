#include "core/project/bodies.h"

#include <vector>

#include "core/base/names.h"
#include "core/base/units.h"
#include "core/body/mannequin/proportions.h"
#include "core/json/fields/reader.h"
#include "core/json/fields/writer.h"
#include "core/project/fields.h"

namespace toile::project {
namespace {

constexpr double kMetres = 1e-2;  // per cm
constexpr const char* kSexNames[] = {"female", "male", "child"};

Error unknown_preset(const std::string& name) {
  std::vector<std::string> names;
  for (const mannequin::BodyPreset& preset : mannequin::body_presets()) names.emplace_back(preset.name);
  return {"project.unknown_preset", "there is no preset " + in_quotes(name) + "; " + advice(name, names),
          "/preset"};
}

template <typename T>
Result<T> read_alone(const json::JsonValue& object, const std::string& where) {
  std::optional<Error> error;
  T out;
  fields::read(fields::FieldPlace{object, where, error}, out, fields::kAnything);
  if (error) return *std::move(error);
  return out;
}

measure::MeasureSet first_measures() {
  measure::MeasureSet set;
  set[measure::Measure::kHeight] = 170 * kMetres;
  set[measure::Measure::kBust] = 90 * kMetres;
  set[measure::Measure::kWaist] = 72 * kMetres;
  set[measure::Measure::kHip] = 96 * kMetres;
  return set;
}

}  // namespace

const char* name_of(mannequin::Sex sex) { return kSexNames[static_cast<int>(sex)]; }

Result<mannequin::MannequinSettings> mannequin_settings(const ProjectMannequin& given) {
  mannequin::MannequinSettings settings;
  if (!given.preset.empty()) {
    const mannequin::BodyPreset* preset = mannequin::find_preset(given.preset);
    if (!preset) return unknown_preset(given.preset);
    settings.sex = preset->sex;
    settings.asked = preset->measures();
  } else if (given.sex.empty()) {
    settings.asked = first_measures();
  }
  for (int i = 0; i < 3; ++i)
    if (given.sex == kSexNames[i]) settings.sex = static_cast<mannequin::Sex>(i);
  for (int i = 0; i < measure::kMeasureCount; ++i)
    if (const auto& cm = given.measures_cm[static_cast<std::size_t>(i)])
      settings.asked[measure::measure_at(i)] = *cm * kMetres;
  if (given.arm_angle) settings.arm_angle = radians_from_degrees(*given.arm_angle);
  if (given.pose == "t") settings.arm_angle = mannequin::kQuarterTurn;
  settings.triangle_count = given.triangles;
  return settings;
}

// It turns about the upright axis last, and a document about z last; after half a turn about z the one is the
// other, backwards.
void stand_up(ProjectBody& body, const measure::BodyStance& stance) {
  body.unit = stance.unit_in_m == 1e-2 ? "cm" : stance.unit_in_m == 1e-3 ? "mm" : "m";
  if (stance.unit_in_m == 0.1) body.scale = 0.1;
  body.up = std::string(1, stance.up);
  const double turn = 90.0 * stance.quarter_turns;
  body.rotation = stance.upside_down ? Vec3{0, -turn, 180} : Vec3{0, turn, 0};
}

std::string turned_words(const measure::BodyStance& stance) {
  std::string words;
  const auto add = [&](const std::string& more) { words += (words.empty() ? "" : ", ") + more; };
  if (stance.up == 'z') add("z is up in its file, and it is set upright");
  if (stance.upside_down) add("its head was below, and it is turned over");
  if (stance.quarter_turns != 0)
    add(std::string("it looked ") + (stance.quarter_turns == 2 ? "to the back" : "to the side") +
        ", and is turned by " + std::to_string(90 * stance.quarter_turns) + "° to look to the front");
  return words;
}

Result<ProjectMannequin> read_mannequin(const json::JsonValue& object, const std::string& where) {
  return read_alone<ProjectMannequin>(object, where);
}

Result<ProjectBody> read_body(const json::JsonValue& object, const std::string& where) {
  return read_alone<ProjectBody>(object, where);
}

json::JsonValue mannequin_json(const ProjectMannequin& mannequin) {
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

std::pair<double, double> measure_range_cm(measure::Measure m) {
  const fields::Range range = fields::kMeasureRangeCm[static_cast<int>(m)];
  return {range.least, range.most};
}

}  // namespace toile::project
