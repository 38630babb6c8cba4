#pragma once
// What an uploaded pattern file holds, before a project is made of it.

#include <string>

#include "core/base/result.h"
#include "server/documents/documents.h"

namespace toile {

/// What a person says of the file, when it says nothing or something wrong.
struct ImportWishes {
  std::string unit;  ///< "mm", "cm" or "inch"; empty: by the evidence
  std::string size;  ///< of a graded file; empty: its sample size
};

/// import_json or specification_json (core/project/create/import_report.h) of a pattern asset, with "asset"
/// and "file" first and proposals of seams, or the seams of a specification. Each piece of a DXF has "from",
/// as a project document takes it; each piece "points" and "hole_points", its loops flattened to 0.2 mm (mm,
/// y up, counter-clockwise, first point not repeated; empty when it cannot be cut), and its edges "points" as
/// well. Last comes "document": a project to begin with, of all pieces that can be cut, as often as they are
/// cut, one cotton and a mannequin, without seams; null when no piece can be cut. Errors: store.not_found,
/// documents.wrong_kind, documents.unit, documents.size; dxf.*, garmentcode.* with the file's name first in
/// `where`.
Result<std::string> import_pattern(Documents& documents, const RequestContext& context,
                                   const std::string& asset, const ImportWishes& wishes);

}  // namespace toile
