#pragma once
// Who a project dresses. Each change is one step of the project's history.

#include <string>

#include "core/base/result.h"
#include "core/json/tree.h"
#include "core/project/project.h"
#include "server/documents/documents.h"
#include "server/documents/projects.h"

namespace toile::documents {

/// Puts a body into the project in place of the one called `body`, or beside the others when there is none of
/// that name. `wish` has "mannequin" as a document has it, or "asset", the id of an uploaded body; beside it
/// "friction" and "skin_offset_mm" may stand, and with a file "unit", "up" and "turn" (degrees about the
/// upright axis) where the guess is wrong. Errors: request.unknown_key, request.body, project.*, mannequin.*,
/// mesh.*, store.*.
Result<store::ProjectRow> dress_project(Documents& documents, const store::RequestContext& context,
                                        const std::string& id, const std::string& body,
                                        const json::JsonValue& wish, int expected);

/// A body that was asked for, and the project's files with its own.
struct DressedBody {
  project::ProjectBody body;
  ProjectFileMap files;
};
/// What dress_project would put into a project that has those files, under the id `body`. Nothing is changed.
/// Errors: as there.
Result<DressedBody> body_of_wish(Documents& documents, const store::RequestContext& context,
                                 const std::string& body, const json::JsonValue& wish,
                                 const ProjectFileMap& files);

/// Takes a body out of the project. Errors: edit.unknown_body, store.*, and those of what is told by it.
Result<store::ProjectRow> undress_project(Documents& documents, const store::RequestContext& context,
                                          const std::string& id, const std::string& body, int expected);

}  // namespace toile::documents
