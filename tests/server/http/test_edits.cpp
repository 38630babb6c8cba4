// Edits, undo, redo, their history and imports over HTTP.

#include <string>

#include "tests/core/image/pictures.h"
#include "tests/server/http/served.h"

namespace toile::test {
namespace {

constexpr const char* kRename = R"({"edits": [{"edit": "rename_piece", "piece": "napkin", "to": "cloth"}]})";
constexpr const char* kWiden =
    R"({"edits": [{"edit": "set_edge_length", "piece": "cloth", "edge": "south", "length_mm": 350, "keep": "middle"}]})";

class Edits : public Served {
 protected:
  void SetUp() override {
    serve();
    one = "/api/v1/projects/" + make_project();
  }
  Answer post(const std::string& what, const std::string& body = "", const std::string& match = "*") {
    return send_json("POST", one + what, body, match.empty() ? "" : "If-Match: " + match + "\r\n");
  }
  std::string document() { return store->project(kMe, one.substr(17))->document; }
  std::string one;
};

TEST_F(Edits, AreDoneUndoneAndRedone) {
  const std::string first = document();
  const Answer renamed = post("/edits", kRename, "\"1\"");
  ASSERT_EQ(renamed.status, 200) << renamed.body;
  EXPECT_EQ(renamed.headers.at("etag"), "\"2\"");
  EXPECT_NE(renamed.body.find("\"id\": \"cloth\""), std::string::npos);
  const std::string second = document();
  ASSERT_EQ(post("/edits", kWiden, "\"2\"").status, 200);
  const std::string third = document();
  EXPECT_EQ(post("/undo", "", "\"3\"").headers.at("etag"), "\"4\"");
  EXPECT_EQ(document(), second);
  EXPECT_EQ(post("/undo").status, 200);
  EXPECT_EQ(document(), first);
  EXPECT_PROBLEM(post("/undo"), 409, "edit.nothing_to_undo");
  EXPECT_EQ(post("/redo").status, 200);
  EXPECT_EQ(post("/redo").status, 200);
  EXPECT_EQ(document(), third);
  EXPECT_PROBLEM(post("/redo"), 409, "edit.nothing_to_redo");
}

TEST_F(Edits, WantTheRevisionThatTheyChange) {
  EXPECT_PROBLEM(post("/edits", kRename, ""), 428, "request.if_match");
  EXPECT_PROBLEM(post("/edits", kRename, "\"9\""), 412, "store.conflict");
  EXPECT_PROBLEM(post("/edits", kRename, "W/\"1\""), 412, "store.conflict");
  EXPECT_PROBLEM(post("/undo", "", ""), 428, "request.if_match");
  EXPECT_PROBLEM(post("/redo", "", "\"9\""), 412, "store.conflict");
}

TEST_F(Edits, AreRefusedWithTheirPlace) {
  const Answer unknown = post("/edits", R"({"edits": [{"edit": "mirror_piece", "piece": "sleeve"}]})");
  EXPECT_PROBLEM(unknown, 422, "edit.unknown_piece");
  EXPECT_EQ(member(unknown, "where"), "/edits/0: piece sleeve");
  EXPECT_PROBLEM(post("/edits", R"({"edits": [{"edit": "tear"}]})"), 422, "edit.unknown");
  EXPECT_PROBLEM(post("/edits", R"({"edits": 3})"), 422, "project.wrong_type");
  EXPECT_PROBLEM(post("/edits", R"({})"), 422, "request.edits");
  EXPECT_PROBLEM(post("/edits", R"({"edit": []})"), 422, "request.unknown_key");
  EXPECT_PROBLEM(post("/edits", "["), 400, "json.syntax");
  EXPECT_PROBLEM(
      post(
          "/edits",
          R"({"edits": [{"edit": "move_point", "piece": "napkin", "edge": "south", "point": 0, "to": [150, 310]}]})"),
      422, "pattern.self_crossing");
  EXPECT_PROBLEM(send_json("POST", "/api/v1/projects/p_0/edits", kRename, "If-Match: *\r\n"), 404,
                 "store.not_found");
}

TEST_F(Edits, StandInTheHistoryNewestFirst) {
  ASSERT_EQ(post("/edits", kRename).status, 200);
  ASSERT_EQ(post("/edits", kWiden).status, 200);
  const Answer page = get(one + "/edits?limit=1");
  ASSERT_EQ(page.status, 200) << page.body;
  EXPECT_NE(page.body.find("set_edge_length"), std::string::npos);
  EXPECT_EQ(page.body.find("rename_piece"), std::string::npos);
  const Answer rest = get(one + "/edits?limit=1&cursor=" + member(page, "next"));
  EXPECT_NE(rest.body.find("rename_piece"), std::string::npos);
  EXPECT_PROBLEM(get(one + "/edits?cursor=x"), 400, "store.cursor");
  EXPECT_PROBLEM(get("/api/v1/projects/p_0/edits"), 404, "store.not_found");
  ASSERT_EQ(send_json("PUT", one, napkin_request(post_asset()), "If-Match: *\r\n").status, 200);
  EXPECT_EQ(get(one + "/edits").body, "{\"edits\": [], \"next\": null}\n") << "a replaced document has none";
}

TEST_F(Edits, ProposalsOfSeamsComeWithTheRevisionThatTheyAreFor) {
  const Answer answer = get(one + "/proposals");
  ASSERT_EQ(answer.status, 200) << answer.body;
  EXPECT_EQ(answer.body.find("{\"proposals\": ["), 0u);
  EXPECT_EQ(answer.headers.at("etag"), "\"1\"");
  EXPECT_PROBLEM(get("/api/v1/projects/p_0/proposals"), 404, "store.not_found");
}

TEST_F(Edits, ImportsReportOnAnUploadedPattern) {
  const std::string dxf =
      "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\nA\n90\n4\n70\n1\n10\n0\n20\n0\n10\n90\n20\n0\n10\n90\n20\n9"
      "0\n"
      "10\n0\n20\n90\n0\nENDSEC\n0\nEOF\n";
  const std::string asset = member(upload("dxf", "a.dxf", dxf), "id");
  const Answer report =
      send_json("POST", "/api/v1/imports", "{\"asset\": \"" + asset + "\", \"unit\": \"mm\"}");
  ASSERT_EQ(report.status, 200) << report.body;
  EXPECT_NE(report.body.find("\"area_mm2\": 8100"), std::string::npos) << report.body;
  EXPECT_PROBLEM(send_json("POST", "/api/v1/imports", "{}"), 422, "request.import");
  EXPECT_PROBLEM(send_json("POST", "/api/v1/imports", "{\"asset\": 3}"), 422, "request.import");
  EXPECT_PROBLEM(send_json("POST", "/api/v1/imports", "{\"asset\": \"a_0\"}"), 404, "store.not_found");
  EXPECT_PROBLEM(send_json("POST", "/api/v1/imports", "{\"asset\": \"" + post_asset() + "\"}"), 422,
                 "documents.wrong_kind");
}

TEST_F(Edits, ImportsAreToldWhatLayersAre) {
  const std::string dxf =
      "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\n5\n90\n4\n70\n1\n10\n0\n20\n0\n10\n90\n20\n0\n10\n90\n20\n9"
      "0\n10\n0\n20\n90\n0\nLINE\n8\n1\n10\n20\n20\n20\n11\n20\n21\n70\n0\nENDSEC\n0\nEOF\n";
  const Answer kept = upload("dxf", "odd.dxf", dxf);
  ASSERT_EQ(kept.status, 201) << kept.body;
  const std::string asset = member(kept, "id");
  const auto import = [&](const std::string& layers) {
    return send_json("POST", "/api/v1/imports",
                     R"({"asset": ")" + asset + R"(", "unit": "mm", "layers": )" + layers + "}");
  };
  EXPECT_PROBLEM(import("{}"), 422, "dxf.open_outline");
  const Answer layers = get("/api/v1/assets/" + asset + "/layers");
  ASSERT_EQ(layers.status, 200) << layers.body;
  EXPECT_NE(layers.body.find(R"({"name": "5", "read_as": "grade", "given": false, "count": 1)"),
            std::string::npos)
      << layers.body;
  const Answer report = import(R"({"5": "cut", "1": "grain"})");
  ASSERT_EQ(report.status, 200) << report.body;
  EXPECT_NE(report.body.find("\"area_mm2\": 8100"), std::string::npos) << report.body;
  EXPECT_NE(report.body.find("\"grain_deg\": 90"), std::string::npos);
  EXPECT_PROBLEM(import(R"({"5": "cutt"})"), 422, "dxf.unknown_role");
  EXPECT_PROBLEM(import(R"({"6": "cut"})"), 422, "dxf.unknown_layer");
  EXPECT_PROBLEM(import(R"({"5": 1})"), 422, "request.import");
  EXPECT_PROBLEM(import("[]"), 422, "request.import");
  EXPECT_PROBLEM(get("/api/v1/assets/a_0/layers"), 404, "store.not_found");
}

TEST_F(Edits, PutAnUploadedPictureOnAPiece) {
  const std::string png = png_of(squares());
  const Answer kept = ask(port, "POST", "/api/v1/assets?kind=image&name=checks.png", png);
  ASSERT_EQ(kept.status, 201) << kept.body;
  const std::string id = member(kept, "id");
  const std::string edits =
      R"({"edits": [{"edit": "set_texture", "piece": "napkin", "texture": {"image": "checks.png", "scale_mm": 40}}])";
  EXPECT_PROBLEM(post("/edits", edits + "}"), 422, "documents.missing_file");
  EXPECT_PROBLEM(post("/edits", edits + R"(, "files": {"checks.png": 3}})"), 422, "request.files");
  const Answer done = post("/edits", edits + R"(, "files": {"checks.png": ")" + id + "\"}}");
  ASSERT_EQ(done.status, 200) << done.body;
  EXPECT_NE(done.body.find("\"checks.png\": \"" + id + "\""), std::string::npos);
  const Answer content = ask(port, "GET", "/api/v1/assets/" + id + "/content");
  EXPECT_EQ(content.headers.at("content-type"), "image/png");
  EXPECT_EQ(content.body, png);
  EXPECT_EQ(post("/undo").status, 200);
}

TEST_F(Edits, ABrokenPictureIsNotKept) {
  const Answer cut =
      ask(port, "POST", "/api/v1/assets?kind=image&name=cut.png", png_of(squares()).substr(0, 70));
  EXPECT_PROBLEM(cut, 422, "image.truncated");
  EXPECT_EQ(member(cut, "where"), "cut.png");
  EXPECT_PROBLEM(ask(port, "POST", "/api/v1/assets?kind=image&name=a.png", "GIF89a"), 422, "image.format");
}

}  // namespace
}  // namespace toile::test
