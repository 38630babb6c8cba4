#include "server/documents/assets.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>

#include "core/json/tree.h"
#include "tests/core/image/pictures.h"
#include "tests/server/documents/documents_fixture.h"

namespace toile {
namespace {

double number_at(const json::JsonValue& value, const char* key) {
  const json::JsonValue* found = value.find(key);
  return found != nullptr && found->number() != nullptr ? *found->number() : -1;
}

TEST(Assets, TellThePiecesOfADrawing) {
  const TemporaryFolder folder;
  const auto store = opened_documents(folder.path());
  const Result<store::AssetRow> row =
      documents::add_asset(store.documents(), kMe, "dxf", "cloth.dxf", cloth_dxf());
  ASSERT_TRUE(row) << to_string(row.error());
  EXPECT_EQ(row->kind, "dxf");
  EXPECT_EQ(row->name, "cloth.dxf");
  const Result<json::JsonValue> info = json::parse_json(row->info);
  ASSERT_TRUE(info) << row->info;
  const auto* pieces = info->find("pieces")->array();
  ASSERT_EQ(pieces->size(), 1u) << row->info;
  EXPECT_EQ(*pieces->front().find("name")->text(), "CLOTH");
  EXPECT_EQ(number_at(pieces->front(), "width_mm"), 300);
  EXPECT_EQ(number_at(pieces->front(), "height_mm"), 300);
  EXPECT_EQ(number_at(pieces->front(), "points"), 4);
  EXPECT_EQ(number_at(pieces->front(), "holes"), 0);
  EXPECT_EQ(static_cast<double>(info->find("notes")->array()->size()), number_at(*info, "note_count"));
  EXPECT_EQ(*store->asset_bytes(kMe, row->id), cloth_dxf());
}

TEST(Assets, TellTheSizeOfABody) {
  const TemporaryFolder folder;
  const auto store = opened_documents(folder.path());
  const Result<store::AssetRow> row =
      documents::add_asset(store.documents(), kMe, "body", "Post.OBJ", kPostObj);
  ASSERT_TRUE(row) << to_string(row.error());
  const Result<json::JsonValue> info = json::parse_json(row->info);
  ASSERT_TRUE(info) << row->info;
  EXPECT_EQ(number_at(*info, "vertices"), 8);
  EXPECT_EQ(number_at(*info, "triangles"), 12);
  EXPECT_EQ(number_at(*info, "height_m"), 0.5);
  EXPECT_EQ(number_at(*info, "width_m"), 0.2);
  EXPECT_TRUE(std::filesystem::is_empty(store->scratch_folder())) << "what was read is tidied away";
}

TEST(Assets, KeepNothingOfAFileThatCannotBeRead) {
  const TemporaryFolder folder;
  const auto store = opened_documents(folder.path());
  const Result<store::AssetRow> drawing = documents::add_asset(
      store.documents(), kMe, "dxf", "cut.dxf", "0\nSECTION\n2\nENTITIES\n0\nLINE\n10\nwide\n");
  ASSERT_FALSE(drawing);
  EXPECT_TRUE(drawing.error().code.starts_with("dxf.")) << drawing.error().code;
  EXPECT_TRUE(drawing.error().where.starts_with("cut.dxf")) << drawing.error().where;
  for (const auto& [name, bytes] :
       {std::pair{"body.obj", "no mesh at all"}, std::pair{"body.stl", "solid"},
        std::pair{"body.glb", "glTFxxxx"}, std::pair{"body.obj", ""}, std::pair{"body", "v 0 0 0"},
        std::pair{"body.txt", kPostObj}, std::pair{"body.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"}}) {
    const Result<store::AssetRow> body = documents::add_asset(store.documents(), kMe, "body", name, bytes);
    ASSERT_FALSE(body) << name;
    EXPECT_TRUE(body.error().code.starts_with("mesh.")) << body.error().code;
    const std::string words = to_string(body.error());
    EXPECT_NE(words.find(name), std::string::npos) << words;
    EXPECT_EQ(words.find(folder.path()), std::string::npos) << "our folders are nobody's business: " << words;
  }
  EXPECT_TRUE(store->assets(kMe, "")->empty());
  EXPECT_TRUE(std::filesystem::is_empty(store->scratch_folder()));
}

/// A triangle whose coordinates are the 36 bytes of another file.
std::string gltf_of(const std::string& uri) {
  return R"({"asset": {"version": "2.0"}, "buffers": [{"uri": ")" + uri + R"(", "byteLength": 36}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], "nodes": [{"mesh": 0}],
    "scenes": [{"nodes": [0]}], "scene": 0})";
}

