#pragma once
// Edits of a project document: those of its pattern (core/pattern/edit/edit.h) and of what a project says of
// its pieces beside their shape. The same JSON (proto/schema/edit.schema.json) stands in requests, in the
// undo history and in a replay.

#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/base/result.h"
#include "core/drape/drape_input.h"
#include "core/json/tree.h"
#include "core/pattern/edit/edit.h"
#include "core/project/project.h"
#include "core/project/resolve/opened_files.h"

namespace toile::editing {

/// Without a texture: takes the one away that is there.
struct SetTexture {
  std::string piece;
  std::optional<project::ProjectTexture> texture = {};
};

/// Replaces all that the piece has otherwise than its fabric; nothing given: it is as its fabric.
struct SetPhysical {
  std::string piece;
  std::optional<project::ProjectPhysical> physical = {};
};

/// Which method drapes the garment: settings.solver of the document.
struct SetSolver {
  std::string solver;
};

/// After how much simulated time a drape that has not settled ends: settings.max_time_s of the document.
struct SetMaxTime {
  double max_time_s = 8;
};

/// In place of `remove` elements of a list from `at` on: those of `insert`.
template <typename T>
struct ListSplice {
  int at = 0, remove = 0;
  std::vector<T> insert = {};
};

/// Puts back parts of the document's lists: what an undo does.
struct RestoreLists {
  std::optional<ListSplice<project::ProjectPiece>> pieces;
  std::optional<ListSplice<project::ProjectSeam>> seams;
  std::optional<ListSplice<project::ProjectAttachment>> attachments;
  std::optional<ListSplice<project::ProjectButton>> buttons;
  std::optional<ListSplice<project::ProjectElastic>> elastics;
  std::optional<ListSplice<project::ProjectFold>> folds;
  std::optional<ListSplice<project::ProjectCushion>> cushions;
  std::optional<ListSplice<project::ProjectBody>> bodies;
};

using ProjectEdit =
    std::variant<edit::PatternEdit, SetTexture, SetPhysical, SetSolver, SetMaxTime, RestoreLists>;

/// Edits of one call at most.
inline constexpr std::size_t kMostEdits = 200;

/// A JSON list of edits, each an object with its kind in "edit". `where` is the list's JSON pointer. Errors:
/// edit.unknown, edit.too_many, and project.* as for a document.
Result<std::vector<ProjectEdit>> read_edits(const json::JsonValue& list, const std::string& where);

/// The list; read_edits gives the same edits back.
json::JsonValue edits_json(std::span<const ProjectEdit> edits);

/// The names of all edits, as they stand in "edit".
std::vector<std::string> edit_names();

/// The edits' format as JSON Schema: what proto/schema/edit.schema.json holds.
json::JsonValue edit_schema();

/// The edit that makes `now` what `wanted` is. REQUIRES projects that differ in the lists of RestoreLists
/// alone.
ProjectEdit edit_between(const project::Project& now, const project::Project& wanted);

struct EditedProject {
  project::Project project;
  std::string document;              ///< its text, one line
  std::vector<ProjectEdit> inverse;  ///< gives the project of before, every value the same
  project::Project read_back;        ///< what parse_project makes of the text
  drape::DrapeInput cloth;           ///< what the text resolves to; bodies are in it only when they changed
};

/// The project after the edits, one after the other: all of them or none. A piece from a file becomes an
/// outline of the document when its shape is changed. Attachments, buttons, elastics, folds and cushions
/// follow the names and places of what they are on, and go with it.
///
/// `known`: the pattern that the project resolves to, where somebody has it; else it is made when an edit
/// needs it.
///
/// Errors: those of apply_edit, edit.in_use (of two edges to be joined only one is held),
/// edit.unknown_fabric, with "/edits/2" first in `where`; and those of reading and resolving the document
/// that comes out, with "/edits" first.
Result<EditedProject> apply_edits(const project::Project& project, std::span<const ProjectEdit> edits,
                                  resolve::OpenedFiles& files, const pattern::Pattern* known = nullptr);
Result<EditedProject> apply_edits(const project::Project& project, std::span<const ProjectEdit> edits,
                                  const resolve::ProjectFiles& files);

}  // namespace toile::editing
