#pragma once
// Landmarks that a person moves or adds on a body of a project. Each change is one step of its history.

#include <string>

#include "core/base/result.h"
#include "core/base/types.h"
#include "server/documents/documents.h"

namespace toile::documents {

/// Puts the landmark `name` of a body to the skin nearest to `place` (m, in the scene): a new one, or one
/// that the body has by itself or the document sets. On a standing body it is told from a landmark and the
/// body's height, so that it goes along with changes of measures; else by its triangle. Errors:
/// request.landmark, edit.unknown_body, store.*, and those of reading the project.
Result<store::ProjectRow> move_landmark(Documents& documents, const store::RequestContext& context,
                                        const std::string& id, const std::string& body,
                                        const std::string& name, Vec3 place, int expected);

/// Takes what the document says of a landmark away: it is where the body has it by itself, or gone. Errors:
/// edit.unknown_body, edit.unknown_landmark, those of what is told by it, store.*.
Result<store::ProjectRow> forget_landmark(Documents& documents, const store::RequestContext& context,
                                          const std::string& id, const std::string& body,
                                          const std::string& name, int expected);

}  // namespace toile::documents