TEST(Assets, DoNotReadOtherFilesThatAnUploadedOneNames) {
  const TemporaryFolder folder;
  const auto store = opened_documents(folder.path());
  const std::array<float, 9> secret{0, 0, 0, 1, 0, 0, 0, 1, 0.25f};
  std::ofstream(folder.path() + "/secret", std::ios::binary)
      .write(reinterpret_cast<const char*>(secret.data()), sizeof secret);
  for (const std::string& uri : {std::string("../secret"), folder.path() + "/secret"}) {
    const Result<store::AssetRow> row =
        documents::add_asset(store.documents(), kMe, "body", "a.gltf", gltf_of(uri));
    EXPECT_FALSE(row) << row->info;
  }
  const std::string inside =
      "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAIA+";
  EXPECT_TRUE(documents::add_asset(store.documents(), kMe, "body", "a.gltf", gltf_of(inside)))
      << "its own bytes are read";
  const std::string with_material = std::string("mtllib ../secret\n") + kPostObj;
  EXPECT_TRUE(documents::add_asset(store.documents(), kMe, "body", "a.obj", with_material))
      << "without the material";
}

TEST(Assets, TellTheSizeOfAPictureByItsBytes) {
  const TemporaryFolder folder;
  const auto store = opened_documents(folder.path());
  const std::string png = test::png_of(test::squares(24));
  const Result<store::AssetRow> row =
      documents::add_asset(store.documents(), kMe, "image", "checks.jpg", png);
  ASSERT_TRUE(row) << to_string(row.error());
  EXPECT_EQ(row->info, R"({"format": "png", "width": 24, "height": 24, "opaque": true})");
  EXPECT_EQ(documents::image_media_type(*store->asset_bytes(kMe, row->id)), "image/png");
  const Result<store::AssetRow> cut =
      documents::add_asset(store.documents(), kMe, "image", "cut.png", png.substr(0, 60));
  ASSERT_FALSE(cut);
  EXPECT_EQ(cut.error().code, "image.truncated");
  EXPECT_EQ(cut.error().where, "cut.png");
  EXPECT_EQ(code_of(documents::add_asset(store.documents(), kMe, "image", "a.png", "<svg/>")),
            "image.format");
  const std::string large = png + std::string(std::size_t{20} << 20, ' ');
  EXPECT_EQ(code_of(documents::add_asset(store.documents(), kMe, "image", "a.png", large)),
            "documents.too_large");
  EXPECT_EQ(store->assets(kMe, "image")->size(), 1u);
}

TEST(Assets, HaveOneOfAFewKinds) {
  const TemporaryFolder folder;
  const auto store = opened_documents(folder.path());
  EXPECT_EQ(code_of(documents::add_asset(store.documents(), kMe, "picture", "a.png", "x")), "documents.kind");
  EXPECT_EQ(code_of(documents::add_asset(store.documents(), kMe, "", "a.dxf", cloth_dxf())),
            "documents.kind");
}

TEST(Assets, HaveALargestSize) {
  const TemporaryFolder folder;
  const auto store = opened_documents(folder.path());
  const std::string large((std::size_t{50} << 20) + 1, '\n');
  const Result<store::AssetRow> row = documents::add_asset(store.documents(), kMe, "dxf", "a.dxf", large);
  ASSERT_FALSE(row);
  EXPECT_EQ(row.error().code, "documents.too_large");
  EXPECT_NE(row.error().message.find("50 MiB"), std::string::npos);
}

TEST(Assets, RefuseNamesThatLeaveTheirFolder) {
  const TemporaryFolder folder;
  const auto store = opened_documents(folder.path());
  for (const char* name : {"../cloth.dxf", "/cloth.dxf", "a/b.dxf", "..", ".dxf", "a\n.dxf", ""}) {
    EXPECT_EQ(code_of(documents::add_asset(store.documents(), kMe, "dxf", name, cloth_dxf())),
              "store.bad_name")
        << name;
    EXPECT_EQ(code_of(documents::add_asset(store.documents(), kMe, "body", name, kPostObj)), "store.bad_name")
        << name;
  }
}

}  // namespace
}  // namespace toile
