#include "proto/cpp/project_places.h"

#include <cmath>

#include "core/base/units.h"

namespace toile {

namespace {

double metres(double value) { return std::round(value * 1e5) / 1e5 + 0.0; }
double millimetres(double value) { return std::round(mm_from_metres(value) * 1e2) / 1e2 + 0.0; }
double degrees(double value) { return std::round(degrees_from_radians(value) * 1e6) / 1e6 + 0.0; }
Vec3 rounded(Vec3 p, double (*by)(double)) { return {by(p.x), by(p.y), by(p.z)}; }

ProjectWrapped wrapped_of(const WrappedPlacement& w) {
  ProjectWrapped out;
  out.axis = {metres(w.axis.x), metres(w.axis.z)};
  out.axis_height = metres(w.axis.y);
  out.radius = metres(w.radius), out.angle = degrees(w.angle), out.height = metres(w.height);
  out.anchor = {millimetres(w.anchor.x), millimetres(w.anchor.y)};
  out.slope = w.slope, out.up = w.up, out.turn = degrees(w.turn), out.flipped = w.flipped;
  return out;
}

}  // namespace

ProjectPlacement project_placement(const Placement& placement) {
  ProjectPlacement out;
  if (const auto* rigid = std::get_if<RigidPlacement>(&placement)) {
    out.rigid =
        ProjectRigid{rounded(rigid->translation, metres), rounded(rigid->rotation, degrees), rigid->flipped};
  } else {
    out.wrapped = wrapped_of(std::get<WrappedPlacement>(placement));
  }
  return out;
}

ProjectAttachment project_attachment(const Pattern& pattern, const Attachment& attachment) {
  const Panel& panel = pattern.panels[static_cast<std::size_t>(attachment.panel)];
  ProjectAttachment out;
  out.id = attachment.id, out.piece = panel.id;
  for (const Index e : attachment.edges)
    out.edges.push_back(edges_of(panel)[static_cast<std::size_t>(e)]->id);
  out.hold = attachment.hold == Attachment::Hold::kHeight ? "height" : "place";
  out.release_after_s = attachment.release_after;
  return out;
}

}  // namespace toile
