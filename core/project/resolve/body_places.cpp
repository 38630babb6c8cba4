#include "core/project/resolve/body_places.h"

#include <algorithm>
#include <cmath>

#include "core/arrange/box_places.h"
#include "core/base/aabb.h"
#include "core/base/names.h"
#include "core/base/snapped.h"
#include "core/base/units.h"
#include "core/body/measure/lines.h"
#include "core/body/measure/own_landmarks.h"
#include "core/json/tree.h"
#include "core/project/resolve/body_shape.h"
#include "core/project/resolve/pieces.h"

namespace toile::resolve {

namespace {

/// m, goals lie so far outside the distance that cloth keeps from the skin: contact and hold agree there.
constexpr double kClear = 0.5e-3;

Vec2 metres(Vec2 mm) { return {metres_from_mm(mm.x), metres_from_mm(mm.y)}; }

sewing::WrappedPlacement wrapped_of(const project::ProjectWrapped& given) {
  sewing::WrappedPlacement wrapped;
  wrapped.axis = {given.axis.x, given.axis_height, given.axis.y};
  wrapped.radius = given.radius;
  wrapped.angle = radians_from_degrees(given.angle);
  wrapped.height = given.height;
  wrapped.anchor = metres(given.anchor);
  wrapped.slope = given.slope;
  wrapped.up = normalized(given.up);
  wrapped.turn = radians_from_degrees(given.turn);
  wrapped.flipped = given.flipped;
  return wrapped;
}

arrange::BoxSide side_named(const std::string& name) {
  if (name == "back") return arrange::BoxSide::kBack;
  if (name == "left") return arrange::BoxSide::kLeft;
  return name == "right" ? arrange::BoxSide::kRight : arrange::BoxSide::kFront;
}

/// Corners and handles of the outline, m: its curves lie within them.
std::vector<Vec2> hull_of(const pattern::Panel& panel) {
  std::vector<Vec2> points;
  for (const pattern::PanelEdge& edge : panel.outline.edges) {
    for (const pattern::CubicBezier& curve : edge.curves) {
      for (const Vec2 p : {curve.p0, curve.p1, curve.p2, curve.p3}) points.push_back(metres(p));
    }
  }
  return points;
}

arrange::OnBox where_on_box(const std::string& side, Vec2 at, double away, double turn,
                            const std::optional<Vec2>& anchor, bool flipped, const std::vector<Vec2>& hull) {
  return {side_named(side),
          at,
          away,
          radians_from_degrees(turn),
          anchor ? metres(*anchor) : bounding_box(hull).middle(),
          flipped};
}

}  // namespace

BodyPlaces::BodyPlaces(const project::Project& project, std::span<const body::Body> bodies)
    : project_(project), bodies_(bodies), known_(bodies.size()) {}

const measure::BodyFigure* BodyPlaces::figure_of(Index body) {
  std::optional<Result<measure::BodyFigure>>& figure = known_[body].figure;
  if (!figure) figure = measure::find_figure(bodies_[body].mesh);
  return figure->ok() ? &**figure : nullptr;
}

const Result<std::vector<measure::Landmark>>& BodyPlaces::landmarks_of(Index body) {
  std::optional<Result<std::vector<measure::Landmark>>>& known = known_[body].landmarks;
  if (known) return *known;
  std::vector<measure::OwnLandmark> own;
  for (const project::ProjectLandmark& given : project_.bodies[static_cast<std::size_t>(body)].landmarks) {
    constexpr std::array<double, 3> kMiddle{1.0 / 3, 1.0 / 3, 1.0 / 3};
    Vec3 offset = given.offset_mm.value_or(Vec3{}) * 1e-3;
    if (const measure::BodyFigure* figure = figure_of(body); figure && given.body_height_mm)
      offset = offset * (figure->height() / (*given.body_height_mm * 1e-3));
    own.push_back(
        {given.name, {given.triangle.value_or(kNone), given.share.value_or(kMiddle)}, given.near, offset});
  }
  const geometry::TriangleMesh& mesh = bodies_[body].mesh;
  std::vector<measure::Landmark> landmarks;
  if (const measure::BodyFigure* figure = figure_of(body)) landmarks = measure::find_landmarks(mesh, *figure);
  if (Status added = measure::add_own_landmarks(mesh, own, landmarks); !added) {
    known = added.error();
  } else {
    known = std::move(landmarks);
  }
  return *known;
}

Status BodyPlaces::check_landmarks() {
  for (std::size_t b = 0; b < project_.bodies.size(); ++b) {
    const project::ProjectBody& body = project_.bodies[b];
    const std::string list = json::pointer_to(json::pointer_to("/bodies", b), "landmarks");
    for (std::size_t i = 0; i < body.landmarks.size(); ++i) {
      if (!body.mannequin || !body.landmarks[i].triangle) continue;
      return Error{
          "landmark.of_mannequin",
          "the triangles of a mannequin change with its measures; tell the landmark from another one "
          "with \"near\" and \"offset_mm\"",
          json::pointer_to(json::pointer_to(list, i), "triangle")};
    }
    if (body.landmarks.empty()) continue;
    if (const auto& known = landmarks_of(static_cast<Index>(b)); !known)
      return json::error_at(list, known.error());
  }
  return {};
}

Result<Index> BodyPlaces::standing(const std::string& id, const std::string& where) {
  std::optional<Error> why;
  bool named = false;
  for (Index b = 0; b < static_cast<Index>(bodies_.size()); ++b) {
    if (!id.empty() && bodies_[b].id != id) continue;
    named = true;
    if (figure_of(b)) return b;
    if (!why) why = known_[b].figure->error();
  }
  if (!id.empty() && !named) {
    return Error{"project.unknown_body", "there is no body " + in_quotes(id),
                 json::pointer_to(where, "body")};
  }
  if (why) return json::error_at(where, *why);
  return Error{"project.no_body", "this is told by a body, and the project has none", where};
}

const measure::PartBox& BodyPlaces::box_of(Index body, const std::string& part) {
  std::optional<std::array<measure::PartBox, measure::kBodyParts>>& boxes = known_[body].boxes;
  if (!boxes) boxes = measure::part_boxes(bodies_[body].mesh, *figure_of(body));
  return *std::find_if(boxes->begin(), boxes->end(),
                       [&](const measure::PartBox& b) { return part == measure::name_of(b.part); });
}

Result<sewing::Placement> BodyPlaces::on_box(const project::ProjectOnBox& given, const pattern::Panel& panel,
                                             const std::string& where) {
  const Index body = TRY(standing(given.body, where));
  const arrange::OnBox at =
      where_on_box(given.side, given.at, given.away, given.turn, given.anchor, given.flipped, hull_of(panel));
  return sewing::Placement{arrange::on_box_side(box_of(body, given.part), at)};
}

Result<sewing::Placement> BodyPlaces::around(const project::ProjectAround& given, const pattern::Panel& panel,
                                             const std::string& where) {
  const Index body = TRY(standing(given.body, where));
  const std::vector<Vec2> hull = hull_of(panel);
  const arrange::OnBox at =
      where_on_box(given.side, given.at, given.away, given.turn, given.anchor, given.flipped, hull);
  // What of the part lies under the piece, along the part.
  const double c = std::cos(at.turn), s = std::sin(at.turn);
  double low = 0, high = 0;
  for (const Vec2 p : hull) {
    const double up = s * (p.x - at.anchor.x) + c * (p.y - at.anchor.y);
    low = std::min(low, up);
    high = std::max(high, up);
  }
  const measure::PartBox& box = box_of(body, given.part);
  const double radius =
      arrange::radius_of_part(bodies_[body].mesh, *figure_of(body), box, at.at.y + low, at.at.y + high);
  if (!(radius + at.away > 1e-3)) {
    return Error{"project.around_nothing",
                 "the body has nothing of this part where the piece would go around it", where};
  }
  return sewing::Placement{arrange::around_box(box, at, radius, given.slope)};
}

Result<sewing::Placement> BodyPlaces::placement(const project::ProjectPlacement& given,
                                                const pattern::Panel& panel, const std::string& where) {
  if (given.rigid) {
    return sewing::Placement{sewing::RigidPlacement{given.rigid->translation, radians(given.rigid->rotation),
                                                    given.rigid->flipped}};
  }
  if (given.wrapped) return sewing::Placement{wrapped_of(*given.wrapped)};
  if (given.on_box) return on_box(*given.on_box, panel, json::pointer_to(where, "on_box"));
  if (!given.around) {
    return Error{"project.no_placement",
                 "the piece " + in_quotes(panel.id) + " has no place; give it one, or have it arranged",
                 where};
  }
  return around(*given.around, panel, json::pointer_to(where, "around"));
}

Result<Index> BodyPlaces::bearer(const project::ProjectGoal& given, const std::string& where) {
  std::vector<std::string> names;
  bool any = false;
  for (Index b = 0; b < static_cast<Index>(bodies_.size()); ++b) {
    if (!given.body.empty() && bodies_[b].id != given.body) continue;
    any = true;
    const auto& known = landmarks_of(b);
    if (!known) continue;  // check_landmarks says why
    if (measure::landmark_named(*known, given.landmark)) return b;
    for (const measure::Landmark& mark : *known) names.push_back(mark.name);
  }
  if (!any || names.empty()) return standing(given.body, where);
  return Error{"project.unknown_landmark",
               "there is no landmark " + in_quotes(given.landmark) + "; " + advice(given.landmark, names),
               json::pointer_to(where, "landmark")};
}

Result<std::vector<Vec3>> BodyPlaces::landmark_goal(const project::ProjectGoal& given,
                                                    const std::string& where) {
  const Index body = TRY(bearer(given, where));
  const geometry::TriangleMesh& mesh = bodies_[body].mesh;
  const measure::Landmark* mark = measure::landmark_named(*landmarks_of(body), given.landmark);
  const double away = bodies_[body].skin_offset + kClear;
  return std::vector<Vec3>{snapped(mark->place + measure::skin_normal(mark->at, mesh) * away)};
}

Result<std::vector<Vec3>> BodyPlaces::line_goal(const project::ProjectGoal& given, const std::string& where) {
  const std::vector<std::string>& names = measure::body_line_names();
  if (std::find(names.begin(), names.end(), given.line) == names.end()) {
    return Error{"project.unknown_line",
                 "there is no line " + in_quotes(given.line) + " on a body; " + advice(given.line, names),
                 json::pointer_to(where, "line")};
  }
  const Index body = TRY(standing(given.body, where));
  Result<std::vector<Vec3>> line =
      measure::body_line(measure::PlaneCutter(bodies_[body].mesh), *figure_of(body), given.line,
                         metres_from_mm(given.up_mm.value_or(0)), bodies_[body].skin_offset + kClear);
  if (!line) return json::error_at(json::pointer_to(where, "line"), line.error());
  for (Vec3& p : *line) p = snapped(p);
  return line;
}

Result<std::vector<Vec3>> BodyPlaces::goal(const project::ProjectGoal& given, const std::string& where) {
  if (given.up_mm && given.line.empty()) {
    return Error{"project.two_ways", "only a line can be shifted up", json::pointer_to(where, "up_mm")};
  }
  if (given.place) return std::vector<Vec3>{*given.place};
  return given.line.empty() ? landmark_goal(given, where) : line_goal(given, where);
}

}  // namespace toile::resolve
