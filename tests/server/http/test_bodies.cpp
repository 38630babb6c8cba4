// Bodies and arrangement over HTTP: figures, dressing, places, the look at a start, and undo of all of it.

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "core/body/mesh_import/formats.h"
#include "tests/server/http/dressed.h"
#include "tests/server/http/served.h"

namespace toile::test {
namespace {

class Dressing : public Served {
 protected:
  void SetUp() override {
    serve();
    make_project("sewn");
  }
  void make_project(const std::string& start) {
    const Answer made = send_json("POST", "/api/v1/projects", dressed_pair(post_asset(), start));
    ASSERT_EQ(made.status, 201) << made.body;
    id = member(made, "id");
    one = "/api/v1/projects/" + id;
  }
  Answer change(const std::string& method, const std::string& what, const std::string& body = "",
                const std::string& match = "*") {
    return send_json(method, one + what, body, match.empty() ? "" : "If-Match: " + match + "\r\n");
  }
  std::string document() { return store->project(kMe, id)->document; }
  json::JsonValue tree_of(const Answer& answer) {
    EXPECT_EQ(answer.status, 200) << answer.body.substr(0, 500);
    const Result<json::JsonValue> tree =
        json::parse_json(answer.body, {.bytes = answer.body.size(), .depth = 64});
    return tree ? *tree : json::JsonValue();
  }
  static double measure(const json::JsonValue& figure, const std::string& name) {
    for (const json::JsonValue& one_of : *figure.find("measures")->array())
      if (*one_of.find("name")->text() == name) return *one_of.find("cm")->number();
    return NAN;
  }
  json::JsonValue first_body() { return (*tree_of(get(one + "/bodies")).find("bodies")->array())[0]; }
  std::string id, one;
};

TEST_F(Dressing, MeasuresTheBodiesOfAProject) {
  const json::JsonValue body = first_body();
  EXPECT_EQ(*body.find("id")->text(), "anna");
  EXPECT_TRUE(*body.find("stands")->boolean());
  EXPECT_NEAR(measure(body, "height"), 170, 0.5);
  EXPECT_NEAR(measure(body, "waist"), 72, 0.5);
  EXPECT_EQ(body.find("boxes")->array()->size(), 8u);
  EXPECT_GE(body.find("landmarks")->array()->size(), 30u);
}

TEST_F(Dressing, ChangesAndUndoesTheMannequin) {
  const std::string first = document();
  const Answer dressed = change("PUT", "/bodies/anna",
                                R"({"mannequin": {"preset": "m50", "waist_cm": 92, "triangles": 1000},
                                    "skin_offset_mm": 3})",
                                "\"1\"");
  ASSERT_EQ(dressed.status, 200) << dressed.body;
  EXPECT_EQ(dressed.headers.at("etag"), "\"2\"");
  const json::JsonValue body = first_body();
  EXPECT_NEAR(measure(body, "waist"), 92, 0.5);
  EXPECT_EQ(*body.find("skin_offset_mm")->number(), 3);
  EXPECT_EQ(*body.find("mannequin")->find("preset")->text(), "m50");
  ASSERT_EQ(
      change("PUT", "/bodies/anna", R"({"mannequin": {"preset": "m50", "waist_cm": 90, "triangles": 1000}})")
          .status,
      200);
  EXPECT_EQ(*first_body().find("skin_offset_mm")->number(), 3) << "what is not said stays";
  ASSERT_EQ(change("POST", "/undo").status, 200);
  ASSERT_EQ(change("POST", "/undo").status, 200);
  EXPECT_EQ(document(), first);
  ASSERT_EQ(change("POST", "/redo").status, 200);
  EXPECT_NEAR(measure(first_body(), "waist"), 92, 0.5);
}

