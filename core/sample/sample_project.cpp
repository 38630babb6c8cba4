#include "core/sample/sample_project.h"

#include <algorithm>

#include "core/base/units.h"
#include "core/pattern/curve.h"
#include "core/pattern/dxf/read.h"
#include "core/pattern/dxf/write.h"
#include "core/project/create/create.h"

namespace toile::sample {
namespace {

constexpr double kSameEdge = 0.5;  // mm between the middles of an edge as drafted and as read

Vec2 middle_of(const pattern::PanelEdge& edge) {
  return pattern::point_at_length(edge, pattern::arc_length(edge) / 2);
}

using EdgeNames = std::vector<std::pair<std::string, std::string>>;

/// How the file's reader calls the edges, and what the garment does.
Result<EdgeNames> edge_names(const pattern::Panel& drafted, const dxf::DxfDrawing& drawing) {
  EdgeNames names;
  for (const dxf::DxfPiece& piece : drawing.pieces) {
    if (piece.name != drafted.id) continue;
    const pattern::Panel read = TRY(dxf::panel_from_piece(piece));
    for (const pattern::PanelEdge& r : read.outline.edges)
      for (const pattern::PanelEdge& d : drafted.outline.edges)
        if (length(middle_of(r) - middle_of(d)) < kSameEdge) names.push_back({r.id, d.id});
  }
  if (names.size() == drafted.outline.edges.size()) return names;
  return Error{"sample.edges", "the DXF file does not give the piece's edges back", "piece " + drafted.id,
               ErrorKind::kInternal};
}

/// Where the garment says that the piece is sewn from; what is worn waits at the origin to be arranged.
project::ProjectPlacement place_of(const draft::Garment& garment, const std::string& piece) {
  for (const draft::PiecePlace& p : garment.places)
    if (p.piece == piece) return {.rigid = project::ProjectRigid{p.translation, p.rotation}};
  for (const draft::BentPlace& p : garment.bent) {
    if (p.anchor.piece != piece) continue;
    return {.wrapped = project::ProjectWrapped{.axis = {p.at.x, p.at.z - p.radius},
                                               .radius = p.radius,
                                               .height = p.at.y,
                                               .anchor = p.anchor.at}};
  }
  return {.rigid = project::ProjectRigid{}};
}

project::ProjectPiece piece_of(const draft::Garment& garment, const pattern::Panel& panel,
                               const std::string& file) {
  project::ProjectPiece piece;
  piece.id = panel.id;
  piece.from = project::ProjectDxf{.dxf = file, .piece = panel.id, .corners = {}, .units = "mm"};
  piece.fabric = panel.fabric;
  piece.layer = panel.layer;
  piece.placement = place_of(garment, panel.id);
  project::ProjectPhysical physical;
  for (const auto& [id, fabric] : garment.interlinings)
    if (id == panel.id) physical.interlining = fabric;
  if (panel.spacing > 0) physical.particle_distance_mm = mm_from_metres(panel.spacing);
  if (!(physical == project::ProjectPhysical{})) piece.physical = physical;
  return piece;
}

/// Lines within a piece come from the DXF file, which numbers them (dxf::panel_from_piece); edges have their
/// names.
std::vector<std::string> lines_in_document(const draft::Garment& garment, const std::string& piece,
                                           std::vector<std::string> lines) {
  for (const pattern::Panel& panel : garment.pattern.panels) {
    if (panel.id != piece) continue;
    for (std::size_t i = 0; i < panel.lines.size(); ++i)
      std::replace(lines.begin(), lines.end(), panel.lines[i].id, "i" + std::to_string(i));
  }
  return lines;
}

project::ProjectAttachment attachment_of(const draft::DraftedHold& hold) {
  project::ProjectAttachment out;
  out.id = hold.id;
  out.piece = hold.piece;
  out.points = hold.points;
  out.edges = hold.edges;
  out.hold = "place";
  out.release_after_s = -1;
  return out;
}

/// One for each hook, numbered from 1.
void take_hooks(const draft::DraftedHooks& hooks, project::Project& project) {
  for (std::size_t i = 0; i < hooks.points.size(); ++i) {
    project::ProjectAttachment& out = project.attachments.emplace_back();
    out.id = hooks.id + " " + std::to_string(i + 1);
    out.piece = hooks.piece;
    out.points = {hooks.points[i]};
    out.to.emplace().place = hooks.places[i];
    out.release_after_s = -1;
  }
}

void take_notions(const draft::Garment& garment, project::Project& project) {
  for (const draft::DraftedButton& b : garment.buttons)
    project.buttons.push_back({.id = b.id, .a = {b.a.piece, b.a.at}, .b = {b.b.piece, b.b.at}});
  for (const draft::DraftedHold& h : garment.holds) project.attachments.push_back(attachment_of(h));
  for (const draft::DraftedHooks& h : garment.hooks) take_hooks(h, project);
  for (const draft::DraftedCushion& c : garment.cushions)
    project.cushions.push_back({.id = c.id, .pieces = c.pieces, .pressure_pa = c.pressure_pa});
  for (const draft::DraftedFold& f : garment.folds)
    project.folds.push_back(
        {f.id, f.piece, lines_in_document(garment, f.piece, f.lines), f.angle, f.stiffness});
  for (const draft::DraftedElastic& e : garment.elastics)
    project.elastics.push_back(
        {e.id, e.piece, lines_in_document(garment, e.piece, e.lines), e.factor, e.stiffness_n});
}

Status take_cloths(const draft::Garment& garment, const std::string& cloth, project::Project& project) {
  for (const draft::Cloth& c : garment.cloths) {
    project::ProjectFabric fabric;
    fabric.id = c.id;
    fabric.like = c.like;
    fabric.colour = {c.colour.x, c.colour.y, c.colour.z};
    project.fabrics.push_back(std::move(fabric));
  }
  project.fabric = cloth.empty() ? garment.cloths.front().id : cloth;
  const bool known = std::any_of(garment.cloths.begin(), garment.cloths.end(),
                                 [&](const draft::Cloth& c) { return c.id == project.fabric; });
  if (known) return {};
  std::string all;
  for (const draft::Cloth& c : garment.cloths) all += (all.empty() ? "" : ", ") + c.id;
  return Error{"sample.cloth", "this sample is made of " + all, cloth};
}

}  // namespace

Result<SampleProject> sample_project(const draft::Garment& garment,
                                     const std::optional<project::ProjectBody>& body,
                                     const std::string& cloth) {
  SampleProject out;
  out.dxf_name = garment.name + ".dxf";
  out.dxf = TRY(dxf::write_dxf(garment.pattern));
  const dxf::DxfDrawing drawing = TRY(dxf::read_dxf(out.dxf));
  out.project.name = garment.title;
  for (const pattern::Panel& panel : garment.pattern.panels) {
    project::ProjectPiece piece = piece_of(garment, panel, out.dxf_name);
    piece.edge_names = TRY(edge_names(panel, drawing));
    out.project.pieces.push_back(std::move(piece));
  }
  TRY(take_cloths(garment, cloth, out.project));
  for (const pattern::Seam& seam : garment.pattern.seams)
    out.project.seams.push_back(create::project_seam(garment.pattern, seam));
  if (body) out.project.bodies.push_back(*body);
  for (const draft::Solid& solid : garment.solids) {
    project::ProjectBody& thing = out.project.bodies.emplace_back();
    thing.id = solid.id;
    thing.file = solid.id + ".obj";
    thing.unit = "m";
  }
  take_notions(garment, out.project);
  out.project.settings.particle_distance_mm = garment.particle_distance_mm;
  out.project.settings.max_time_s = garment.max_time_s;
  return out;
}

}  // namespace toile::sample
