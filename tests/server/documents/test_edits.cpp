#include "server/documents/edits.h"

#include <gtest/gtest.h>

#include "core/project/project.h"
#include "core/project/resolve/textures.h"
#include "server/documents/imports.h"
#include "server/documents/proposals.h"
#include "server/documents/read_cloth.h"
#include "server/documents/views.h"
#include "tests/core/image/pictures.h"
#include "tests/open_counter.h"
#include "tests/server/documents/documents_fixture.h"

namespace toile {
namespace {

json::JsonValue json(const std::string& text) { return json::parse_json(text).value(); }

constexpr const char* kWider = R"([{"edit": "move_point", "piece": "cloth", "edge": "e1", "point": 1,
                                   "to": [310, 310]}])";
constexpr const char* kRename = R"([{"edit": "rename_piece", "piece": "cloth", "to": "napkin"}])";

struct EditedCloth : ClothStore {
  std::string id = documents::create_project(store.documents(), kMe, kClothDocument, files)->id;

  Result<store::ProjectRow> edit(const std::string& edits, int expected = 0) {
    return documents::edit_project(store.documents(), kMe, id, json(edits), expected);
  }
  Result<store::ProjectRow> undo() { return documents::undo_edit(store.documents(), kMe, id, 0); }
  Result<store::ProjectRow> redo() { return documents::redo_edit(store.documents(), kMe, id, 0); }
  std::string document() { return store->project(kMe, id)->document; }
};

TEST(EditsInStore, UndoGivesBackTheBytesThatWereUploaded) {
  EditedCloth at;
  ASSERT_TRUE(at.edit(kWider));
  const std::string wider = at.document();
  ASSERT_TRUE(at.edit(kRename));
  const std::string renamed = at.document();
  EXPECT_NE(wider, renamed);
  ASSERT_TRUE(at.undo());
  EXPECT_EQ(at.document(), wider);
  ASSERT_TRUE(at.undo());
  EXPECT_EQ(at.document(), kClothDocument) << "blanks and all";
  EXPECT_EQ(at.undo().error().code, "edit.nothing_to_undo");
  ASSERT_TRUE(at.redo());
  EXPECT_EQ(at.document(), wider);
  ASSERT_TRUE(at.redo());
  EXPECT_EQ(at.document(), renamed);
  EXPECT_EQ(at.redo().error().code, "edit.nothing_to_redo");
}

TEST(EditsInStore, SurviveARestart) {
  EditedCloth at;
  ASSERT_TRUE(at.edit(kWider));
  ASSERT_TRUE(at.edit(kRename));
  ASSERT_TRUE(at.undo());
  const std::string wider = at.document();
  at.store.reset();
  at.store = opened_documents(at.folder.path());
  ASSERT_TRUE(at.redo());
  ASSERT_TRUE(at.undo());
  EXPECT_EQ(at.document(), wider);
  ASSERT_TRUE(at.undo());
  EXPECT_EQ(at.document(), kClothDocument);
}

TEST(EditsInStore, TheEditedDocumentIsAProjectThatCanBeDraped) {
  EditedCloth at;
  const Result<store::ProjectRow> row = at.edit(kWider);
  ASSERT_TRUE(row) << to_string(row.error());
  EXPECT_EQ(row->revision, 2);
  const project::Project project = project::parse_project(row->document).value();
  EXPECT_FALSE(project.pieces[0].from);
  EXPECT_TRUE(
      resolve::resolve_project(project, documents::files_in_store(at.store.documents(), kMe, row->files)));
}

TEST(EditsInStore, RefusedEditsChangeNothing) {
  EditedCloth at;
  const Result<store::ProjectRow> wrong = at.edit(R"([{"edit": "mirror_piece", "piece": "sleeve"}])");
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().code, "edit.unknown_piece");
  EXPECT_EQ(wrong.error().where, "/edits/0: piece sleeve");
  EXPECT_EQ(at.edit(kRename, 7).error().code, "store.conflict");
  EXPECT_EQ(at.store->project(kMe, at.id)->revision, 1);
  EXPECT_EQ(at.document(), kClothDocument);
  EXPECT_EQ(documents::edit_project(at.store.documents(), kMe, "p_00000000000000000000", json("[]"), 0)
                .error()
                .code,
            "store.not_found");
}

