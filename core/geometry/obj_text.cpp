#include "core/geometry/obj_text.h"

#include "core/base/text.h"

namespace toile::geometry {

void ObjText::reserve(std::size_t vertices, std::size_t triangles) {
  text_.reserve(text_.size() + vertices * 40 + triangles * 20);  // bytes of a usual line
}

void ObjText::number(double value) {
  text_ += ' ';
  // Adding 0 takes the sign from a zero: others may write "-0" or not, and the bytes should not tell.
  text_ += digits_ == ObjDigits::kAll ? number_text(value) : significant_text(value + 0.0, 9);
}

void ObjText::vertex(Vec3 p) {
  text_ += 'v';
  for (const double x : {p.x, p.y, p.z}) number(x);
  text_ += '\n';
}

void ObjText::texture_place(Vec2 p) {
  text_ += "vt";
  for (const double x : {p.x, p.y}) number(x);
  text_ += '\n';
}

void ObjText::object(std::string_view name) {
  text_ += "o ";
  if (name.empty()) text_ += '_';
  // A name ends at a blank and cannot hold control characters.
  for (const char c : name) text_ += static_cast<unsigned char>(c) <= ' ' || c == 127 ? '_' : c;
  text_ += '\n';
}

void ObjText::face(const Tri& t) {
  text_ += 'f';
  for (const Index corner : t) text_ += ' ' + std::to_string(corner + 1);
  text_ += '\n';
}

void ObjText::textured_face(const Tri& t) {
  text_ += 'f';
  for (const Index corner : t) {
    const std::string number = std::to_string(corner + 1);
    text_.append(1, ' ').append(number).append(1, '/').append(number);
  }
  text_ += '\n';
}

std::string obj_text(const TriangleMesh& mesh, ObjDigits digits) {
  ObjText text(digits);
  text.reserve(mesh.vertices.size(), mesh.triangles.size());
  for (const Vec3& p : mesh.vertices) text.vertex(p);
  for (const Tri& t : mesh.triangles) text.face(t);
  return text.take();
}

}  // namespace toile::geometry
