// Random edits: whatever is carried out can be undone and done again to the same bytes, whatever is refused
// says where, and the JSON of an edit means the same edit.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/pattern/validate.h"
#include "core/project/editing/edits.h"
#include "tests/core/project/editing/edited_document.h"
#include "tests/garments/random_chance.h"

namespace toile {
namespace {

using test::Chance;
using test::square_files;

/// Makes edits of what a project has, and now and then of what it has not.
class RandomEdits {
 public:
  explicit RandomEdits(std::uint64_t seed) : chance_(seed) {}

  std::vector<editing::ProjectEdit> some(const project::Project& project) {
    project::Project cloth = project;
    cloth.bodies.clear();
    const pattern::Pattern pattern = resolve::resolve_project(cloth, square_files()).value().pattern;
    std::vector<editing::ProjectEdit> edits;
    for (int n = chance_.whole(1, 3); n > 0; --n) edits.push_back(one(project, pattern));
    return edits;
  }

 private:
  Vec2 near(Vec2 p, double reach) {
    return p + Vec2{chance_.between(-reach, reach), chance_.between(-reach, reach)};
  }
  template <typename T>
  const T& any(const std::vector<T>& list) {
    return list[static_cast<std::size_t>(chance_.whole(0, static_cast<int>(list.size()) - 1))];
  }
  std::string fresh(const std::string& stem) { return stem + std::to_string(chance_.whole(1, 60)); }

  editing::ProjectEdit one(const project::Project& project, const pattern::Pattern& pattern) {
    const pattern::Panel& panel = any(pattern.panels);
    const pattern::PanelEdge& edge = *any(pattern::edges_of(panel));
    const int curves = static_cast<int>(edge.curves.size());
    const pattern::CubicBezier& curve = any(edge.curves);
    const int kind = chance_.whole(0, 27);
    if (kind < 10) return of_edge(kind, panel, edge, curves, curve);
    if (kind < 18) return of_piece(kind, project, panel, edge);
    return of_more(kind, project, pattern, panel);
  }

  editing::ProjectEdit of_edge(int kind, const pattern::Panel& panel, const pattern::PanelEdge& edge,
                               int curves, const pattern::CubicBezier& curve) {
    const std::string &p = panel.id, &e = edge.id;
    switch (kind) {
      case 0:
        return edit::PatternEdit(edit::MovePoint{p, e, chance_.whole(0, curves), near(curve.p0, 15)});
      case 1:
        return edit::PatternEdit(
            edit::MoveHandle{p, e, chance_.whole(0, curves - 1), chance_.whole(1, 2), near(curve.p1, 10)});
      case 2:
        return edit::PatternEdit(edit::InsertPoint{p, e, chance_.unit()});
      case 3:
        return edit::PatternEdit(edit::DeletePoint{p, e, chance_.whole(0, curves)});
      case 4:
        return edit::PatternEdit(
            edit::SplitEdge{p, e, chance_.unit(), chance_.happens(0.5) ? fresh("x") : ""});
      case 5: {
        const pattern::Loop& loop = panel.outline;
        const auto at = static_cast<std::size_t>(chance_.whole(0, static_cast<int>(loop.edges.size()) - 1));
        return edit::PatternEdit(
            edit::JoinEdges{p, loop.edges[at].id, loop.edges[(at + 1) % loop.edges.size()].id});
      }
      case 6:
        return edit::PatternEdit(edit::StraightenEdge{p, e, chance_.whole(-1, curves - 1)});
      case 7:
        return edit::PatternEdit(edit::BendEdge{p, e, 0, near(curve.p1, 20), near(curve.p2, 20)});
      case 8:
        return edit::PatternEdit(edit::SetEdgeLength{
            p, e, chance_.between(5, 250),
            std::vector<std::string>{"start", "middle",
                                     "end"}[static_cast<std::size_t>(chance_.whole(0, 2))]});
      default:
        return edit::PatternEdit(
            edit::AddDart{p, e, chance_.unit(), chance_.between(1, 10), chance_.between(1, 30), fresh("d")});
    }
  }

  editing::ProjectEdit of_piece(int kind, const project::Project& project, const pattern::Panel& panel,
                                const pattern::PanelEdge& edge) {
    const std::string& p = panel.id;
    const Vec2 at = near({50, 50}, 40);
    switch (kind) {
      case 10:
        return edit::PatternEdit(edit::MirrorPiece{p});
      case 11:
        return edit::PatternEdit(edit::RotateGrain{p, chance_.between(-180, 180)});
      case 12:
        return edit::PatternEdit(edit::AddLine{p, {fresh("l"), {at, at + Vec2{5, 5}}, chance_.happens(0.3)}});
      case 13:
        return edit::PatternEdit(edit::RemoveLine{p, panel.lines.empty() ? "none" : any(panel.lines).id});
      case 14:
        if (chance_.happens(0.5))
          return edit::PatternEdit(
              edit::AddInnerDart{p, at, at + near({0, 15}, 10), chance_.between(1, 6), 0.5, fresh("i")});
        if (chance_.happens(0.5)) return edit::PatternEdit(edit::RenameEdge{p, edge.id, fresh("r")});
        return edit::PatternEdit(edit::RemoveHole{p, edge.id});
      case 15:
        return edit::PatternEdit(edit::MovePiece{p, near({0, 0}, 50)});
      case 16:
        return edit::PatternEdit(edit::RenamePiece{p, fresh("piece")});
      default:
        if (chance_.happens(0.3)) return edit::PatternEdit(edit::DeletePiece{p});
        if (project.pieces.size() > 5) return edit::PatternEdit(edit::DeletePiece{p});
        return edit::PatternEdit(
            edit::DuplicatePiece{p, fresh("copy"), near({0, 0}, 50), chance_.happens(0.5)});
    }
  }

