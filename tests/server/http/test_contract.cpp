// What the server answers and streams fits proto/openapi.yaml and proto/asyncapi.yaml: a drape from the
// upload to the last result is recorded, and check_contract.py holds it against the schemas. The same script
// looks over the two files themselves.

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "server/accounts/passwords.h"
#include "tests/core/image/pictures.h"
#include "tests/server/http/dressed.h"
#include "tests/server/http/served.h"

namespace toile::test {
namespace {

constexpr const char* kJson = "Content-Type: application/json\r\n";

class Contract : public Served {
 protected:
  void SetUp() override { serve({}, true); }

  Answer recorded(const std::string& method, const std::string& target, const std::string& body = "",
                  const std::string& headers = "") {
    const Answer answer = ask(port, method, target, body, headers);
    const auto type = answer.headers.find("content-type");
    const bool json = type != answer.headers.end() && type->second.find("json") != std::string::npos;
    keep({{"method", method},
          {"path", target.substr(0, target.find('?'))},
          {"status", static_cast<double>(answer.status)},
          {"content_type", type == answer.headers.end() ? std::string() : type->second},
          {"body", json ? answer.body : std::string()}});
    return answer;
  }
  void keep(std::vector<json::JsonMember> members) {
    lines += json::write_json_line(std::move(members)) + "\n";
  }

  void keep_stream(const std::string& address, const std::string& headers = "") {
    Socket viewer(port, address + "/stream", headers);
    keep({{"method", std::string("GET")},
          {"path", address + "/stream"},
          {"status", static_cast<double>(viewer.status())},
          {"content_type", std::string()},
          {"body", std::string()}});
    viewer.send(Socket::kText, R"({"type": "resume"})");  // refused: it is not paused
    while (const auto message = viewer.read(120)) {
      if (message->opcode == Socket::kText) keep({{"message", message->payload}});
      if (message->opcode == Socket::kBinary) ++frames;
      if (message->opcode == Socket::kClose) return;
    }
    ADD_FAILURE() << "the stream broke off";
  }

  void record_edits(const std::string& project) {
    const std::string edits = R"({"edits": [{"edit": "rotate_grain", "piece": "napkin", "angle": 45}]})";
    const std::string any = std::string("Content-Type: application/json\r\n") + "If-Match: *\r\n";
    EXPECT_EQ(recorded("POST", project + "/edits", edits, any).status, 200);
    recorded("POST", project + "/edits", R"({"edits": [{"edit": "tear"}]})", any);
    const std::string printed =
        R"({"edits": [{"edit": "set_texture", "piece": "napkin", "texture": {"image": "a.png", "scale_mm": 40}}])";
    const std::string image =
        member(recorded("POST", "/api/v1/assets?kind=image&name=checks.png", png_of(squares())), "id");
    recorded("POST", project + "/edits", printed + "}", any);
    const std::string with_file = printed + R"(, "files": {"a.png": ")" + image + "\"}}";
    EXPECT_EQ(recorded("POST", project + "/edits", with_file, any).status, 200);
    EXPECT_EQ(recorded("GET", project + "/pieces").status, 200);
    for (const char* file : {"/pattern.dxf", "/pattern.svg", "/pattern.pdf"})
      EXPECT_EQ(recorded("GET", project + file).status, 200);
    recorded("GET", project + "/pattern.pdf?paper=a9");
    recorded("GET", project + "/edits?limit=1");
    EXPECT_EQ(recorded("POST", project + "/undo", "", any).status, 200);
    recorded("POST", project + "/undo", "", any);
    EXPECT_EQ(recorded("POST", project + "/redo", "", any).status, 200);
    recorded("POST", project + "/redo", "");
    recorded("GET", project + "/edits");
    const Answer version = recorded("POST", project + "/versions", R"({"name": "as drawn"})", any);
    EXPECT_EQ(version.status, 201);
    recorded("POST", project + "/versions", R"({"name": "as drawn"})", any);
    recorded("POST", project + "/versions", R"({"name": ""})", any);
    recorded("POST", project + "/versions", R"({"name": "late"})", "If-Match: \"99\"\r\n");
    const std::string named = project + "/versions/" + member(version, "id");
    recorded("GET", project + "/versions");
    EXPECT_EQ(recorded("POST", named + "/restore", "", any).status, 200);
    recorded("POST", project + "/versions/v_0/restore", "", any);
    EXPECT_EQ(recorded("DELETE", named).status, 204);
    recorded("DELETE", named);
  }