TEST(EditsInStore, TheHistoryIsListedWithWhatWasDone) {
  EditedCloth at;
  ASSERT_TRUE(at.edit(kWider));
  ASSERT_TRUE(at.edit(kRename));
  ASSERT_TRUE(at.undo());
  const json::JsonValue first = json(documents::history_json(at.store.documents(), kMe, at.id, 0, 1).value());
  ASSERT_EQ(first.find("edits")->array()->size(), 1u);
  const json::JsonValue& step = first.find("edits")->array()->front();
  EXPECT_EQ(*step.find("number")->number(), 2);
  EXPECT_TRUE(*step.find("undone")->boolean());
  EXPECT_EQ(json::write_json_line(*step.find("edits")), json::write_json_line(json(kRename)));
  EXPECT_EQ(*first.find("next")->text(), "2");
  const json::JsonValue rest = json(documents::history_json(at.store.documents(), kMe, at.id, 2, 1).value());
  EXPECT_EQ(*rest.find("edits")->array()->front().find("number")->number(), 1);
  EXPECT_EQ(rest.find("next")->text(), nullptr);
}

TEST(Imports, TellWhatAFileHolds) {
  ClothStore at;
  const Result<std::string> text = documents::import_pattern(at.store.documents(), kMe, at.dxf, {"mm", ""});
  ASSERT_TRUE(text) << to_string(text.error());
  const json::JsonValue report = json(*text);
  EXPECT_EQ(*report.find("asset")->text(), at.dxf);
  EXPECT_EQ(*report.find("unit")->find("name")->text(), "mm");
  ASSERT_EQ(report.find("pieces")->array()->size(), 1u);
  const json::JsonValue& piece = report.find("pieces")->array()->front();
  EXPECT_EQ(*piece.find("area_mm2")->number(), 90000);
  EXPECT_EQ(*piece.find("from")->find("dxf")->text(), "cloth.dxf");
  EXPECT_EQ(*piece.find("from")->find("piece")->text(), "CLOTH");
  EXPECT_EQ(piece.find("points")->array()->size(), 4u);
  EXPECT_NE(report.find("report")->find("counts"), nullptr);
}

TEST(Imports, TakeAPersonsWordForTheUnit) {
  ClothStore at;
  const json::JsonValue report =
      json(documents::import_pattern(at.store.documents(), kMe, at.dxf, {"cm", ""}).value());
  EXPECT_EQ(*report.find("pieces")->array()->front().find("width_mm")->number(), 3000);
  EXPECT_EQ(*report.find("pieces")->array()->front().find("from")->find("units")->text(), "cm");
}

TEST(Imports, GiveADocumentThatMakesAProjectOnceItIsSent) {
  ClothStore at;
  const json::JsonValue report =
      json(documents::import_pattern(at.store.documents(), kMe, at.dxf, {"mm", ""}).value());
  EXPECT_EQ(*report.find("file")->text(), "cloth.dxf");
  const std::string document = json::write_json_line(*report.find("document"));
  const Result<project::Project> project = project::parse_project(document);
  ASSERT_TRUE(project) << to_string(project.error());
  EXPECT_TRUE(project->seams.empty());
  EXPECT_TRUE(project->bodies.front().mannequin);
  EXPECT_EQ(project->name, "cloth");
  const auto made = documents::create_project(at.store.documents(), kMe, document, {{"cloth.dxf", at.dxf}});
  ASSERT_TRUE(made) << to_string(made.error());
}

/// A square of 300 mm on layer 5, with a line on 1 in it that would have to be the outline, if nobody said
/// otherwise, and one on 9 that is its grain.
std::string odd_dxf() {
  std::string text = cloth_dxf();
  for (std::size_t at = 0; (at = text.find("8\nCUT\n", at)) != std::string::npos;)
    text.replace(at, 6, "8\n5\n");
  const auto line = [](const char* layer, const char* x) {
    return std::string("0\nLINE\n8\n") + layer + "\n10\n" + x + "\n20\n50\n11\n" + x + "\n21\n250\n";
  };
  return text.insert(text.find("0\nTEXT"), line("1", "100") + line("9", "200"));
}

struct OddStore : ClothStore {
  std::string odd = documents::add_asset(store.documents(), kMe, "dxf", "odd.dxf", odd_dxf())->id;
  const std::vector<std::pair<std::string, std::string>> layers{
      {"5", "cut"}, {"1", "internal"}, {"9", "grain"}};
};

