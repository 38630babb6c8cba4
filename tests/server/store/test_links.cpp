#include "server/store/links.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/server/store/store_folder.h"

namespace toile {
namespace {

class LinksInStore : public testing::Test {
 protected:
  LinksInStore() : store(opened(folder.path())) {
    store::JobRow row;
    row.name = "shirt";
    job = store->create_job(store::RequestContext("anna"), row, "")->id;
  }
  store::LinkRow link(const std::string& label = "") const {
    store::LinkRow row;
    row.owner = "anna";
    row.job = job;
    row.label = label;
    row.takes.models = true;
    return row;
  }

  const TemporaryFolder folder;
  std::unique_ptr<store::Store> store;
  std::string job;
};

TEST_F(LinksInStore, AreKeptOverAReopening) {
  const std::string id = store->links()->add_link(link("for ben"), "hash")->id;
  store.reset();
  store = opened(folder.path());
  const auto known = store->links()->link_of_secret("hash");
  ASSERT_TRUE(known);
  EXPECT_EQ(known->link.id, id);
  EXPECT_EQ(known->link.job, job);
  EXPECT_EQ(known->link.label, "for ben");
  EXPECT_EQ(to_text(known->link.takes), "models");
  EXPECT_FALSE(known->has_account);
  EXPECT_GT(store->links()->add_link(link(), "other")->id, id) << "ids rise over a start";
}

TEST_F(LinksInStore, AreForJobsOfTheirOwner) {
  store::LinkRow row = link();
  row.owner = "ben";
  EXPECT_EQ(code_of(store->links()->add_link(row, "hash")), "store.not_found");
  ASSERT_TRUE(store->links()->add_link(link(), "hash"));
  const std::string id = store->links()->links("anna", "")->front().id;
  EXPECT_TRUE(store->links()->links("ben", "")->empty());
  EXPECT_EQ(code_of(store->links()->revoke_link("ben", id)), "store.not_found");
  EXPECT_EQ(store->links()->link_of_secret("hash")->link.revoked_ms, 0);
}

TEST_F(LinksInStore, AreRememberedWhenTheyAreTakenBack) {
  const std::string id = store->links()->add_link(link(), "hash")->id;
  ASSERT_TRUE(store->links()->revoke_link("anna", id));
  EXPECT_GT(store->links()->link_of_secret("hash")->link.revoked_ms, 0);
  EXPECT_TRUE(store->links()->links("anna", job)->empty());
  EXPECT_EQ(code_of(store->links()->revoke_link("anna", id)), "store.not_found");
}

TEST_F(LinksInStore, LongOverAreForgotten) {
  store::LinkRow old = link();
  old.expires_ms = 1000;
  ASSERT_TRUE(store->links()->add_link(old, "old"));
  ASSERT_TRUE(store->links()->add_link(link(), "new"));
  EXPECT_EQ(code_of(store->links()->link_of_secret("old")), "store.not_found");
}

TEST_F(LinksInStore, AreNotWithoutEnd) {
  for (int i = 0; i < store::Links::kMost; ++i)
    ASSERT_TRUE(store->links()->add_link(link(), "hash" + std::to_string(i)));
  EXPECT_EQ(code_of(store->links()->add_link(link(), "more")), "links.too_many");
  ASSERT_TRUE(store->links()->revoke_link("anna", store->links()->links("anna", "")->front().id));
  EXPECT_TRUE(store->links()->add_link(link(), "more"));
}

TEST(WhatALinkGives, HasWords) {
  EXPECT_EQ(to_text(store::LinkTakes{}), "");
  EXPECT_EQ(*store::takes_from(""), store::LinkTakes{});
  EXPECT_EQ(to_text(*store::takes_from("report,pictures")), "pictures,report");
  EXPECT_EQ(code_of(store::takes_from("pictures,all")), "links.take");
}

TEST(WhatALinkGives, IsPicturesModelsAndTheReportOnly) {
  const store::LinkTakes all{true, true, true};
  for (const char* name :
       {"front.png", "turntable.mp4", "drape.avi", "final.glb", "final.obj", "report.json"}) {
    EXPECT_TRUE(store::may_take(all, name)) << name;
    EXPECT_FALSE(store::may_take({}, name)) << name;
  }
  for (const char* name : {"final.hung", "drape.film", "rest.obj", "sewn.json", "body.obj", ""})
    EXPECT_FALSE(store::may_take(all, name)) << name;
}

TEST(WhatALinkGives, LeavesOutWhatLeadsElsewhere) {
  store::JobRow job;
  job.id = "j_1";
  job.project_id = "p_1";
  job.document = "{}";
  job.files["a"] = "a_1";
  job.reason_where = "seam";
  job.results["front.png"] = 1;
  job.results["final.hung"] = 1;
  store::LinkRow link;
  link.id = "l_1";
  link.takes.pictures = true;
  const store::JobRow shown = store::shown_by(link, job);
  EXPECT_EQ(shown.id, "l_1");
  EXPECT_TRUE(shown.project_id.empty() && shown.document.empty() && shown.files.empty());
  EXPECT_TRUE(shown.reason_where.empty());
  EXPECT_EQ(shown.results.size(), 1u);
}

}  // namespace
}  // namespace toile
