#pragma once
// Bodies as people look at them: what the tape says, where landmarks are, and the boxes of their parts.

#include <string>

#include "core/base/result.h"
#include "core/json/tree.h"
#include "core/project/resolve/resolve.h"
#include "server/documents/documents.h"

namespace toile::documents {

/// {"presets": [{"name", "sex", "measures_cm": {…}}], "measures": [{"name", "rule", "girth", "least_cm",
/// "most_cm"}]}: the size tables with all fourteen measures, what proportions give filled in.
std::string body_presets_json();

/// The members of a figure: "stands" and, when it does not, "why" {"code", "detail"}; "vertices",
/// "triangles", "low", "high"; "measures" [{"name", "girth", "cm", "at_cm", "rule", "line", "asked_cm" or
/// null}]; "landmarks" [{"name", "place", "own": true where the
/// document sets it}]; "boxes" [{"part", "centre", "axes", "half"}]. Places in metres. A
/// mesh that is no standing person has the first four members and empty lists.
std::vector<json::JsonMember> figure_members(const geometry::TriangleMesh& mesh,
                                             const measure::MeasureSet& asked);

/// How an uploaded body stands in its file, and its figure once it stands on the floor and looks to the
/// front: {"stance": {"unit_in_m", "up", "upside_down", "turned_degrees"} or null, …figure}. Errors:
/// store.not_found, documents.wrong_kind, mesh.*.
Result<std::string> asset_figure_json(Documents& documents, const store::RequestContext& context,
                                      const std::string& asset);

/// A body made from measures and kept as a file: {"asset": its row, …figure}. `wish` is a mannequin as a
/// project document has it; `name` is the file's, with or without ".obj". Errors: project.* with a pointer,
/// mannequin.*, store.*.
struct MadeBody {
  store::AssetRow asset;
  std::vector<json::JsonMember> figure;
};
Result<MadeBody> make_body(Documents& documents, const store::RequestContext& context,
                           const json::JsonValue& wish, const std::string& name);

/// {"bodies": [{"id", "file" or null, "mannequin" or null, "friction", "skin_offset_mm", …figure}]}, each in
/// its place; `documents` keeps figures that were found. Errors: those of reading the document and its
/// bodies.
Result<std::string> project_bodies_json(Documents& documents, const std::string& document,
                                        const resolve::ProjectFiles& files);

}  // namespace toile::documents