  void record_bodies(const std::string& post) {
    recorded("GET", "/api/v1/bodies/presets");
    recorded("GET", "/api/v1/fabrics");
    recorded("GET", "/api/v1/fabrics/single-jersey");
    recorded("GET", "/api/v1/fabrics/singel-jersey");
    recorded("GET", "/api/v1/bodies/" + post + "/figure");
    recorded("GET", "/api/v1/bodies/a_0/figure");
    const std::string slim = R"({"mannequin": {"preset": "eu38", "triangles": 1000}, "name": "anna"})";
    recorded("POST", "/api/v1/bodies/mannequins", R"({"mannequin": {"preset": "eu39"}})", kJson);
    const Answer made = recorded("POST", "/api/v1/bodies/mannequins", slim, kJson);
    EXPECT_EQ(made.status, 201) << made.body;
  }

  void record_arrangement(const std::string& post) {
    const std::string any = std::string(kJson) + "If-Match: *\r\n";
    const std::string one =
        "/api/v1/projects/" + member(recorded("POST", "/api/v1/projects", dressed_pair(post), kJson), "id");
    recorded("GET", one + "/bodies");
    recorded("GET", one + "/body");
    recorded("PUT", one + "/bodies/anna", R"({"mannequin": {"preset": "eu40", "triangles": 1000}})", any);
    recorded("PUT", one + "/bodies/anna", R"({"asset": "a_0"})", any);
    recorded("PUT", one + "/bodies/anna", "{}", kJson);
    const std::string mark = one + "/bodies/anna/landmarks/navel";
    EXPECT_EQ(recorded("PUT", mark, R"({"place": [0, 1, 0.2]})", any).status, 200);
    recorded("PUT", mark, R"({"place": [0, 1]})", any);
    recorded("GET", one + "/bodies");
    EXPECT_EQ(recorded("DELETE", mark, "", any).status, 200);
    recorded("DELETE", mark, "", any);
    recorded("PUT", one + "/bodies/post", "{\"asset\": \"" + post + "\"}", any);
    EXPECT_EQ(recorded("DELETE", one + "/bodies/post", "", any).status, 200);
    recorded("DELETE", one + "/bodies/post", "", any);
    EXPECT_EQ(recorded("POST", one + "/arrange", "", any).status, 200);
    recorded("POST", one + "/arrange", "");
    EXPECT_EQ(
        recorded("POST", one + "/place", R"({"piece": "back", "side": "back", "with_partner": true})", any)
            .status,
        200);
    recorded("POST", one + "/place", R"({"piece": "back", "side": "below"})", any);
    EXPECT_EQ(recorded("GET", one + "/check").status, 200);
    EXPECT_EQ(recorded("GET", one + "/start").status, 200);
  }

