#pragma once
// What an uploaded pattern file holds, before a project is made of it.

#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "server/documents/documents.h"

namespace toile::documents {

/// What a person says of the file, when it says nothing or something wrong.
struct ImportWishes {
  std::string unit;  ///< "mm", "cm" or "inch"; empty: by the evidence
  std::string size;  ///< of a graded file; empty: its sample size
  /// What layers of a DXF stand for, by their names, in the words of core/pattern/dxf/layers.h.
  std::vector<std::pair<std::string, std::string>> layers = {};
};

/// import_json or specification_json (core/project/create/import_report.h) of a pattern asset, with "asset"
/// and "file" first and proposals of seams, or the seams of a specification. Each piece of a DXF has "from",
/// as a project document takes it; each piece "points" and "hole_points", its loops flattened to 0.2 mm (mm,
/// y up, counter-clockwise, first point not repeated; empty when it cannot be cut), and its edges "points" as
/// well. Last comes "document": a project to begin with, of all pieces that can be cut, as often as they are
/// cut, one cotton and a mannequin, without seams; null when no piece can be cut. Errors: store.not_found,
/// documents.wrong_kind, documents.unit, documents.size, documents.layers; dxf.*, garmentcode.* with the
/// file's name first in `where`.
Result<std::string> import_pattern(Documents& documents, const store::RequestContext& context,
                                   const std::string& asset, const ImportWishes& wishes);

/// {"asset", "file", "layers": layers_json (core/project/create/import_report.h)} of a DXF asset as it is
/// read when nobody says otherwise, also of one in which no piece can be found so. Errors: store.not_found,
/// documents.wrong_kind; dxf.* with the file's name first in `where`.
Result<std::string> pattern_layers(Documents& documents, const store::RequestContext& context,
                                   const std::string& asset);

}  // namespace toile::documents
