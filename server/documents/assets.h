#pragma once
// Uploaded files: read before they are kept, so that a broken one is told at once and a good one has its
// summary.

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/image/read_picture.h"
#include "server/documents/documents.h"

namespace toile::documents {

inline constexpr std::size_t kMostDxfBytes = std::size_t{50} << 20;
inline constexpr std::size_t kMostBodyBytes = std::size_t{100} << 20;
inline constexpr std::size_t kMostSpecificationBytes = std::size_t{4} << 20;
inline constexpr std::size_t kMostShapeBytes = std::size_t{32} << 20;
inline constexpr std::size_t kMostImageBytes = image::PictureLimits{}.bytes;

/// How many there are, in an answer.
json::JsonValue count_of(std::size_t count);

bool is_asset_kind(std::string_view kind);
/// Their names in a sentence.
std::string asset_kinds_text();
/// Of a file of that kind.
std::size_t most_asset_bytes(std::string_view kind);

/// Reads the file and keeps it. `kind` is "dxf", "specification" (GarmentCode), "body", "image" or
/// "shape" (proto/hung.md); `name` has
/// no folders, and that of a body ends as its format does; of an image the bytes tell the format. What
/// reading told stands in `info`, a JSON object:
///   dxf:  {"mm_per_unit", "pieces": [{"name", "width_mm", "height_mm", "points", "holes", "layer"}],
///   "notes": [text],
///          "note_count"}; of the notes the first hundred
///   specification: {"pieces", "seams"}, their numbers
///   body: {"vertices", "triangles", "width_m", "height_m", "depth_m", "closed", "notes": [text]}, the unit
///   guessed from the size, y up; notes say what was mended and what could not be
///   shape: {"pieces", "particles"}, their numbers
///   image: {"format": "png" or "jpeg", "width", "height", "opaque"}, pixels as they are shown
/// Errors: documents.kind, documents.too_large; dxf.*, garmentcode.*, mesh.*, image.* with the file's name
/// first in `where`; store.*.
Result<store::AssetRow> add_asset(Documents& documents, const store::RequestContext& context,
                                  const std::string& kind, const std::string& name, std::string_view bytes);

/// The media type of a kept image's bytes: one that a browser shows and does not run.
std::string image_media_type(std::string_view bytes);

}  // namespace toile::documents
