// The history of projects in the store.

#include <gtest/gtest.h>

#include "server/store/store.h"
#include "tests/server/store/store_folder.h"

namespace toile {
namespace {

store::ProjectRow project_row(const std::string& document) {
  store::ProjectRow row;
  row.name = "Skirt";
  row.document = document;
  return row;
}

store::EditRow step(const std::string& edits) {
  store::EditRow row;
  row.edits = "[\"" + edits + "\"]";
  row.inverse = "[\"not " + edits + "\"]";
  return row;
}

/// A store with one project, and edits that are done to it.
struct EditedStore {
  TemporaryFolder folder;
  std::unique_ptr<store::Store> store = opened(folder.path());
  std::string id = store->create_project(kMe, project_row("first"))->id;

  Result<store::ProjectRow> act(store::EditStep kind, const store::EditRow& edit, const std::string& document,
                                int expected = 0) {
    store::ProjectRow row = *store->project(kMe, id);
    row.document = document;
    return store->edit_project(kMe, row, expected == 0 ? row.revision : expected, kind, edit);
  }
  Result<store::ProjectRow> do_edit(const std::string& edits) {
    return act(store::EditStep::kDo, step(edits), edits);
  }
  store::EditRow next(store::EditStep kind) {
    return store->next_edit(kMe, id, kind)->value_or(store::EditRow{});
  }
  std::vector<store::EditRow> history() { return *store->edits(kMe, id, 0, 1000); }
};

TEST(StoreEdits, KeepAStepWithItsDocumentOverAReopening) {
  EditedStore at;
  store::EditRow odd = step("a");
  odd.original = "first";
  const Result<store::ProjectRow> row = at.act(store::EditStep::kDo, odd, "second");
  ASSERT_TRUE(row) << to_string(row.error());
  EXPECT_EQ(row->revision, 2);
  at.store.reset();
  at.store = opened(at.folder.path());
  EXPECT_EQ(at.store->project(kMe, at.id)->document, "second");
  const store::EditRow kept = at.next(store::EditStep::kUndo);
  EXPECT_EQ(kept.number, 1);
  EXPECT_EQ(kept.edits, "[\"a\"]");
  EXPECT_EQ(kept.inverse, "[\"not a\"]");
  EXPECT_EQ(kept.original, "first");
  EXPECT_FALSE(kept.undone);
  EXPECT_GT(kept.created_ms, 1'735'689'600'000);
}

TEST(StoreEdits, GoBackAndForth) {
  EditedStore at;
  for (const char* edits : {"a", "b", "c"}) ASSERT_TRUE(at.do_edit(edits));
  EXPECT_EQ(at.next(store::EditStep::kRedo).number, 0) << "nothing is undone";
  ASSERT_TRUE(at.act(store::EditStep::kUndo, at.next(store::EditStep::kUndo), "b"));
  ASSERT_TRUE(at.act(store::EditStep::kUndo, at.next(store::EditStep::kUndo), "a"));
  EXPECT_EQ(at.next(store::EditStep::kUndo).edits, "[\"a\"]");
  EXPECT_EQ(at.next(store::EditStep::kRedo).edits, "[\"b\"]");
  ASSERT_TRUE(at.act(store::EditStep::kRedo, at.next(store::EditStep::kRedo), "b"));
  EXPECT_EQ(at.next(store::EditStep::kRedo).edits, "[\"c\"]");
  EXPECT_EQ(at.store->project(kMe, at.id)->revision, 7);
}

TEST(StoreEdits, ANewStepForgetsWhatWasUndone) {
  EditedStore at;
  for (const char* edits : {"a", "b"}) ASSERT_TRUE(at.do_edit(edits));
  ASSERT_TRUE(at.act(store::EditStep::kUndo, at.next(store::EditStep::kUndo), "a"));
  ASSERT_TRUE(at.do_edit("c"));
  EXPECT_EQ(at.next(store::EditStep::kRedo).number, 0);
  const std::vector<store::EditRow> history = at.history();
  ASSERT_EQ(history.size(), 2u);
  EXPECT_EQ(history[0].edits, "[\"c\"]") << "the newest first";
  EXPECT_EQ(history[1].edits, "[\"a\"]");
}

TEST(StoreEdits, ChangeNothingAtAnotherRevisionOrStep) {
  EditedStore at;
  ASSERT_TRUE(at.do_edit("a"));
  EXPECT_EQ(at.act(store::EditStep::kDo, step("b"), "b", 1).error().code, "store.conflict");
  store::EditRow nobody = step("z");
  nobody.number = 9;
  EXPECT_EQ(at.act(store::EditStep::kUndo, nobody, "z").error().code, "store.not_found");
  EXPECT_EQ(at.act(store::EditStep::kRedo, at.next(store::EditStep::kUndo), "z").error().code,
            "store.not_found");
  EXPECT_EQ(at.store->project(kMe, at.id)->document, "a") << "all or nothing";
  EXPECT_EQ(at.history().size(), 1u);
  store::ProjectRow stranger = *at.store->project(kMe, at.id);
  EXPECT_EQ(at.store->edit_project(kStranger, stranger, 2, store::EditStep::kDo, step("x")).error().code,
            "store.not_found");
  EXPECT_TRUE(at.store->edits(kStranger, at.id, 0, 10)->empty());
}

TEST(StoreEdits, GoWithAReplacedOrRemovedProject) {
  EditedStore at;
  ASSERT_TRUE(at.do_edit("a"));
  store::ProjectRow row = *at.store->project(kMe, at.id);
  row.document = "other";
  ASSERT_TRUE(at.store->replace_project(kMe, row, 0));
  EXPECT_TRUE(at.history().empty());
  ASSERT_TRUE(at.do_edit("b"));
  ASSERT_TRUE(at.store->remove_project(kMe, at.id, 0));
  EXPECT_TRUE(at.history().empty());
}

TEST(StoreEdits, AreListedInPages) {
  EditedStore at;
  for (const char* edits : {"a", "b", "c"}) ASSERT_TRUE(at.do_edit(edits));
  const std::vector<store::EditRow> first = *at.store->edits(kMe, at.id, 0, 2);
  ASSERT_EQ(first.size(), 2u);
  const std::vector<store::EditRow> rest = *at.store->edits(kMe, at.id, first.back().number, 2);
  ASSERT_EQ(rest.size(), 1u);
  EXPECT_EQ(rest[0].edits, "[\"a\"]");
  EXPECT_TRUE(rest[0].inverse.empty()) << "only undo has use for it";
}

TEST(LongStoreEdits, AreBoundedInBytes) {
  EditedStore at;
  store::EditRow large = step("large");
  large.inverse = std::string(std::size_t{25} << 20, 'x');
  for (int i = 0; i < 4; ++i) ASSERT_TRUE(at.act(store::EditStep::kDo, large, "large"));
  const std::vector<store::EditRow> history = at.history();
  ASSERT_EQ(history.size(), 2u);
  EXPECT_EQ(history[0].number, 4);
  EXPECT_EQ(history[1].number, 3);
}

TEST(LongStoreEdits, AreBoundedInNumber) {
  EditedStore at;
  for (int i = 0; i < 510; ++i) ASSERT_TRUE(at.do_edit("a"));
  const std::vector<store::EditRow> history = at.history();
  ASSERT_EQ(history.size(), 500u);
  EXPECT_EQ(history.back().number, 11);
}

}  // namespace
}  // namespace toile
