#include "server/documents/arrangement.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/arrange/garment_graph.h"
#include "core/base/names.h"
#include "core/base/units.h"
#include "core/body/measure/segments.h"
#include "core/drape/worn_part.h"
#include "core/mesh/make_panel_meshes.h"
#include "core/project/create/places.h"
#include "core/project/resolve/resolve.h"
#include "server/documents/edits.h"
#include "server/documents/findings.h"
#include "server/documents/projects.h"

namespace toile::documents {
namespace {

constexpr double kFarthestMm = 5000;  // of a place from a box
const std::vector<std::string> kSideNames{"front", "back", "left", "right"};

std::vector<std::string> part_names() {
  std::vector<std::string> names;
  names.reserve(measure::kBodyParts);
  for (int p = 0; p < measure::kBodyParts; ++p)
    names.emplace_back(measure::name_of(static_cast<measure::BodyPart>(p)));
  return names;
}

/// The wearer's other side: "left_arm" ↔ "right_arm", "left" ↔ "right"; what has no side stays.
std::string other_side(const std::string& name) {
  if (name.starts_with("left")) return "right" + name.substr(4);
  if (name.starts_with("right")) return "left" + name.substr(5);
  return name;
}

/// Where the mirror image of a piece comes; the piece's own pattern may lie turned by `angle` (radians)
/// against its partner's.
PieceWish mirrored(const PieceWish& wish, const std::string& partner, double angle) {
  PieceWish out = wish;
  out.piece = partner;
  out.part = other_side(wish.part);
  out.side = other_side(wish.side);
  out.at_mm.x = -wish.at_mm.x;
  out.turn = -wish.turn - degrees_from_radians(angle);
  while (out.turn <= -180) out.turn += 360;
  while (out.turn > 180) out.turn -= 360;
  out.turn = std::round(out.turn * 1e6) / 1e6 + 0.0;
  return out;
}

/// Nothing where the piece has no mirror image.
std::optional<PieceWish> partners_wish(const drape::DrapeInput& input, const PieceWish& wish) {
  const Result<mesh::PanelMeshes> meshes =
      mesh::make_panel_meshes(input.pattern, input.settings.particle_distance, {});
  if (!meshes) return std::nullopt;
  const arrange::GarmentGraph graph = arrange::make_garment_graph(input.pattern, *meshes);
  const auto at = std::find_if(graph.pieces.begin(), graph.pieces.end(),
                               [&](const arrange::GarmentPiece& p) { return p.id == wish.piece; });
  if (at == graph.pieces.end()) return std::nullopt;
  const Index partner = arrange::mirror_partner(graph, static_cast<Index>(at - graph.pieces.begin()));
  if (partner == kNone) return std::nullopt;
  const arrange::GarmentPiece& other = graph.pieces[static_cast<std::size_t>(partner)];
  const std::optional<arrange::FlatMove> onto = arrange::lay_on(other, *at, true);
  return onto ? std::optional(mirrored(wish, other.id, onto->angle())) : std::nullopt;
}

/// Told by the body, so that the piece goes along when the measures change.
project::ProjectPlacement placement_of(const PieceWish& wish) {
  const Vec2 at{metres_from_mm(wish.at_mm.x), metres_from_mm(wish.at_mm.y)};
  const double away = metres_from_mm(wish.away_mm);
  project::ProjectPlacement out;
  if (wish.wrapped) {
    project::ProjectAround& around = out.around.emplace();
    around.part = wish.part;
    around.side = wish.side;
    around.at = at;
    around.away = std::max(away, 0.0);
    around.turn = wish.turn;
    around.flipped = wish.flipped;
  } else {
    project::ProjectOnBox& box = out.on_box.emplace();
    box.part = wish.part;
    box.side = wish.side;
    box.at = at;
    box.away = away;
    box.turn = wish.turn;
    box.flipped = wish.flipped;
  }
  return out;
}

Error bad_place(const std::string& message, const std::string& key) {
  return {"request.place", message, json::pointer_to("", key)};
}

Status read_word(const json::JsonValue& object, const char* key, const std::vector<std::string>& words,
                 std::string& out) {
  const json::JsonValue* value = object.find(key);
  if (!value) return {};
  if (!value->text() || std::find(words.begin(), words.end(), *value->text()) == words.end())
    return bad_place("this is one of a few words; " + advice(value->text() ? *value->text() : "", words),
                     key);
  out = *value->text();
  return {};
}

Status read_length(const json::JsonValue* value, const std::string& key, double most, double& out) {
  if (!value) return {};
  if (!value->number() || !(std::abs(*value->number()) <= most))
    return bad_place("this is a number of at most " + std::to_string(static_cast<int>(most)), key);
  out = *value->number();
  return {};
}

Status read_numbers(const json::JsonValue& object, PieceWish& wish) {
  if (const json::JsonValue* at = object.find("at_mm")) {
    if (!at->array() || at->array()->size() != 2) return bad_place("this is a list of two numbers", "at_mm");
    const auto& xy = *at->array();
    TRY(read_length(&xy[0], "at_mm", kFarthestMm, wish.at_mm.x));
    TRY(read_length(&xy[1], "at_mm", kFarthestMm, wish.at_mm.y));
  }
  TRY(read_length(object.find("away_mm"), "away_mm", kFarthestMm, wish.away_mm));
  return read_length(object.find("turn"), "turn", 360, wish.turn);
}

/// The arrangement of some pieces as one of all; the others stay where they are.
arrange::Arrangement of_all(arrange::Arrangement some, const drape::DrapeInput& input,
                            const drape::DrapeInput& worn) {
  std::vector<sewing::Placement> placements = input.placements;
  std::vector<Index> index;
  for (std::size_t p = 0; p < input.pattern.panels.size(); ++p) {
    const bool kept = index.size() < worn.pattern.panels.size() &&
                      worn.pattern.panels[index.size()].id == input.pattern.panels[p].id;
    if (!kept) continue;
    const auto now = static_cast<Index>(index.size());
    if (!std::binary_search(some.unplaced.begin(), some.unplaced.end(), now))
      placements[p] = some.placements[now];
    index.push_back(static_cast<Index>(p));
  }
  some.placements = std::move(placements);
  for (sewing::Attachment& a : some.attachments) a.panel = index[static_cast<std::size_t>(a.panel)];
  for (const drape::LeftOut& piece : worn.left_out)
    some.pieces.push_back({piece.id, "left where it is, nothing holds it"});
  drape::tell_left_out(worn, some.findings);
  return some;
}

/// Whether an arrangement before this one made it. An id alone does not tell, since a person may call their
/// own attachments as they like: it is all that such a hold is.
bool is_arranged_hold(const project::ProjectAttachment& a) {
  const std::string name = "hold_" + a.piece;
  if (!a.id.starts_with(name)) return false;
  const std::string rest = a.id.substr(name.size());  // "_2": another had the name
  const bool named = rest.empty() || (rest.size() > 1 && rest[0] == '_' &&
                                      rest.find_first_not_of("0123456789", 1) == std::string::npos);
  const sewing::Attachment usual;
  return named && a.hold == "height" && a.points.empty() && !a.to && a.release_after_s == usual.release_after;
}

/// `id`, with a number behind it where another attachment has it.
std::string free_id(const std::string& id, const std::vector<project::ProjectAttachment>& taken) {
  const auto has = [&](const std::string& name) {
    return std::any_of(taken.begin(), taken.end(), [&](const auto& a) { return a.id == name; });
  };
  std::string name = id;
  for (int n = 2; has(name); ++n) name = id + "_" + std::to_string(n);
  return name;
}

}  // namespace

Result<arrange::Arrangement> arrangement_of(const drape::DrapeInput& input) {
  const drape::DrapeInput worn = drape::worn_part(input);
  const mesh::PanelMeshes meshes =
      TRY(mesh::make_panel_meshes(worn.pattern, worn.settings.particle_distance, {}));
  arrange::Arrangement made =
      TRY(arrange::arrange({worn.pattern, meshes, worn.bodies, drape::names_left_out(worn)}));
  const bool all = worn.left_out.empty() && made.unplaced.empty();
  return all ? std::move(made) : of_all(std::move(made), input, worn);
}

void take_arrangement(const arrange::Arrangement& made, const pattern::Pattern& pattern,
                      project::Project& project) {
  for (std::size_t p = 0; p < project.pieces.size(); ++p) {
    project.pieces[p].placement = create::project_placement(made.placements[p]);
  }
  std::erase_if(project.attachments, is_arranged_hold);
  for (const sewing::Attachment& a : made.attachments) {
    project::ProjectAttachment hold = create::project_attachment(pattern, a);
    hold.id = free_id(hold.id, project.attachments);
    project.attachments.push_back(std::move(hold));
  }
}

std::vector<json::JsonMember> arrangement_members(const arrange::Arrangement& made) {
  std::vector<json::JsonValue> pieces, holds, findings;
  for (const arrange::ArrangedPiece& p : made.pieces)
    pieces.push_back(std::vector<json::JsonMember>{{"id", p.id}, {"place", p.where}});
  for (const sewing::Attachment& a : made.attachments) holds.emplace_back(a.id);
  for (const preflight::Finding& f : made.findings) findings.push_back(finding_json(f));
  return {{"pieces", std::move(pieces)}, {"holds", std::move(holds)}, {"findings", std::move(findings)}};
}

Result<ArrangedProject> arrange_project(Documents& documents, const store::RequestContext& context,
                                        const std::string& id, int expected) {
  json::JsonValue arrangement;
  const ProjectChange change = [&](const project::Project& now, ProjectFileMap&,
                                   resolve::OpenedFiles& opened) -> Result<project::Project> {
    const drape::DrapeInput input = TRY(resolve::resolve_project(now, opened));
    const arrange::Arrangement made = TRY(arrangement_of(input));
    arrangement = arrangement_members(made);
    project::Project wanted = now;
    take_arrangement(made, input.pattern, wanted);
    return wanted;
  };
  store::ProjectRow project = TRY(change_project(documents, context, id, expected, change));
  return ArrangedProject{std::move(project), std::move(arrangement)};
}

Result<PieceWish> read_piece_wish(const json::JsonValue& object) {
  PieceWish wish;
  const json::JsonValue* piece = object.find("piece");
  if (!piece || !piece->text()) return bad_place("\"piece\" is the id of a piece", "piece");
  wish.piece = *piece->text();
  TRY(read_word(object, "part", part_names(), wish.part));
  TRY(read_word(object, "side", kSideNames, wish.side));
  TRY(read_numbers(object, wish));
  for (const auto& [key, out] : {std::pair{"wrapped", &wish.wrapped},
                                 {"flipped", &wish.flipped},
                                 {"with_partner", &wish.with_partner}}) {
    const json::JsonValue* given = object.find(key);
    if (!given) continue;
    if (!given->boolean()) return bad_place("this is true or false", key);
    *out = *given->boolean();
  }
  return wish;
}

Result<store::ProjectRow> place_piece(Documents& documents, const store::RequestContext& context,
                                      const std::string& id, const PieceWish& wish, int expected) {
  const ProjectChange change = [&](const project::Project& now, ProjectFileMap&,
                                   resolve::OpenedFiles& opened) -> Result<project::Project> {
    const auto at = std::find_if(now.pieces.begin(), now.pieces.end(),
                                 [&](const project::ProjectPiece& piece) { return piece.id == wish.piece; });
    if (at == now.pieces.end())
      return Error{"edit.unknown_piece", "There is no piece of that name.", "piece " + clipped(wish.piece)};
    project::Project wanted = now;
    wanted.pieces[static_cast<std::size_t>(at - now.pieces.begin())].placement = placement_of(wish);
    const drape::DrapeInput input = TRY(resolve::resolve_project(wanted, opened));
    const std::optional<PieceWish> more = wish.with_partner ? partners_wish(input, wish) : std::nullopt;
    for (project::ProjectPiece& piece : wanted.pieces)
      if (more && piece.id == more->piece) piece.placement = placement_of(*more);
    return wanted;
  };
  return change_project(documents, context, id, expected, change);
}

}  // namespace toile::documents
