// What strangers upload: each is refused with a code and a place, soon, and the server goes on.

#include <chrono>
#include <string>
#include <thread>

#include "tests/app/junk.h"
#include "tests/server/http/served.h"

namespace toile::test {
namespace {

class BadUploads : public Served {
 protected:
  void SetUp() override { serve(); }
  void TearDown() override {
    EXPECT_EQ(get("/healthz").status, 200);
    Served::TearDown();
  }

  void expect_refused(const Answer& answer, const std::string& code, const std::string& where) {
    EXPECT_GE(answer.status, 400) << answer.body.substr(0, 500);
    EXPECT_LT(answer.status, 500) << answer.body.substr(0, 500);
    EXPECT_PROBLEM(answer, answer.status, code);
    EXPECT_NE(member(answer, "where").find(where), std::string::npos) << answer.body.substr(0, 500);
  }
  void expect_bad_file(const std::string& kind, const std::string& name, const std::string& bytes,
                       const std::string& code) {
    expect_refused(upload(kind, name, bytes), code, "");
  }
  void expect_bad_napkin(const std::string& from, const std::string& to, const std::string& code,
                         const std::string& where) {
    expect_refused(send_json("POST", "/api/v1/projects", napkin_request(post_asset(), from, to)), code,
                   where);
  }
};

TEST_F(BadUploads, TheFixturesThemselvesAreGood) {
  EXPECT_EQ(upload("dxf", "cut.dxf", square_dxf()).status, 201);
  EXPECT_EQ(send_json("POST", "/api/v1/projects", napkin_request(post_asset())).status, 201);
}

TEST_F(BadUploads, DxfFilesThatAreNone) {
  expect_bad_file("dxf", "cut.dxf", "Dear Sir or Madam,\nplease find attached my best regards.\n", "dxf.");
  expect_bad_file("dxf", "cut.dxf", "", "dxf.empty");
  expect_bad_file("dxf", "cut.dxf", square_dxf("10\n0\n20\n0\n10\n100\n20\n0\n10\n100\n20\n100\n", "0"),
                  "dxf.open_outline");
  expect_bad_file("dxf", "cut.dxf", square_dxf("10\n0\n20\n0\n10\n200\n20\n0\n10\n100\n20\n0\n"), "dxf.");
  expect_bad_file("dxf", "cut.dxf",
                  square_dxf("10\n0\n20\n0\n10\n100\n20\n100\n10\n150\n20\n0\n10\n0\n20\n100\n"),
                  "dxf.self_crossing");
  expect_bad_file("dxf", "cut.dxf", square_dxf("10\nnan\n20\ninf\n10\n1e300\n20\n0\n10\n9\n20\n9\n"), "dxf.");
}

TEST_F(BadUploads, DxfFilesCutOffBeforeTheirOutlineEnds) {
  const std::string whole = square_dxf(), outline = whole.substr(0, whole.find("0\nTEXT"));
  for (std::size_t length = 0; length < outline.size(); length += 5)
    expect_bad_file("dxf", "cut.dxf", whole.substr(0, length), "dxf.");
  for (std::size_t length = outline.size(); length < whole.size(); length += 5)
    EXPECT_EQ(upload("dxf", "cut.dxf", whole.substr(0, length)).status, 201)
        << "its piece is whole: " << length;
}

TEST_F(BadUploads, BodiesThatAreNone) {
  expect_bad_file("body", "a.obj", "", "mesh.empty");
  expect_bad_file("body", "a.obj", "v nan nan nan\nv nan 1 0\nv 0 nan 1\nf 1 2 3\n", "mesh.");
  std::string infinite = kPost;
  expect_bad_file("body", "a.obj", infinite.replace(infinite.find("0.5"), 3, "inf"), "mesh.");
  expect_bad_file("body", "a.obj", std::string(kPost).substr(0, 60), "mesh.");
  expect_bad_file("body", "a.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", "mesh.");
  expect_bad_file("body", "a.glb", "glTF\x02", "mesh.");
  expect_bad_file("body", "a.exe", kPost, "");
}

TEST_F(BadUploads, FiftyMegabytesOfAnything) {
  expect_bad_file("dxf", "a.dxf", repeated("x", kFiftyMegabytes), "dxf.");
  expect_bad_file("dxf", "a.dxf", repeated(std::string(1, '\0'), kFiftyMegabytes), "dxf.");
  expect_bad_file("dxf", "a.dxf", repeated("0\nLINE\n", kFiftyMegabytes), "dxf.");
  expect_bad_file("body", "a.obj", repeated("x", kFiftyMegabytes), "");
  expect_bad_file("body", "a.obj", repeated(std::string(1, '\0'), kFiftyMegabytes), "");
  const std::string json = "Content-Type: application/json\r\n";
  for (const char* filling : {" ", "[", "{\"a\":", "1,", "x"}) {
    expect_refused(ask(port, "POST", "/api/v1/projects", repeated(filling, kFiftyMegabytes), json),
                   "http.too_large", "");
  }
}

TEST_F(BadUploads, JsonNestedTenThousandDeep) {
  for (const char* level : {"[", "{\"a\":"}) {
    expect_bad_napkin("\"toile\": 1",
                      "\"toile\": 1, \"x\": " + repeated(level, 10000 * std::string(level).size()),
                      "json.too_deep", "/document/x");
    expect_refused(send_json("POST", "/api/v1/jobs", repeated(level, 100'000)), "json.too_deep", "");
  }
}

TEST_F(BadUploads, FourMegabytesOfNearlyADocument) {
  constexpr std::size_t kJustAllowed = (std::size_t{4} << 20) - 4000;
  std::string unknown = "\"toile\": 1, \"x\": [", points = "[";
  unknown += repeated("[],", kJustAllowed);
  points += repeated("[300, 300], ", kJustAllowed);
  expect_bad_napkin("\"toile\": 1", unknown + "[]]", "", "");
  expect_bad_napkin("[[300, 300], [0, 300]]", points + "[0, 300]]", "", "");
}

TEST_F(BadUploads, DocumentsWithAFault) {
  expect_bad_napkin("[[0, 300], [0, 0]]", "[[0, 300], [0, 7]]", "pattern.open_outline",
                    "/document/pieces/0/outline");
  expect_bad_napkin("[[300, 300], [0, 300]]", "[[300, 300], [150, -100], [0, 300]]", "pattern.self_crossing",
                    "/document/pieces/0");
  expect_bad_napkin("\"seams\": []", R"("seams": [{"id": "s", "a": [{"piece": "napkin", "edge": "east"}],
                    "b": [{"piece": "sleeve", "edge": "west"}]}])",
                    "project.unknown_piece", "/document/seams/0/b/0/piece");
  expect_bad_napkin("\"seams\": []", R"("seams": [{"id": "s", "a": [{"piece": "napkin", "edge": "east"}],
                    "b": [{"piece": "napkin", "edge": "wset"}]}])",
                    "project.unknown_edge", "/document/seams/0/b/0/edge");
  expect_bad_napkin("post.obj", "pots.obj", "documents.missing_file", "/document/bodies/0/file");
  expect_bad_napkin("post.obj", "../../../etc/passwd", "", "/document/bodies/0/file");
  expect_bad_napkin("\"seams\"", "\"saems\"", "project.unknown_key", "/document/saems");
  expect_bad_napkin("\"particle_distance_mm\": 25", "\"particle_distance_mm\": 1e300", "project.out_of_range",
                    "/document/settings/particle_distance_mm");
}

TEST_F(BadUploads, ANapkinOfAMillionParticlesIsRefusedAtTheLatestWhenItIsSubmitted) {
  jobs->stop();
  auto real = make_job_service(*documents, hub, {});
  std::string text =
      napkin_request(post_asset(), "\"particle_distance_mm\": 25", "\"particle_distance_mm\": 0.5");
  for (std::size_t at = text.find("300"); at != std::string::npos; at = text.find("300", at + 5)) {
    text.replace(at, 3, "90000");
  }
  const Answer made = send_json("POST", "/api/v1/projects", text);
  if (made.status != 201) return expect_refused(made, "mesh.", "");
  const auto job = real->submit(kMe, member(made, "id"), "");
  if (!job) return;
  ASSERT_TRUE(real->start());
  for (int i = 0; i < 2400; ++i) {
    const Result<JobRow> now = store->job(kMe, job->id);
    if (now && now->state == JobState::kFailed) {
      EXPECT_EQ(now->reason_code, "mesh.too_many_particles");
      real->stop();
      return;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  ADD_FAILURE() << "neither refused nor failed";
  real->stop();
}

}  // namespace
}  // namespace toile::test