TEST_F(Dressing, PutsAnUploadedFigureOnItsFeet) {
  const Answer made = send_json("POST", "/api/v1/bodies/mannequins",
                                R"({"mannequin": {"sex": "male", "height_cm": 180, "triangles": 1000}})");
  ASSERT_EQ(made.status, 201) << made.body;
  const Result<std::string> obj =
      store->asset_bytes(kMe, *json::parse_json(made.body, {.depth = 64})->find("asset")->find("id")->text());
  std::string lying;  // centimetres, z up, facing the other way
  for (std::size_t at = 0; at < obj->size();) {
    const std::size_t end = obj->find('\n', at);
    double x = 0, y = 0, z = 0;
    const std::string line = obj->substr(at, end - at);
    if (std::sscanf(line.c_str(), "v %lf %lf %lf", &x, &y, &z) == 3) {
      lying += "v " + std::to_string(-100 * x) + " " + std::to_string(100 * z) + " " +
               std::to_string(100 * y + 30) + "\n";
    } else {
      lying += line + "\n";
    }
    at = end + 1;
  }
  const std::string asset = member(upload("body", "scan.obj", lying), "id");
  const json::JsonValue figure = tree_of(get("/api/v1/bodies/" + asset + "/figure"));
  EXPECT_EQ(*figure.find("stance")->find("unit_in_m")->number(), 0.01);
  EXPECT_EQ(*figure.find("stance")->find("up")->text(), "z");
  const Answer dressed = change("PUT", "/bodies/anna", "{\"asset\": \"" + asset + "\"}");
  ASSERT_EQ(dressed.status, 200) << dressed.body;
  const json::JsonValue body = first_body();
  EXPECT_TRUE(*body.find("stands")->boolean()) << dressed.body;
  EXPECT_NEAR(measure(body, "height"), 180, 0.5);
  EXPECT_NEAR(*(*body.find("low")->array())[1].number(), 0, 1e-4);
  for (const char* name : {"bust", "waist", "hip", "inseam"})
    EXPECT_NEAR(measure(body, name), measure(figure, name), 0.1) << name;
  EXPECT_EQ(change("POST", "/undo").status, 200);
  EXPECT_EQ(change("POST", "/redo").status, 200) << "its file is still the project's";
}

TEST_F(Dressing, TakesAnObjectThatIsNoPerson) {
  const Answer dressed = change("PUT", "/bodies/post", "{\"asset\": \"" + post_asset() + "\"}");
  ASSERT_EQ(dressed.status, 200) << dressed.body;
  const json::JsonValue all = tree_of(get(one + "/bodies"));
  ASSERT_EQ(all.find("bodies")->array()->size(), 2u);
  EXPECT_FALSE(*(*all.find("bodies")->array())[1].find("stands")->boolean());
  EXPECT_EQ(change("DELETE", "/bodies/post").status, 200);
  EXPECT_EQ(tree_of(get(one + "/bodies")).find("bodies")->array()->size(), 1u);
  EXPECT_EQ(change("POST", "/undo").status, 200);
  EXPECT_EQ(tree_of(get(one + "/bodies")).find("bodies")->array()->size(), 2u);
  EXPECT_PROBLEM(change("DELETE", "/bodies/nobody"), 422, "edit.unknown_body");
}

TEST_F(Dressing, IsRefusedWithTheMeasureAtFault) {
  const Answer thin = change("PUT", "/bodies/anna", R"({"mannequin": {"sex": "female", "waist_cm": 31}})");
  EXPECT_PROBLEM(thin, 422, "mannequin.setting");
  EXPECT_EQ(member(thin, "where"), "/mannequin: waist");
  EXPECT_PROBLEM(change("PUT", "/bodies/anna", R"({"mannequin": {"preset": "eu39"}})"), 422,
                 "project.unknown_preset");
  EXPECT_PROBLEM(change("PUT", "/bodies/anna", R"({"mannequin": {"wiast_cm": 70}})"), 422,
                 "project.unknown_key");
  EXPECT_PROBLEM(change("PUT", "/bodies/anna", "{}"), 422, "request.body");
  EXPECT_PROBLEM(change("PUT", "/bodies/anna", "[]"), 422, "request.body");
  EXPECT_PROBLEM(change("PUT", "/bodies/anna", R"({"asset": "a_0"})"), 404, "store.not_found");
  EXPECT_PROBLEM(change("PUT", "/bodies/anna", R"({"asset": "a_0", "size": 3})"), 422, "request.unknown_key");
  EXPECT_PROBLEM(change("PUT", "/bodies/anna", R"({"mannequin": {}})", ""), 428, "request.if_match");
  EXPECT_PROBLEM(change("PUT", "/bodies/anna", R"({"mannequin": {}})", "\"7\""), 412, "store.conflict");
}

