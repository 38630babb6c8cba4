#include "server/documents/assets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/aabb.h"
#include "core/base/hash.h"
#include "core/base/names.h"
#include "core/base/rounded.h"
#include "core/json/tree.h"
#include "core/pattern/dxf/read.h"
#include "core/pattern/garmentcode/read.h"
#include "core/warm/hung_garment.h"
#include "server/store/file_name.h"

namespace toile::documents {
namespace {

/// The kinds, and what the reader of each may be given at most.
constexpr std::array<std::pair<std::string_view, std::size_t>, 5> kKinds{{
    {"dxf", kMostDxfBytes},
    {"specification", kMostSpecificationBytes},
    {"body", kMostBodyBytes},
    {"image", kMostImageBytes},
    {"shape", kMostShapeBytes},
}};

const std::pair<std::string_view, std::size_t>* kind_named(std::string_view kind) {
  const auto* found =
      std::find_if(kKinds.begin(), kKinds.end(), [&](const auto& k) { return k.first == kind; });
  return found == kKinds.end() ? nullptr : found;
}

constexpr std::size_t kMostNotes = 100;
constexpr std::size_t kLongestText = 200;  // bytes of a name or note in a summary

/// To three decimals: thousandths of a millimetre, or millimetres, are enough for a summary.

json::JsonValue text_of(const std::string& text) { return json::JsonValue(clipped(text, kLongestText)); }

json::JsonValue summary_of(const dxf::DxfPiece& piece) {
  const Vec2 size = bounding_box(piece.outline).size();
  return json::JsonValue(std::vector<json::JsonMember>{
      {"name", json::JsonValue(piece.name)},  // whole: a document refers to it
      {"width_mm", rounded(size.x, 3)},
      {"height_mm", rounded(size.y, 3)},
      {"points", count_of(piece.outline.size())},
      {"holes", count_of(piece.holes.size())},
      {"layer", text_of(piece.layer)},
  });
}

/// Of a drawing whose layers have to be told before anything is found: who imports it says what they are.
json::JsonValue without_pieces(const Error& error) {
  return json::JsonValue(std::vector<json::JsonMember>{
      {"pieces", json::JsonValue(std::vector<json::JsonValue>{})},
      {"notes", json::JsonValue(std::vector<json::JsonValue>{text_of(to_string(error))})},
      {"note_count", count_of(1)},
  });
}

Result<std::string> dxf_info(const std::string& name, std::string_view bytes) {
  const Result<dxf::DxfDrawing> drawing = dxf::read_dxf(bytes);
  if (!drawing && dxf::layers_may_help(bytes, drawing.error()))
    return json::write_json_line(without_pieces(drawing.error()));
  if (!drawing) {
    Error error = drawing.error();
    error.where = error.where.empty() ? name : name + ": " + error.where;
    return error;
  }
  std::vector<json::JsonValue> pieces, notes;
  for (const dxf::DxfPiece& piece : drawing->pieces) pieces.push_back(summary_of(piece));
  for (const std::string& note : drawing->notes) {
    if (notes.size() < kMostNotes) notes.push_back(text_of(note));
  }
  return json::write_json_line(json::JsonValue(std::vector<json::JsonMember>{
      {"mm_per_unit", json::JsonValue(drawing->mm_per_unit)},
      {"pieces", json::JsonValue(std::move(pieces))},
      {"notes", json::JsonValue(std::move(notes))},
      {"note_count", count_of(drawing->notes.size())},
  }));
}

Result<std::string> specification_info(const std::string& name, std::string_view bytes) {
  const Result<garmentcode::GarmentCodeGarment> garment = garmentcode::read_garmentcode(bytes);
  if (!garment) {
    Error error = garment.error();
    error.where = error.where.empty() ? name : name + ": " + error.where;
    return error;
  }
  return json::write_json_line(json::JsonValue(std::vector<json::JsonMember>{
      {"pieces", count_of(garment->pattern.panels.size())},
      {"seams", count_of(garment->pattern.seams.size())},
  }));
}

Result<std::string> body_info(const mesh_import::MeshImporter& importer, const store::RequestContext& context,
                              const std::string& name, std::string_view bytes) {
  const mesh_import::RepairedMesh read = TRY(importer.bytes(name, bytes, {}, context.given_up.get()));
  const geometry::TriangleMesh& mesh = read.mesh;
  const Vec3 size = bounding_box(mesh.vertices).size();
  std::vector<json::JsonValue> notes;
  for (const std::string& words : mesh_import::repair_words(read.repairs)) notes.push_back(text_of(words));
  return json::write_json_line(json::JsonValue(std::vector<json::JsonMember>{
      {"vertices", count_of(mesh.vertices.size())},
      {"triangles", count_of(mesh.triangles.size())},
      {"width_m", rounded(size.x, 3)},
      {"height_m", rounded(size.y, 3)},
      {"depth_m", rounded(size.z, 3)},
      {"closed", json::JsonValue(read.repairs.open_shells == 0)},
      {"notes", json::JsonValue(std::move(notes))},
  }));
}

/// All of it is decoded: a picture that is kept can be drawn.
Result<std::string> image_info(const std::string& name, std::string_view bytes) {
  const Result<image::ReadPicture> read = image::read_picture(bytes);
  if (!read) return placed_at(read.error(), name);
  return json::write_json_line(json::JsonValue(std::vector<json::JsonMember>{
      {"format", json::JsonValue(std::string(read->format == image::PictureFormat::kPng ? "png" : "jpeg"))},
      {"width", json::JsonValue(static_cast<double>(read->width))},
      {"height", json::JsonValue(static_cast<double>(read->height))},
      {"opaque", json::JsonValue(read->picture.opaque)},
  }));
}

Result<std::string> shape_info(const std::string& name, std::string_view bytes) {
  const Result<warm::HungGarment> hung = warm::decode_hung(bytes);
  if (!hung) return placed_at(hung.error(), name);
  std::size_t particles = 0;
  for (const warm::HungPiece& piece : hung->pieces) particles += piece.positions.size();
  return json::write_json_line(json::JsonValue(std::vector<json::JsonMember>{
      {"pieces", count_of(hung->pieces.size())},
      {"particles", count_of(particles)},
  }));
}

Result<std::string> info_of(const mesh_import::MeshImporter& importer, const store::RequestContext& context,
                            const std::string& kind, const std::string& name, std::string_view bytes) {
  if (kind == "dxf") return dxf_info(name, bytes);
  if (kind == "specification") return specification_info(name, bytes);
  if (kind == "image") return image_info(name, bytes);
  if (kind == "shape") return shape_info(name, bytes);
  return body_info(importer, context, name, bytes);
}

}  // namespace

json::JsonValue count_of(std::size_t count) { return json::JsonValue(static_cast<double>(count)); }

bool is_asset_kind(std::string_view kind) { return kind_named(kind) != nullptr; }

std::size_t most_asset_bytes(std::string_view kind) {
  const auto* known = kind_named(kind);
  return known ? known->second : kMostBodyBytes;
}

std::string asset_kinds_text() {
  std::string text;
  for (std::size_t k = 0; k < kKinds.size(); ++k) {
    if (k > 0) text += k + 1 < kKinds.size() ? ", " : " or ";
    text += in_quotes(std::string(kKinds[k].first));
  }
  return text;
}

Result<store::AssetRow> add_asset(Documents& documents, const store::RequestContext& context,
                                  const std::string& kind, const std::string& name, std::string_view bytes) {
  if (!is_asset_kind(kind)) {
    return Error{"documents.kind", "a file is " + asset_kinds_text() + ", not " + in_quotes(kind), "",
                 ErrorKind::kMalformed};
  }
  TRY(store::check_name(name));
  const std::size_t most = most_asset_bytes(kind);
  if (bytes.size() > most) {
    return Error{"documents.too_large",
                 "the file has more than the " + std::to_string(most >> 20) + " MiB that are allowed", name,
                 ErrorKind::kTooLarge};
  }
  Result<std::string> read = info_of(documents.importer(), context, kind, name, bytes);
  if (!read) {  // who looks for what brings readers down finds the file by its hash
    context.log.info("upload refused", {{"code", read.error().code},
                                        {"kind", kind},
                                        {"bytes", std::to_string(bytes.size())},
                                        {"xxh3", hash_of(bytes)}});
    return read.error();
  }
  store::AssetRow row;
  row.kind = kind;
  row.name = name;
  row.info = std::move(*read);
  return documents.store().put_asset(context, std::move(row), bytes);
}

std::string image_media_type(std::string_view bytes) {
  const std::optional<image::PictureFormat> format = image::picture_format(bytes);
  return format ? std::string(image::media_type(*format)) : "application/octet-stream";
}

}  // namespace toile::documents
