#pragma once
// What a document tells by the body, in space: boxes of its parts, landmarks, lines around it.

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/body/body.h"
#include "core/body/measure/landmarks.h"
#include "core/body/measure/segments.h"
#include "core/pattern/pattern.h"
#include "core/project/project.h"
#include "core/sewing/placement.h"

namespace toile::resolve {

/// Looks at bodies when they are asked for, at each once.
class BodyPlaces {
 public:
  /// Both must outlive the object. REQUIRES one body for each of the project's, in their order, as they stand
  /// in space.
  BodyPlaces(const project::Project& project, std::span<const body::Body> bodies);

  /// Whether every landmark that the document sets lies on its body. Errors: landmark.duplicate,
  /// landmark.unknown, landmark.no_triangle.
  Status check_landmarks();

  /// Those that a body has by itself, moved where the document says so, and the document's own.
  const Result<std::vector<measure::Landmark>>& landmarks_of(Index body);

  /// Errors: project.unknown_body, body.not_standing, project.no_body; `where` is the pointer of what the
  /// placement says. `panel` is the piece in its own plane, mm.
  Result<sewing::Placement> placement(const project::ProjectPlacement& given, const pattern::Panel& panel,
                                      const std::string& where);

  /// An attachment's goal, m: see Attachment::goal. Errors: as above, project.unknown_landmark,
  /// project.unknown_line, body.no_line.
  Result<std::vector<Vec3>> goal(const project::ProjectGoal& given, const std::string& where);

 private:
  struct Known {
    std::optional<Result<measure::BodyFigure>> figure;
    std::optional<Result<std::vector<measure::Landmark>>> landmarks;
    std::optional<std::array<measure::PartBox, measure::kBodyParts>> boxes;
  };

  const measure::BodyFigure* figure_of(Index body);
  /// The body of that id, which must stand; of no id, the first that stands.
  Result<Index> standing(const std::string& id, const std::string& where);
  /// The body of that id; of no id, the first that bears the landmark.
  Result<Index> bearer(const project::ProjectGoal& given, const std::string& where);
  const measure::PartBox& box_of(Index body, const std::string& part);
  Result<std::vector<Vec3>> landmark_goal(const project::ProjectGoal& given, const std::string& where);
  Result<std::vector<Vec3>> line_goal(const project::ProjectGoal& given, const std::string& where);
  Result<sewing::Placement> on_box(const project::ProjectOnBox& given, const pattern::Panel& panel,
                                   const std::string& where);
  Result<sewing::Placement> around(const project::ProjectAround& given, const pattern::Panel& panel,
                                   const std::string& where);

  const project::Project& project_;
  std::span<const body::Body> bodies_;
  std::vector<Known> known_;
};

}  // namespace toile::resolve
