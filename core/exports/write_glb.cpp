#include "core/exports/write_glb.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/base/write_file.h"
#include "core/exports/glb_looks.h"
#include "core/mesh/vertex_normals.h"

namespace toile::exports {
namespace {

using GltfJson = nlohmann::json;

// Numbers of the glTF 2.0 specification.
constexpr std::uint32_t kMagic = 0x46546C67;      // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;  // "JSON"
constexpr std::uint32_t kBinChunk = 0x004E4942;   // "BIN"
constexpr int kFloat = 5126, kUnsignedInt = 5125;
constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963;
constexpr int kRepeat = 10497, kLinear = 9729, kLinearMipmapLinear = 9987;
constexpr double kClothRoughness = 0.9, kBodyRoughness = 0.75;

void append_u32(std::string& bytes, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 0xFF);
}

void append_float(std::string& bytes, double value) {
  // Adding 0 takes the sign from a zero: one position, one spelling.
  append_u32(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(value + 0.0)));
}

/// One part of the model: its own vertices and its triangles among them.
struct Part {
  std::string name;
  int material = 0;
  std::vector<Vec3> positions, normals;
  std::vector<Vec2> texture_coordinates;  // empty for a body
  std::vector<Tri> triangles;
  std::vector<analysis::ClothMap> maps{};  // of its vertices
};

/// A vertex array of the binary chunk under construction, and the JSON that describes it.
class GltfBuffer {
 public:
  int add_positions(const std::vector<Vec3>& values) {
    const int accessor = add_vectors(values);
    // The specification wants the bounds of positions, as they are stored.
    GltfJson low = GltfJson::array(), high = GltfJson::array();
    for (const auto component : {&Vec3::x, &Vec3::y, &Vec3::z}) {
      const auto [least, most] =
          std::minmax_element(values.begin(), values.end(),
                              [&](const Vec3& a, const Vec3& b) { return a.*component < b.*component; });
      low.push_back(static_cast<float>((*least).*component + 0.0));  // as stored: rounded to float
      high.push_back(static_cast<float>((*most).*component + 0.0));
    }
    accessors_[accessor]["min"] = low;
    accessors_[accessor]["max"] = high;
    return accessor;
  }

  int add_vectors(const std::vector<Vec3>& values) {
    const std::size_t begin = bytes_.size();
    for (const Vec3& v : values) {
      append_float(bytes_, v.x);
      append_float(bytes_, v.y);
      append_float(bytes_, v.z);
    }
    return add_accessor(begin, kArrayBuffer, kFloat, "VEC3", values.size());
  }

  int add_texture_coordinates(const std::vector<Vec2>& values) {
    const std::size_t begin = bytes_.size();
    for (const Vec2& v : values) {
      append_float(bytes_, v.x);
      append_float(bytes_, v.y);
    }
    return add_accessor(begin, kArrayBuffer, kFloat, "VEC2", values.size());
  }

  int add_numbers(const std::vector<float>& values) {
    const std::size_t begin = bytes_.size();
    for (const float value : values) append_float(bytes_, static_cast<double>(value));
    return add_accessor(begin, kArrayBuffer, kFloat, "SCALAR", values.size());
  }

  int add_indices(const std::vector<Tri>& triangles) {
    const std::size_t begin = bytes_.size();
    for (const Tri& t : triangles) {
      for (const Index corner : t) append_u32(bytes_, static_cast<std::uint32_t>(corner));
    }
    return add_accessor(begin, kElementArrayBuffer, kUnsignedInt, "SCALAR", triangles.size() * 3);
  }

