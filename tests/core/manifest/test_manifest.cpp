#include <gtest/gtest.h>

#include <string>

#include "core/manifest/manifest.h"
#include "tests/proto/schemas/kept_schema.h"

namespace toile::manifest {
namespace {

Manifest skirt() {
  Manifest m;
  m.made_by = this_program("00112233445566778899aabbccddeeff");
  m.project_path = "../skirt/project.json";
  m.document = mark_of("project.json", std::string_view("{}"));
  m.inputs = {mark_of("body.obj", std::string_view("v 0 0 0\n"))};
  m.settings.particle_distance_mm = 12;
  m.positions = "ffeeddccbbaa99887766554433221100";
  m.steps = 4711;
  m.results = {mark_of("final.obj", std::string_view("v 1 2 3\n"))};
  return m;
}

TEST(Manifest, ReadsBackAsItWasWritten) {
  const Manifest then = skirt();
  const Result<Manifest> read = parse_manifest(write_manifest(then));
  ASSERT_TRUE(read) << read.error().message << read.error().where;
  EXPECT_EQ(read->made_by, then.made_by);
  EXPECT_EQ(read->project_path, then.project_path);
  EXPECT_EQ(read->document, then.document);
  EXPECT_EQ(read->inputs, then.inputs);
  EXPECT_EQ(read->settings, then.settings);
  EXPECT_EQ(read->positions, then.positions);
  EXPECT_EQ(read->steps, then.steps);
  EXPECT_EQ(read->results, then.results);
  EXPECT_EQ(write_manifest(*read), write_manifest(then));
}

TEST(Manifest, TellsTheProgramThatDraped) {
  const Maker maker = this_program("00");
  EXPECT_NE(maker.version.find('.'), std::string::npos);
  EXPECT_GT(maker.engine, 0);
}

TEST(Manifest, SaysWhereItIsDamaged) {
  const std::string text = write_manifest(skirt());
  for (const char* key : {"\"steps\"", "\"hash\"", "\"toile_manifest\": 1"}) {
    std::string broken = text;
    broken.replace(broken.find(key), std::string(key).size(), "\"other\": 1, \"stray\"");
    const Result<Manifest> read = parse_manifest(broken);
    ASSERT_FALSE(read) << key;
    EXPECT_EQ(read.error().code, "manifest.damaged");
  }
  EXPECT_EQ(parse_manifest(text.substr(0, text.size() / 2)).error().code, "manifest.damaged");
  EXPECT_EQ(parse_manifest("").error().code, "manifest.damaged");
}

TEST(Manifest, ADocumentIsTheSameWhateverItsBlanks) {
  const std::string square = R"([{"id":"s","points":[[0,0],[9,0]]},{"id":"e","points":[[9,0],[9,9]]},)"
                             R"({"id":"n","points":[[9,9],[0,0]]}])";
  const std::string tight =
      R"({"toile":1,"pieces":[{"id":"p","fabric":"poplin","placement":{"rigid":{"translation":[0,1,0]}},"outline":)" +
      square + "}]}";
  const std::string wide =
      R"({ "pieces": [ {"outline": )" + square +
      R"(, "placement": {"rigid": {"translation": [0, 1, 0]}}, "fabric": "poplin", "id": "p"} ],  "toile": 1 })";
  const auto a = project::parse_project(tight), b = project::parse_project(wide);
  if (!a || !b) GTEST_FAIL() << (a ? b : a).error().message;
  EXPECT_EQ(mark_of("p", *a), mark_of("p", *b));
}

TEST(Manifest, ComparesFilesByNameAndContent) {
  const auto mark = [](const char* name, const char* text) { return mark_of(name, std::string_view(text)); };
  const Comparison c = compare({mark("a", "1"), mark("b", "2"), mark("c", "3")},
                               {mark("a", "1"), mark("b", "other"), mark("d", "4")});
  EXPECT_EQ(c.same, std::vector<std::string>{"a"});
  EXPECT_EQ(c.changed, std::vector<std::string>{"b"});
  EXPECT_EQ(c.missing, std::vector<std::string>{"c"});
  EXPECT_EQ(c.added, std::vector<std::string>{"d"});
  EXPECT_FALSE(c.all_same());
  EXPECT_TRUE(compare({mark("a", "1")}, {mark("a", "1")}).all_same());
}

TEST(ManifestSchema, IsKeptAsTheFieldsSayIt) { test::expect_kept("manifest.schema.json", manifest_schema()); }

}  // namespace
}  // namespace toile::manifest