  editing::ProjectEdit of_more(int kind, const project::Project& project, const pattern::Pattern& pattern,
                               const pattern::Panel& panel) {
    const std::string seam = project.seams.empty() ? "none" : any(project.seams).id;
    const Vec2 at = near({50, 50}, 40);
    switch (kind) {
      case 18: {
        const pattern::Panel& other = any(pattern.panels);
        return edit::PatternEdit(
            edit::AddSeam{fresh("s"),
                          {{panel.id, any(pattern::edges_of(panel))->id, chance_.happens(0.5)}},
                          {{other.id, any(pattern::edges_of(other))->id, false, 0, chance_.unit()}},
                          chance_.happens(0.5)});
      }
      case 19:
        return edit::PatternEdit(edit::RemoveSeam{seam});
      case 20:
        return edit::PatternEdit(edit::ReverseSeam{seam});
      case 21:
        return edit::PatternEdit(edit::RemoveDart{seam});
      case 22:
        return edit::PatternEdit(edit::SetFabric{panel.id, chance_.happens(0.8) ? "silk" : "tweed"});
      case 23: {
        const std::string id = fresh("h");
        const Vec2 a = at, b = at + Vec2{6, 0}, c = at + Vec2{3, 6};
        return edit::PatternEdit(edit::AddHole{
            panel.id, {{id, {a, b, c}, {}}, {id + "b", {}, {{{c, c + Vec2{-1, -3}, a + Vec2{0, 2}, a}}}}}});
      }
      case 24:
        return editing::SetTexture{panel.id, project::ProjectTexture{"a.png", chance_.between(1, 90),
                                                                     near({0, 0}, 9), chance_.unit()}};
      case 25:
        return edit::PatternEdit(
            edit::AddNotch{panel.id, any(pattern::edges_of(panel))->id, chance_.unit(), 5});
      case 26: {
        const int notch = chance_.whole(0, static_cast<int>(panel.notches.size()));
        if (chance_.happens(0.5)) return edit::PatternEdit(edit::RemoveNotch{panel.id, notch});
        return edit::PatternEdit(
            edit::MoveNotch{panel.id, notch, any(pattern::edges_of(panel))->id, chance_.unit(), {}});
      }
      default: {
        project::ProjectPhysical physical;
        physical.thickness_mm = chance_.between(0.1, 2);
        return editing::SetPhysical{panel.id, physical};
      }
    }
  }

  Chance chance_;
};

struct Step {
  project::Project before;
  std::vector<editing::ProjectEdit> edits, inverse;
  project::Project after;
};

/// The edits as they come out of their own JSON.
std::vector<editing::ProjectEdit> through_json(const std::vector<editing::ProjectEdit>& edits) {
  const std::string text = json::write_json_line(editing::edits_json(edits));
  const Result<std::vector<editing::ProjectEdit>> read =
      editing::read_edits(json::parse_json(text).value(), "");
  EXPECT_TRUE(read) << to_string(read.error()) << text;
  if (!read) return edits;
  EXPECT_EQ(json::write_json_line(editing::edits_json(*read)), text);
  return *read;
}

void try_history(std::uint64_t seed, int length, int& carried_out, int& refused) {
  RandomEdits random(seed);
  project::Project project = project::parse_project(test::kEditedDocument).value();
  const std::string first = project::write_project(project);
  std::vector<Step> steps;
  for (int i = 0; i < length; ++i) {
    const std::vector<editing::ProjectEdit> edits = random.some(project);
    const std::string before = project::write_project(project);
    const Result<editing::EditedProject> out = editing::apply_edits(project, edits, square_files());
    ASSERT_EQ(project::write_project(project), before) << "the given project was touched";
    if (!out) {
      ++refused;
      EXPECT_FALSE(out.error().code.empty());
      EXPECT_TRUE(out.error().where.starts_with("/edits")) << to_string(out.error());
      continue;
    }
    ++carried_out;
    steps.push_back({project, edits, out->inverse, out->project});
    project = out->project;
  }
  for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
    const Result<editing::EditedProject> back =
        editing::apply_edits(step->after, through_json(step->inverse), square_files());
    ASSERT_TRUE(back) << to_string(back.error()) << json::write_json_line(editing::edits_json(step->edits));
    ASSERT_EQ(back->document, project::write_project_line(step->before))
        << json::write_json_line(editing::edits_json(step->edits));
  }
  ASSERT_FALSE(steps.empty());
  EXPECT_EQ(project::write_project(steps.front().before), first);
  for (const Step& step : steps) {
    const Result<editing::EditedProject> again =
        editing::apply_edits(step.before, through_json(step.edits), square_files());
    ASSERT_TRUE(again) << to_string(again.error());
    ASSERT_EQ(again->document, project::write_project_line(step.after));
  }
}

TEST(RandomProjectEdit, UndoGivesBackTheBytesAndRedoTheOthers) {
  int carried_out = 0, refused = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) try_history(seed, 25, carried_out, refused);
  EXPECT_GT(carried_out, 80) << "most random edits are refused";
  EXPECT_GT(refused, 20) << "no random edit is refused";
}

