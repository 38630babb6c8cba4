// Every route of the service, on its good and its bad ways.

#include <cstring>
#include <fstream>
#include <string>

#include "core/base/hash.h"
#include "core/image/read_picture.h"
#include "core/image/write_png.h"
#include "core/pattern/dxf/read.h"
#include "tests/server/http/served.h"
#include "tests/server/store/update_job.h"

namespace toile::test {
namespace {

class Routes : public Served {
 protected:
  void SetUp() override { serve(); }
  static Result<json::JsonValue> tree(const Answer& answer) {
    return json::parse_json(answer.body, {.depth = 64});
  }
  static std::size_t count(const Answer& answer, const char* list) {
    const auto read = tree(answer);
    return read && read->find(list) ? read->find(list)->array()->size() : 999;
  }
};

TEST_F(Routes, KeepAnUploadAndGiveItBack) {
  const Answer made = upload("body", "post.obj", kPost);
  ASSERT_EQ(made.status, 201) << made.body;
  const std::string id = member(made, "id");
  EXPECT_EQ(made.headers.at("location"), "/api/v1/assets/" + id);
  EXPECT_EQ(*tree(made)->find("info")->find("triangles")->number(), 12);
  EXPECT_EQ(get("/api/v1/assets/" + id).body, made.body);
  const Answer content = get("/api/v1/assets/" + id + "/content");
  EXPECT_EQ(content.body, kPost);
  EXPECT_EQ(content.headers.at("content-type"), "model/obj");
  EXPECT_EQ(content.headers.at("content-disposition"), "inline; filename=\"post.obj\"");
  EXPECT_EQ(member(upload("body", "post.obj", kPost), "id"), id) << "the same again is the same";
}

TEST_F(Routes, ListUploadsByKind) {
  ASSERT_EQ(ask(port, "POST", "/api/v1/bodies?name=post.obj", kPost).status, 201);
  EXPECT_EQ(count(get("/api/v1/assets"), "assets"), 1u);
  EXPECT_EQ(count(get("/api/v1/bodies"), "assets"), 1u);
  EXPECT_EQ(count(get("/api/v1/assets?kind=dxf"), "assets"), 0u);
  EXPECT_PROBLEM(get("/api/v1/assets?kind=fabric"), 400, "documents.kind");
}

TEST_F(Routes, NeverServeAnUploadAsSomethingThatRuns) {
  const std::string dxf =
      "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\nA\n90\n4\n70\n1\n10\n0\n20\n0\n10\n9\n20\n0\n10\n9\n20\n9\n"
      "0\n"
      "ENDSEC\n0\nEOF\n";
  const Answer made = upload("dxf", "page.html", dxf);
  ASSERT_EQ(made.status, 201) << made.body;
  const Answer content = get("/api/v1/assets/" + member(made, "id") + "/content");
  EXPECT_EQ(content.headers.at("content-type"), "image/vnd.dxf");
  EXPECT_EQ(content.headers.at("x-content-type-options"), "nosniff");
  EXPECT_NE(content.headers.at("content-security-policy").find("sandbox"), std::string::npos);
}

TEST_F(Routes, RefuseUploadsWithoutAGoodNameOrKind) {
  EXPECT_PROBLEM(upload("", "post.obj", kPost), 400, "documents.kind");
  EXPECT_PROBLEM(upload("body", "", kPost), 422, "");
  EXPECT_PROBLEM(upload("body", "..%2Fpost.obj", kPost), 422, "");
  EXPECT_PROBLEM(upload("body", "post.obj", ""), 422, "mesh.");
  EXPECT_PROBLEM(get("/api/v1/assets/a_00000000000000000000000000000000"), 404, "store.not_found");
  EXPECT_PROBLEM(get("/api/v1/assets/a_0/content"), 404, "store.not_found");
}

TEST_F(Routes, MakeShowAndReplaceAProject) {
  const std::string asset = post_asset();
  const Answer made = send_json("POST", "/api/v1/projects", napkin_request(asset));
  ASSERT_EQ(made.status, 201) << made.body;
  const std::string address = "/api/v1/projects/" + member(made, "id");
  EXPECT_EQ(made.headers.at("location"), address);
  EXPECT_EQ(made.headers.at("etag"), "\"1\"");
  const Answer shown = get(address);
  EXPECT_EQ(shown.body, made.body);
  EXPECT_EQ(*tree(shown)->find("document")->find("name")->text(), "Napkin");
  EXPECT_EQ(*tree(shown)->find("files")->find("post.obj")->text(), asset);
  EXPECT_EQ(get(address, "If-None-Match: \"1\"\r\n").status, 304);

  const std::string bigger = napkin_request(asset, "\"name\": \"Napkin\"", "\"name\": \"Cloth\"");
  const Answer replaced = send_json("PUT", address, bigger, "If-Match: \"1\"\r\n");
  ASSERT_EQ(replaced.status, 200) << replaced.body;
  EXPECT_EQ(replaced.headers.at("etag"), "\"2\"");
  EXPECT_EQ(member(replaced, "name"), "Cloth");
  EXPECT_EQ(get(address, "If-None-Match: \"1\"\r\n").status, 200);
  EXPECT_PROBLEM(send_json("PUT", address, bigger, "If-Match: \"1\"\r\n"), 412, "store.conflict");
  EXPECT_PROBLEM(send_json("PUT", address, bigger, "If-Match: W/\"2\"\r\n"), 412, "store.conflict");
  EXPECT_PROBLEM(send_json("PUT", address, bigger), 428, "request.if_match");
  EXPECT_EQ(send_json("PUT", address, bigger, "If-Match: *\r\n").headers.at("etag"), "\"3\"");
}

TEST_F(Routes, GiveOutThePatternOfAProject) {
  const std::string place = "/api/v1/projects/" + make_project() + "/pattern.";
  const Answer dxf = get(place + "dxf");
  ASSERT_EQ(dxf.status, 200) << dxf.body;
  EXPECT_EQ(dxf.headers.at("content-type"), "image/vnd.dxf");
  EXPECT_EQ(dxf.headers.at("content-disposition"), "attachment; filename=\"Napkin.dxf\"");
  const Result<dxf::DxfDrawing> drawing = dxf::read_dxf(dxf.body, {});
  ASSERT_TRUE(drawing) << to_string(drawing.error());
  EXPECT_EQ(drawing->pieces.size(), 1u);
  EXPECT_EQ(drawing->unit.name, "mm");

  const Answer svg = get(place + "svg");
  EXPECT_EQ(svg.headers.at("content-type"), "image/svg+xml");
  EXPECT_EQ(svg.headers.at("content-security-policy"), "default-src 'none'; sandbox");
  EXPECT_NE(svg.body.find("<svg"), std::string::npos);

  const Answer pdf = get(place + "pdf"), letter = get(place + "pdf?paper=letter");
  EXPECT_EQ(pdf.headers.at("content-type"), "application/pdf");
  EXPECT_TRUE(pdf.body.starts_with("%PDF-"));
  EXPECT_EQ(get(place + "pdf?paper=a4").body, pdf.body);
  EXPECT_NE(letter.body.find("MediaBox [ 0 0 612"), std::string::npos) << "8.5 inches wide";
  EXPECT_EQ(pdf.body.find("MediaBox [ 0 0 612"), std::string::npos);
}

TEST_F(Routes, TellWhetherAPatternsFileIsStillTheSame) {
  const std::string one = "/api/v1/projects/" + make_project();
  const std::string tag = get(one + "/pattern.pdf").headers.at("etag");
  const std::string known = "If-None-Match: " + tag + "\r\n";
  const Answer same = get(one + "/pattern.pdf", known);
  EXPECT_EQ(same.status, 304);
  EXPECT_EQ(same.body, "");
  EXPECT_EQ(get(one + "/pattern.pdf?paper=a3", known).status, 200) << "other paper is another file";
  const std::string wider = napkin_request(post_asset(), "\"name\": \"Napkin\"", "\"name\": \"Cloth\"");
  ASSERT_EQ(send_json("PUT", one, wider, "If-Match: *\r\n").status, 200);
  EXPECT_EQ(get(one + "/pattern.pdf", known).status, 200) << "another title stands on its sheet";
}

TEST_F(Routes, RefusePatternsThatThereAreNot) {
  const std::string one = "/api/v1/projects/" + make_project();
  EXPECT_PROBLEM(get(one + "/pattern.pdf?paper=a9"), 400, "request.paper");
  EXPECT_PROBLEM(get(one + "/pattern.dxf?paper=a4"), 400, "request.unknown_parameter");
  EXPECT_PROBLEM(get(one + "/pattern.plt"), 404, "http.not_found");
  EXPECT_PROBLEM(get("/api/v1/projects/p_0/pattern.pdf"), 404, "store.not_found");
  EXPECT_PROBLEM(ask(port, "POST", one + "/pattern.pdf"), 405, "http.method");
}

TEST_F(Routes, GiveAProjectTheNameOfTheRequest) {
  const std::string body = napkin_request(post_asset());
  const Answer made = send_json("POST", "/api/v1/projects", "{\"name\": \"Mine\", " + body.substr(1));
  ASSERT_EQ(made.status, 201) << made.body;
  EXPECT_EQ(member(made, "name"), "Mine");
  EXPECT_EQ(*tree(made)->find("document")->find("name")->text(), "Mine");
}

TEST_F(Routes, ListProjectsPageByPage) {
  const std::string request = napkin_request(post_asset());
  std::vector<std::string> ids;
  for (int i = 0; i < 3; ++i) ids.push_back(member(send_json("POST", "/api/v1/projects", request), "id"));
  const Answer first = get("/api/v1/projects?limit=2");
  EXPECT_EQ(count(first, "projects"), 2u);
  EXPECT_EQ(*tree(first)->find("projects")->array()->front().find("id")->text(), ids[2]) << "newest first";
  EXPECT_FALSE(tree(first)->find("projects")->array()->front().find("document"));
  const Answer second = get("/api/v1/projects?limit=2&cursor=" + member(first, "next"));
  EXPECT_EQ(count(second, "projects"), 1u);
  EXPECT_EQ(member(second, "next"), "");
  EXPECT_EQ(count(get("/api/v1/projects?limit=3"), "projects"), 3u);
  for (const char* limit : {"0", "101", "-1", "x", "1e3", "99999999999"}) {
    EXPECT_PROBLEM(get(std::string("/api/v1/projects?limit=") + limit), 400, "request.limit");
  }
  EXPECT_PROBLEM(get("/api/v1/projects?cursor=nonsense"), 400, "store.cursor");
}

TEST_F(Routes, RemoveAProject) {
  const std::string address = "/api/v1/projects/" + make_project();
  EXPECT_EQ(ask(port, "DELETE", address).status, 204);
  EXPECT_PROBLEM(get(address), 404, "store.not_found");
  EXPECT_PROBLEM(ask(port, "DELETE", address), 404, "store.not_found");
  EXPECT_PROBLEM(get(address + "/pieces"), 404, "store.not_found");
  EXPECT_PROBLEM(send_json("PUT", address, napkin_request(post_asset()), "If-Match: *\r\n"), 404,
                 "store.not_found");
}

TEST_F(Routes, RemoveAProjectOnlyAtTheRevisionOfIfMatch) {
  const std::string address = "/api/v1/projects/" + make_project();
  ASSERT_EQ(send_json("PUT", address, napkin_request(post_asset()), "If-Match: \"1\"\r\n").status, 200);
  for (const char* tag : {"\"1\"", "\"3\"", "W/\"2\"", "2", "\"x\""}) {
    EXPECT_PROBLEM(ask(port, "DELETE", address, "", std::string("If-Match: ") + tag + "\r\n"), 412,
                   "store.conflict");
  }
  EXPECT_EQ(get(address).status, 200);
  EXPECT_EQ(ask(port, "DELETE", address, "", "If-Match: \"2\"\r\n").status, 204);
  EXPECT_PROBLEM(ask(port, "DELETE", address, "", "If-Match: \"2\"\r\n"), 404, "store.not_found");
  const std::string other = "/api/v1/projects/" + make_project();
  EXPECT_EQ(ask(port, "DELETE", other, "", "If-Match: *\r\n").status, 204);
}

TEST_F(Routes, MakeAProjectOnceForEachKey) {
  const std::string request = napkin_request(post_asset());
  const auto post = [this](const std::string& body, const std::string& key) {
    return send_json("POST", "/api/v1/projects", body, "Idempotency-Key: " + key + "\r\n");
  };
  const Answer first = post(request, "once");
  ASSERT_EQ(first.status, 201) << first.body;
  const std::string address = first.headers.at("location");
  const Answer again = post(request, "once");
  EXPECT_EQ(again.status, 200);
  EXPECT_EQ(again.body, first.body);
  EXPECT_EQ(again.headers.at("location"), address);
  EXPECT_EQ(count(get("/api/v1/projects"), "projects"), 1u);

  const std::string bigger = napkin_request(post_asset(), "\"name\": \"Napkin\"", "\"name\": \"Cloth\"");
  EXPECT_PROBLEM(post(bigger, "once"), 409, "store.idempotency_mismatch");
  ASSERT_EQ(send_json("PUT", address, bigger, "If-Match: *\r\n").status, 200);
  const Answer edited = post(request, "once");
  EXPECT_EQ(edited.status, 200) << edited.body;
  EXPECT_EQ(member(edited, "name"), "Cloth") << "the project as it is now";

  EXPECT_EQ(post(request, "twice").status, 201);
  EXPECT_PROBLEM(post(request, "two words"), 400, "store.idempotency_key");
  ASSERT_EQ(ask(port, "DELETE", address).status, 204);
  EXPECT_EQ(post(request, "once").status, 201) << "a removed project has freed its key";
}

TEST_F(Routes, RefuseRequestsForProjectsThatAreNone) {
  const auto post = [this](const std::string& body) { return send_json("POST", "/api/v1/projects", body); };
  EXPECT_PROBLEM(post(""), 400, "json.syntax");
  EXPECT_PROBLEM(post("[]"), 422, "request.object");
  EXPECT_PROBLEM(post("{}"), 422, "request.document");
  EXPECT_PROBLEM(post(R"({"document": 1})"), 422, "request.document");
  EXPECT_PROBLEM(post(R"({"document": {}, "documnet": 1})"), 422, "request.unknown_key");
  EXPECT_PROBLEM(post(R"({"document": {}, "files": []})"), 422, "request.files");
  EXPECT_PROBLEM(post(R"({"document": {}, "files": {"a": 1}})"), 422, "request.files");
  EXPECT_PROBLEM(post(R"({"document": {}, "document": {}})"), 400, "json.duplicate_key");
  const Answer unknown = post(napkin_request("a_00000000000000000000000000000000"));
  EXPECT_PROBLEM(unknown, 422, "documents.unknown_asset");
  EXPECT_EQ(member(unknown, "where"), "/files/post.obj");
}

TEST_F(Routes, DrawTheFlatPieces) {
  const Answer pieces = get("/api/v1/projects/" + make_project() + "/pieces");
  ASSERT_EQ(pieces.status, 200) << pieces.body;
  const Result<json::JsonValue> read = tree(pieces);
  const json::JsonValue& piece = read->find("pieces")->array()->front();
  EXPECT_EQ(*piece.find("id")->text(), "napkin");
  EXPECT_EQ(piece.find("outline")->array()->size(), 4u);
  EXPECT_EQ(piece.find("edges")->array()->size(), 4u);
  EXPECT_EQ(*piece.find("outline")->array()->at(2).array()->at(0).number(), 300);
}

TEST_F(Routes, SubmitAJobOnceForEachKey) {
  const std::string request = "{\"project_id\": \"" + make_project() + "\"}";
  const Answer first = send_json("POST", "/api/v1/jobs", request, "Idempotency-Key: once\r\n");
  ASSERT_EQ(first.status, 201) << first.body;
  EXPECT_EQ(first.headers.at("location"), "/api/v1/jobs/" + member(first, "id"));
  EXPECT_EQ(member(first, "state"), "queued");
  const Answer again = send_json("POST", "/api/v1/jobs", request, "Idempotency-Key: once\r\n");
  EXPECT_EQ(again.status, 200) << "it was there already";
  EXPECT_EQ(again.headers.at("location"), first.headers.at("location"));
  EXPECT_EQ(again.body, first.body);
  EXPECT_NE(member(send_json("POST", "/api/v1/jobs", request), "id"), member(first, "id"));
  EXPECT_EQ(count(get("/api/v1/jobs"), "jobs"), 2u);
  EXPECT_EQ(count(get("/api/v1/jobs?limit=1"), "jobs"), 1u);
  EXPECT_PROBLEM(send_json("POST", "/api/v1/jobs", request, "Idempotency-Key: \x01\r\n"), 400, "");
  const std::string other = "{\"project_id\": \"" + make_project() + "\"}";
  EXPECT_PROBLEM(send_json("POST", "/api/v1/jobs", other, "Idempotency-Key: once\r\n"), 409,
                 "store.idempotency_mismatch");
}

TEST_F(Routes, AnswerARetryWithTheJobOfThenAlthoughTheProjectHasChanged) {
  const std::string project = make_project(), request = "{\"project_id\": \"" + project + "\"}";
  const Answer first = send_json("POST", "/api/v1/jobs", request, "Idempotency-Key: once\r\n");
  ASSERT_EQ(first.status, 201) << first.body;
  ASSERT_EQ(
      send_json("PUT", "/api/v1/projects/" + project, napkin_request(post_asset()), "If-Match: *\r\n").status,
      200);
  const Answer retry = send_json("POST", "/api/v1/jobs", request, "Idempotency-Key: once\r\n");
  EXPECT_EQ(retry.status, 200) << retry.body;
  EXPECT_EQ(retry.body, first.body);
  const Answer anew = send_json("POST", "/api/v1/jobs", request, "Idempotency-Key: again\r\n");
  EXPECT_EQ(anew.status, 201);
  EXPECT_EQ(*tree(anew)->find("project_revision")->number(), 2);
}

TEST_F(Routes, SubmitAJobAsUrgentAsItIs) {
  const std::string project = make_project();
  const auto submit = [&](const std::string& more) {
    return send_json("POST", "/api/v1/jobs", "{\"project_id\": \"" + project + "\"" + more + "}");
  };
  EXPECT_EQ(member(submit(""), "priority"), "batch");
  EXPECT_EQ(member(submit(", \"priority\": \"interactive\""), "priority"), "interactive");
  EXPECT_PROBLEM(submit(", \"priority\": \"urgent\""), 422, "request.priority");
  EXPECT_PROBLEM(submit(", \"priority\": 3"), 422, "request.priority");
}

TEST_F(Routes, SubmitAJobWithOrWithoutPictures) {
  const std::string project = make_project();
  const auto submit = [&](const std::string& more) {
    return send_json("POST", "/api/v1/jobs", "{\"project_id\": \"" + project + "\"" + more + "}");
  };
  const Answer without = submit(", \"pictures\": false");
  EXPECT_EQ(*tree(submit(""))->find("pictures")->boolean(), true);
  EXPECT_EQ(*tree(without)->find("pictures")->boolean(), false);
  EXPECT_EQ(*tree(get("/api/v1/jobs/" + member(without, "id")))->find("pictures")->boolean(), false);
  EXPECT_PROBLEM(submit(", \"pictures\": \"no\""), 422, "request.pictures");
}

TEST_F(Routes, RefuseJobsOfNothing) {
  EXPECT_PROBLEM(send_json("POST", "/api/v1/jobs", R"({"project_id": "p_00000000000000000000"})"), 404,
                 "store.not_found");
  EXPECT_PROBLEM(send_json("POST", "/api/v1/jobs", "{}"), 422, "request.project_id");
  EXPECT_PROBLEM(send_json("POST", "/api/v1/jobs", R"({"project": "p"})"), 422, "request.unknown_key");
  for (const char* what : {"", "/results", "/results/report.json", "/pieces", "/body"}) {
    EXPECT_PROBLEM(get(std::string("/api/v1/jobs/j_00000000000000000000") + what), 404, "store.not_found");
  }
  for (const char* what : {"/pause", "/resume", "/step", "/cancel"}) {
    EXPECT_PROBLEM(ask(port, "POST", std::string("/api/v1/jobs/j_00000000000000000000") + what), 404,
                   "store.not_found");
  }
}

TEST_F(Routes, PauseResumeAndCancelAJob) {
  const std::string address = "/api/v1/jobs/" + make_job();
  EXPECT_EQ(member(ask(port, "POST", address + "/pause"), "state"), "paused");
  EXPECT_PROBLEM(ask(port, "POST", address + "/pause"), 409, "jobs.state");
  EXPECT_EQ(member(ask(port, "POST", address + "/resume"), "state"), "queued");
  EXPECT_EQ(member(ask(port, "POST", address + "/cancel"), "state"), "cancelled");
  EXPECT_PROBLEM(ask(port, "POST", address + "/cancel"), 409, "jobs.state");
  EXPECT_EQ(member(get(address), "state"), "cancelled");
}

TEST_F(Routes, GiveOutResultsAndTheReport) {
  const std::string id = make_job(), address = "/api/v1/jobs/" + id;
  EXPECT_EQ(count(get(address + "/results"), "results"), 0u);
  ASSERT_TRUE(store->put_result(kMe, id, "front.png", "\x89PNG"));
  auto row = store->job(kMe, id);
  row->state = store::JobState::kSucceeded;
  row->report = "{\"settled\": true}\n";
  row->results = {{"front.png", 4}};
  ASSERT_TRUE(test::update_job(*store, kMe, *row));
  EXPECT_EQ(count(get(address + "/results"), "results"), 1u);
  const Answer png = get(address + "/results/front.png");
  EXPECT_EQ(png.body, "\x89PNG");
  EXPECT_EQ(png.headers.at("content-type"), "image/png");
  EXPECT_PROBLEM(get(address + "/results/back.png"), 404, "store.not_found");
  EXPECT_TRUE(*tree(get(address))->find("report")->find("settled")->boolean());
}

TEST_F(Routes, MakeAPictureAmongTheResultsSmaller) {
  const std::string id = make_job(), address = "/api/v1/jobs/" + id + "/results/";
  const std::string png = *image::encode_png(640, 800, 3, std::vector<std::uint8_t>(640 * 800 * 3, 90));
  auto row = store->job(kMe, id);
  row->state = store::JobState::kSucceeded;
  for (const auto& [name, bytes] : {std::pair<std::string, std::string>{"front.png", png}, {"a.obj", "v"}}) {
    ASSERT_TRUE(store->put_result(kMe, id, name, bytes));
    row->results[name] = {static_cast<std::int64_t>(bytes.size()), hash_of(std::string_view(bytes))};
  }
  ASSERT_TRUE(test::update_job(*store, kMe, *row));
  const auto width_of = [](const Answer& answer) { return image::read_picture(answer.body)->picture.width; };
  const Answer small = get(address + "front.png/small");
  EXPECT_EQ(small.headers.at("content-type"), "image/png");
  EXPECT_EQ(width_of(small), 320);
  EXPECT_EQ(width_of(get(address + "front.png/small?width=64")), 64);
  for (const char* wrong : {"8", "2000", "wide", "64x"})
    EXPECT_PROBLEM(get(address + "front.png/small?width=" + wrong), 400, "request.width");
  EXPECT_PROBLEM(get(address + "a.obj/small"), 422, "request.no_picture");
  EXPECT_PROBLEM(get(address + "back.png/small"), 404, "store.not_found");
}

TEST_F(Routes, ShowTheReportAsAPageWithItsPictures) {
  const std::string id = make_job(), address = "/api/v1/jobs/" + id + "/report";
  EXPECT_PROBLEM(get(address), 404, "jobs.no_report");
  const std::string png = *image::encode_png(64, 80, 3, std::vector<std::uint8_t>(64 * 80 * 3, 90));
  ASSERT_TRUE(store->put_result(kMe, id, "front.png", png));
  auto row = store->job(kMe, id);
  row->state = store::JobState::kSucceeded;
  row->report = R"({"name": "skirt", "fit": [{"at": "waist", "text": "waist 2.1 cm too tight"}]})";
  row->results["front.png"] = {static_cast<std::int64_t>(png.size()), hash_of(std::string_view(png))};
  ASSERT_TRUE(test::update_job(*store, kMe, *row));
  const Answer page = get(address);
  EXPECT_EQ(page.headers.at("content-type"), "text/html; charset=utf-8");
  EXPECT_NE(page.headers.at("content-security-policy").find("default-src 'none'; img-src data:"),
            std::string::npos);
  EXPECT_NE(page.body.find("waist 2.1 cm too tight"), std::string::npos);
  EXPECT_NE(page.body.find("data:image/png;base64,"), std::string::npos);
}

TEST_F(Routes, AResultThatTheDiskHasChangedIsAFaultAndNotAnAnswer) {
  const std::string id = make_job();
  ASSERT_TRUE(store->put_result(kMe, id, "front.png", "png!"));
  Result<store::JobRow> row = store->job(kMe, id);
  row->state = store::JobState::kSucceeded;
  row->results["front.png"] = {4, hash_of(std::string_view("png!"))};
  ASSERT_TRUE(test::update_job(*store, kMe, *row));
  const std::string target = "/api/v1/jobs/" + id + "/results/front.png";
  EXPECT_EQ(get(target).body, "png!");
  std::ofstream(folder / "data" / "results" / id / "front.png") << "pgn!";
  EXPECT_PROBLEM(get(target), 500, "store.corrupt");
  EXPECT_NE(get("/metrics").body.find("toile_store_failures_total{code=\"store.corrupt\"} 1\n"),
            std::string::npos);
}

TEST_F(Routes, GiveOutAJobsLog) {
  const std::string id = make_job(), target = "/api/v1/jobs/" + id + "/log";
  EXPECT_EQ(get(target).body, "");
  std::ofstream(std::filesystem::path(store->log_folder()) / id) << "{\"event\": \"job queued\"}\n";
  const Answer lines = get(target);
  EXPECT_EQ(lines.headers.at("content-type"), "application/x-ndjson");
  EXPECT_EQ(lines.body, "{\"event\": \"job queued\"}\n");
  EXPECT_PROBLEM(get("/api/v1/jobs/j_0/log"), 404, "store.not_found");
}

TEST_F(Routes, SendTheBodyAsOneMesh) {
  const Answer body = get("/api/v1/jobs/" + make_job() + "/body");
  ASSERT_EQ(body.status, 200);
  ASSERT_EQ(body.body.size(), 8u + 8 * 12 + 12 * 12);
  std::uint32_t vertices = 0, triangles = 0;
  std::memcpy(&vertices, body.body.data(), 4);
  std::memcpy(&triangles, body.body.data() + 4, 4);
  EXPECT_EQ(vertices, 8u);
  EXPECT_EQ(triangles, 12u);
  for (std::size_t at = 8 + 8 * 12; at < body.body.size(); at += 4) {
    std::uint32_t corner = 99;
    std::memcpy(&corner, body.body.data() + at, 4);
    EXPECT_LT(corner, 8u);
  }
}

TEST_F(Routes, TellTheColoursThatAJobWasMadeWith) {
  const std::string project = make_project();
  const Answer made = send_json("POST", "/api/v1/jobs", "{\"project_id\": \"" + project + "\"}");
  ASSERT_EQ(made.status, 201) << made.body;
  const std::string target = "/api/v1/jobs/" + member(made, "id") + "/pieces";
  const Answer before = get(target);
  ASSERT_EQ(before.status, 200) << before.body;
  const auto seen = tree(before);
  const auto drawn = tree(get("/api/v1/projects/" + project + "/pieces"));
  const json::JsonValue& piece = seen->find("pieces")->array()->front();
  const json::JsonValue& of_project = drawn->find("pieces")->array()->front();
  EXPECT_EQ(json::write_json_line(*piece.find("colour")), json::write_json_line(*of_project.find("colour")));
  EXPECT_EQ(piece.find("outline"), nullptr);
  const std::string edits = R"({"edits": [{"edit": "set_fabric", "piece": ")" + *piece.find("id")->text() +
                            R"(", "fabric": "denim-10oz"}]})";
  ASSERT_EQ(send_json("POST", "/api/v1/projects/" + project + "/edits", edits, "If-Match: *\r\n").status,
            200);
  EXPECT_EQ(get(target).body, before.body) << "the job keeps what it is made of";
}

TEST_F(Routes, SayThatThePageIsNotBuilt) {
  EXPECT_NE(get("/").body.find("has not been built"), std::string::npos);
  EXPECT_PROBLEM(get("/index.js"), 404, "http.not_found");
}

}  // namespace
}  // namespace toile::test
