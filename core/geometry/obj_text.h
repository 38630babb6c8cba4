#pragma once
// Wavefront OBJ as text: the one place that knows how its lines are written.

#include <string>
#include <string_view>
#include <utility>

#include "core/base/types.h"
#include "core/geometry/triangle_mesh.h"

namespace toile::geometry {

/// How exactly coordinates are written.
enum class ObjDigits {
  kNine,  ///< significant digits, no signed zeros: a micrometre on a kilometre, for other programs to read
  kAll    ///< as many as read back as the same double: for meshes that Toile reads again
};

/// The lines of an OBJ file, in the order in which they are added.
class ObjText {
 public:
  explicit ObjText(ObjDigits digits = ObjDigits::kNine) : digits_(digits) {}

  void reserve(std::size_t vertices, std::size_t triangles);
  void vertex(Vec3 p);                 ///< m; the first is number 1 in the file
  void texture_place(Vec2 p);          ///< m on the flat piece: `vt`
  void object(std::string_view name);  ///< what follows belongs to it; blanks in the name become "_"
  void face(const Tri& t);             ///< corners counted from 0
  void textured_face(const Tri& t);    ///< whose corners have texture places of the same number
  std::string take() { return std::move(text_); }

 private:
  void number(double value);

  ObjDigits digits_;
  std::string text_;
};

/// The whole file of a mesh: its vertices, then its triangles.
std::string obj_text(const TriangleMesh& mesh, ObjDigits digits);

}  // namespace toile::geometry
