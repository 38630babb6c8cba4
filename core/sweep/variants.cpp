#include "core/sweep/variants.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/base/text.h"
#include "core/body/measure/measures.h"
#include "core/fabric/library.h"

namespace toile::sweep {
namespace {

const std::string& fabric_of(const project::Project& project, const project::ProjectPiece& piece) {
  return piece.fabric.empty() ? project.fabric : piece.fabric;
}

bool is_moving_by_files(const project::ProjectBody& body) {
  return std::any_of(body.motion.begin(), body.motion.end(),
                     [](const project::ProjectKeyframe& keyframe) { return !keyframe.mannequin; });
}

/// The same poses of another figure.
Status move_alike(const project::ProjectBody& was, project::ProjectBody& now) {
  if (was.motion.empty()) return {};
  if (!now.mannequin || is_moving_by_files(was)) {
    return Error{
        "sweep.moving_body",
        "the project's body moves, and only a mannequin can move as another mannequin does; take its "
        "\"motion\" out of the document first",
        ""};
  }
  now.motion = was.motion;
  for (project::ProjectKeyframe& keyframe : now.motion) {
    const project::ProjectMannequin pose = *keyframe.mannequin;
    keyframe.mannequin = now.mannequin;
    keyframe.mannequin->pose = pose.pose;
    keyframe.mannequin->arm_angle = pose.arm_angle;
  }
  return {};
}

}  // namespace

std::string main_fabric(const project::Project& project) {
  std::map<std::string, int> pieces;
  for (const project::ProjectPiece& piece : project.pieces) ++pieces[fabric_of(project, piece)];
  std::string most;
  int count = 0;
  for (const project::ProjectPiece& piece : project.pieces) {  // of equals the first in the document
    const std::string& fabric = fabric_of(project, piece);
    if (pieces[fabric] <= count) continue;
    count = pieces[fabric];
    most = fabric;
  }
  return most;
}

Result<project::Project> cut_of(project::Project project, const std::string& fabric) {
  const bool own = std::any_of(project.fabrics.begin(), project.fabrics.end(),
                               [&](const project::ProjectFabric& one) { return one.id == fabric; });
  if (!own) {
    TRY(fabric::named(fabric, ""));
  }
  const std::string before = main_fabric(project);
  for (project::ProjectPiece& piece : project.pieces)
    if (!piece.fabric.empty() && piece.fabric == before) piece.fabric = fabric;
  if (project.fabric == before) project.fabric = fabric;
  return project;
}

void take_the_place_of(const project::ProjectBody& was, project::ProjectBody& now) {
  now.friction = was.friction;
  now.skin_offset_mm = was.skin_offset_mm;
  now.restitution = was.restitution;
  if (was.mannequin && now.mannequin) {
    now.translation = was.translation;
    now.rotation = was.rotation;
    now.scale = was.scale;
  }
  now.landmarks = was.landmarks;
  if (was.file == now.file) return;
  std::erase_if(now.landmarks, [](const project::ProjectLandmark& l) { return l.triangle.has_value(); });
}

Result<project::Project> worn_by(project::Project project, project::ProjectBody body) {
  const auto at = std::find_if(project.bodies.begin(), project.bodies.end(),
                               [&](const project::ProjectBody& one) { return one.id == body.id; });
  if (at == project.bodies.end()) {
    project.bodies.push_back(std::move(body));
    return project;
  }
  take_the_place_of(*at, body);
  TRY(move_alike(*at, body));
  *at = std::move(body);
  return project;
}

std::string main_body(const project::Project& project) {
  return project.bodies.empty() ? "body" : project.bodies.front().id;
}

std::string name_of(const project::ProjectBody& body) {
  if (!body.mannequin) return body.file.empty() ? body.id : body.file;
  std::string name = !body.mannequin->preset.empty() ? body.mannequin->preset : body.mannequin->sex;
  for (int i = 0; i < measure::kMeasureCount; ++i) {
    const auto& value = body.mannequin->measures_cm[static_cast<std::size_t>(i)];
    if (!value) continue;
    if (!name.empty()) name += ' ';
    name += std::string(measure::measure_name(measure::measure_at(i))) + ' ' + number_text(*value);
  }
  if (body.mannequin->pose == "t") name += name.empty() ? "pose t" : " pose t";
  return name.empty() ? "mannequin" : name;
}

}  // namespace toile::sweep
