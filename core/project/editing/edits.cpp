#include "core/project/editing/edits.h"

#include <algorithm>
#include <utility>

#include "core/base/names.h"
#include "core/fabric/library.h"
#include "core/pattern/curve.h"
#include "core/project/bodies.h"
#include "core/project/create/create.h"
#include "core/project/editing/parts.h"
#include "core/project/resolve/pieces.h"
#include "core/project/resolve/resolve.h"

namespace toile::editing {
namespace {

/// A project while it is edited, with its pattern once an edit needs it.
struct Editing {
  project::Project project;
  std::optional<pattern::Pattern> pattern;
  resolve::OpenedFiles& files;
};

/// The cloth alone: few edits touch the bodies, and to read them takes long.
Result<drape::DrapeInput> resolve_cloth(project::Project project, resolve::OpenedFiles& files) {
  return resolve::resolve_project(project::without_bodies(std::move(project)), files);
}

project::ProjectNotch project_notch(const pattern::Notch& notch) {
  project::ProjectNotch out{notch.at, notch.depth, std::nullopt};
  if (!(notch.inwards == Vec2{})) out.inwards = notch.inwards;
  return out;
}

/// The panel's shape as an outline of the document.
void write_shape(project::ProjectPiece& piece, const pattern::Panel& panel) {
  piece.from.reset();
  piece.edge_names.clear();
  piece.outline = create::outline_of(panel.outline);
  piece.holes.clear();
  // Read back, a hole is run the other way; so it is written.
  for (const pattern::Loop& hole : panel.holes)
    piece.holes.push_back(create::outline_of(pattern::reversed(hole)));
  piece.notches.clear();
  for (const pattern::Notch& notch : panel.notches) piece.notches.push_back(project_notch(notch));
  piece.grain = panel.grain;
}

/// The number of lines that stand in the piece's file: they are the panel's first.
std::size_t lines_of_file(const project::ProjectPiece& piece, const pattern::Panel& panel) {
  return piece.from ? panel.lines.size() - piece.lines.size() : 0;
}

/// A piece stays in its file while its shape and what is drawn in it there are the same.
void write_panel(project::ProjectPiece& piece, const pattern::Panel& panel, const pattern::Panel* before,
                 bool reshaped) {
  std::size_t filed = before ? lines_of_file(piece, *before) : 0;
  const auto first = panel.lines.begin();
  const bool lines_stay = panel.lines.size() >= filed && std::equal(first, first + std::ptrdiff_t(filed),
                                                                    before ? before->lines.begin() : first);
  if (reshaped || !lines_stay) {
    write_shape(piece, panel);
    filed = 0;
  }
  if (before && !(before->grain == panel.grain)) piece.grain = panel.grain;
  piece.lines.clear();
  for (auto line = first + std::ptrdiff_t(filed); line != panel.lines.end(); ++line)
    piece.lines.push_back({line->id, line->points, line->drawn});
  piece.fabric = panel.fabric;
}

template <typename T>
auto named(std::vector<T>& list, const std::string& id) {
  return std::find_if(list.begin(), list.end(), [&](const T& one) { return one.id == id; });
}

/// The pieces of the document as the edited pattern has them.
void write_pieces(project::Project& project, const pattern::Pattern& before,
                  const edit::EditedPattern& edited) {
  const edit::EditEffect& effect = edited.effect;
  std::vector<project::ProjectPiece>& pieces = project.pieces;
  if (effect.piece.empty()) {
    if (!effect.was.empty()) pieces.erase(named(pieces, effect.was));
    return;
  }
  if (!effect.copy_of.empty()) {
    project::ProjectPiece copy = *named(pieces, effect.copy_of);
    copy.id = effect.piece;
    pieces.push_back(std::move(copy));
  } else {
    named(pieces, effect.was)->id = effect.piece;
  }
  const auto at = named(pieces, effect.piece);
  const auto index = static_cast<std::size_t>(at - pieces.begin());
  const pattern::Panel* old = index < before.panels.size() ? &before.panels[index] : nullptr;
  write_panel(*at, edited.pattern.panels[index], old, effect.reshaped);
  // A picture stays where it lies on the cloth; of a piece that is turned over it shows its right side still.
  if (effect.motion && at->texture) at->texture->offset = edit::moved(at->texture->offset, *effect.motion);
  if (old && effect.motion && !effect.motion->middle) stay_in_space(*at, effect.motion->by);
}

Status apply_one(Editing& editing, const edit::PatternEdit& edit) {
  if (const auto* fabric = std::get_if<edit::SetFabric>(&edit);
      fabric && named(editing.project.fabrics, fabric->fabric) == editing.project.fabrics.end() &&
      !fabric::find(fabric->fabric)) {
    return Error{"edit.unknown_fabric",
                 "neither the project nor the library has a fabric " + in_quotes(fabric->fabric), ""};
  }
  if (!editing.pattern) {
    drape::DrapeInput input = TRY(resolve_cloth(editing.project, editing.files));
    editing.pattern = std::move(input.pattern);
  }
  edit::EditedPattern edited = TRY(edit::apply_edit(*editing.pattern, edit));
  TRY(follow_parts(editing.project, edited.effect));
  write_pieces(editing.project, *editing.pattern, edited);
  editing.project.seams.clear();
  for (const pattern::Seam& seam : edited.pattern.seams) {
    editing.project.seams.push_back(create::project_seam(edited.pattern, seam));
  }
  editing.pattern = std::move(edited.pattern);
  return {};
}

Result<project::ProjectPiece*> piece_of(project::Project& project, const std::string& id) {
  const auto found = named(project.pieces, id);
  if (found != project.pieces.end()) return &*found;
  return Error{"edit.unknown_piece", "There is no piece of that name.", "piece " + id};
}

Status apply_one(Editing& editing, const SetTexture& edit) {
  project::ProjectPiece* piece = TRY(piece_of(editing.project, edit.piece));
  piece->texture = edit.texture;
  return {};
}

Status apply_one(Editing& editing, const SetPhysical& edit) {
  project::ProjectPiece* piece = TRY(piece_of(editing.project, edit.piece));
  piece->physical = edit.physical;
  return {};
}

Status apply_one(Editing& editing, const SetSolver& edit) {
  editing.project.settings.solver = edit.solver;
  return {};
}

Status apply_one(Editing& editing, const SetMaxTime& edit) {
  editing.project.settings.max_time_s = edit.max_time_s;
  return {};
}

Status apply_one(Editing& editing, const RestoreLists& edit) {
  editing.pattern.reset();
  return restore(editing.project, edit);
}

/// The edited document, once it is found to be one that can be draped.
Result<EditedProject> checked(project::Project project, resolve::OpenedFiles& files, bool other_bodies) {
  Result<project::WrittenProject> written = project::write_checked(project);
  if (!written) return json::error_at("/edits", written.error());
  Result<drape::DrapeInput> input = other_bodies ? resolve::resolve_project(written->read_back, files)
                                                 : resolve_cloth(written->read_back, files);
  if (!input) return json::error_at("/edits", input.error());
  return EditedProject{
      std::move(project), std::move(written->line), {}, std::move(written->read_back), std::move(*input)};
}

/// What leads from `now` back to `before`.
std::vector<ProjectEdit> inverse_of(const project::Project& now, const project::Project& before) {
  std::vector<ProjectEdit> inverse;
  if (now.settings.solver != before.settings.solver) inverse.push_back(SetSolver{before.settings.solver});
  const double most = before.settings.max_time_s;
  if (now.settings.max_time_s != most) inverse.push_back(SetMaxTime{most});
  project::Project lists = now;
  lists.settings = before.settings;
  if (!(lists == before)) inverse.push_back(difference(lists, before));
  return inverse;
}

}  // namespace

Result<EditedProject> apply_edits(const project::Project& project, std::span<const ProjectEdit> edits,
                                  resolve::OpenedFiles& files, const pattern::Pattern* known) {
  Editing editing{project, std::nullopt, files};
  if (known) editing.pattern = *known;
  for (std::size_t i = 0; i < edits.size(); ++i) {
    const Status done = std::visit([&](const auto& edit) { return apply_one(editing, edit); }, edits[i]);
    if (!done) return json::error_at(json::pointer_to("/edits", i), done.error());
  }
  const bool other_bodies = editing.project.bodies != project.bodies;
  EditedProject out = TRY(checked(std::move(editing.project), files, other_bodies));
  out.inverse = inverse_of(out.project, project);
  return out;
}

Result<EditedProject> apply_edits(const project::Project& project, std::span<const ProjectEdit> edits,
                                  const resolve::ProjectFiles& files) {
  resolve::OpenedFiles opened(files);
  return apply_edits(project, edits, opened);
}

ProjectEdit edit_between(const project::Project& now, const project::Project& wanted) {
  return difference(now, wanted);
}

}  // namespace toile::editing
