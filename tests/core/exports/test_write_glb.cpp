#include "core/exports/write_glb.h"

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>
#include <assimp/scene.h>
#include <gtest/gtest.h>

#include <assimp/Importer.hpp>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>

#include "tests/core/exports/two_panels.h"
#include "tests/core/image/jpegs.h"
#include "tests/core/image/pictures.h"

namespace toile {
namespace {

using nlohmann::json;

std::uint32_t u32_at(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i) value = value << 8 | static_cast<unsigned char>(bytes.at(at + i));
  return value;
}

float float_at(const std::string& bytes, std::size_t at) {
  const std::uint32_t bits = u32_at(bytes, at);
  float value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

/// The file taken apart by the rules of the glTF 2.0 specification.
struct Glb {
  json doc;
  std::string binary;
};

Glb parse(const std::string& bytes) {
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_EQ(u32_at(bytes, 4), 2u);
  EXPECT_EQ(u32_at(bytes, 8), bytes.size());
  const std::uint32_t text_length = u32_at(bytes, 12);
  EXPECT_EQ(text_length % 4, 0u);
  EXPECT_EQ(bytes.substr(16, 4), "JSON");
  Glb glb{json::parse(bytes.substr(20, text_length)), ""};
  const std::size_t next = 20 + text_length;
  if (next == bytes.size()) return glb;
  const std::uint32_t binary_length = u32_at(bytes, next);
  EXPECT_EQ(binary_length % 4, 0u);
  EXPECT_EQ(bytes.substr(next + 4, 4), std::string("BIN\0", 4));
  EXPECT_EQ(next + 8 + binary_length, bytes.size());
  glb.binary = bytes.substr(next + 8);
  return glb;
}

std::size_t components(const json& accessor) {
  const std::string type = accessor["type"];
  return type == "SCALAR" ? 1 : type == "VEC2" ? 2 : 3;
}

std::size_t start_of(const Glb& glb, int accessor) {
  return glb.doc["bufferViews"][glb.doc["accessors"][accessor]["bufferView"].get<int>()]["byteOffset"];
}

std::vector<float> floats(const Glb& glb, int index) {
  const json& accessor = glb.doc["accessors"][index];
  EXPECT_EQ(accessor["componentType"], 5126);
  std::vector<float> values(accessor["count"].get<std::size_t>() * components(accessor));
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = float_at(glb.binary, start_of(glb, index) + 4 * i);
  return values;
}

std::vector<std::uint32_t> indices(const Glb& glb, int index) {
  EXPECT_EQ(glb.doc["accessors"][index]["componentType"], 5125);
  std::vector<std::uint32_t> values(glb.doc["accessors"][index]["count"].get<std::size_t>());
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = u32_at(glb.binary, start_of(glb, index) + 4 * i);
  return values;
}

const json& primitive(const Glb& glb, int node) {
  return glb.doc["meshes"][glb.doc["nodes"][node]["mesh"].get<int>()]["primitives"][0];
}

exports::GlbModel model_of(const TwoPanels& t, std::span<const body::Body> bodies = {}) {
  return {&t.garment, t.positions, t.names, t.fabrics, t.fabric_of_panel, bodies};
}

class WriteGlb : public ExportTest {
 protected:
  TwoPanels garment_ = two_panels();
  std::vector<body::Body> bodies_{small_body("mannequin")};
};

TEST_F(WriteGlb, MakesOneNamedNodePerPanelAndBody) {
  const Glb glb = parse(*exports::glb_bytes(model_of(garment_, bodies_)));
  ASSERT_EQ(glb.doc["nodes"].size(), 3u);
  EXPECT_EQ(glb.doc["nodes"][0]["name"], "front");
  EXPECT_EQ(glb.doc["nodes"][1]["name"], "back");
  EXPECT_EQ(glb.doc["nodes"][2]["name"], "mannequin");
  EXPECT_EQ(glb.doc["scenes"][0]["nodes"], json({0, 1, 2}));
  EXPECT_EQ(glb.doc["asset"]["version"], "2.0");
  EXPECT_EQ(glb.doc["buffers"].size(), 1u);
  EXPECT_EQ(glb.doc["buffers"][0]["byteLength"], glb.binary.size());
  EXPECT_FALSE(glb.doc["buffers"][0].contains("uri"));
}

TEST_F(WriteGlb, KeepsEveryAccessorInsideItsViewAndEveryViewInsideTheBuffer) {
  const Glb glb = parse(*exports::glb_bytes(model_of(garment_, bodies_)));
  for (const json& view : glb.doc["bufferViews"]) {
    EXPECT_LE(view["byteOffset"].get<std::size_t>() + view["byteLength"].get<std::size_t>(),
              glb.binary.size());
    EXPECT_EQ(view["byteOffset"].get<std::size_t>() % 4, 0u);
  }
  for (const json& accessor : glb.doc["accessors"]) {
    const json& view = glb.doc["bufferViews"][accessor["bufferView"].get<int>()];
    EXPECT_EQ(accessor["count"].get<std::size_t>() * components(accessor) * 4, view["byteLength"]);
    EXPECT_EQ(view["target"], accessor["type"] == "SCALAR" ? 34963 : 34962);
  }
}

TEST_F(WriteGlb, HasEachMapAsAnAttributeOfThePiecesOwnVertices) {
  exports::GlbModel model = model_of(garment_, bodies_);
  const std::vector<analysis::ClothMap> maps{{analysis::MapKind::kPressure, {0, 1, 2, 3, 4, 5, 6, 7}}};
  model.maps = maps;
  const Glb glb = parse(*exports::glb_bytes(model));
  EXPECT_EQ(floats(glb, primitive(glb, 1)["attributes"]["_PRESSURE"]), (std::vector<float>{4, 5, 6, 7}));
  EXPECT_FALSE(primitive(glb, 2)["attributes"].contains("_PRESSURE")) << "a body has none";
  const std::vector<analysis::ClothMap> shorter{{analysis::MapKind::kPressure, {0, 1}}};
  model.maps = shorter;
  EXPECT_EQ(exports::glb_bytes(model).error().code, "export.bad_garment");
}

TEST_F(WriteGlb, WritesPositionsAsFloatsWithTheirExactBounds) {
  const Glb glb = parse(*exports::glb_bytes(model_of(garment_)));
  const int accessor = primitive(glb, 1)["attributes"]["POSITION"];
  const std::vector<float> values = floats(glb, accessor);
  ASSERT_EQ(values.size(), 12u);
  for (int v = 0; v < 4; ++v) {
    EXPECT_EQ(values[3 * v], static_cast<float>(garment_.positions[4 + v].x));
    EXPECT_EQ(values[3 * v + 1], static_cast<float>(garment_.positions[4 + v].y));
    EXPECT_EQ(values[3 * v + 2], static_cast<float>(garment_.positions[4 + v].z));
  }
  const json& bounds = glb.doc["accessors"][accessor];
  EXPECT_EQ(bounds["min"].get<std::vector<float>>(), (std::vector<float>{0.1f, 1.0f, -0.1f}));
  EXPECT_EQ(bounds["max"].get<std::vector<float>>(), (std::vector<float>{0.1f, 1.2f, 0.0f}));
}

TEST_F(WriteGlb, CountsIndicesWithinEachPanel) {
  const Glb glb = parse(*exports::glb_bytes(model_of(garment_)));
  for (int node = 0; node < 2; ++node) {
    EXPECT_EQ(indices(glb, primitive(glb, node)["indices"]), (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
  }
}

TEST_F(WriteGlb, ShadesSmoothlyAcrossASeam) {
  const Glb glb = parse(*exports::glb_bytes(model_of(garment_)));
  const std::vector<float> front = floats(glb, primitive(glb, 0)["attributes"]["NORMAL"]);
  const std::vector<float> back = floats(glb, primitive(glb, 1)["attributes"]["NORMAL"]);
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(front[3 * 1 + i], back[i]);  // front's vertex 1 is sewn to back's first
  EXPECT_GT(front[3], 0.1f);
  EXPECT_GT(front[5], 0.1f);
  for (std::size_t v = 0; v < front.size(); v += 3) {
    EXPECT_NEAR(std::hypot(front[v], front[v + 1], front[v + 2]), 1, 1e-6);
  }
}

TEST_F(WriteGlb, CarriesTheFlatPieceInMetresAsTextureCoordinates) {
  const Glb glb = parse(*exports::glb_bytes(model_of(garment_, bodies_)));
  EXPECT_EQ(floats(glb, primitive(glb, 0)["attributes"]["TEXCOORD_0"]),
            (std::vector<float>{0, 0, 0.1f, 0, 0.1f, 0.2f, 0, 0.2f}));
  EXPECT_FALSE(primitive(glb, 2)["attributes"].contains("TEXCOORD_0"));
}

TEST_F(WriteGlb, GivesEachPanelItsFabricDoubleSided) {
  const Glb glb = parse(*exports::glb_bytes(model_of(garment_, bodies_)));
  const json& wool = glb.doc["materials"][primitive(glb, 0)["material"].get<int>()];
  EXPECT_EQ(wool["name"], "wool");
  EXPECT_EQ(wool["doubleSided"], true);
  EXPECT_EQ(wool["pbrMetallicRoughness"]["baseColorFactor"][0], 0.75);
  EXPECT_EQ(wool["pbrMetallicRoughness"]["metallicFactor"], 0.0);
  EXPECT_EQ(glb.doc["materials"][primitive(glb, 1)["material"].get<int>()]["name"], "linen");
  EXPECT_EQ(glb.doc["materials"][primitive(glb, 2)["material"].get<int>()]["name"], "body");
}

std::shared_ptr<const image::TextureImage> image_of(const std::string& name, std::string bytes) {
  image::ReadPicture read = image::read_picture(bytes).value();
  return std::make_shared<const image::TextureImage>(
      image::TextureImage{name, std::move(bytes), std::move(read)});
}

/// What the file has behind image `index`.
std::string image_bytes(const Glb& glb, int index) {
  const json& view = glb.doc["bufferViews"][glb.doc["images"][index]["bufferView"].get<int>()];
  EXPECT_FALSE(view.contains("target"));
  return glb.binary.substr(view["byteOffset"].get<std::size_t>(), view["byteLength"].get<std::size_t>());
}

TEST_F(WriteGlb, EmbedsThePictureOfAPanelAndLaysItOnTheCloth) {
  image::Textures textures;
  textures.images = {image_of("squares.png", test::png_of(test::squares(15)))};
  textures.of_panel = {image::lay_texture(0, {0, 1}, {0.01, 0.02}, 0.05, 1, 0)};
  exports::GlbModel model = model_of(garment_, bodies_);
  model.textures = &textures;
  const Glb glb = parse(*exports::glb_bytes(model));
  EXPECT_EQ(image_bytes(glb, 0), textures.images[0]->bytes);
  EXPECT_EQ(glb.doc["images"][0]["mimeType"], "image/png");
  EXPECT_EQ(glb.doc["samplers"][0]["wrapS"], 10497);
  EXPECT_EQ(glb.doc["samplers"][0]["wrapT"], 10497);
  const json& material = glb.doc["materials"][primitive(glb, 0)["material"].get<int>()];
  const json& surface = material["pbrMetallicRoughness"];
  EXPECT_EQ(glb.doc["textures"][surface["baseColorTexture"]["index"].get<int>()]["source"], 0);
  EXPECT_EQ(surface["baseColorFactor"], json({1.0, 1.0, 1.0, 1.0}));
  EXPECT_EQ(material["doubleSided"], true);
  const std::vector<float> at = floats(glb, primitive(glb, 0)["attributes"]["TEXCOORD_0"]);
  const std::vector<float> wanted{-0.2f, 1.4f, 1.8f, 1.4f, 1.8f, -2.6f, -0.2f, -2.6f};
  for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(at[i], wanted[i], 1e-6) << i;
  // The other panel is as it was.
  EXPECT_EQ(primitive(glb, 1)["material"], 0);
  EXPECT_EQ(floats(glb, primitive(glb, 1)["attributes"]["TEXCOORD_0"])[2], 0.1f);
  for (const json& view : glb.doc["bufferViews"]) EXPECT_EQ(view["byteOffset"].get<std::size_t>() % 4, 0u);
}

TEST_F(WriteGlb, SharesOnePictureBetweenFabricsUnlessTheyShineThrough) {
  image::Textures textures;
  textures.images = {image_of("squares.png", test::png_of(test::squares()))};
  textures.of_panel = {image::lay_texture(0, {0, 1}, {}, 0.1, 1, 0),
                       image::lay_texture(0, {1, 0}, {}, 0.2, 1, 0)};
  exports::GlbModel model = model_of(garment_);
  model.textures = &textures;
  const Glb opaque = parse(*exports::glb_bytes(model));
  EXPECT_EQ(opaque.doc["images"].size(), 1u);
  EXPECT_EQ(opaque.doc["materials"].size(), 5u);
  EXPECT_NE(primitive(opaque, 0)["material"], primitive(opaque, 1)["material"]);

  image::Picture lace = test::squares();
  for (std::size_t i = 3; i < lace.rgba.size(); i += 4) lace.rgba[i] = 0;
  textures.images = {image_of("lace.png", test::png_of(lace))};
  const Glb clear = parse(*exports::glb_bytes(model));
  ASSERT_EQ(clear.doc["images"].size(), 2u);
  const image::Picture on_wool = image::read_picture(image_bytes(clear, 0)).value().picture;
  EXPECT_TRUE(on_wool.opaque);
  EXPECT_NEAR(on_wool.rgba[0], 225, 1);  // 0.75 of light as sRGB
  EXPECT_NEAR(image::read_picture(image_bytes(clear, 1)).value().picture.rgba[0], 137, 1);
}

TEST_F(WriteGlb, EmbedsAPhotographThatWasHeldUprightAsItIsSeen) {
  image::Textures textures;
  textures.images = {image_of("photo.jpg", test::jpeg_of(test::squares(24), {.orientation = 6}))};
  textures.of_panel = {image::lay_texture(0, {0, 1}, {}, 0.1, 1, 0)};
  exports::GlbModel model = model_of(garment_);
  model.textures = &textures;
  const Glb glb = parse(*exports::glb_bytes(model));
  EXPECT_EQ(glb.doc["images"][0]["mimeType"], "image/png");
  EXPECT_EQ(image::read_picture(image_bytes(glb, 0)).value().picture, textures.images[0]->read.picture);
}

TEST_F(WriteGlb, KeepsAJpegAsItIs) {
  image::Textures textures;
  textures.images = {image_of("photo.jpg", test::jpeg_of(test::squares(24)))};
  textures.of_panel = {image::lay_texture(0, {0, 1}, {}, 0.1, 1, 0)};
  exports::GlbModel model = model_of(garment_);
  model.textures = &textures;
  const Glb glb = parse(*exports::glb_bytes(model));
  EXPECT_EQ(glb.doc["images"][0]["mimeType"], "image/jpeg");
  EXPECT_EQ(image_bytes(glb, 0), textures.images[0]->bytes);
}

TEST_F(WriteGlb, IsReadBackWithItsPictureByAssimp) {
  image::Textures textures;
  textures.images = {image_of("squares.png", test::png_of(test::squares()))};
  textures.of_panel = {image::lay_texture(0, {0, 1}, {0.01, 0.02}, 0.05, 1, 0)};
  exports::GlbModel model = model_of(garment_, bodies_);
  model.textures = &textures;
  const std::string bytes = *exports::glb_bytes(model);
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, "glb");
  ASSERT_NE(scene, nullptr) << importer.GetErrorString();
  ASSERT_EQ(scene->mNumMeshes, 3u);
  const aiMesh& front = *scene->mMeshes[0];
  ASSERT_TRUE(front.HasTextureCoords(0));
  EXPECT_NEAR(front.mTextureCoords[0][2].x, 1.8, 1e-6);
  EXPECT_NEAR(front.mTextureCoords[0][2].y, 1 + 2.6, 1e-6);  // assimp counts upwards
  aiString path;
  const aiMaterial& material = *scene->mMaterials[front.mMaterialIndex];
  ASSERT_EQ(material.GetTexture(AI_MATKEY_BASE_COLOR_TEXTURE, &path), aiReturn_SUCCESS);
  const aiTexture* const picture = scene->GetEmbeddedTexture(path.C_Str());
  ASSERT_NE(picture, nullptr);
  EXPECT_STREQ(picture->achFormatHint, "png");
  EXPECT_EQ(std::string(reinterpret_cast<const char*>(picture->pcData), picture->mWidth),
            textures.images[0]->bytes);
  aiTextureMapMode mode{};
  ASSERT_EQ(material.Get(AI_MATKEY_MAPPINGMODE_U(aiTextureType_BASE_COLOR, 0), mode), aiReturn_SUCCESS);
  EXPECT_EQ(mode, aiTextureMapMode_Wrap);
}

TEST_F(WriteGlb, RefusesAPictureThatIsNotThere) {
  image::Textures textures;
  textures.of_panel = {image::lay_texture(0, {0, 1}, {}, 0.1, 1, 0)};
  exports::GlbModel model = model_of(garment_);
  model.textures = &textures;
  EXPECT_EQ(exports::glb_bytes(model).error().code, "export.bad_index");
}

TEST_F(WriteGlb, LeavesOutAPanelWithoutTriangles) {
  garment_.garment.triangles.resize(2);
  garment_.garment.panel_of_triangle.resize(2);
  const Glb glb = parse(*exports::glb_bytes(model_of(garment_)));
  EXPECT_EQ(glb.doc["nodes"].size(), 1u);
}

TEST_F(WriteGlb, IsAValidFileWithoutAnything) {
  const Glb glb = parse(*exports::glb_bytes({}));
  EXPECT_TRUE(glb.binary.empty());
  for (const char* list : {"nodes", "meshes", "accessors", "bufferViews", "buffers"}) {
    EXPECT_FALSE(glb.doc.contains(list)) << "glTF allows no empty lists";
  }
}

TEST_F(WriteGlb, WritesAnyNameAsUtf8) {
  garment_.names[0] = "Rücken \"links\" \xff";
  const Result<std::string> bytes = exports::glb_bytes(model_of(garment_));
  ASSERT_TRUE(bytes.ok());
  EXPECT_EQ(parse(*bytes).doc["nodes"][0]["name"], "Rücken \"links\" \xEF\xBF\xBD");
}

TEST_F(WriteGlb, GivesTheSameBytesTwiceAndInTheFile) {
  const std::string bytes = *exports::glb_bytes(model_of(garment_, bodies_));
  EXPECT_EQ(bytes, *exports::glb_bytes(model_of(garment_, bodies_)));
  ASSERT_TRUE(exports::write_glb(directory_ / "a.glb", model_of(garment_, bodies_)).ok());
  EXPECT_EQ(file_text(directory_ / "a.glb"), bytes);
}

TEST_F(WriteGlb, RefusesWhatNoFloatCanHold) {
  garment_.positions[6].z = 1e39;
  const auto refused = exports::glb_bytes(model_of(garment_));
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, "export.not_finite");
  EXPECT_EQ(refused.error().where, "vertex 6");
  bodies_[0].mesh.vertices[0].x = std::numeric_limits<double>::infinity();
  const exports::GlbModel bodies_only{nullptr, {}, {}, {}, {}, bodies_};
  EXPECT_EQ(exports::glb_bytes(bodies_only).error().where, "mannequin");
}

TEST_F(WriteGlb, RefusesIndicesThatLeadNowhere) {
  TwoPanels broken = two_panels();
  broken.garment.triangles[1][2] = 4;  // a vertex of the other panel
  EXPECT_EQ(exports::glb_bytes(model_of(broken)).error().code, "export.bad_index");
  broken = two_panels();
  broken.fabric_of_panel[0] = 2;
  EXPECT_EQ(exports::glb_bytes(model_of(broken)).error().code, "export.bad_index");
  broken = two_panels();
  broken.garment.weld[0] = -1;
  EXPECT_EQ(exports::glb_bytes(model_of(broken)).error().code, "export.bad_index");
  bodies_[0].mesh.triangles[0][0] = 4;
  EXPECT_EQ(exports::glb_bytes(model_of(garment_, bodies_)).error().code, "export.bad_index");
}

TEST_F(WriteGlb, RefusesAGarmentThatDisagreesWithItself) {
  TwoPanels broken = two_panels();
  broken.garment.weld.pop_back();
  EXPECT_EQ(exports::glb_bytes(model_of(broken)).error().code, "export.bad_garment");
  broken = two_panels();
  broken.names.pop_back();
  EXPECT_EQ(exports::glb_bytes(model_of(broken)).error().code, "export.bad_garment");
  broken = two_panels();
  broken.garment.first_vertex = {0, 9, 8};
  EXPECT_EQ(exports::glb_bytes(model_of(broken)).error().code, "export.bad_garment");
}

}  // namespace
}  // namespace toile
