// Versions of a project over HTTP: a state is named, left, come back to, undone.

#include <string>

#include "tests/server/http/served.h"

namespace toile::test {
namespace {

constexpr const char* kRename = R"({"edits": [{"edit": "rename_piece", "piece": "napkin", "to": "cloth"}]})";

class Versions : public Served {
 protected:
  void SetUp() override {
    serve();
    id = make_project();
    one = "/api/v1/projects/" + id;
  }
  Answer post(const std::string& what, const std::string& body = "", const std::string& match = "*") {
    return send_json("POST", one + what, body, match.empty() ? "" : "If-Match: " + match + "\r\n");
  }
  Answer name(const std::string& called, const std::string& match = "*") {
    return post("/versions", R"({"name": ")" + called + "\"}", match);
  }
  std::string document() { return store->project(kMe, id)->document; }
  std::string id, one;
};

TEST_F(Versions, AreNamedLeftAndComeBackToAsAnEdit) {
  const std::string first = document();
  const Answer made = name("as drawn", "\"1\"");
  ASSERT_EQ(made.status, 201) << made.body;
  const std::string version = member(made, "id");
  EXPECT_EQ(made.headers.at("location"), one + "/versions/" + version);
  EXPECT_EQ(member(made, "name"), "as drawn");
  EXPECT_NE(made.body.find("\"current\": true"), std::string::npos) << made.body;
  ASSERT_EQ(post("/edits", kRename).status, 200);
  const std::string renamed = document();
  EXPECT_NE(get(one + "/versions").body.find("\"current\": false"), std::string::npos);
  const Answer back = post("/versions/" + version + "/restore", "", "\"2\"");
  ASSERT_EQ(back.status, 200) << back.body;
  EXPECT_EQ(back.headers.at("etag"), "\"3\"");
  EXPECT_NE(back.body.find("\"id\": \"napkin\""), std::string::npos);
  EXPECT_NE(get(one + "/versions").body.find("\"current\": true"), std::string::npos);
  ASSERT_EQ(post("/undo").status, 200);
  EXPECT_EQ(document(), renamed) << "coming back is undone like any edit";
  ASSERT_EQ(post("/redo").status, 200);
  EXPECT_NE(get(one + "/versions").body.find("\"current\": true"), std::string::npos);
  EXPECT_NE(document(), renamed);
  EXPECT_NE(first, renamed);
}

TEST_F(Versions, AreNoStepWhereTheProjectStandsSoAlready) {
  const std::string version = member(name("as drawn"), "id");
  const Answer back = post("/versions/" + version + "/restore");
  EXPECT_EQ(back.headers.at("etag"), "\"1\"");
  EXPECT_PROBLEM(post("/undo"), 409, "edit.nothing_to_undo");
}

TEST_F(Versions, TellWhichDrapesWereMadeOfThem) {
  ASSERT_EQ(name("as drawn").status, 201);
  const store::ProjectRow now = *store->project(kMe, id);
  store::JobRow row;
  row.project_id = id;
  row.document = now.document;
  row.files = now.files;
  const std::string job = store->create_job(kMe, row, "")->id;
  EXPECT_NE(get(one + "/versions").body.find("\"jobs\": [\"" + job + "\"]"), std::string::npos)
      << get(one + "/versions").body;
}

TEST_F(Versions, AreRefusedWithTheirPlace) {
  EXPECT_PROBLEM(name("late", "\"7\""), 412, "store.conflict");
  EXPECT_PROBLEM(name("blind", ""), 428, "request.if_match");
  EXPECT_PROBLEM(name(""), 422, "versions.name");
  EXPECT_PROBLEM(name(" blank"), 422, "versions.name");
  EXPECT_PROBLEM(name(std::string(81, 'x')), 422, "versions.name");
  EXPECT_PROBLEM(name("two\\nlines"), 422, "versions.name");
  EXPECT_PROBLEM(post("/versions", "{}"), 422, "versions.name");
  EXPECT_PROBLEM(post("/versions", R"({"name": "a", "revision": 3})"), 422, "request.unknown_key");
  ASSERT_EQ(name("taken").status, 201);
  const Answer again = name("taken");
  EXPECT_PROBLEM(again, 409, "versions.taken");
  EXPECT_EQ(member(again, "where"), "/name");
  EXPECT_PROBLEM(post("/versions/v_0/restore"), 404, "store.not_found");
  EXPECT_PROBLEM(get("/api/v1/projects/p_0/versions"), 404, "store.not_found");
}

TEST_F(Versions, AreRemovedAndLeaveTheProjectAlone) {
  const std::string version = one + "/versions/" + member(name("as drawn"), "id");
  EXPECT_EQ(send_json("DELETE", version, "").status, 204);
  EXPECT_PROBLEM(send_json("DELETE", version, ""), 404, "store.not_found");
  EXPECT_EQ(get(one + "/versions").body.find("as drawn"), std::string::npos);
  EXPECT_EQ(get(one).status, 200);
}

TEST_F(Versions, AreNotComeBackToWhereAFileIsAnotherByNow) {
  const std::string version = member(name("as drawn"), "id");
  store::ProjectRow row = *store->project(kMe, id);
  ASSERT_FALSE(row.files.empty());
  for (auto& [file, asset] : row.files) asset = "a_00000000000000000000000000000000";
  ASSERT_TRUE(store->replace_project(kMe, row, 0));
  EXPECT_PROBLEM(post("/versions/" + version + "/restore"), 409, "documents.file_taken");
}

}  // namespace
}  // namespace toile::test
