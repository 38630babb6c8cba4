// What was draped before is not draped again.

#include <filesystem>

#include "tests/server/jobs/house.h"
#include "tests/server/store/store_folder.h"
#include "tests/server/store/update_job.h"

namespace toile {
namespace {

using test::cloth_over_block;
using test::kOwner;

class EqualInputs : public test::JobHouse {
 protected:
  void start(const std::string& engine) {
    settings.engine = engine;
    make(1);
    ASSERT_TRUE(service->start());
  }
  store::JobRow submitted(const std::string& project) { return *service->submit(kOwner, project, ""); }
  /// Of a project that is draped to its end.
  store::JobRow draped(const std::string& project) {
    const std::string id = submitted(project).id;
    EXPECT_TRUE(publisher.wait_for_end(id));
    EXPECT_EQ(row(id).state, store::JobState::kSucceeded) << row(id).reason;
    return row(id);
  }
};

TEST_F(EqualInputs, AreAnsweredAtOnceWithTheSameResults) {
  start("engine");
  const std::string project = project_of(cloth_over_block(200, 0.2));
  const store::JobRow first = draped(project), second = submitted(project);
  EXPECT_NE(second.id, first.id);
  EXPECT_EQ(second.state, store::JobState::kSucceeded);
  EXPECT_EQ(row(second.id).state, store::JobState::kSucceeded);
  EXPECT_EQ(second.results, first.results);
  EXPECT_EQ(second.report, first.report);
  EXPECT_EQ(second.reason_code, first.reason_code);
  EXPECT_EQ(second.worked_ms, 0);
  EXPECT_GT(second.ended_ms, 0);
  for (const auto& [name, file] : first.results) {
    EXPECT_EQ(*store.result_bytes(kOwner, second.id, name), *store.result_bytes(kOwner, first.id, name));
  }
  EXPECT_EQ(service->counts().answered, 1);
  jobs::JobWish anew;
  anew.anew = true;
  EXPECT_EQ(service->submit(kOwner, project, "", anew)->state, store::JobState::kQueued);
  EXPECT_EQ(service->progress(kOwner, second.id)->state, store::JobState::kSucceeded);
}

TEST_F(EqualInputs, OfADrapeWithoutPicturesAnswerForNoneWithThem) {
  start("engine");
  const std::string project = project_of(cloth_over_block(200, 0.2));
  jobs::JobWish plain;
  plain.pictures = false;
  const std::string first = service->submit(kOwner, project, "", plain)->id;
  ASSERT_TRUE(publisher.wait_for_end(first));
  const store::JobRow without = row(first);
  EXPECT_EQ(without.state, store::JobState::kSucceeded) << without.reason;
  EXPECT_TRUE(without.notes.empty()) << "nothing is amiss: none were wanted";
  EXPECT_FALSE(without.results.contains("front.png"));
  EXPECT_TRUE(without.results.contains("report.json"));
  EXPECT_TRUE(without.results.contains("drape.film")) << "pictures can be drawn of it later";
  for (const auto& told : publisher.log(first).progress) EXPECT_NE(told.progress.phase, jobs::kStillsPhase);
  EXPECT_EQ(service->submit(kOwner, project, "", plain)->state, store::JobState::kSucceeded);
  const store::JobRow with = draped(project);
  EXPECT_TRUE(with.results.contains("front.png"));
  EXPECT_EQ(hash_in(with), hash_in(without));
  EXPECT_FALSE(service->retry(kOwner, first, "")->pictures);
}

TEST_F(EqualInputs, AreThoseOfTheSameEngineDocumentAndFilesOnly) {
  start("engine");
  const std::string document = cloth_over_block(200, 0.2);
  draped(project_of(document));
  EXPECT_EQ(submitted(project_of(cloth_over_block(201, 0.2))).state, store::JobState::kQueued);
  store::ProjectRow other = *store.project(kOwner, project_of(document));
  store::AssetRow body;
  body.kind = "body";
  body.name = "block.obj";
  other.files = {{"block.obj", store.put_asset(kOwner, body, test::kBlock).value().id}};
  const std::string with_other_file = store.create_project(kOwner, other, "").value().id;
  EXPECT_EQ(submitted(with_other_file).state, store::JobState::kQueued);
  start("another engine");
  EXPECT_EQ(submitted(project_of(document)).state, store::JobState::kQueued);
  start("");
  EXPECT_EQ(submitted(project_of(document)).state, store::JobState::kQueued)
      << "no engine answers for another";
}

TEST_F(EqualInputs, OfWhatFellShortOrFailedAreDrapedAnew) {
  start("engine");
  const std::string project = project_of(cloth_over_block(200, 0.2));
  const store::JobRow first = draped(project);
  store.tamper(kOwner, first.id, [](store::JobRow& row) { row.notes = {{"stills.not_drawn", "none"}}; });
  const store::JobRow second = draped(project);
  EXPECT_GT(second.worked_ms, 0);
  for (const std::string& id : {first.id, second.id})
    store.tamper(kOwner, id, [](store::JobRow& row) { row.state = store::JobState::kFailed; });
  EXPECT_GT(draped(project).worked_ms, 0);
}

TEST_F(EqualInputs, AreDrapedAnewWhereAnEndedJobIsTriedAgain) {
  start("engine");
  const std::string project = project_of(cloth_over_block(200, 0.2));
  const store::JobRow first = draped(project);
  ASSERT_TRUE(store.remove_project(kOwner, project, 0));
  const auto again = service->retry(kOwner, first.id, "key");
  ASSERT_TRUE(again) << to_string(again.error());
  EXPECT_EQ(service->retry(kOwner, first.id, "key")->id, again->id)
      << "a request that is sent again makes no other";
  ASSERT_TRUE(publisher.wait_for_end(again->id));
  EXPECT_EQ(row(again->id).state, store::JobState::kSucceeded);
  EXPECT_GT(row(again->id).worked_ms, 0);
  EXPECT_EQ(hash_in(row(again->id)), hash_in(first));
  const std::string endless = submitted(project_of(cloth_over_block(201, test::kEndless))).id;
  EXPECT_EQ(service->retry(kOwner, endless, "").error().code, "jobs.state");
  EXPECT_EQ(service->retry(kOwner, "j_none", "").error().code, "store.not_found");
}

TEST_F(EqualInputs, AreDrapedWhereTheResultsOfThenCannotBeHad) {
  start("engine");
  const std::string project = project_of(cloth_over_block(200, 0.2));
  const store::JobRow first = draped(project);
  store.on_share_results = [] { return Status(Error{"store.corrupt", "changed", "", ErrorKind::kSystem}); };
  const store::JobRow second = draped(project);
  EXPECT_GT(second.worked_ms, 0);
  EXPECT_EQ(hash_in(second), hash_in(first));
}

TEST(EqualResults, AreOneFileUntilTheFirstJobGoesAndStayWithTheSecond) {
  const TemporaryFolder folder;
  const auto store = opened(folder.path());
  store::JobRow first = some_job("first");
  first.input = "equal";
  first = *store->create_job(kMe, first, "");
  const std::string bytes = "report";
  ASSERT_TRUE(store->put_result(kMe, first.id, "report.json", bytes));
  first.results["report.json"] = {6, hash_of(std::string_view(bytes))};
  EXPECT_FALSE(*store->succeeded_job_of_input(kMe, "equal")) << "it has not ended";
  first.state = store::JobState::kSucceeded;
  ASSERT_TRUE(test::update_job(*store, kMe, first));
  EXPECT_EQ((*store->succeeded_job_of_input(kMe, "equal"))->id, first.id);
  EXPECT_FALSE(*store->succeeded_job_of_input(kStranger, "equal"));
  EXPECT_FALSE(*store->succeeded_job_of_input(kMe, ""));
  store::JobRow second = *store->create_job(kMe, some_job("second"), "");
  ASSERT_TRUE(store->share_results(kMe, first.id, second.id));
  second.results = first.results;
  second.state = store::JobState::kSucceeded;
  ASSERT_TRUE(test::update_job(*store, kMe, second));
  EXPECT_EQ(std::filesystem::hard_link_count(*store->result_path(kMe, second.id, "report.json")), 2u);
  ASSERT_TRUE(store->remove_job(kMe, first.id));
  EXPECT_EQ(*store->result_bytes(kMe, second.id, "report.json"), "report");
  EXPECT_EQ(code_of(store->share_results(kStranger, second.id, second.id)), "store.not_found");
}

TEST(EqualResults, ThatTheDiskHasChangedAreNotHandedOn) {
  const TemporaryFolder folder;
  const auto store = opened(folder.path());
  store::JobRow first = *store->create_job(kMe, some_job("first"), "");
  ASSERT_TRUE(store->put_result(kMe, first.id, "report.json", "reporT"));
  first.results["report.json"] = {6, hash_of(std::string_view("report"))};
  ASSERT_TRUE(test::update_job(*store, kMe, first));
  const store::JobRow second = *store->create_job(kMe, some_job("second"), "");
  EXPECT_EQ(code_of(store->share_results(kMe, first.id, second.id)), "store.corrupt");
}

}  // namespace
}  // namespace toile
