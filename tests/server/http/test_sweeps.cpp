// Sweeps over HTTP: what they are asked by, what they answer, and all of one at once.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/server/http/with_accounts.h"

namespace toile::test {
namespace {

using Words = std::vector<std::string>;

class SweepRoutes : public Served {
 protected:
  void SetUp() override {
    serve();
    project = make_project();
  }
  /// Of the napkin, with more members beside its id.
  Answer ask_for(const std::string& more, const std::string& headers = "") {
    return send_json("POST", "/api/v1/sweeps",
                     "{\"project_id\": \"" + project + "\"" + (more.empty() ? "" : ", " + more) + "}",
                     headers);
  }
  static json::JsonValue tree(const Answer& answer) {
    auto read = json::parse_json(answer.body, {.depth = 64});
    EXPECT_TRUE(read) << answer.body;
    return read ? *read : json::JsonValue();
  }
  static Words words(const json::JsonValue& in, const char* key) {
    Words words;
    for (const json::JsonValue& one : *in.find(key)->array()) words.push_back(*one.text());
    return words;
  }
  static Words jobs_of(const Answer& answer) {
    Words jobs;
    const json::JsonValue sweep = tree(answer);
    for (const json::JsonValue& cell : *sweep.find("cells")->array())
      jobs.push_back(cell.find("job")->text() ? *cell.find("job")->text() : "");
    return jobs;
  }
  std::string document_of(const std::string& job) { return store->job(kMe, job)->document; }