TEST(LongRandomProjectEdit, UndoGivesBackTheBytesAndRedoTheOthersManyTimes) {
  int carried_out = 0, refused = 0;
  for (std::uint64_t seed = 1000; seed < 1300; ++seed) try_history(seed, 40, carried_out, refused);
  EXPECT_GT(carried_out, 3000);
}

constexpr const char* kSeeds[] = {
    R"([{"edit": "move_point", "piece": "front", "edge": "right", "point": 1, "to": [120, 110]}])",
    R"([{"edit": "split_edge", "piece": "back", "edge": "left", "at": 0.3}, {"edit": "mirror_piece", "piece": "back"}])",
    R"([{"edit": "add_dart", "piece": "back", "edge": "hem", "at": 0.5, "width_mm": 9, "depth_mm": 30, "id": "d"}])",
    R"([{"edit": "add_hole", "piece": "band", "edges": [{"id": "h", "points": [[9, 9], [20, 9], [15, 20], [9, 9]]}]}])",
    R"([{"edit": "restore", "pieces": {"at": 2, "remove": 1}, "seams": {"at": 0, "remove": 2},
        "attachments": {"at": 1, "remove": 1}, "buttons": {"at": 0, "remove": 1}, "elastics": {"at": 0, "remove": 1}}])",
    R"([{"edit": "set_physical", "piece": "front", "physical": {"thickness_mm": 2, "friction": 0.5}}])",
};

/// Text with a few bytes changed, left out, doubled or taken from another of the seeds.
std::string mangled(Chance& chance) {
  std::string text = kSeeds[chance.whole(0, static_cast<int>(std::size(kSeeds)) - 1)];
  for (int n = chance.whole(1, 4); n > 0 && !text.empty(); --n) {
    const auto at = static_cast<std::size_t>(chance.whole(0, static_cast<int>(text.size()) - 1));
    const std::string other = kSeeds[chance.whole(0, static_cast<int>(std::size(kSeeds)) - 1)];
    switch (chance.whole(0, 4)) {
      case 0:
        text[at] = static_cast<char>(chance.whole(32, 126));
        break;
      case 1:
        text.erase(at, static_cast<std::size_t>(chance.whole(1, 8)));
        break;
      case 2:
        text.insert(at, text.substr(at, static_cast<std::size_t>(chance.whole(1, 20))));
        break;
      case 3:
        text[at] = "0123456789-.e"[chance.whole(0, 12)];
        break;
      default:
        text.insert(at, other.substr(other.size() / 2));
        break;
    }
  }
  return text;
}

void fuzz(std::uint64_t seed, int rounds) {
  Chance chance(seed);
  const project::Project project = project::parse_project(test::kEditedDocument).value();
  for (int i = 0; i < rounds; ++i) {
    const std::string text = mangled(chance);
    const Result<json::JsonValue> tree = json::parse_json(text);
    if (!tree) continue;
    const Result<std::vector<editing::ProjectEdit>> edits = editing::read_edits(*tree, "/edits");
    if (!edits) {
      EXPECT_TRUE(edits.error().where.starts_with("/edits")) << text;
      continue;
    }
    const Result<editing::EditedProject> out = editing::apply_edits(project, *edits, square_files());
    if (!out) {
      EXPECT_TRUE(out.error().where.starts_with("/edits")) << text << to_string(out.error());
      continue;
    }
    const Result<editing::EditedProject> back =
        editing::apply_edits(out->project, out->inverse, square_files());
    ASSERT_TRUE(back) << text << to_string(back.error());
    EXPECT_EQ(back->document, project::write_project_line(project)) << text;
  }
}

TEST(RandomProjectEdit, MangledEditsAreRefusedOrUndone) { fuzz(7, 3000); }

TEST(LongRandomProjectEdit, ManyMangledEditsAreRefusedOrUndone) { fuzz(8, 200000); }

}  // namespace
}  // namespace toile