TEST(Imports, OfAFileOfOtherLayersNeedToBeToldThem) {
  OddStore at;
  EXPECT_NE(at.store->asset(kMe, at.odd)->info.find("\"pieces\": []"), std::string::npos);
  EXPECT_EQ(documents::import_pattern(at.store.documents(), kMe, at.odd, {}).error().code,
            "dxf.open_outline");
  const json::JsonValue listed = json(documents::pattern_layers(at.store.documents(), kMe, at.odd).value());
  EXPECT_EQ(*listed.find("file")->text(), "odd.dxf");
  std::vector<std::string> names, roles;
  for (const json::JsonValue& layer : *listed.find("layers")->array()) {
    names.push_back(*layer.find("name")->text());
    roles.push_back(*layer.find("read_as")->text());
  }
  EXPECT_EQ(names, (std::vector<std::string>{"1", "5", "9"}));
  EXPECT_EQ(roles, (std::vector<std::string>{"cut", "grade", "guide"}));
}

TEST(Imports, KeepTheLayersThatTheyWereToldInTheDocument) {
  OddStore at;
  const documents::ImportWishes wishes{"mm", "", at.layers};
  const Result<std::string> text = documents::import_pattern(at.store.documents(), kMe, at.odd, wishes);
  ASSERT_TRUE(text) << to_string(text.error());
  const json::JsonValue report = json(*text);
  const json::JsonValue& piece = report.find("pieces")->array()->front();
  EXPECT_EQ(*piece.find("area_mm2")->number(), 90000);
  EXPECT_EQ(*piece.find("grain_deg")->number(), 90);
  EXPECT_EQ(*piece.find("lines")->number(), 1);
  EXPECT_EQ(*piece.find("from")->find("layers")->find("5")->text(), "cut");
  EXPECT_TRUE(*report.find("layers")->array()->front().find("given")->boolean());
  const std::string document = json::write_json_line(*report.find("document"));
  const std::vector<std::pair<std::string, std::string>> by_name{
      {"1", "internal"}, {"5", "cut"}, {"9", "grain"}};
  EXPECT_EQ(project::parse_project(document)->pieces.front().from->layers, by_name);
  const auto made = documents::create_project(at.store.documents(), kMe, document, {{"odd.dxf", at.odd}});
  ASSERT_TRUE(made) << to_string(made.error());
  const auto read = documents::read_cloth(at.store.documents(), kMe, made->document, made->files);
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_EQ((*read)->cloth.pattern.panels.front().lines.size(), 1u);
}

TEST(Imports, RefuseLayersThatAreNotThereWithTheirPlace) {
  OddStore at;
  const auto refused = [&](const documents::ImportWishes& wishes) {
    return documents::import_pattern(at.store.documents(), kMe, at.odd, wishes).error();
  };
  const Error layer = refused({"", "", {{"7", "cut"}}}), role = refused({"", "", {{"5", "cutt"}}});
  EXPECT_EQ(layer.code + layer.where, "dxf.unknown_layer/layers");
  EXPECT_EQ(role.code + role.where, "dxf.unknown_role/layers/5");
  EXPECT_NE(role.message.find("did you mean \"cut\""), std::string::npos) << role.message;
  const auto made = [&](const std::string& layers) {
    const std::string document = cloth_document("\"units\": \"mm\"", "\"layers\": " + layers);
    return documents::create_project(at.store.documents(), kMe, document, at.files).error();
  };
  const Error word = made(R"({"CUT": "saw"})"), name = made(R"({"TUC": "cut"})");
  EXPECT_EQ(word.code + word.where, "project.unknown_value/document/pieces/0/from/layers/CUT");
  EXPECT_EQ(name.code, "dxf.unknown_layer");
  EXPECT_TRUE(name.where.starts_with("/document/pieces/0/from/layers")) << name.where;
  EXPECT_EQ(documents::pattern_layers(at.store.documents(), kMe, at.body).error().code,
            "documents.wrong_kind");
}