  /// What a server with accounts says beside.
  void record_accounts() {
    Served::TearDown();
    serve({}, false, true);
    store::AccountRow anna;
    anna.name = "anna";
    anna.password = *accounts::hash_of_password("correct horse");
    anna.admin = true;
    const std::string own = store->accounts()->add_account(anna)->id;
    store::AccountRow ben;
    ben.name = "ben";
    const std::string other = store->accounts()->add_account(ben)->id;
    recorded("GET", "/api/v1/session");
    recorded("GET", "/api/v1/keys");
    recorded("POST", "/api/v1/session", R"({"name": "anna", "password": "wrong"})", kJson);
    recorded("POST", "/api/v1/session", R"({"nam": "anna"})", kJson);
    const Answer in =
        recorded("POST", "/api/v1/session", R"({"name": "anna", "password": "correct horse"})", kJson);
    ASSERT_EQ(in.status, 204) << in.body;
    const std::string set = in.headers.at("set-cookie");
    const std::string cookie = "Cookie: " + set.substr(0, set.find(';')) +
                               "\r\nOrigin: http://localhost:" + std::to_string(port) + "\r\n";
    recorded("GET", "/api/v1/session", "", cookie);
    recorded("GET", "/api/v1/admin/accounts");
    recorded("GET", "/api/v1/admin/accounts", "", cookie);
    recorded("GET", "/api/v1/admin/load", "", cookie);
    recorded("POST", "/api/v1/admin/accounts/" + own + "/lock", "", cookie);
    EXPECT_EQ(recorded("POST", "/api/v1/admin/accounts/" + other + "/lock", "", cookie).status, 204);
    EXPECT_EQ(recorded("POST", "/api/v1/admin/accounts/" + other + "/unlock", "", cookie).status, 204);
    const Answer keys = recorded("GET", "/api/v1/keys", "", cookie);
    const auto told = json::parse_json(keys.body);
    ASSERT_TRUE(told) << keys.body;
    recorded("DELETE", "/api/v1/session", "", cookie);
    const Answer again =
        ask(port, "POST", "/api/v1/session", R"({"name": "anna", "password": "correct horse"})", kJson);
    const std::string newer = again.headers.at("set-cookie");
    const std::string second = "Cookie: " + newer.substr(0, newer.find(';')) +
                               "\r\nOrigin: http://localhost:" + std::to_string(port) + "\r\n";
    const auto now = json::parse_json(get("/api/v1/keys", second).body);
    const std::string id = *now->find("keys")->array()->front().find("id")->text();
    recorded("DELETE", "/api/v1/keys/k_0", "", second);
    recorded("DELETE", "/api/v1/keys/" + id, "", second);
  }

  /// What whoever has a link sees of the drape, which has ended and has a picture on it.
  void record_links(const std::string& address) {
    const std::string wish = R"({"label": "to see", "days": 1, "take": ["pictures", "models", "report"]})";
    recorded("POST", address + "/links", R"({"days": -1})", kJson);
    recorded("POST", "/api/v1/jobs/j_0/links", wish, kJson);
    const std::string secret = member(recorded("POST", address + "/links", wish, kJson), "secret");
    recorded("GET", address + "/links");
    recorded("GET", "/api/v1/links");
    recorded("POST", "/api/v1/shared", R"({"secret": "guess"})", kJson);
    recorded("POST", "/api/v1/shared", "[", kJson);
    const Answer opened = recorded("POST", "/api/v1/shared", "{\"secret\": \"" + secret + "\"}", kJson);
    ASSERT_EQ(opened.status, 200) << opened.body;
    const std::string id = member(opened, "id"), place = "/api/v1/shared/" + id,
                      bearer = "Authorization: Bearer " + secret + "\r\n";
    for (const char* part : {"", "/cloth", "/pieces", "/pictures/a.png", "/body", "/report",
                             "/results/front.png", "/results/final.glb", "/results/front.png/small?width=64"})
      EXPECT_EQ(recorded("GET", place + part, "", bearer).status, 200) << part;
    for (const char* part : {"/pictures/b.png", "/results/final.hung", "/results/nothing.png", "/stream"})
      EXPECT_GE(recorded("GET", place + part, "", bearer).status, 400) << part;
    recorded("GET", place);
    keep_stream(place, bearer);
    EXPECT_EQ(recorded("DELETE", "/api/v1/links/" + id).status, 204);
    recorded("DELETE", "/api/v1/links/" + id);
    recorded("GET", place, "", bearer);
  }