  /// The view of an image file; what comes after it starts aligned again.
  int add_image(const std::string& file) {
    views_.push_back({{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", file.size()}});
    bytes_ += file;
    bytes_.resize((bytes_.size() + 3) / 4 * 4, '\0');
    return static_cast<int>(views_.size()) - 1;
  }

  const std::string& bytes() const { return bytes_; }
  const GltfJson& views() const { return views_; }
  const GltfJson& accessors() const { return accessors_; }

 private:
  int add_accessor(std::size_t begin, int target, int component, const char* type, std::size_t count) {
    views_.push_back(
        {{"buffer", 0}, {"byteOffset", begin}, {"byteLength", bytes_.size() - begin}, {"target", target}});
    accessors_.push_back(
        {{"bufferView", views_.size() - 1}, {"componentType", component}, {"count", count}, {"type", type}});
    return static_cast<int>(accessors_.size()) - 1;
  }

  std::string bytes_;  // all components have four bytes and images are filled up: every view starts aligned
  GltfJson views_ = GltfJson::array(), accessors_ = GltfJson::array();
};

/// Finite also as the float that is written.
bool is_storable(Vec3 p) {
  const double most = std::numeric_limits<float>::max();
  return std::abs(p.x) <= most && std::abs(p.y) <= most && std::abs(p.z) <= most;
}

Error bad_garment(const std::string& message) {
  return {"export.bad_garment", message, "", ErrorKind::kInternal};
}

Status check_panels(const sewing::GarmentMesh& g, const GlbModel& model) {
  if (g.first_vertex.empty()) return bad_garment("the garment does not say where its panels start");
  const std::size_t panels = g.first_vertex.size() - 1;
  if (model.panel_names.size() != panels || model.fabric_of_panel.size() != panels) {
    return bad_garment("names or fabrics are not one per panel");
  }
  if (g.first_vertex.front() != 0 || g.first_vertex.back() != static_cast<Index>(g.rest.size()) ||
      !std::is_sorted(g.first_vertex.begin(), g.first_vertex.end())) {
    return bad_garment("the panels do not cover the vertices one after the other");
  }
  for (const Index fabric : model.fabric_of_panel) {
    if (fabric < 0 || fabric >= static_cast<Index>(model.fabrics.size())) {
      return Error{"export.bad_index", "a panel names a fabric that is not there", "", ErrorKind::kInternal};
    }
  }
  return {};
}

Status check_triangles(const sewing::GarmentMesh& g) {
  const auto panels = static_cast<Index>(g.first_vertex.size()) - 1;
  for (std::size_t t = 0; t < g.triangles.size(); ++t) {
    const Index panel = g.panel_of_triangle[t];
    const bool known = panel >= 0 && panel < panels;
    for (const Index corner : g.triangles[t]) {
      if (!known || corner < g.first_vertex[panel] || corner >= g.first_vertex[panel + 1]) {
        return Error{"export.bad_index", "a triangle names a vertex outside its panel",
                     "triangle " + std::to_string(t), ErrorKind::kInternal};
      }
    }
  }
  return {};
}

Status check_garment(const sewing::GarmentMesh& g, const GlbModel& model) {
  if (model.positions.size() != g.rest.size() || g.weld.size() != g.rest.size() ||
      g.panel_of_triangle.size() != g.triangles.size()) {
    return bad_garment("the garment's arrays differ in length");
  }
  for (const analysis::ClothMap& map : model.maps)
    if (map.values.size() != g.rest.size()) return bad_garment("a map has not one value a vertex");
  TRY(check_panels(g, model));
  for (std::size_t v = 0; v < g.rest.size(); ++v) {
    const std::string where = "vertex " + std::to_string(v);
    if (!is_storable(model.positions[v]) || !is_storable({g.rest[v].x, g.rest[v].y, 0})) {
      return Error{"export.not_finite", "a vertex has no finite position; nothing was written", where,
                   ErrorKind::kInternal};
    }
    if (g.weld[v] < 0 || g.weld[v] >= static_cast<Index>(g.rest.size())) {
      return Error{"export.bad_index", "a vertex is sewn to one that is not there", where,
                   ErrorKind::kInternal};
    }
  }
  return check_triangles(g);
}

Status check_body(const body::Body& body) {
  for (const Vec3& p : body.mesh.vertices) {
    if (!is_finite(p))
      return Error{"export.not_finite", "a body has a vertex without finite position", body.id,
                   ErrorKind::kInternal};
  }
  const auto count = static_cast<Index>(body.mesh.vertices.size());
  for (const Tri& t : body.mesh.triangles) {
    for (const Index corner : t) {
      if (corner < 0 || corner >= count) {
        return Error{"export.bad_index", "a body's triangle names a vertex that is not there", body.id,
                     ErrorKind::kInternal};
      }
    }
  }
  return {};
}

/// Of the fabrics' materials, the bodies', and the looks', in this order.
int first_look(const GlbModel& model) { return static_cast<int>(model.fabrics.size()) + 1; }

/// Its own fabric's material, or that of its picture too.
void dress(const GlbModel& model, const GlbLooks& looks, std::size_t panel, std::span<const Vec2> rest,
           Part& part) {
  const int look = looks.look_of_panel.empty() ? kNone : looks.look_of_panel[panel];
  if (look == kNone) {
    part.material = model.fabric_of_panel[panel];
    part.texture_coordinates.assign(rest.begin(), rest.end());
    return;
  }
  part.material = first_look(model) + look;
  part.texture_coordinates =
      glb_coordinates(*image::texture_of(*model.textures, static_cast<Index>(panel)), rest);
}

void append_panels(const GlbModel& model, const GlbLooks& looks, std::vector<Part>& parts) {
  const sewing::GarmentMesh& g = *model.garment;
  const std::vector<Vec3> normals = mesh::vertex_normals(model.positions, g.triangles, g.weld);
  std::vector<Part> panels(g.first_vertex.size() - 1);
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const Index begin = g.first_vertex[p], end = g.first_vertex[p + 1];
    panels[p].name = model.panel_names[p];
    panels[p].positions.assign(model.positions.begin() + begin, model.positions.begin() + end);
    panels[p].normals.assign(normals.begin() + begin, normals.begin() + end);
    dress(model, looks, p, std::span(g.rest).subspan(begin, end - begin), panels[p]);
    for (const analysis::ClothMap& map : model.maps)
      panels[p].maps.push_back({map.kind, {map.values.begin() + begin, map.values.begin() + end}});
  }
  for (std::size_t t = 0; t < g.triangles.size(); ++t) {
    const Index panel = g.panel_of_triangle[t], begin = g.first_vertex[panel];
    const Tri& tri = g.triangles[t];
    // Every panel is a part with vertices of its own, so that seams keep two sides of texture.
    panels[panel].triangles.push_back({tri[0] - begin, tri[1] - begin, tri[2] - begin});
  }
  for (Part& panel : panels) {
    if (!panel.triangles.empty()) parts.push_back(std::move(panel));  // glTF allows no empty accessor
  }
}

void append_bodies(const GlbModel& model, std::vector<Part>& parts) {
  for (const body::Body& body : model.bodies) {
    if (body.mesh.triangles.empty()) continue;
    parts.push_back({body.id,
                     static_cast<int>(model.fabrics.size()),
                     body.mesh.vertices,
                     mesh::vertex_normals(body.mesh.vertices, body.mesh.triangles),
                     {},
                     body.mesh.triangles});
  }
}

GltfJson material(const std::string& name, const double* colour, double roughness, bool double_sided) {
  const auto part = [&](int i) { return std::clamp(colour[i], 0.0, 1.0); };
  return {{"name", name},
          {"doubleSided", double_sided},
          {"pbrMetallicRoughness",
           {{"baseColorFactor", {part(0), part(1), part(2), 1.0}},
            {"metallicFactor", 0.0},
            {"roughnessFactor", roughness}}}};
}

GltfJson materials(const GlbModel& model, const GlbLooks& looks) {
  GltfJson all = GltfJson::array();
  const auto name_of = [](const material::Fabric& fabric) {
    return fabric.name.empty() ? fabric.id : fabric.name;
  };
  for (const material::Fabric& fabric : model.fabrics)
    all.push_back(material(name_of(fabric), fabric.colour, kClothRoughness, true));
  all.push_back(material("body", model.body_colour.data(), kBodyRoughness, false));
  constexpr double kAsThePicture[] = {1, 1, 1};
  for (const GlbLook& look : looks.looks) {
    const std::string name = name_of(model.fabrics[look.fabric]) + ", " + looks.images[look.image].name;
    GltfJson one = material(name, kAsThePicture, kClothRoughness, true);
    one["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", look.image}};
    all.push_back(std::move(one));
  }
  return all;
}

/// Images, how they are repeated, and textures: one per image.
void add_images(const GlbLooks& looks, GltfBuffer& buffer, GltfJson& doc) {
  if (looks.images.empty()) return;  // glTF allows no empty lists
  GltfJson images = GltfJson::array(), textures = GltfJson::array();
  for (const GlbImage& image : looks.images) {
    textures.push_back({{"sampler", 0}, {"source", images.size()}});
    images.push_back({{"name", image.name},
                      {"mimeType", image.media_type},
                      {"bufferView", buffer.add_image(image.bytes)}});
  }
  doc["samplers"] = GltfJson::array(
      {{{"wrapS", kRepeat}, {"wrapT", kRepeat}, {"magFilter", kLinear}, {"minFilter", kLinearMipmapLinear}}});
  doc["images"] = std::move(images);
  doc["textures"] = std::move(textures);
}

/// The document, whose parts' arrays go to `buffer`.
GltfJson document(const GlbModel& model, const GlbLooks& looks, const std::vector<Part>& parts,
                  GltfBuffer& buffer) {
  GltfJson meshes = GltfJson::array(), nodes = GltfJson::array(), roots = GltfJson::array();
  for (const Part& part : parts) {
    GltfJson attributes = {{"POSITION", buffer.add_positions(part.positions)},
                           {"NORMAL", buffer.add_vectors(part.normals)}};
    if (!part.texture_coordinates.empty())
      attributes["TEXCOORD_0"] = buffer.add_texture_coordinates(part.texture_coordinates);
    for (const analysis::ClothMap& map : part.maps)
      attributes[std::string(analysis::trait_of(map.kind).attribute)] = buffer.add_numbers(map.values);
    const GltfJson primitive = {{"attributes", attributes},
                                {"indices", buffer.add_indices(part.triangles)},
                                {"material", part.material}};
    roots.push_back(nodes.size());
    nodes.push_back({{"name", part.name}, {"mesh", meshes.size()}});
    meshes.push_back({{"name", part.name}, {"primitives", GltfJson::array({primitive})}});
  }
  GltfJson doc = {{"asset", {{"version", "2.0"}, {"generator", "Toile"}}}, {"scene", 0}};
  doc["materials"] = materials(model, looks);
  add_images(looks, buffer, doc);
  doc["scenes"] = GltfJson::array({GltfJson::object()});
  if (buffer.views().empty()) return doc;  // glTF allows no empty lists
  if (!parts.empty()) {
    doc["scenes"][0]["nodes"] = roots;
    doc["nodes"] = nodes;
    doc["meshes"] = meshes;
    doc["accessors"] = buffer.accessors();
  }
  doc["bufferViews"] = buffer.views();
  doc["buffers"] = GltfJson::array({GltfJson{{"byteLength", buffer.bytes().size()}}});
  return doc;
}

/// Header, JSON chunk filled up with blanks, binary chunk (a multiple of 4 as it is).
Result<std::string> container(std::string text, const std::string& binary) {
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::uint64_t length = 12 + 8 + text.size() + (binary.empty() ? 0 : 8 + binary.size());
  if (length > std::numeric_limits<std::uint32_t>::max()) {
    return Error{"export.too_large", "a .glb file holds at most 4 GiB; export fewer pieces at once", "",
                 ErrorKind::kInternal};
  }
  std::string bytes;
  bytes.reserve(length);
  append_u32(bytes, kMagic);
  append_u32(bytes, 2);
  append_u32(bytes, static_cast<std::uint32_t>(length));
  append_u32(bytes, static_cast<std::uint32_t>(text.size()));
  append_u32(bytes, kJsonChunk);
  bytes += text;
  if (binary.empty()) return bytes;
  append_u32(bytes, static_cast<std::uint32_t>(binary.size()));
  append_u32(bytes, kBinChunk);
  return bytes += binary;
}

}  // namespace

Result<std::string> glb_bytes(const GlbModel& model) {
  std::vector<Part> parts;
  GlbLooks looks;
  if (model.garment != nullptr) {
    TRY(check_garment(*model.garment, model));
    if (model.textures != nullptr) {
      GlbLooks made = TRY(glb_looks(*model.textures, model.fabric_of_panel, model.fabrics));
      looks = std::move(made);
    }
    append_panels(model, looks, parts);
  }
  for (const body::Body& body : model.bodies) TRY(check_body(body));
  append_bodies(model, parts);
  GltfBuffer buffer;
  const GltfJson doc = document(model, looks, parts, buffer);
  // Names come from files: what is no UTF-8 is replaced rather than refused.
  return container(doc.dump(-1, ' ', false, GltfJson::error_handler_t::replace), buffer.bytes());
}

Status write_glb(const std::filesystem::path& path, const GlbModel& model) {
  const std::string bytes = TRY(glb_bytes(model));
  return write_file(path, bytes);
}

}  // namespace toile::exports
