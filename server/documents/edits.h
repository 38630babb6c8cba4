#pragma once
// Edits of a project in the store, and their history: each kept with what undoes it.

#include <cstdint>
#include <functional>
#include <string>

#include "core/base/result.h"
#include "core/json/tree.h"
#include "server/documents/documents.h"
#include "server/documents/projects.h"

namespace toile::documents {

/// Does the edits (a JSON list, edit.schema.json) to the project when it stands at revision `expected` (0: at
/// any), and forgets what was undone. Errors: those of read_edits and apply_edits; json.too_large when the
/// document grows beyond its limit; documents.missing_file and documents.wrong_kind of a picture that an edit
/// names; those of check_more_files; store.*. `more_files` come to the project's own, and stay when the edits
/// are undone.
Result<store::ProjectRow> edit_project(Documents& documents, const store::RequestContext& context,
                                       const std::string& id, const json::JsonValue& edits, int expected,
                                       const ProjectFileMap& more_files = {});

/// Makes the project what `change` makes of it, as one step of its history. `change` gets the document, the
/// files that it may add to, and the same files to resolve it with. Errors: those of `change` and of
/// edit_project.
using ProjectChange = std::function<Result<project::Project>(
    const project::Project& now, ProjectFileMap& files, resolve::OpenedFiles& opened)>;
Result<store::ProjectRow> change_project(Documents& documents, const store::RequestContext& context,
                                         const std::string& id, int expected, const ProjectChange& change);

/// Undoes the newest step that is not undone: the document gets back the bytes of before. Errors:
/// edit.nothing_to_undo, store.*.
Result<store::ProjectRow> undo_edit(Documents& documents, const store::RequestContext& context,
                                    const std::string& id, int expected);

/// Does the oldest undone step again. Errors: edit.nothing_to_redo, those of apply_edits, store.*.
Result<store::ProjectRow> redo_edit(Documents& documents, const store::RequestContext& context,
                                    const std::string& id, int expected);

/// {"edits": [{"number", "undone", "created_ms", "edits"}], "next"}: newest first, from below the number
/// `before` (0: all), at most `limit`; next is the `before` of the page after it, or null. Errors: store.*.
Result<std::string> history_json(Documents& documents, const store::RequestContext& context,
                                 const std::string& id, std::int64_t before, int limit);

}  // namespace toile::documents