TEST_F(Dressing, ArrangesAllPiecesAsOneStepThatCanBeUndone) {
  const std::string first = document();
  const json::JsonValue before = tree_of(get(one + "/check"));
  EXPECT_FALSE(*before.find("ready")->boolean()) << "four pieces lie on one another";
  const json::JsonValue& worst = before.find("findings")->array()->front();
  const json::JsonValue& first_concern = worst.find("about")->array()->front();
  EXPECT_EQ(*first_concern.find("thing")->text(), "piece");
  EXPECT_TRUE(worst.find("where")->text()->starts_with("piece " + *first_concern.find("id")->text()))
      << json::write_json(worst);
  const Answer arranged = change("POST", "/arrange", "", "\"1\"");
  const json::JsonValue tree = tree_of(arranged);
  EXPECT_EQ(arranged.headers.at("etag"), "\"2\"");
  EXPECT_EQ(tree.find("arrangement")->find("pieces")->array()->size(), 4u);
  const json::JsonValue after = tree_of(get(one + "/check"));
  EXPECT_TRUE(*after.find("ready")->boolean()) << json::write_json(after);
  ASSERT_EQ(change("POST", "/undo").status, 200);
  EXPECT_EQ(document(), first);
  EXPECT_PROBLEM(change("POST", "/arrange", "", ""), 428, "request.if_match");
}

TEST_F(Dressing, IsReadyWithPiecesThatLieOnOneAnotherWhereTheDrapeMayArrangeThem) {
  make_project("auto");
  const json::JsonValue check = tree_of(get(one + "/check"));
  EXPECT_TRUE(*check.find("ready")->boolean());
  for (const json::JsonValue& finding : *check.find("findings")->array())
    EXPECT_NE(*finding.find("severity")->text(), "error") << json::write_json(finding);
}

TEST_F(Dressing, PlacesAPieceOnASideOfABox) {
  const Answer placed =
      change("POST", "/place", R"({"piece": "front", "part": "hips", "side": "front", "away_mm": 80})");
  ASSERT_EQ(placed.status, 200) << placed.body;
  const json::JsonValue check = tree_of(get(one + "/check"));
  const json::JsonValue body = first_body();
  const auto number = [](const json::JsonValue& list, std::size_t k) { return *(*list.array())[k].number(); };
  const json::JsonValue& hips = (*body.find("boxes")->array())[3];
  ASSERT_EQ(*hips.find("part")->text(), "hips");
  const json::JsonValue& front = (*check.find("pieces")->array())[0];
  const double z = number(*front.find("low"), 2);
  EXPECT_NEAR(z, number(*hips.find("centre"), 2) + number(*hips.find("half"), 2) + 0.08, 0.02)
      << json::write_json(check);
  EXPECT_EQ(*front.find("by_hand")->find("part")->text(), "hips");
  EXPECT_NEAR(*front.find("by_hand")->find("away_mm")->number(), 80, 1e-6);
  EXPECT_EQ(get(one + "/pieces").status, 200) << "the flat pieces need no body";
  EXPECT_EQ(change("POST", "/edits", R"({"edits": [{"edit": "mirror_piece", "piece": "front"}]})").status,
            200);
  EXPECT_PROBLEM(change("POST", "/place", R"({"piece": "sleeve"})"), 422, "edit.unknown_piece");
  EXPECT_PROBLEM(change("POST", "/place", R"({"piece": "front", "part": "tail"})"), 422, "request.place");
  EXPECT_PROBLEM(change("POST", "/place", R"({"piece": "front", "away_mm": 1e9})"), 422, "request.place");
  EXPECT_PROBLEM(change("POST", "/place", R"({"side": "front"})"), 422, "request.place");
  EXPECT_PROBLEM(change("POST", "/place", R"({"piece": "front", "with_partner": 1})"), 422, "request.place");
}

