#include "server/documents/edits.h"

#include <gtest/gtest.h>

#include "proto/cpp/project.h"
#include "server/documents/imports.h"
#include "tests/server/documents/documents_fixture.h"

namespace toile {
namespace {

JsonValue json(const std::string& text) { return parse_json(text).value(); }

constexpr const char* kWider = R"([{"edit": "move_point", "piece": "cloth", "edge": "e1", "point": 1,
                                   "to": [310, 310]}])";
constexpr const char* kRename = R"([{"edit": "rename_piece", "piece": "cloth", "to": "napkin"}])";

struct EditedCloth : ClothStore {
  std::string id = create_project(*store, kLocalOwner, kClothDocument, files)->id;

  Result<ProjectRow> edit(const std::string& edits, int expected = 0) {
    return edit_project(*store, kLocalOwner, id, json(edits), expected);
  }
  Result<ProjectRow> undo() { return undo_edit(*store, kLocalOwner, id, 0); }
  Result<ProjectRow> redo() { return redo_edit(*store, kLocalOwner, id, 0); }
  std::string document() { return store->project(kLocalOwner, id)->document; }
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
  at.store = opened(at.folder.path());
  ASSERT_TRUE(at.redo());
  ASSERT_TRUE(at.undo());
  EXPECT_EQ(at.document(), wider);
  ASSERT_TRUE(at.undo());
  EXPECT_EQ(at.document(), kClothDocument);
}

TEST(EditsInStore, TheEditedDocumentIsAProjectThatCanBeDraped) {
  EditedCloth at;
  const Result<ProjectRow> row = at.edit(kWider);
  ASSERT_TRUE(row) << to_string(row.error());
  EXPECT_EQ(row->revision, 2);
  const Project project = parse_project(row->document).value();
  EXPECT_FALSE(project.pieces[0].from);
  EXPECT_TRUE(resolve_project(project, files_in_store(*at.store, kLocalOwner, row->files)));
}

TEST(EditsInStore, RefusedEditsChangeNothing) {
  EditedCloth at;
  const Result<ProjectRow> wrong = at.edit(R"([{"edit": "mirror_piece", "piece": "sleeve"}])");
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().code, "edit.unknown_piece");
  EXPECT_EQ(wrong.error().where, "/edits/0: piece sleeve");
  EXPECT_EQ(at.edit(kRename, 7).error().code, "store.conflict");
  EXPECT_EQ(at.store->project(kLocalOwner, at.id)->revision, 1);
  EXPECT_EQ(at.document(), kClothDocument);
  EXPECT_EQ(edit_project(*at.store, kLocalOwner, "p_00000000000000000000", json("[]"), 0).error().code,
            "store.not_found");
}

TEST(EditsInStore, TheHistoryIsListedWithWhatWasDone) {
  EditedCloth at;
  ASSERT_TRUE(at.edit(kWider));
  ASSERT_TRUE(at.edit(kRename));
  ASSERT_TRUE(at.undo());
  const JsonValue first = json(history_json(*at.store, kLocalOwner, at.id, 0, 1).value());
  ASSERT_EQ(first.find("edits")->array()->size(), 1u);
  const JsonValue& step = first.find("edits")->array()->front();
  EXPECT_EQ(*step.find("number")->number(), 2);
  EXPECT_TRUE(*step.find("undone")->boolean());
  EXPECT_EQ(write_json_line(*step.find("edits")), write_json_line(json(kRename)));
  EXPECT_EQ(*first.find("next")->text(), "2");
  const JsonValue rest = json(history_json(*at.store, kLocalOwner, at.id, 2, 1).value());
  EXPECT_EQ(*rest.find("edits")->array()->front().find("number")->number(), 1);
  EXPECT_EQ(rest.find("next")->text(), nullptr);
}

TEST(Imports, TellWhatAFileHolds) {
  ClothStore at;
  const Result<std::string> text = import_pattern(*at.store, kLocalOwner, at.dxf, {"mm", ""});
  ASSERT_TRUE(text) << to_string(text.error());
  const JsonValue report = json(*text);
  EXPECT_EQ(*report.find("asset")->text(), at.dxf);
  EXPECT_EQ(*report.find("unit")->find("name")->text(), "mm");
  ASSERT_EQ(report.find("pieces")->array()->size(), 1u);
  const JsonValue& piece = report.find("pieces")->array()->front();
  EXPECT_EQ(*piece.find("area_mm2")->number(), 90000);
  EXPECT_EQ(*piece.find("from")->find("dxf")->text(), "cloth.dxf");
  EXPECT_EQ(*piece.find("from")->find("piece")->text(), "CLOTH");
  EXPECT_EQ(piece.find("points")->array()->size(), 4u);
  EXPECT_NE(report.find("report")->find("counts"), nullptr);
}

TEST(Imports, TakeAPersonsWordForTheUnit) {
  ClothStore at;
  const JsonValue report = json(import_pattern(*at.store, kLocalOwner, at.dxf, {"cm", ""}).value());
  EXPECT_EQ(*report.find("pieces")->array()->front().find("width_mm")->number(), 3000);
  EXPECT_EQ(*report.find("pieces")->array()->front().find("from")->find("units")->text(), "cm");
}

TEST(Imports, RefuseWhatIsNoPattern) {
  ClothStore at;
  EXPECT_EQ(import_pattern(*at.store, kLocalOwner, at.body, {}).error().code, "documents.wrong_kind");
  EXPECT_EQ(import_pattern(*at.store, kLocalOwner, at.dxf, {"yard", ""}).error().code, "documents.unit");
  const Error size = import_pattern(*at.store, kLocalOwner, at.dxf, {"", "42"}).error();
  EXPECT_EQ(size.code, "dxf.unknown_size");
  EXPECT_TRUE(size.where.starts_with("cloth.dxf")) << size.where;
  EXPECT_EQ(import_pattern(*at.store, kLocalOwner, "a_0", {}).error().code, "store.not_found");
}

}  // namespace
}  // namespace toile
