#include "core/project/create/places.h"

#include <cmath>

#include "core/base/units.h"

namespace toile::create {

namespace {

double metres(double value) { return std::round(value * 1e5) / 1e5 + 0.0; }
double millimetres(double value) { return std::round(mm_from_metres(value) * 1e2) / 1e2 + 0.0; }
double degrees(double value) { return std::round(degrees_from_radians(value) * 1e6) / 1e6 + 0.0; }
Vec3 rounded(Vec3 p, double (*by)(double)) { return {by(p.x), by(p.y), by(p.z)}; }

project::ProjectWrapped wrapped_of(const sewing::WrappedPlacement& w) {
  project::ProjectWrapped out;
  out.axis = {metres(w.axis.x), metres(w.axis.z)};
  out.axis_height = metres(w.axis.y);
  out.radius = metres(w.radius);
  out.angle = degrees(w.angle);
  out.height = metres(w.height);
  out.anchor = {millimetres(w.anchor.x), millimetres(w.anchor.y)};
  out.slope = w.slope;
  out.up = w.up;
  out.turn = degrees(w.turn);
  out.flipped = w.flipped;
  return out;
}

}  // namespace

project::ProjectPlacement project_placement(const sewing::Placement& placement) {
  project::ProjectPlacement out;
  if (const auto* rigid = std::get_if<sewing::RigidPlacement>(&placement)) {
    out.rigid = project::ProjectRigid{rounded(rigid->translation, metres), rounded(rigid->rotation, degrees),
                                      rigid->flipped};
  } else {
    out.wrapped = wrapped_of(std::get<sewing::WrappedPlacement>(placement));
  }
  return out;
}

std::optional<project::ProjectOnBox> project_on_box(const sewing::RigidPlacement& rigid, Vec2 anchor,
                                                    std::span<const measure::PartBox> boxes) {
  constexpr double kParallel = 1 - 1e-9;
  const std::vector<Vec3> p =
      sewing::place({anchor, anchor + Vec2{rigid.flipped ? -1.0 : 1.0, 0}, anchor + Vec2{0, 1}}, rigid);
  const Vec3 u = p[1] - p[0], normal = cross(u, p[2] - p[0]);
  std::optional<project::ProjectOnBox> best;
  double least = 0;
  for (const measure::PartBox& box : boxes) {
    for (const char* side : {"front", "back", "left", "right"}) {
      const std::string name = side;
      const bool lengthwise = name == "front" || name == "back";
      const Vec3 axis = box.axis[lengthwise ? 2 : 0], way = name == "front" || name == "left" ? axis : -axis;
      if (dot(way, normal) < kParallel) continue;
      const double half = lengthwise ? box.half.z : box.half.x;
      const Vec3 d = p[0] - box.centre - way * half, up = box.axis[1], right = cross(up, way);
      if (best && length(d) >= least) continue;
      least = length(d);
      best.emplace();
      best->part = measure::name_of(box.part);
      best->side = name;
      best->at = {metres(dot(d, right)), metres(dot(d, up))};
      best->away = metres(dot(d, way));
      best->turn = degrees(std::atan2(dot(u, up), dot(u, right)));
      best->flipped = rigid.flipped;
      best->anchor = Vec2{mm_from_metres(anchor.x), mm_from_metres(anchor.y)};
    }
  }
  return best;
}

int tell_by_boxes(const drape::DrapeInput& input, project::Project& project) {
  for (const body::Body& body : input.bodies) {
    const Result<measure::BodyFigure> figure = measure::find_figure(body.mesh);
    if (!figure) continue;
    const auto boxes = measure::part_boxes(body.mesh, *figure);
    int told = 0;
    for (std::size_t i = 0; i < project.pieces.size(); ++i) {
      const auto* rigid = std::get_if<sewing::RigidPlacement>(&input.placements[i]);
      if (!rigid || !project.pieces[i].placement.rigid) continue;
      const Vec2 corner = input.pattern.panels[i].outline.edges.front().curves.front().p0;
      auto on_box = project_on_box(*rigid, {metres_from_mm(corner.x), metres_from_mm(corner.y)}, boxes);
      if (!on_box) continue;
      project.pieces[i].placement = {};
      project.pieces[i].placement.on_box = std::move(on_box);
      ++told;
    }
    return told;
  }
  return 0;
}

project::ProjectAttachment project_attachment(const pattern::Pattern& pattern,
                                              const sewing::Attachment& attachment) {
  const pattern::Panel& panel = pattern.panels[static_cast<std::size_t>(attachment.panel)];
  project::ProjectAttachment out;
  out.id = attachment.id;
  out.piece = panel.id;
  for (const Vec2 at : attachment.points) out.points.push_back({millimetres(at.x), millimetres(at.y)});
  for (const Index e : attachment.edges)
    out.edges.push_back(pattern::edges_of(panel)[static_cast<std::size_t>(e)]->id);
  out.hold = attachment.hold == sewing::Attachment::Hold::kHeight ? "height" : "place";
  out.release_after_s = attachment.release_after;
  return out;
}

}  // namespace toile::create
