#include "core/project/resolve/opened_files.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "core/json/fields/schema.h"
#include "core/project/cloth_fields.h"

#include "tests/core/project/editing/edited_document.h"

namespace toile {
namespace {

/// Files that count how often each is asked for.
struct CountedFiles {
  std::map<std::string, int> reads;

  resolve::ProjectFiles files() {
    return {.dxf_text = [this](const std::string& name) -> Result<std::string> {
              ++reads[name];
              if (name == "none.dxf") return Error{"project.file", "it is not there", ""};
              return test::square_dxf();
            },
            .body_mesh = [this](const std::string& name,
                                const mesh_import::MeshSettings&) -> Result<mesh_import::RepairedMesh> {
              ++reads[name];
              return mesh_import::RepairedMesh{};
            },
            .mannequin = [this](const mannequin::MannequinSettings&) -> Result<geometry::TriangleMesh> {
              ++reads["a mannequin"];
              return geometry::TriangleMesh{};
            }};
  }
};

project::ProjectDxf front_in(const std::string& units) {
  return {.dxf = "cut.dxf", .piece = "FRONT", .corners = {}, .units = units};
}

TEST(OpenedFiles, ReadADrawingOnceHoweverOftenItIsAskedFor) {
  CountedFiles counted;
  resolve::OpenedFiles files(counted.files());
  const Result<const dxf::DxfDrawing*> first = files.drawing(front_in("mm"));
  ASSERT_TRUE(first) << to_string(first.error());
  EXPECT_EQ(files.drawing(front_in("mm")).value(), *first) << "the same drawing, not a second one";
  EXPECT_EQ(counted.reads["cut.dxf"], 1);
}

TEST(OpenedFiles, TakeOneFileInTwoUnitsFromTheSameBytes) {
  CountedFiles counted;
  resolve::OpenedFiles files(counted.files());
  const dxf::DxfDrawing* small = files.drawing(front_in("mm")).value();
  const dxf::DxfDrawing* large = files.drawing(front_in("cm")).value();
  EXPECT_NE(small, large);
  EXPECT_EQ(counted.reads["cut.dxf"], 1);
}

TEST(OpenedFiles, TakeOneFileWithOtherLayersFromTheSameBytes) {
  CountedFiles counted;
  resolve::OpenedFiles files(counted.files());
  project::ProjectDxf told = front_in("mm");
  told.layers = {{"FRONT", "sew"}};
  const dxf::DxfDrawing* usual = files.drawing(front_in("mm")).value();
  const Result<const dxf::DxfDrawing*> sewn = files.drawing(told);
  ASSERT_TRUE(sewn) << to_string(sewn.error());
  EXPECT_FALSE(usual->pieces[0].on_sew_line);
  EXPECT_TRUE((*sewn)->pieces[0].on_sew_line);
  EXPECT_EQ(counted.reads["cut.dxf"], 1);
  told.layers = {{"NO", "sew"}};
  EXPECT_EQ(files.drawing(told).error().code, "dxf.unknown_layer");
}

TEST(OpenedFiles, KnowEveryWordThatADocumentMayUseOfLayers) {
  project::ProjectDxf dxf;
  fields::Definitions definitions;
  fields::SchemaWriter writer(definitions);
  fields::describe(writer, dxf);
  const json::JsonValue schema = writer.schema();
  const json::JsonValue* words =
      schema.find("properties")->find("layers")->find("additionalProperties")->find("enum");
  std::vector<std::string> said;
  for (const json::JsonValue& word : *words->array()) said.push_back(*word.text());
  EXPECT_EQ(said, dxf::given_role_words());
}

TEST(OpenedFiles, KeepBodiesByTheirFileUnitAndAxis) {
  CountedFiles counted;
  resolve::OpenedFiles files(counted.files());
  project::ProjectBody ann;
  ann.file = "ann.obj";
  ASSERT_TRUE(files.body_mesh(ann));
  ASSERT_TRUE(files.body_mesh(ann));
  EXPECT_EQ(counted.reads["ann.obj"], 1);
  ann.up = "z";
  ASSERT_TRUE(files.body_mesh(ann));
  EXPECT_EQ(counted.reads["ann.obj"], 2) << "turned, it is another mesh";
}

TEST(OpenedFiles, MakeAMannequinOnceForTheSameMeasures) {
  CountedFiles counted;
  resolve::OpenedFiles files(counted.files());
  project::ProjectMannequin figure;
  ASSERT_TRUE(files.mannequin(figure));
  ASSERT_TRUE(files.mannequin(figure));
  EXPECT_EQ(counted.reads["a mannequin"], 1);
  figure.pose = "t";
  ASSERT_TRUE(files.mannequin(figure));
  EXPECT_EQ(counted.reads["a mannequin"], 2);
}

TEST(OpenedFiles, AskAgainForWhatCouldNotBeRead) {
  CountedFiles counted;
  resolve::OpenedFiles files(counted.files());
  project::ProjectDxf from = front_in("mm");
  from.dxf = "none.dxf";
  EXPECT_EQ(files.drawing(from).error().code, "project.file");
  EXPECT_EQ(files.drawing(from).error().code, "project.file");
  EXPECT_EQ(counted.reads["none.dxf"], 2);
}

}  // namespace
}  // namespace toile
