#include "core/project/create/create.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/base/aabb.h"
#include "core/base/names.h"
#include "core/base/units.h"
#include "core/pattern/curve.h"
#include "core/pattern/garmentcode/read.h"
#include "core/pattern/own_mirror.h"
#include "core/pattern/seams/accept.h"
#include "core/pattern/seams/check.h"
#include "core/pattern/seams/garment_words.h"
#include "core/pattern/seams/piece_words.h"
#include "core/pattern/seams/upper_ends.h"
#include "core/pattern/validate.h"
#include "core/project/create/choose_fabrics.h"
#include "core/project/create/choose_mesh.h"
#include "core/project/create/collar_folds.h"
#include "core/project/create/cut_pieces.h"
#include "core/project/create/halves.h"
#include "core/project/create/waist_elastic.h"

namespace toile::create {
namespace {

project::ProjectRigid rigid_at(const garmentcode::GarmentCodePlace& place) {
  return {place.translation, place.rotation, place.flipped};
}

project::ProjectPiece inline_piece(const pattern::Panel& panel, const project::ProjectRigid& placement) {
  project::ProjectPiece piece;
  piece.id = panel.id;
  piece.outline = outline_of(panel.outline);
  for (const pattern::Loop& hole : panel.holes) piece.holes.push_back(outline_of(hole));
  for (const pattern::Notch& notch : panel.notches) {
    project::ProjectNotch& out = piece.notches.emplace_back(project::ProjectNotch{notch.at, notch.depth, {}});
    if (!(notch.inwards == Vec2{})) out.inwards = notch.inwards;
  }
  for (const pattern::InnerLine& line : panel.lines)
    piece.lines.push_back({line.id, line.points, line.drawn});
  if (panel.grain != Vec2{0, 1}) piece.grain = panel.grain;
  piece.placement.rigid = placement;
  return piece;
}

Status take_garmentcode(std::string_view text, NewProject& made) {
  garmentcode::GarmentCodeGarment garment = TRY(garmentcode::read_garmentcode(text));
  for (std::size_t p = 0; p < garment.panels.size(); ++p)
    made.project.pieces.push_back(
        inline_piece(garment.pattern.panels[p], rigid_at(garment.panels[p].placement)));
  made.pattern = std::move(garment.pattern);
  made.notes = std::move(garment.notes);
  return {};
}

/// The panel turned over, its edges under the same names in their own order.
pattern::Panel turned_over(const pattern::Panel& panel, std::string id) {
  pattern::Panel other = panel;
  other.id = std::move(id);
  const auto mirror = [](Vec2& p) { p.x = -p.x; };
  const auto turn = [&](pattern::Loop& loop) {
    for (pattern::PanelEdge& edge : loop.edges)
      for (pattern::CubicBezier& c : edge.curves)
        for (Vec2* p : {&c.p0, &c.p1, &c.p2, &c.p3}) mirror(*p);
    loop = pattern::reversed(loop);
  };
  turn(other.outline);
  for (pattern::Loop& hole : other.holes) turn(hole);
  mirror(other.grain);
  for (pattern::Notch& notch : other.notches) {
    mirror(notch.at);
    mirror(notch.inwards);
  }
  for (pattern::InnerLine& line : other.lines)
    for (Vec2& p : line.points) mirror(p);
  return other;
}

std::string unused_id(const std::string& wanted, std::set<std::string>& used) {
  std::string id = wanted;
  for (int n = 2; !used.insert(id).second; ++n) id = wanted + "_" + std::to_string(n);
  return id;
}

/// The piece as often as it is cut, `mirrored` of them turned over: from the file, and turned over or
/// `filled` in the document.
void take_dxf_piece(const dxf::DxfPiece& drawn, const pattern::Panel& panel, int count, int mirrored,
                    bool filled, const dxf::DxfDrawing& drawing, const NewProjectSettings& settings,
                    std::set<std::string>& used, NewProject& made, std::vector<char>& clockwise) {
  // More than a pair of a piece that is its own image are gores, which stand in a row; of a cuff or a collar
  // they are its layers.
  const seams::PieceKind kind = seams::words_of(drawn.name).kind;
  const bool layers = kind == seams::PieceKind::kCuff || kind == seams::PieceKind::kCollar;
  const bool row = count > 2 && !layers && pattern::is_own_mirror(panel.outline);
  for (int k = 0; k < count; ++k) {
    const bool over = !row && k >= count - mirrored;
    pattern::Panel copy = over ? turned_over(panel, "") : panel;
    const std::string end = row ? "_" + std::to_string(k + 1) : over && count > 1 ? "_mirrored" : "";
    copy.id = unused_id(drawn.name + end, used);
    copy.fabric = material_fabric(drawn.material);
    project::ProjectPiece piece = inline_piece(copy, {});
    if (!over && !filled) {
      const std::string& unit = drawing.unit.name;
      const bool told = unit == "mm" || unit == "cm" || unit == "inch";
      piece.outline.clear();
      piece.holes.clear();
      piece.notches.clear();
      piece.lines.clear();
      piece.from = project::ProjectDxf{settings.pattern_file, drawn.name,   {},
                                       told ? unit : "",      drawing.size, given_layers(drawing)};
    }
    made.project.pieces.push_back(std::move(piece));
    made.pattern.panels.push_back(std::move(copy));
    made.materials.push_back(drawn.material);
    clockwise.push_back(
        seams::runs_clockwise(drawn.outline));  // a copy turned over shows its right side, too
  }
}

Aabb2 box_of(const pattern::Panel& panel) { return bounding_box(pattern::flatten(panel.outline, 1)); }

/// Rows before and behind the body, each from the wearer's right to the left; right sides face outwards.
void stand_in_rows(const NewProjectSettings& settings, NewProject& made) {
  constexpr double kGap = 0.05, kAway = 0.15;  // m
  for (const bool back : {false, true}) {
    std::vector<std::size_t> row;
    double width = -kGap;
    for (std::size_t p = 0; p < made.pattern.panels.size(); ++p) {
      if ((seams::words_of(made.pattern.panels[p].id).face < 0) != back) continue;
      row.push_back(p);
      width += metres_from_mm(box_of(made.pattern.panels[p]).size().x) + kGap;
    }
    std::stable_sort(row.begin(), row.end(), [&](std::size_t x, std::size_t y) {
      return seams::words_of(made.pattern.panels[x].id).side >
             seams::words_of(made.pattern.panels[y].id).side;
    });
    double x = (settings.body.low.x + settings.body.high.x - width) / 2;  // the wearer's right is at -x
    const double middle = settings.body.middle().y;
    for (const std::size_t p : row) {
      const Aabb2 box = box_of(made.pattern.panels[p]);
      const double left = metres_from_mm(box.low.x), right = metres_from_mm(box.high.x);
      project::ProjectRigid& rigid = *made.project.pieces[p].placement.rigid;
      rigid.rotation.y = back ? 180 : 0;
      rigid.translation = {back ? x + right : x - left, middle - metres_from_mm(box.low.y + box.high.y) / 2,
                           back ? settings.body.low.z - kAway : settings.body.high.z + kAway};
      x += right - left + kGap;
    }
  }
}

const char* why(Twice twice) {
  switch (twice) {
    case Twice::kForgottenHalf:
      return "is half a garment wide and not symmetric, yet the file has it cut once";
    case Twice::kDrawnHalf:
      return "is not symmetric, and the file draws the garment by halves and counts no pieces";
    case Twice::kLimb:
      return "is of an arm or a leg, and the file neither counts pieces nor names sides";
    case Twice::kNo:
      break;
  }
  return "";
}

Status take_dxf(const dxf::DxfDrawing& given, const NewProjectSettings& settings, NewProject& made,
                std::vector<char>& clockwise) {
  constexpr int kMostCopies = 20;
  std::set<std::string> used;
  const CutPieces cut = TRY(cut_pieces(given));
  const dxf::DxfDrawing& drawing = cut.drawing;
  const std::vector<pattern::Panel>& panels = cut.panels;
  const std::vector<Twice> twice = taken_twice(drawing, panels);
  made.notes = drawing.notes;
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const dxf::DxfPiece& piece = drawing.pieces[p];
    const bool both = twice[p] != Twice::kNo;
    const int count = both ? 2 : std::clamp(piece.quantity, 1, kMostCopies);
    const int mirrored = both ? 1 : std::clamp(piece.mirrored, 0, count);
    take_dxf_piece(piece, panels[p], count, mirrored, cut.filled[p] != 0, drawing, settings, used, made,
                   clockwise);
    if (both)
      made.notes.push_back("piece " + in_quotes(piece.name) + " " + why(twice[p]) +
                           ": it is taken twice, once mirrored");
  }
  stand_in_rows(settings, made);
  return {};
}

/// Proposes seams and takes those that are sure enough, for a pattern that has none.
Status sew(const seams::ProposalSettings& sides, const NewProjectSettings& settings,
           const RunContext& context, NewProject& made) {
  if (!made.pattern.seams.empty()) return {};
  made.proposals = seams::propose_seams(made.pattern, sides, context);
  if (context.cancelled())
    return Error{"cancelled", "the search for seams was cancelled", "", ErrorKind::kCancelled};
  made.accepted.assign(made.proposals.size(), false);
  if (settings.accept_seams)
    made.accepted = seams::sewn_to_wear(made.pattern, made.proposals, *settings.accept_seams);
  for (std::size_t i = 0; i < made.proposals.size(); ++i)
    if (made.accepted[i]) made.pattern.seams.push_back(made.proposals[i].seam);
  return {};
}

void complete(const NewProjectSettings& settings, NewProject& made) {
  project::Project& project = made.project;
  project.name = settings.name;
  for (const pattern::Seam& seam : made.pattern.seams)
    project.seams.push_back(project_seam(made.pattern, seam));
  choose_fabrics(made.pattern, made.materials, project);
  choose_mesh(made.pattern, project.settings);
  project::ProjectBody body;
  body.id = "body";
  body.file = settings.body_file;
  project.bodies = {body};
}

/// Gives trousers and skirts that are pulled on the elastic of their casing.
void hold_at_waist(NewProject& made) {
  std::vector<pattern::Seam> sewn = made.pattern.seams;
  for (std::size_t i = 0; i < made.proposals.size(); ++i)
    if (made.proposals[i].confidence >= kSure) sewn.push_back(made.proposals[i].seam);
  made.project.elastics = waist_elastics(made.pattern, sewn);
  if (!made.project.elastics.empty())
    made.notes.push_back(
        "nothing but its upper edges holds the garment at the waist: elastics are sewn there, "
        "as in a casing");
}

/// Collars are small, turn sharply and are interlined, but for those of ribs.
void make_crisp(project::ProjectPiece& piece) {
  constexpr double kDistance = 8;  // mm
  if (!piece.physical) piece.physical.emplace();
  piece.physical->particle_distance_mm = kDistance;
  if (piece.fabric != "rib") piece.physical->interlining = "interlining";
}

/// Turns down the collars that are worn so.
void turn_collars_down(NewProject& made) {
  for (CollarFold& collar : collar_folds(made.pattern)) {
    std::vector<project::ProjectLine>& lines = made.project.pieces[collar.panel].lines;
    lines.insert(lines.end(), collar.lines.begin(), collar.lines.end());
    for (const Index p : {collar.panel, collar.stand})
      if (p != kNone) make_crisp(made.project.pieces[p]);
    made.project.folds.push_back(std::move(collar.fold));
  }
  if (!made.project.folds.empty())
    made.notes.push_back("collars are turned down: see the folds; without its fold a collar stands");
}

json::JsonValue side_json(const std::vector<project::ProjectSeamEdge>& side) {
  std::vector<json::JsonValue> edges;
  edges.reserve(side.size());
  for (const project::ProjectSeamEdge& e : side)
    edges.push_back(std::vector<json::JsonMember>{
        {"piece", e.piece}, {"edge", e.edge}, {"reversed", e.reversed}, {"from", e.from}, {"to", e.to}});
  return edges;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> given_layers(const dxf::DxfDrawing& drawing) {
  std::vector<std::pair<std::string, std::string>> given;
  for (const dxf::DxfLayerUse& layer : drawing.layers)
    if (layer.given) given.emplace_back(layer.name, dxf::role_word(layer.role));
  return given;
}

bool is_specification(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n\xef\xbb\xbf");
  return first != std::string_view::npos && text[first] == '{';
}

json::JsonValue proposal_json(const pattern::Pattern& pattern, const seams::SeamProposal& proposal,
                              bool to_wear) {
  const project::ProjectSeam seam = project_seam(pattern, proposal.seam);
  const auto thousandths = [](double x) { return std::round(x * 1000) / 1000; };
  return std::vector<json::JsonMember>{{"id", seam.id},
                                       {"confidence", thousandths(proposal.confidence)},
                                       {"to_wear", to_wear},
                                       {"a", side_json(seam.a)},
                                       {"b", side_json(seam.b)},
                                       {"same_direction", seam.same_direction},
                                       {"length_a_mm", thousandths(proposal.length_a)},
                                       {"length_b_mm", thousandths(proposal.length_b)}};
}

std::vector<json::JsonValue> proposals_json(const pattern::Pattern& pattern,
                                            const std::vector<seams::SeamProposal>& proposals) {
  const std::vector<bool> to_wear = seams::sewn_to_wear(pattern, proposals, kSure);
  std::vector<json::JsonValue> told;
  for (std::size_t i = 0; i < proposals.size(); ++i)
    told.push_back(proposal_json(pattern, proposals[i], to_wear[i]));
  return told;
}

std::vector<json::JsonValue> seams_json(const NewProject& made) {
  if (!made.proposals.empty()) {
    pattern::Pattern unsewn = made.pattern;  // seams that were taken are among the proposals
    unsewn.seams.clear();
    return proposals_json(unsewn, made.proposals);
  }
  std::vector<json::JsonValue> seams;
  for (const pattern::Seam& seam : made.pattern.seams)
    seams.push_back(proposal_json(
        made.pattern,
        {seam, 1, seams::series_length(made.pattern, seam.a), seams::series_length(made.pattern, seam.b)},
        true));
  return seams;
}

std::vector<project::ProjectEdge> outline_of(const pattern::Loop& loop) {
  std::vector<project::ProjectEdge> edges;
  for (const pattern::PanelEdge& edge : loop.edges) {
    project::ProjectEdge& out = edges.emplace_back();
    out.id = edge.id;
    for (const pattern::CubicBezier& c : edge.curves) out.curves.push_back({c.p0, c.p1, c.p2, c.p3});
  }
  return edges;
}

project::ProjectSeam project_seam(const pattern::Pattern& pattern, const pattern::Seam& seam) {
  const auto series = [&](const std::vector<pattern::SeamEdge>& side) {
    std::vector<project::ProjectSeamEdge> out;
    for (const pattern::SeamEdge& e : side) {
      const pattern::Panel& panel = pattern.panels[e.panel];
      out.push_back({panel.id, pattern::edges_of(panel)[e.edge]->id, e.reversed, e.from, e.to});
    }
    return out;
  };
  return {seam.id, series(seam.a), series(seam.b), seam.same_direction};
}

Result<NewProject> new_project(const dxf::DxfDrawing& drawing, const NewProjectSettings& settings,
                               const RunContext& context) {
  NewProject made;
  seams::ProposalSettings sides;
  TRY(take_dxf(drawing, settings, made, sides.clockwise));
  TRY(sew(sides, settings, context, made));
  complete(settings, made);
  hold_at_waist(made);
  turn_collars_down(made);
  return made;
}

Result<NewProject> new_project(std::string_view text, const NewProjectSettings& settings,
                               const RunContext& context) {
  if (!is_specification(text)) {
    const dxf::DxfDrawing drawing = TRY(dxf::read_dxf(text, settings.dxf));
    return new_project(drawing, settings, context);
  }
  NewProject made;
  TRY(take_garmentcode(text, made));
  TRY(sew({true, {}}, settings, context, made));
  complete(settings, made);
  return made;
}

}  // namespace toile::create
