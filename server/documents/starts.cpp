#include "server/documents/starts.h"

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/aabb.h"
#include "core/base/units.h"
#include "core/drape/fit_start.h"
#include "core/drape/pipeline.h"
#include "core/drape/worn_part.h"
#include "core/project/project.h"
#include "proto/cpp/frame_codec.h"
#include "proto/cpp/message_bytes.h"
#include "server/documents/findings.h"
#include "server/documents/piece_stand.h"
#include "server/documents/projects.h"
#include "server/documents/read_cloth.h"
#include "server/documents/stream_pieces.h"

namespace toile::documents {
namespace {

std::string geometry_of(const drape::DrapeInput& input, const sewing::Assembly& assembly) {
  const std::vector<Vec3>& points = assembly.positions;
  const Aabb3 extent = bounding_box(points);
  const std::string topology = proto::encode_topology(
      1, proto::grid_for(extent.low, extent.high), assembly.garment, stream_pieces(input, assembly.garment));
  std::string out;
  out.reserve(4 + topology.size() + 12 * points.size());
  proto::put(out, static_cast<std::uint32_t>(topology.size()));
  out += topology;
  for (const Vec3& p : points)
    for (const double x : {p.x, p.y, p.z}) proto::put(out, static_cast<float>(x));
  return out;
}

json::JsonValue vector_json(Vec3 p) { return std::vector<json::JsonValue>{p.x, p.y, p.z}; }

/// A place in the words of a request to place the piece; null where there is nothing to say.
json::JsonValue wish_json(const std::optional<PieceWish>& wish) {
  if (!wish) return {};
  return std::vector<json::JsonMember>{{"part", wish->part},
                                       {"side", wish->side},
                                       {"at_mm", std::vector<json::JsonValue>{wish->at_mm.x, wish->at_mm.y}},
                                       {"away_mm", wish->away_mm},
                                       {"turn", wish->turn},
                                       {"wrapped", wish->wrapped},
                                       {"flipped", wish->flipped}};
}

/// `assembly`: of all pieces; `found`: of those that would be draped.
std::string check_of(const project::Project& project, const drape::DrapeInput& input,
                     const sewing::Assembly& assembly, const preflight::Findings& found) {
  std::vector<json::JsonValue> findings, pieces;
  const PieceStands stands(input);
  for (const preflight::Finding& finding : found) findings.push_back(finding_json(finding));
  const sewing::GarmentMesh& garment = assembly.garment;
  for (std::size_t p = 0; p < input.pattern.panels.size(); ++p) {
    const auto first = static_cast<std::size_t>(garment.first_vertex[p]);
    const auto end = static_cast<std::size_t>(garment.first_vertex[p + 1]);
    const Aabb3 e = bounding_box(std::span(assembly.positions).subspan(first, end - first));
    const std::optional<PieceWish> hand = wish_of_hand(project.pieces[p]);
    pieces.push_back(
        std::vector<json::JsonMember>{{"id", input.pattern.panels[p].id},
                                      {"low", vector_json(e.low)},
                                      {"high", vector_json(e.high)},
                                      {"by_hand", wish_json(hand)},
                                      {"stands", wish_json(hand ? hand : stands.of(static_cast<Index>(p)))}});
  }
  return json::write_json_line(std::vector<json::JsonMember>{{"ready", !preflight::first_error(found)},
                                                             {"findings", std::move(findings)},
                                                             {"pieces", std::move(pieces)}}) +
         "\n";
}

Result<StartView> make_view(Documents& documents, const store::RequestContext& context,
                            const store::ProjectRow& row) {
  const project::Project project = TRY(project::parse_project(row.document));
  const drape::DrapeInput input =
      TRY(resolve::resolve_project(project, files_in_store(documents, context, row.files)));
  RunContext run;
  run.cancel = context.given_up.get();
  const drape::DrapeInput worn = drape::worn_part(input);
  drape::DrapeStart start = TRY(drape::prepare_start(worn, run));
  if (preflight::first_error(start.findings)) drape::fit_start(worn, start, run);
  if (run.cancelled())  // then it may have been left half dressed, which nobody must keep
    return Error{"cancelled", "nobody waits for the start any more", "", ErrorKind::kCancelled};
  if (worn.left_out.empty())
    return StartView{check_of(project, input, start.assembly, start.findings),
                     geometry_of(input, start.assembly)};
  const drape::DrapeStart whole = TRY(drape::prepare_start(input, run));
  return StartView{check_of(project, input, whole.assembly, start.findings),
                   geometry_of(input, whole.assembly)};
}

std::size_t bytes_of(const std::string& key, const StartView& view) {
  return key.size() + view.check.size() + view.geometry.size();
}

}  // namespace

Result<std::shared_ptr<const StartView>> start_of(Documents& documents, const store::RequestContext& context,
                                                  const store::ProjectRow& project) {
  const std::string key = key_of(context.owner, project.document, project.files);
  if (std::shared_ptr<const StartView> kept = documents.starts().find(key)) return kept;
  StartView made = TRY(make_view(documents, context, project));
  auto view = std::make_shared<const StartView>(std::move(made));
  documents.starts().keep(key, view, bytes_of(key, *view));
  return std::shared_ptr<const StartView>(std::move(view));
}

}  // namespace toile::documents
