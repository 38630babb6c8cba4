#pragma once
// A project document for a pattern that has none yet.

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/aabb.h"
#include "core/base/result.h"
#include "core/base/run_context.h"
#include "core/base/types.h"
#include "core/json/tree.h"
#include "core/pattern/dxf/read.h"
#include "core/pattern/pattern.h"
#include "core/pattern/seams/propose.h"
#include "core/project/project.h"

namespace toile::create {

struct NewProjectSettings {
  std::string name;           ///< of the project
  std::string pattern_file;   ///< the document's name for the pattern
  std::string body_file;      ///< and for the body
  dxf::DxfSettings dxf = {};  ///< unit, size and layers of a DXF file
  /// Corners of the box around the body, m, y up: pieces that come without a place stand around it.
  Aabb3 body{{-0.3, 0, -0.2}, {0.3, 1.7, 0.2}};
  /// Accepts the proposals of this confidence and above that can be sewn together; unset: none.
  std::optional<double> accept_seams;
};

struct NewProject {
  project::Project project;
  pattern::Pattern pattern;  ///< as the project has it, with its seams
  /// What was proposed, when the file had no seams of its own; seams name panels and edges of `pattern`.
  std::vector<seams::SeamProposal> proposals;
  std::vector<bool> accepted;      ///< which of them the project has: a proposal may be another's alternative
  std::vector<std::string> notes;  ///< what the file had that the project has not
  /// Of each piece: what its file says that it is cut of; empty where it says nothing.
  std::vector<std::string> materials = {};
};

/// A project with the pieces of a GarmentCode specification (text that begins with "{"), their seams and
/// places, or with those of a DXF file. Pieces of a DXF are cut as often as it says, mirrored ones as
/// outlines of the document; they stand flat in rows before and behind the body, after what their names say,
/// to be arranged. Cloth: as materials and names tell, see choose_fabrics.h; what holds up
/// trousers without a waistband: see waist_elastic.h. Pieces of a DXF that cannot be cut are left
/// out, and `notes` name them. Errors: those of read_garmentcode and read_dxf, pattern.* with the piece where
/// none can be cut; "cancelled".
Result<NewProject> new_project(std::string_view pattern_text, const NewProjectSettings& settings,
                               const RunContext& context = {});

/// The same for a drawing that is read already; settings.dxf is of no effect.
Result<NewProject> new_project(const dxf::DxfDrawing& drawing, const NewProjectSettings& settings,
                               const RunContext& context = {});

/// What the drawing's layers were said to stand for when it was read, as a document has it.
std::vector<std::pair<std::string, std::string>> given_layers(const dxf::DxfDrawing& drawing);

/// Whether the text is a GarmentCode specification rather than a DXF: it begins with "{".
bool is_specification(std::string_view text);

/// Least confidence of a seam that is sewn where nobody says otherwise.
inline constexpr double kSure = 0.8;

/// {id, confidence, to_wear, a, b [{piece, edge, reversed, from, to}], same_direction, length_a_mm,
/// length_b_mm}. Parts of an edge are fractions of its length. `to_wear`: of sewn_to_wear().
json::JsonValue proposal_json(const pattern::Pattern& pattern, const seams::SeamProposal& proposal,
                              bool to_wear);

/// All of them, surest first.
std::vector<json::JsonValue> proposals_json(const pattern::Pattern& pattern,
                                            const std::vector<seams::SeamProposal>& proposals);

/// The file's own seams, with confidence 1, or all proposals.
std::vector<json::JsonValue> seams_json(const NewProject& made);

/// The panel's outline as a document says it, curve by curve.
std::vector<project::ProjectEdge> outline_of(const pattern::Loop& loop);

/// The seam by the names of its pieces and edges.
project::ProjectSeam project_seam(const pattern::Pattern& pattern, const pattern::Seam& seam);

}  // namespace toile::create