TEST_F(Dressing, TellsWhereAPieceStandsInWordsThatPlaceItThereAgain) {
  const auto pieces = [&] { return *tree_of(get(one + "/check")).find("pieces")->array(); };
  const auto low = [](const json::JsonValue& piece, std::size_t k) {
    return *(*piece.find("low")->array())[k].number();
  };
  ASSERT_EQ(change("POST", "/arrange").status, 200);
  const std::vector<json::JsonValue> before = pieces();
  for (const json::JsonValue& piece : before) {
    ASSERT_FALSE(piece.find("by_hand")->object());
    ASSERT_TRUE(piece.find("stands")->object()) << json::write_json(piece);
    json::JsonValue wish = *piece.find("stands");
    std::get<std::vector<json::JsonMember>>(wish.data).push_back({"piece", *piece.find("id")});
    ASSERT_EQ(change("POST", "/place", json::write_json(wish)).status, 200);
  }
  const std::vector<json::JsonValue> after = pieces();
  for (std::size_t p = 0; p < before.size(); ++p) {
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(low(after[p], k), low(before[p], k), 0.03) << json::write_json(before[p]);
  }
}

TEST_F(Dressing, TurnsAPieceOver) {
  ASSERT_EQ(change("POST", "/place", R"({"piece": "front", "flipped": true})").status, 200);
  const json::JsonValue check = tree_of(get(one + "/check"));
  EXPECT_TRUE(*(*check.find("pieces")->array())[0].find("by_hand")->find("flipped")->boolean());
  EXPECT_NE(document().find("\"flipped\": true"), std::string::npos) << document();
  EXPECT_PROBLEM(change("POST", "/place", R"({"piece": "front", "flipped": 1})"), 422, "request.place");
}

TEST_F(Dressing, KeepsLandmarksThatArePutElsewhereAndTheyGrowWithTheBody) {
  const auto mark = [&](const std::string& name) -> std::optional<Vec3> {
    const json::JsonValue body = first_body();
    for (const json::JsonValue& landmark : *body.find("landmarks")->array()) {
      const auto& at = *landmark.find("place")->array();
      if (*landmark.find("name")->text() == name)
        return Vec3{*at[0].number(), *at[1].number(), *at[2].number()};
    }
    return std::nullopt;
  };
  const auto text = [](Vec3 p) {
    return "{\"place\": [" + std::to_string(p.x) + ", " + std::to_string(p.y) + ", " + std::to_string(p.z) +
           "]}";
  };
  ASSERT_EQ(change("PUT", "/bodies/anna", R"({"mannequin": {"preset": "eu38", "triangles": 2000}})").status,
            200);
  const std::string first = document();
  const Vec3 front = *mark("waist_front");
  const Vec3 wish = front + Vec3{0.05, 0.03, 0};
  const Answer moved = change("PUT", "/bodies/anna/landmarks/waist_front", text(wish));
  ASSERT_EQ(moved.status, 200) << moved.body;
  EXPECT_LT(length(*mark("waist_front") - wish), 0.03);
  EXPECT_GT(length(*mark("waist_front") - front), 0.03);
  ASSERT_EQ(change("PUT", "/bodies/anna/landmarks/navel", text(front - Vec3{0, 0.04, 0})).status, 200);
  const double below = front.y - mark("navel")->y;
  EXPECT_NEAR(below, 0.04, 0.02);
  ASSERT_EQ(change("PUT", "/bodies/anna",
                   R"({"mannequin": {"preset": "eu38", "height_cm": 185, "triangles": 2000}})")
                .status,
            200);
  ASSERT_TRUE(mark("navel"));
  EXPECT_NE(document().find("\"body_height_mm\""), std::string::npos);
  ASSERT_EQ(change("POST", "/undo").status, 200);
  ASSERT_EQ(change("DELETE", "/bodies/anna/landmarks/waist_front").status, 200);
  EXPECT_LT(length(*mark("waist_front") - front), 1e-6);
  ASSERT_EQ(change("DELETE", "/bodies/anna/landmarks/navel").status, 200);
  EXPECT_FALSE(mark("navel"));
  EXPECT_EQ(document(), first);
  EXPECT_PROBLEM(change("DELETE", "/bodies/anna/landmarks/navel"), 422, "edit.unknown_landmark");
  EXPECT_PROBLEM(change("PUT", "/bodies/bob/landmarks/navel", text(front)), 422, "edit.unknown_body");
  EXPECT_PROBLEM(change("PUT", "/bodies/anna/landmarks/navel", R"({"place": [1, 2]})"), 422,
                 "request.landmark");
  EXPECT_PROBLEM(change("PUT", "/bodies/anna/landmarks/navel", R"({"place": [1e9, 2, 0]})"), 422,
                 "request.landmark");
}