  std::string project;
};

TEST_F(SweepRoutes, MakeADrapeForEachPair) {
  const Answer made = ask_for(R"("bodies": [{}, "eu36", {"mannequin": {"preset": "eu40", "waist_cm": 80}}],
                                 "fabrics": ["denim-10oz", {"label": "own"}], "tags": ["spring"])");
  ASSERT_EQ(made.status, 201) << made.body;
  const json::JsonValue sweep = tree(made);
  EXPECT_EQ(made.headers.at("location"), "/api/v1/sweeps/" + member(made, "id"));
  EXPECT_EQ(words(sweep, "bodies"), (Words{"post.obj", "eu36", "eu40 waist 80"}));
  EXPECT_EQ(words(sweep, "fabrics"), (Words{"denim-10oz", "own"}));
  EXPECT_EQ(*sweep.find("counts")->find("queued")->number(), 6);
  EXPECT_FALSE(*sweep.find("ended")->boolean());
  const Words drapes = jobs_of(made);
  ASSERT_EQ(drapes.size(), 6u);
  EXPECT_EQ(document_of(drapes[1]), store->project(kMe, project)->document) << "nothing is another";
  const auto denim = project::parse_project(document_of(drapes[0]));
  EXPECT_EQ(denim->pieces[0].fabric, "denim-10oz");
  const auto dressed = project::parse_project(document_of(drapes[5]));
  EXPECT_EQ(dressed->pieces[0].fabric, "cotton");
  EXPECT_EQ(dressed->bodies[0].id, "post");
  EXPECT_EQ(dressed->bodies[0].mannequin->preset, "eu40");
  const store::JobRow row = *store->job(kMe, drapes[2]);
  EXPECT_EQ(row.priority, store::JobPriority::kBatch);
  EXPECT_EQ(row.name, "Napkin · eu36 · denim-10oz");
  EXPECT_EQ(row.cell, (store::SweepCell{member(made, "id"), 1, 0}));
  const Answer job = get("/api/v1/jobs/" + drapes[2]);
  EXPECT_EQ(*tree(job).find("sweep")->find("body")->number(), 1);
  EXPECT_NE(job.body.find("spring"), std::string::npos);
  EXPECT_EQ(tree(get("/api/v1/jobs?sweep=" + member(made, "id"))).find("jobs")->array()->size(), 6u);
  EXPECT_EQ(tree(get("/api/v1/jobs?sweep=none")).find("jobs")->array()->size(), 0u);
}

TEST_F(SweepRoutes, TakeFilesAndOtherSizesAsBodies) {
  const std::string asset = member(upload("body", "other.obj", std::string("# other\n") + kPost), "id");
  const std::string wide = member(
      send_json("POST", "/api/v1/projects", napkin_request(post_asset(), "\"Napkin\"", "\"Wide napkin\"")),
      "id");
  const Answer made =
      ask_for(R"("bodies": [{"asset": ")" + asset + R"("}, {"project_id": ")" + wide + R"("}])");
  ASSERT_EQ(made.status, 201) << made.body;
  EXPECT_EQ(words(tree(made), "bodies"), (Words{"other.obj", "Wide napkin"}));
  EXPECT_EQ(words(tree(made), "fabrics"), (Words{"cotton"}));
  const store::JobRow row = *store->job(kMe, jobs_of(made)[0]);
  EXPECT_EQ(row.files.at("other.obj"), asset);
  EXPECT_EQ(store->job(kMe, jobs_of(made)[1])->project_id, wide);
  EXPECT_EQ(store->project(kMe, project)->files.count("other.obj"), 0u) << "the project stays as it was";
}

TEST_F(SweepRoutes, RefuseWithThePlace) {
  const auto refused = [&](const std::string& more, int status, const std::string& code,
                           const std::string& where) {
    const Answer answer = ask_for(more);
    SCOPED_TRACE(more);
    EXPECT_PROBLEM(answer, status, code);
    EXPECT_EQ(member(answer, "where"), where) << more << answer.body;
  };
  refused(R"("fabrics": ["poplin", "denim-10os"])", 422, "project.unknown_fabric", "/fabrics/1");
  refused(R"("fabrics": [7])", 422, "request.fabric", "/fabrics/0");
  refused(R"("fabrics": [])", 422, "sweep.none", "/fabrics");
  refused(R"("fabrics": {})", 422, "request.fabric", "/fabrics");
  refused(R"("fabrics": ["poplin", "poplin"])", 422, "sweep.duplicate", "/fabrics/1");
  refused(R"("bodies": ["eu36", "eu36"])", 422, "sweep.duplicate", "/bodies/1");
  refused(R"("bodies": ["eu36", "eu39"])", 422, "project.unknown_preset", "/bodies/1/mannequin/preset");
  refused(R"("bodies": [{"mannequin": {"preset": "eu36", "waist_cm": 900}}])", 422, "project.out_of_range",
          "/bodies/0/mannequin/waist_cm");
  refused(R"("bodies": [{"mannequin": {}, "asset": "a_0"}])", 422, "request.body", "/bodies/0");
  refused(R"("bodies": [{"colour": 1}])", 422, "request.unknown_key", "/bodies/0/colour");
  refused(R"("bodies": [{"label": " x"}])", 422, "request.label", "/bodies/0/label");
  refused(R"("bodies": [{"project_id": "p_0"}])", 404, "store.not_found", "/bodies/0/project_id");
  refused(R"("priority": "now")", 422, "request.priority", "/priority");
  refused(R"("tags": "spring")", 422, "request.tags", "/tags");
  std::string many;
  for (int i = 0; i < 51; ++i)
    many += (i ? "," : "") + std::string("{\"label\": \"") + std::to_string(i) + "\"}";
  refused("\"bodies\": [" + many + "]", 422, "sweep.too_many", "/bodies");
  refused("\"fabrics\": [" + many + "]", 422, "sweep.too_many", "/fabrics");
  const std::string twenty = many.substr(0, many.find(",{\"label\": \"20"));
  refused("\"bodies\": [" + twenty + "], \"fabrics\": [" + twenty + "]", 422, "sweep.too_many", "/bodies");
  EXPECT_PROBLEM(send_json("POST", "/api/v1/sweeps", "{}"), 422, "request.project_id");
  EXPECT_PROBLEM(send_json("POST", "/api/v1/sweeps", R"({"project_id": "p_0"})"), 404, "store.not_found");
  EXPECT_EQ(store->usage(kMe)->jobs, 0) << "and nothing is draped";
}

TEST_F(SweepRoutes, AreCancelledAndRemovedAsAWhole) {
  const Answer made = ask_for(R"("fabrics": ["poplin", "twill", "felt"])");
  const std::string place = "/api/v1/sweeps/" + member(made, "id");
  const Words drapes = jobs_of(made);
  ASSERT_TRUE(static_cast<ScriptedJobs&>(*jobs).become(kMe, drapes[0], store::JobState::kSucceeded));
  EXPECT_PROBLEM(ask(port, "DELETE", place), 409, "jobs.state");
  const Answer cancelled = ask(port, "POST", place + "/cancel");
  ASSERT_EQ(cancelled.status, 200) << cancelled.body;
  EXPECT_EQ(*tree(cancelled).find("counts")->find("cancelled")->number(), 2);
  EXPECT_EQ(*tree(cancelled).find("counts")->find("succeeded")->number(), 1) << "what has ended stays";
  EXPECT_TRUE(*tree(cancelled).find("ended")->boolean());
  EXPECT_EQ(ask(port, "POST", place + "/cancel").status, 200) << "twice does no harm";
  ASSERT_EQ(ask(port, "DELETE", "/api/v1/jobs/" + drapes[1]).status, 204);
  const Answer shown = get(place);
  EXPECT_EQ(*tree(shown).find("counts")->find("removed")->number(), 1);
  EXPECT_EQ(jobs_of(shown)[1], "");
  ASSERT_EQ(ask(port, "DELETE", place).status, 204);
  EXPECT_PROBLEM(get(place), 404, "store.not_found");
  for (const std::string& job : drapes) EXPECT_EQ(get("/api/v1/jobs/" + job).status, 404);
  EXPECT_PROBLEM(ask(port, "DELETE", place), 404, "store.not_found");
}

TEST_F(SweepRoutes, TellFiguresAsJsonAndCsvAndOnASheet) {
  const Answer made = ask_for(R"("name": "Ten napkins", "fabrics": ["poplin", "twill"])");
  const std::string place = "/api/v1/sweeps/" + member(made, "id"), job = jobs_of(made)[0];
  const std::string still = png_of(squares());
  ASSERT_TRUE(store->put_result(kMe, job, "front.png", still));
  ASSERT_TRUE(store->change_job(kMe, job, [&](store::JobRow& row) -> Status {
    row.state = store::JobState::kSucceeded;
    row.report =
        R"({"settled": true, "worn": "no", "cpu_s": 2.5, "strain": {"weft": {"tension": {"p99": 0.25}}}})";
    row.results["front.png"] = static_cast<std::int64_t>(still.size());
    return {};
  }));
  const json::JsonValue sweep = tree(get(place));
  const json::JsonValue& cell = sweep.find("cells")->array()->front();
  EXPECT_EQ(*cell.find("state")->text(), "succeeded");
  EXPECT_TRUE(*cell.find("pictured")->boolean());
  EXPECT_EQ(*cell.find("figures")->find("worn")->text(), "no");
  EXPECT_EQ(*cell.find("figures")->find("weft_p99")->number(), 0.25);
  EXPECT_EQ(*sweep.find("fraction")->number(), 0.5);
  const Answer csv = get(place + "/table.csv");
  EXPECT_EQ(csv.headers.at("content-type"), "text/csv; charset=utf-8");
  EXPECT_NE(csv.body.find("post.obj,poplin,succeeded,"), std::string::npos) << csv.body;
  EXPECT_NE(csv.body.find(",25.00,"), std::string::npos) << csv.body;
  const Answer sheet = get(place + "/sheet.png");
  ASSERT_EQ(sheet.status, 200) << sheet.body;
  const auto drawn = image::read_picture(sheet.body, {.shown_side = 4096});
  ASSERT_TRUE(drawn) << to_string(drawn.error());
  EXPECT_GT(drawn->width, 600);
  EXPECT_GT(drawn->height, 400);
  EXPECT_EQ(get(place + "/sheet.png?view=back").status, 200) << "a still that is not there leaves its place";
  EXPECT_PROBLEM(get(place + "/sheet.png?view=top"), 400, "request.view");
}

TEST_F(SweepRoutes, AreListedAndMadeOnceUnderAKey) {
  const Answer once = ask_for(R"("fabrics": ["poplin"])", "Idempotency-Key: once\r\n");
  const Answer again = ask_for(R"("fabrics": ["poplin"])", "Idempotency-Key: once\r\n");
  ASSERT_EQ(once.status, 201) << once.body;
  ASSERT_EQ(again.status, 200) << again.body;
  EXPECT_EQ(member(again, "id"), member(once, "id"));
  const json::JsonValue listed = tree(get("/api/v1/sweeps?project=" + project));
  ASSERT_EQ(listed.find("sweeps")->array()->size(), 1u);
  EXPECT_EQ(*listed.find("sweeps")->array()->front().find("id")->text(), member(once, "id"));
  EXPECT_EQ(tree(get("/api/v1/sweeps?project=p_0")).find("sweeps")->array()->size(), 0u);
  project = make_project();
  EXPECT_PROBLEM(ask_for(R"("fabrics": ["poplin"])", "Idempotency-Key: once\r\n"), 409,
                 "store.idempotency_mismatch");
}

TEST_F(SweepRoutes, AFailedCellIsTriedAgainInItsPlace) {
  const Answer made = ask_for(R"("fabrics": ["poplin", "twill"], "tags": ["spring"])");
  const std::string place = "/api/v1/sweeps/" + member(made, "id"), first = jobs_of(made)[0];
  ASSERT_TRUE(static_cast<ScriptedJobs&>(*jobs).become(kMe, first, store::JobState::kFailed));
  const Answer again = ask(port, "POST", "/api/v1/jobs/" + first + "/retry");
  ASSERT_EQ(again.status, 201) << again.body;
  EXPECT_EQ(jobs_of(get(place))[0], member(again, "id"));
  EXPECT_EQ(*tree(get(place)).find("counts")->find("failed")->number(), 0);
}

class AccountSweeps : public Accounts {};

TEST_F(AccountSweeps, AreNotOthers) {
  make_things();
  const std::string his = token(ben, "read,submit"), place = "/api/v1/sweeps/" + things["sweeps"];
  EXPECT_EQ(as(full, "GET", place).status, 200);
  for (const char* part : {"", "/table.csv", "/sheet.png"})
    EXPECT_PROBLEM(as(his, "GET", place + part), 404, "store.not_found");
  EXPECT_PROBLEM(as(his, "POST", place + "/cancel"), 404, "store.not_found");
  EXPECT_PROBLEM(as(his, "DELETE", place), 404, "store.not_found");
  EXPECT_EQ(as(his, "GET", "/api/v1/sweeps").body.find(things["sweeps"]), std::string::npos);
  const std::string json = "Content-Type: application/json\r\n";
  EXPECT_PROBLEM(as(his, "POST", "/api/v1/sweeps", "{\"project_id\": \"" + things["projects"] + "\"}", json),
                 404, "store.not_found");
}

}  // namespace
}  // namespace toile::test