constexpr const char* kTwoSquares = R"({"pattern": {"panels": {
  "left": {"translation": [0, 0, 0], "rotation": [0, 0, 0], "vertices": [[0, 0], [10, 0], [10, 10], [0, 10]],
    "edges": [{"endpoints": [0, 1]}, {"endpoints": [1, 2]}, {"endpoints": [2, 3]}, {"endpoints": [3, 0]}]},
  "right": {"translation": [20, 0, 0], "rotation": [0, 0, 0], "vertices": [[0, 0], [10, 0], [10, 10], [0, 10]],
    "edges": [{"endpoints": [0, 1]}, {"endpoints": [1, 2]}, {"endpoints": [2, 3]}, {"endpoints": [3, 0]}]}},
  "stitches": [[{"panel": "left", "edge": 1}, {"panel": "right", "edge": 3}]]},
  "properties": {"units_in_meter": 100}})";

TEST(Imports, TakeASpecificationWithItsSeamsAndPlaces) {
  ClothStore at;
  const Result<store::AssetRow> asset =
      documents::add_asset(at.store.documents(), kMe, "specification", "two.json", kTwoSquares);
  ASSERT_TRUE(asset) << to_string(asset.error());
  EXPECT_EQ(asset->info, "{\"pieces\": 2, \"seams\": 1}");
  const Result<std::string> text = documents::import_pattern(at.store.documents(), kMe, asset->id, {});
  ASSERT_TRUE(text) << to_string(text.error());
  const json::JsonValue report = json(*text);
  ASSERT_EQ(report.find("pieces")->array()->size(), 2u);
  EXPECT_EQ(*report.find("pieces")->array()->front().find("width_mm")->number(), 100);
  EXPECT_EQ(report.find("pieces")->array()->front().find("points")->array()->size(), 4u);
  ASSERT_EQ(report.find("seams")->array()->size(), 1u);
  EXPECT_EQ(*report.find("seams")->array()->front().find("confidence")->number(), 1);
  const auto made = documents::create_project(at.store.documents(), kMe,
                                              json::write_json_line(*report.find("document")), {});
  ASSERT_TRUE(made) << to_string(made.error());
  EXPECT_EQ(documents::import_pattern(at.store.documents(), kMe, asset->id, {"mm", ""}).error().code,
            "documents.unit");
  EXPECT_EQ(documents::import_pattern(at.store.documents(), kMe, asset->id, {"", "42"}).error().code,
            "documents.size");
  EXPECT_EQ(
      documents::import_pattern(at.store.documents(), kMe, asset->id, {"", "", {{"1", "cut"}}}).error().code,
      "documents.layers");
  EXPECT_EQ(documents::add_asset(at.store.documents(), kMe, "specification", "no.json", "{}").error().code,
            "garmentcode.missing");
}

TEST(Views, ShowCurvesLengthsAndWhatIsWrongWithSeams) {
  ClothStore at;
  const store::AssetRow asset =
      documents::add_asset(at.store.documents(), kMe, "specification", "two.json", kTwoSquares).value();
  const json::JsonValue report =
      json(documents::import_pattern(at.store.documents(), kMe, asset.id, {}).value());
  const std::string id = documents::create_project(at.store.documents(), kMe,
                                                   json::write_json_line(*report.find("document")), {})
                             ->id;
  const auto seam = [&](const std::string& edge) {
    return json(R"([{"edit": "add_seam", "id": "s", "a": [{"piece": "left", "edge": "e1"}],
                     "b": [{"piece": "right", "edge": ")" +
                edge + R"(", "to": 0.25}]}])");
  };
  ASSERT_TRUE(documents::edit_project(at.store.documents(), kMe, id, seam("e3"), 0));
  const auto view = [&] {
    const store::ProjectRow row = at.store->project(kMe, id).value();
    return json(documents::pieces_json(
        *documents::read_cloth(at.store.documents(), kMe, row.document, row.files).value()));
  };
  const json::JsonValue shown = view();
  const json::JsonValue& edge = shown.find("pieces")->array()->front().find("edges")->array()->at(1);
  EXPECT_EQ(*edge.find("id")->text(), "e1");
  EXPECT_EQ(*edge.find("length_mm")->number(), 100);
  EXPECT_EQ(edge.find("curves")->array()->front().array()->size(), 4u);
  const json::JsonValue& sewn = shown.find("seams")->array()->front();
  EXPECT_EQ(*sewn.find("length_a_mm")->number(), 100);
  EXPECT_EQ(*sewn.find("length_b_mm")->number(), 25);
  ASSERT_EQ(sewn.find("issues")->array()->size(), 1u);
  EXPECT_EQ(*sewn.find("issues")->array()->front().find("code")->text(), "seam.length_ratio");
}