TEST_F(Dressing, PlacesTheMirrorImageOnTheOtherSideWhenAsked) {
  // Two pieces alike but mirrored, which nothing sews to each other all around.
  const std::string copies = R"({"edits": [{"edit": "duplicate_piece", "piece": "front", "id": "left_sleeve"},
      {"edit": "duplicate_piece", "piece": "front", "id": "right_sleeve", "mirrored": true}]})";
  const Answer copied = change("POST", "/edits", copies);
  ASSERT_EQ(copied.status, 200) << copied.body;
  const Answer placed =
      change("POST", "/place", R"({"piece": "left_sleeve", "part": "left_arm", "side": "left",
      "at_mm": [12, -30], "away_mm": 80, "turn": 20, "with_partner": true})");
  ASSERT_EQ(placed.status, 200) << placed.body;
  const json::JsonValue check = tree_of(get(one + "/check"));
  int seen = 0;
  for (const json::JsonValue& piece : *check.find("pieces")->array()) {
    if (*piece.find("id")->text() != "right_sleeve") continue;
    const json::JsonValue& hand = *piece.find("by_hand");
    ASSERT_TRUE(hand.object()) << json::write_json(check);
    EXPECT_EQ(*hand.find("part")->text(), "right_arm");
    EXPECT_EQ(*hand.find("side")->text(), "right");
    EXPECT_NEAR(*(*hand.find("at_mm")->array())[0].number(), -12, 1e-6);
    EXPECT_NEAR(*(*hand.find("at_mm")->array())[1].number(), -30, 1e-6);
    ++seen;
  }
  EXPECT_EQ(seen, 1);
}

TEST_F(Dressing, ShowsTheStartAsTheStreamWould) {
  ASSERT_EQ(change("POST", "/arrange").status, 200);
  const Answer start = get(one + "/start");
  ASSERT_EQ(start.status, 200) << start.body;
  std::uint32_t size = 0;
  ASSERT_GT(start.body.size(), 8u);
  std::memcpy(&size, start.body.data(), 4);
  ASSERT_LT(size, start.body.size());
  EXPECT_EQ(start.body.substr(4, 2), "TL");
  EXPECT_EQ((start.body.size() - 4 - size) % 12, 0u);
  EXPECT_PROBLEM(get("/api/v1/projects/p_0/start"), 404, "store.not_found");
  EXPECT_PROBLEM(get("/api/v1/projects/p_0/check"), 404, "store.not_found");
  EXPECT_PROBLEM(get("/api/v1/projects/p_0/bodies"), 404, "store.not_found");
  EXPECT_PROBLEM(get("/api/v1/projects/p_0/body"), 404, "store.not_found");
}

TEST_F(Dressing, ListsPresetsWithAllTheirMeasures) {
  const json::JsonValue tree = tree_of(get("/api/v1/bodies/presets"));
  EXPECT_EQ(tree.find("measures")->array()->size(), 14u);
  for (const json::JsonValue& preset : *tree.find("presets")->array())
    EXPECT_EQ(preset.find("measures_cm")->object()->size(), 14u) << json::write_json(preset);
}

TEST_F(Dressing, TellsThePageEveryFormatOfMeshFiles) {
  const json::JsonValue tree = tree_of(get("/api/v1/bodies/presets"));
  std::vector<std::string> told, known;
  for (const json::JsonValue& format : *tree.find("formats")->array())
    told.push_back(*format.find("ending")->text());
  for (const mesh_import::MeshFormat& format : mesh_import::mesh_formats()) known.emplace_back(format.ending);
  EXPECT_EQ(told, known);
}

}  // namespace
}  // namespace toile::test