  void record_sweeps(const std::string& project) {
    const std::string wish = "{\"project_id\": \"" + project +
                             R"(", "fabrics": ["silk-habotai", {"label": "as it is"}], "tags": ["spring"]})";
    const std::string once = std::string(kJson) + "Idempotency-Key: swept\r\n";
    const Answer made = recorded("POST", "/api/v1/sweeps", wish, once);
    ASSERT_EQ(made.status, 201) << made.body;
    EXPECT_EQ(recorded("POST", "/api/v1/sweeps", wish, once).status, 200);
    recorded("POST", "/api/v1/sweeps", "[", kJson);
    recorded("POST", "/api/v1/sweeps", R"({"project_id": "p_0"})", kJson);
    recorded("POST", "/api/v1/sweeps", "{\"project_id\": \"" + project + R"(", "fabrics": ["felt?"]})",
             kJson);
    const std::string place = "/api/v1/sweeps/" + member(made, "id");
    recorded("GET", place);
    recorded("DELETE", place);
    for (int waited = 0; waited < 1200 && get(place).body.find("\"ended\": true") == std::string::npos;
         ++waited)
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    const Answer ended = recorded("GET", place);
    EXPECT_NE(ended.body.find("\"succeeded\": 2"), std::string::npos) << ended.body;
    recorded("GET", "/api/v1/sweeps?project=" + project);
    recorded("GET", "/api/v1/sweeps?limit=0");
    EXPECT_EQ(recorded("GET", place + "/table.csv").status, 200);
    EXPECT_EQ(recorded("GET", place + "/sheet.png").status, 200);
    recorded("GET", place + "/sheet.png?view=below");
    EXPECT_EQ(recorded("POST", place + "/cancel").status, 200);
    recorded("GET", "/api/v1/jobs?sweep=" + member(made, "id"));
    EXPECT_EQ(recorded("DELETE", place).status, 204);
    for (const char* part : {"", "/table.csv", "/sheet.png"})
      EXPECT_EQ(recorded("GET", place + part).status, 404);
    recorded("POST", place + "/cancel");
    recorded("DELETE", place);
  }

  /// The list of what was asked for, once something of it is made or has failed.
  std::string listed_once_made(const std::string& place) {
    for (int waited = 0; waited < 600; ++waited) {
      const std::string listed = get(place).body;
      if (listed.find("\"made\"") != std::string::npos || listed.find("\"failed\"") != std::string::npos)
        break;
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return recorded("GET", place).body;
  }

  /// Made, or failed where ffmpeg is not installed.
  void record_movies(const std::string& address) {
    const std::string place = address + "/movies";
    const std::string turn = R"({"kind": "turntable", "width": 64, "height": 80, "fps": 2, "seconds": 1})";
    recorded("POST", place, R"({"kind": "walk"})", kJson);
    recorded("POST", place, R"({"width": 65})", kJson);
    EXPECT_EQ(recorded("POST", place, turn, kJson).status, 202);
    const std::string other = R"({"kind": "turntable", "width": 64, "height": 80, "fps": 3, "seconds": 1})";
    recorded("POST", place, other, kJson);
    recorded("DELETE", place + "/turntable-64x80-3-1s.mp4");
    recorded("DELETE", place + "/nothing.mp4");
    const std::string listed = listed_once_made(place);
    if (listed.find("\"made\"") == std::string::npos) {
      EXPECT_NE(listed.find("movie.no_ffmpeg"), std::string::npos) << listed;
      return;
    }
    EXPECT_EQ(recorded("POST", place, turn, kJson).status, 200);
    EXPECT_EQ(recorded("GET", address + "/results/turntable-64x80-2-1s.mp4").status, 200);
  }

  void record_stills(const std::string& address) {
    const std::string place = address + "/stills", near = R"({"eye": [0, 1, 3], "width": 64, "height": 80})";
    for (const char* wrong : {R"({"view": "below"})", R"({"width": 9999})", R"({"map": "warmth"})",
                              R"({"eye": [0, 1]})", R"({"angle": 30})", R"({"eye": [0, 1, 3], "angle": 0})",
                              R"({"eye": [0, 1, 3], "view": "front"})", R"({"transparent": 1})"})
      EXPECT_EQ(recorded("POST", place, wrong, kJson).status, 422) << wrong;
    EXPECT_EQ(recorded("POST", place, near, kJson).status, 202);
    recorded("POST", place, R"({"view": "front", "width": 64, "height": 80})", kJson);
    recorded("DELETE", place + "/still-front-64x80.png");
    recorded("DELETE", place + "/nothing.png");
    const std::string listed = listed_once_made(place);
    EXPECT_NE(listed.find("\"made\""), std::string::npos) << listed;
    EXPECT_EQ(recorded("POST", place, near, kJson).status, 200);
  }

  int check(const std::string& recordings) {
    const std::string root = TOILE_SOURCE_DIR;
    const std::string command =
        "python3 " + root + "/tests/server/http/check_contract.py " + root + "/proto " + recordings + " >&2";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  std::string lines;
  int frames = 0;
};

TEST_F(Contract, EveryAnswerAndMessageFitsItsSchema) {
  recorded("GET", "/healthz");
  recorded("GET", "/readyz");
  recorded("POST", "/api/v1/assets?kind=dxf&name=a.dxf", "no dxf");
  const std::string dxf =
      "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\nA\n90\n4\n70\n1\n10\n0\n20\n0\n10\n9\n20\n0\n10\n9\n20\n9\n"
      "0\n"
      "ENDSEC\n0\nEOF\n";
  recorded("POST", "/api/v1/assets?kind=dxf&name=a.dxf", dxf);
  recorded("POST", "/api/v1/assets?kind=x&name=a.dxf", dxf);
  const std::string pattern = member(recorded("POST", "/api/v1/assets?kind=dxf&name=a.dxf", dxf), "id");
  recorded("POST", "/api/v1/imports", "{\"asset\": \"" + pattern + "\", \"unit\": \"cm\"}", kJson);
  recorded("POST", "/api/v1/imports", "{\"asset\": \"a_0\"}", kJson);
  const std::string told = "{\"asset\": \"" + pattern + R"(", "layers": {"A": "sew"}})";
  EXPECT_EQ(recorded("POST", "/api/v1/imports", told, kJson).status, 200);
  EXPECT_EQ(recorded("GET", "/api/v1/assets/" + pattern + "/layers").status, 200);
  recorded("GET", "/api/v1/assets/a_0/layers");
  const std::string panel =
      R"({"translation": [0, 0, 0], "rotation": [0, 0, 0], "vertices": [[0, 0], [9, 0], [9, 9]], "edges":
          [{"endpoints": [0, 1]}, {"endpoints": [1, 2]}, {"endpoints": [2, 0]}]})";
  const std::string specification = "{\"pattern\": {\"panels\": {\"a\": " + panel + "}}}";
  const Answer kept = recorded("POST", "/api/v1/assets?kind=specification&name=a.json", specification);
  EXPECT_EQ(kept.status, 201) << kept.body;
  const std::string given = "{\"asset\": \"" + member(kept, "id") + "\"}";
  EXPECT_EQ(recorded("POST", "/api/v1/imports", given, kJson).status, 200);
  const std::string asset = member(recorded("POST", "/api/v1/bodies?name=post.obj", kPost), "id");
  recorded("GET", "/api/v1/jobs?state=asleep");
  recorded("PUT", "/api/v1/jobs/j_0/tags", R"({"tags": ["spring"]})", kJson);
  EXPECT_EQ(recorded("GET", "/api/v1/events").status, 200);
  recorded("GET", "/api/v1/events?after=x");
  const std::string hook = R"({"url": "https://example.org/told"})";
  EXPECT_EQ(recorded("POST", "/api/v1/webhooks", hook, kJson).status, 201);
  recorded("POST", "/api/v1/webhooks", "{}", kJson);
  const auto hooks = json::parse_json(recorded("GET", "/api/v1/webhooks").body);
  const std::string hook_place =
      "/api/v1/webhooks/" + *hooks->find("webhooks")->array()->front().find("id")->text();
  EXPECT_EQ(recorded("POST", hook_place + "/ping").status, 202);
  EXPECT_EQ(recorded("GET", hook_place + "/deliveries").status, 200);
  EXPECT_EQ(recorded("DELETE", hook_place).status, 204);
  recorded("DELETE", hook_place);
  recorded("GET", "/api/v1/assets");
  recorded("GET", "/api/v1/bodies");
  recorded("GET", "/api/v1/assets/" + asset);
  recorded("GET", "/api/v1/assets/" + asset + "/content");
  recorded("GET", "/api/v1/assets/a_0");
  const std::string picture = png_of(squares());
  const std::string image =
      member(recorded("POST", "/api/v1/assets?kind=image&name=checks.png", picture), "id");
  recorded("GET", "/api/v1/assets/" + image);
  recorded("GET", "/api/v1/assets/" + image + "/content");
  recorded("POST", "/api/v1/assets?kind=image&name=cut.png", picture.substr(0, 60));
  record_bodies(asset);
  record_arrangement(asset);

  const std::string request = napkin_request(asset);
  const std::string once = std::string(kJson) + "Idempotency-Key: once\r\n";
  const std::string project = member(recorded("POST", "/api/v1/projects", request, once), "id");
  ASSERT_FALSE(project.empty());
  EXPECT_EQ(recorded("POST", "/api/v1/projects", request, once).status, 200);
  const std::string one = "/api/v1/projects/" + project;
  recorded("POST", "/api/v1/projects", "[", kJson);
  recorded("GET", "/api/v1/projects?limit=1");
  recorded("GET", "/api/v1/projects?limit=0");
  recorded("GET", one);
  recorded("GET", one + "/pieces");
  recorded("GET", one + "/proposals");
  recorded("PUT", one, request, kJson);
  recorded("PUT", one, request, std::string(kJson) + "If-Match: \"9\"\r\n");
  recorded("PUT", one, request, std::string(kJson) + "If-Match: \"1\"\r\n");
  record_edits(one);
  const std::string any = std::string(kJson) + "If-Match: *\r\n";
  EXPECT_EQ(recorded("POST", one + "/redo", "", any).status, 200) << "it is draped with its picture";

  const std::string submission = "{\"project_id\": \"" + project + "\"}";
  const std::string job = member(recorded("POST", "/api/v1/jobs", submission, once), "id");
  ASSERT_FALSE(job.empty());
  EXPECT_EQ(recorded("POST", "/api/v1/jobs", submission, once).status, 200);
  const std::string address = "/api/v1/jobs/" + job;
  recorded("GET", address);
  recorded("GET", "/api/v1/jobs");
  keep_stream(address);
  EXPECT_GE(frames, 2);
  const Answer done = recorded("GET", address);
  EXPECT_EQ(member(done, "state"), "succeeded") << done.body;
  recorded("GET", address + "/results");
  recorded("GET", address + "/results/report.json");
  recorded("GET", address + "/results/nothing");
  recorded("GET", address + "/results/front.png/small?width=64");
  recorded("GET", address + "/results/report.json/small");
  record_links(address);
  record_movies(address);
  record_stills(address);
  record_sweeps(project);
  EXPECT_EQ(recorded("PUT", address + "/tags", R"({"tags": ["spring"]})", kJson).status, 200);
  recorded("GET", address + "/report");
  recorded("GET", address + "/log");
  recorded("GET", address + "/pieces");
  recorded("GET", address + "/body");
  recorded("GET", address + "/stream");
  recorded("POST", address + "/pause");
  recorded("POST", address + "/resume");
  recorded("POST", address + "/cancel");
  recorded("GET", "/api/v1/jobs");

  const std::string held = member(recorded("POST", "/api/v1/jobs", submission, kJson), "id");
  recorded("POST", "/api/v1/jobs/" + held + "/pause");
  recorded("POST", "/api/v1/jobs/" + held + "/resume");
  recorded("POST", "/api/v1/jobs/" + held + "/pause");
  recorded("POST", "/api/v1/jobs/" + held + "/step");
  const std::string edited = member(recorded("POST", "/api/v1/jobs/" + held + "/go_on"), "id");
  recorded("POST", "/api/v1/jobs/" + edited + "/cancel");
  recorded("POST", "/api/v1/jobs/" + held + "/retry");
  recorded("POST", "/api/v1/jobs/" + held + "/cancel");
  const std::string again = member(recorded("POST", address + "/retry"), "id");
  recorded("POST", "/api/v1/jobs/" + again + "/cancel");
  recorded("GET", "/metrics");
  recorded("DELETE", address);
  recorded("DELETE", address);
  recorded("DELETE", "/api/v1/assets/" + asset);
  const std::string spare = member(upload("body", "spare.obj", kPost), "id");
  recorded("DELETE", "/api/v1/assets/" + spare);
  recorded("DELETE", one, "", "If-Match: \"9\"\r\n");
  recorded("DELETE", one);
  recorded("DELETE", one);

  recorded("GET", "/api/v1/session");
  recorded("POST", "/api/v1/session", R"({"name": "a", "password": "b"})", kJson);
  recorded("DELETE", "/api/v1/session");
  recorded("GET", "/api/v1/admin/accounts");
  recorded("GET", "/api/v1/admin/jobs");
  recorded("GET", "/api/v1/admin/load");
  recorded("POST", "/api/v1/admin/accounts/u_0/lock");
  record_accounts();

  const std::string path = (folder / "recordings.jsonl").string();
  std::ofstream(path) << lines;
  EXPECT_EQ(check(path), 0);
}

}  // namespace
}  // namespace toile::test