TEST(Proposals, AreThoseThatNoSeamHasYet) {
  ClothStore at;
  const store::AssetRow asset =
      documents::add_asset(at.store.documents(), kMe, "specification", "two.json", kTwoSquares).value();
  const json::JsonValue report =
      json(documents::import_pattern(at.store.documents(), kMe, asset.id, {}).value());
  const auto proposed = [&] {
    const std::string document = json::write_json_line(*report.find("document"));
    return json(documents::proposals_json(
        documents::read_cloth(at.store.documents(), kMe, document, {}).value()->cloth.pattern));
  };
  const json::JsonValue found = proposed();
  ASSERT_NE(found.find("proposals")->array(), nullptr);
  for (const json::JsonValue& seam : *found.find("proposals")->array()) {
    EXPECT_GT(*seam.find("confidence")->number(), 0);
    EXPECT_FALSE(seam.find("a")->array()->empty());
  }
  EXPECT_FALSE(documents::read_cloth(at.store.documents(), kMe, "{", {}));
}

TEST(Imports, RefuseWhatIsNoPattern) {
  ClothStore at;
  EXPECT_EQ(documents::import_pattern(at.store.documents(), kMe, at.body, {}).error().code,
            "documents.wrong_kind");
  EXPECT_EQ(documents::import_pattern(at.store.documents(), kMe, at.dxf, {"yard", ""}).error().code,
            "documents.unit");
  const Error size = documents::import_pattern(at.store.documents(), kMe, at.dxf, {"", "42"}).error();
  EXPECT_EQ(size.code, "dxf.unknown_size");
  EXPECT_TRUE(size.where.starts_with("cloth.dxf")) << size.where;
  EXPECT_EQ(documents::import_pattern(at.store.documents(), kMe, "a_0", {}).error().code, "store.not_found");
}

constexpr const char* kChecked =
    R"([{"edit": "set_texture", "piece": "cloth", "texture": {"image": "checks.png", "scale_mm": 40}}])";

struct TexturedCloth : EditedCloth {
  std::string upload(const std::string& kind, const std::string& name, const std::string& bytes) {
    return documents::add_asset(store.documents(), kMe, kind, name, bytes)->id;
  }
  std::string picture = upload("image", "checks.png", test::png_of(test::squares()));

  Result<store::ProjectRow> edit_with(const std::string& edits, const documents::ProjectFileMap& more) {
    return documents::edit_project(store.documents(), kMe, id, json(edits), 0, more);
  }
  std::size_t file_count() { return store->project(kMe, id)->files.size(); }
};

TEST(EditsInStore, BringThePictureThatTheyPutOnAPiece) {
  TexturedCloth at;
  const Result<store::ProjectRow> row = at.edit_with(kChecked, {{"checks.png", at.picture}});
  ASSERT_TRUE(row) << to_string(row.error());
  EXPECT_EQ(row->files.at("checks.png"), at.picture);
  const Result<project::Project> project = project::parse_project(row->document);
  const resolve::ProjectFiles files = documents::files_in_store(at.store.documents(), kMe, row->files);
  const drape::DrapeInput input = resolve::resolve_project(*project, files).value();
  const Result<image::Textures> textures = resolve::read_textures(*project, input.pattern, files);
  ASSERT_TRUE(textures) << to_string(textures.error());
  ASSERT_EQ(textures->images.size(), 1u);
  EXPECT_EQ(textures->images[0]->read.picture, test::squares());
  ASSERT_NE(image::texture_of(*textures, 0), nullptr);
  EXPECT_NEAR(image::texture_at(*image::texture_of(*textures, 0), {0.04, 0}).x, 1, 1e-12);
  ASSERT_TRUE(at.undo());
  EXPECT_EQ(at.document(), kClothDocument);
  EXPECT_EQ(at.file_count(), 3u) << "the picture stays";
  ASSERT_TRUE(at.redo());
  ASSERT_TRUE(at.edit(kChecked)) << "the picture is there now";
}

