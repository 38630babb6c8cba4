#pragma once
// Models in the formats that other programs take, written by assimp. final.glb and final.obj are our own.

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/types.h"

namespace toile::exports {

/// A surface of one colour.
struct ModelPart {
  std::string name;
  std::vector<Vec3> positions;                  ///< m, y up
  std::vector<Vec3> normals;                    ///< unit, one a vertex
  std::vector<Vec2> coordinates;                ///< one a vertex, of a picture; none: no coordinates
  std::vector<Tri> triangles;                   ///< counter-clockwise seen from outside
  std::array<double, 3> colour{0.5, 0.5, 0.5};  ///< linear RGB, 0 to 1
};

struct ModelFormat {
  const char* ending;      ///< of the file's name, without its point; the format's word as well
  const char* name;        ///< as people call it
  const char* id;          ///< assimp's
  bool colours;            ///< a colour a vertex stands in it; else materials do, if anything
  double units_per_metre;  ///< unless told otherwise: printers take numbers for millimetres
};

/// All of them, in the order in which people are told.
std::span<const ModelFormat> model_formats();

/// By its ending, in lower case; null when there is none.
const ModelFormat* model_format_named(std::string_view ending);

/// A file of a model; a second one lies beside the first (materials).
struct ModelFile {
  std::string name, bytes;
};

/// The model as files, the first named `stem` and the format's ending. REQUIRES parts with normals for each
/// vertex. Errors: export.not_finite, export.bad_index, export.empty (no triangle), export.model (assimp's
/// reason).
Result<std::vector<ModelFile>> model_files(std::span<const ModelPart> parts, const ModelFormat& format,
                                           const std::string& stem, double units_per_metre);

}  // namespace toile::exports
