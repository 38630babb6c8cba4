#include "core/project/resolve/sewn_parts.h"

#include <utility>

#include "core/base/units.h"
#include "core/project/resolve/body_places.h"
#include "core/project/resolve/make_all.h"

namespace toile::resolve {
namespace {

Result<std::vector<pattern::SeamEdge>> series_of(const std::vector<project::ProjectSeamEdge>& given,
                                                 const PatternNames& names, const std::string& where) {
  std::vector<pattern::SeamEdge> series;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const std::string place = json::pointer_to(where, i);
    const Index panel = TRY(names.panel(given[i].piece, json::pointer_to(place, "piece")));
    const Index edge = TRY(names.edge(panel, given[i].edge, json::pointer_to(place, "edge")));
    series.push_back({panel, edge, given[i].reversed, given[i].from, given[i].to});
  }
  return series;
}

Result<pattern::Seam> seam_of(const project::ProjectSeam& given, const PatternNames& names,
                              const std::string& where) {
  std::vector<pattern::SeamEdge> a = TRY(series_of(given.a, names, json::pointer_to(where, "a")));
  std::vector<pattern::SeamEdge> b = TRY(series_of(given.b, names, json::pointer_to(where, "b")));
  return pattern::Seam{given.id, std::move(a), std::move(b), given.same_direction};
}

Result<sewing::Attachment> attachment_of(const project::ProjectAttachment& given, const PatternNames& names,
                                         BodyPlaces& places, const std::string& where) {
  const Index panel = TRY(names.panel(given.piece, json::pointer_to(where, "piece")));
  sewing::Attachment attachment;
  attachment.id = given.id;
  attachment.panel = panel;
  for (std::size_t i = 0; i < given.edges.size(); ++i) {
    const Index edge =
        TRY(names.edge(panel, given.edges[i], json::pointer_to(json::pointer_to(where, "edges"), i)));
    attachment.edges.push_back(edge);
  }
  for (const Vec2 p : given.points) attachment.points.push_back({metres_from_mm(p.x), metres_from_mm(p.y)});
  attachment.release_after = given.release_after_s;
  attachment.hold =
      given.hold == "place" ? sewing::Attachment::Hold::kPlace : sewing::Attachment::Hold::kHeight;
  if (!given.to) return attachment;
  if (!given.hold.empty()) {
    return Error{"project.two_ways", "only one of \"hold\" or \"to\" may stand here",
                 json::pointer_to(where, "hold")};
  }
  std::vector<Vec3> goal = TRY(places.goal(*given.to, json::pointer_to(where, "to")));
  if (goal.size() > 1 && given.edges.empty() && given.points.empty()) {
    return Error{"project.attached_whole",
                 "a whole piece cannot lie on a line; name the edges or points that do", where};
  }
  attachment.hold = sewing::Attachment::Hold::kGoal;
  attachment.goal = std::move(goal);
  return attachment;
}

Result<sewing::PanelPoint> point_of(const project::ProjectButtonPoint& given, const PatternNames& names,
                                    const std::string& where) {
  const Index panel = TRY(names.panel(given.piece, json::pointer_to(where, "piece")));
  return sewing::PanelPoint{panel, {metres_from_mm(given.at.x), metres_from_mm(given.at.y)}};
}

Result<sewing::Button> button_of(const project::ProjectButton& given, const PatternNames& names,
                                 const std::string& where) {
  const sewing::PanelPoint a = TRY(point_of(given.a, names, json::pointer_to(where, "a")));
  const sewing::PanelPoint b = TRY(point_of(given.b, names, json::pointer_to(where, "b")));
  return sewing::Button{given.id, a, b, metres_from_mm(given.distance_mm)};
}

/// Each name is an edge's of the panel, or else a line's.
Status add_edges_and_lines(const std::vector<std::string>& given, const PatternNames& names, Index panel,
                           const std::string& where, std::vector<Index>& edges, std::vector<Index>& lines) {
  for (std::size_t i = 0; i < given.size(); ++i) {
    const std::string place = json::pointer_to(where, i);
    const bool edge = names.has_edge(panel, given[i]);
    const Index found = TRY(edge ? names.edge(panel, given[i], place) : names.line(panel, given[i], place));
    (edge ? edges : lines).push_back(found);
  }
  return {};
}

Result<sewing::Elastic> elastic_of(const project::ProjectElastic& given, const PatternNames& names,
                                   const std::string& where) {
  const Index panel = TRY(names.panel(given.piece, json::pointer_to(where, "piece")));
  sewing::Elastic elastic{given.id, panel, {}, {}, given.factor, given.stiffness_n};
  TRY(add_edges_and_lines(given.lines, names, panel, json::pointer_to(where, "lines"), elastic.edges,
                          elastic.lines));
  return elastic;
}

Result<sewing::Crease> crease_of(const project::ProjectFold& given, const PatternNames& names,
                                 const std::string& where) {
  const Index panel = TRY(names.panel(given.piece, json::pointer_to(where, "piece")));
  constexpr double kNewtons = 1e-3;
  sewing::Crease crease{
      given.id, panel, {}, {}, radians_from_degrees(given.angle), given.stiffness_mn * kNewtons};
  TRY(add_edges_and_lines(given.lines, names, panel, json::pointer_to(where, "lines"), crease.edges,
                          crease.lines));
  return crease;
}

Result<sewing::Cushion> cushion_of(const project::ProjectCushion& given, const PatternNames& names,
                                   const std::string& where) {
  constexpr double kCubicMetres = 1e-3;
  sewing::Cushion cushion{given.id, {}, given.pressure_pa, given.volume_l * kCubicMetres};
  for (std::size_t i = 0; i < given.pieces.size(); ++i) {
    const Index panel =
        TRY(names.panel(given.pieces[i], json::pointer_to(json::pointer_to(where, "pieces"), i)));
    cushion.panels.push_back(panel);
  }
  return cushion;
}

}  // namespace

Status add_seams(const std::vector<project::ProjectSeam>& given, const PatternNames& names,
                 std::vector<pattern::Seam>& seams) {
  const auto made = [&](const project::ProjectSeam& one, const std::string& at) {
    return seam_of(one, names, at);
  };
  return make_all(given, "/seams", seams, made);
}

Status add_notions(const project::Project& project, const PatternNames& names, sewing::Notions& notions) {
  const auto named = [&](auto make) {
    return [&names, make](const auto& given, const std::string& at) { return make(given, names, at); };
  };
  TRY(make_all(project.buttons, "/buttons", notions.buttons, named(button_of)));
  TRY(make_all(project.elastics, "/elastics", notions.elastics, named(elastic_of)));
  TRY(make_all(project.folds, "/folds", notions.creases, named(crease_of)));
  return make_all(project.cushions, "/cushions", notions.cushions, named(cushion_of));
}

Status add_told_by_bodies(const project::Project& project, const PatternNames& names,
                          drape::DrapeInput& input) {
  BodyPlaces places(project, input.bodies);
  TRY(places.check_landmarks());
  for (std::size_t i = 0; i < project.pieces.size(); ++i) {
    const std::string where = json::pointer_to(json::pointer_to("/pieces", i), "placement");
    const sewing::Placement placement =
        TRY(places.placement(project.pieces[i].placement, input.pattern.panels[i], where));
    input.placements.push_back(placement);
  }
  const auto hold = [&](const project::ProjectAttachment& given, const std::string& at) {
    return attachment_of(given, names, places, at);
  };
  return make_all(project.attachments, "/attachments", input.attachments, hold);
}

}  // namespace toile::resolve