TEST(EditsInStore, RefuseAPictureThatIsNotThere) {
  TexturedCloth at;
  const auto expect = [&](const Result<store::ProjectRow>& row, const char* code, const char* where) {
    ASSERT_FALSE(row) << code;
    EXPECT_EQ(row.error().code, code);
    EXPECT_EQ(row.error().where, where);
  };
  expect(at.edit(kChecked), "documents.missing_file", "/edits/0/texture/image");
  expect(at.edit_with(kChecked, {{"checks.png", at.dxf}}), "documents.wrong_kind", "/edits/0/texture/image");
  expect(at.edit_with(kChecked, {{"checks.png", "a_0"}}), "documents.unknown_asset", "/files/checks.png");
  expect(at.edit_with(kChecked, {{"checks.png", at.picture}, {"post.obj", at.picture}}),
         "documents.file_taken", "/files/post.obj");
  EXPECT_EQ(at.file_count(), 2u);
  EXPECT_EQ(at.document(), kClothDocument);
}

TEST(EditsInStore, AProjectWithoutItsPictureIsMissingAFile) {
  TexturedCloth at;
  const std::string document =
      cloth_document(R"("fabric": "cotton",)", R"("texture": {"image": "checks.png", "scale_mm": 40},
      "fabric": "cotton",)");
  const auto missing = documents::create_project(at.store.documents(), kMe, document, at.files);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, "documents.missing_file");
  EXPECT_EQ(missing.error().where, "/document/pieces/0/texture/image");
  documents::ProjectFileMap files = at.files;
  files["checks.png"] = at.picture;
  const auto made = documents::create_project(at.store.documents(), kMe, document, files);
  ASSERT_TRUE(made) << to_string(made.error());
  const std::string pieces =
      documents::pieces_json(*documents::read_cloth(at.store.documents(), kMe, document, files).value());
  EXPECT_NE(
      pieces.find(R"("texture": {"image": "checks.png", "scale_mm": 40, "offset": [0, 0], "angle": 0})"),
      std::string::npos)
      << pieces;
}

TEST(DocumentEdits, ReadEachFileOnceAndTheDrawingAfterThemNone) {
  ClothStore at;
  const auto made = documents::create_project(at.store.documents(), kMe, kClothDocument, at.files);
  ASSERT_TRUE(made) << to_string(made.error());
  test::OpenCounter dxf(at.store->asset_path(kMe, at.dxf).value());
  const auto edited = [&](const char* edits) {
    const auto row =
        documents::edit_project(at.store.documents(), kMe, made->id, json::parse_json(edits).value(), 0);
    EXPECT_TRUE(row) << to_string(row.error());
    return row.value();
  };
  const store::ProjectRow turned = edited(R"([{"edit": "rotate_grain", "piece": "cloth", "angle": 90}])");
  EXPECT_EQ(dxf.opened(), 1) << "the document was resolved before and after";
  const auto view = documents::read_cloth(at.store.documents(), kMe, turned.document, turned.files);
  ASSERT_TRUE(view) << to_string(view.error());
  EXPECT_NE(documents::pieces_json(**view).find("\"id\": \"cloth\""), std::string::npos);
  EXPECT_EQ(dxf.opened(), 1) << "what the edit has read is shown";
  edited(R"([{"edit": "rename_edge", "piece": "cloth", "edge": "e0", "to": "hem"}])");
  EXPECT_LE(dxf.opened(), 2);
}

TEST(DocumentEdits, OfAPlacedPieceReadEachFileOnce) {
  ClothStore at;
  const auto made = documents::create_project(at.store.documents(), kMe, kClothDocument, at.files);
  ASSERT_TRUE(made) << to_string(made.error());
  test::OpenCounter dxf(at.store->asset_path(kMe, at.dxf).value());
  const documents::ProjectChange change = [](const project::Project& now, documents::ProjectFileMap&,
                                             resolve::OpenedFiles& opened) -> Result<project::Project> {
    TRY(resolve::resolve_project(now, opened));
    project::Project wanted = now;
    wanted.pieces[0].layer = 3;
    TRY(resolve::resolve_project(wanted, opened));
    return wanted;
  };
  const auto row = documents::change_project(at.store.documents(), kMe, made->id, 0, change);
  ASSERT_TRUE(row) << to_string(row.error());
  EXPECT_EQ(row->revision, 2);
  EXPECT_EQ(dxf.opened(), 1) << "resolved by the change twice, and once by the edit that keeps it";
}

}  // namespace
}  // namespace toile
