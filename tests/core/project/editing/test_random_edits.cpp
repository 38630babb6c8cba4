// Random edits: whatever is carried out can be undone and done again to the same bytes, whatever is refused
// says where, and the JSON of an edit means the same edit.

#include <rapidcheck/gtest.h>

#include <string>
#include <vector>

#include "core/pattern/validate.h"
#include "core/project/editing/edits.h"
#include "tests/core/project/editing/edited_document.h"
#include "tests/damage.h"
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
  if (!read) RC_FAIL(to_string(read.error()) + " " + text);
  RC_ASSERT(json::write_json_line(editing::edits_json(*read)) == text);
  return *read;
}

/// The document that the edits lead to. They have been carried out before.
std::string document_after(const project::Project& project, const std::vector<editing::ProjectEdit>& edits) {
  const Result<editing::EditedProject> out =
      editing::apply_edits(project, through_json(edits), square_files());
  if (!out) RC_FAIL(to_string(out.error()) + " " + json::write_json_line(editing::edits_json(edits)));
  return out->document;
}

struct Tally {
  int carried_out = 0, refused = 0;
};

/// Each number stands for a few edits of what the project has become by then, so that a history which fails
/// can be told without the edits that do not matter.
std::vector<Step> history(const std::vector<std::uint64_t>& numbers, Tally& tally) {
  project::Project project = project::parse_project(test::kEditedDocument).value();
  std::vector<Step> steps;
  for (const std::uint64_t number : numbers) {
    const std::vector<editing::ProjectEdit> edits = RandomEdits(number).some(project);
    const std::string before = project::write_project(project);
    const Result<editing::EditedProject> out = editing::apply_edits(project, edits, square_files());
    RC_ASSERT(project::write_project(project) == before);  // the given one is not touched
    ++(out ? tally.carried_out : tally.refused);
    if (!out) {
      RC_ASSERT(!out.error().code.empty());
      RC_ASSERT(out.error().where.starts_with("/edits"));
      continue;
    }
    steps.push_back({project, edits, out->inverse, out->project});
    project = out->project;
    RC_ASSERT(project::write_project(project::parse_project(out->document).value()) ==
              project::write_project(project));
  }
  return steps;
}

/// `share` of rapidcheck's usual lengths, which are 0 to 100.
Tally try_histories(double share) {
  Tally tally;
  EXPECT_TRUE(rc::check([&] {
    const auto number = rc::gen::resize(100, rc::gen::arbitrary<std::uint64_t>());
    const auto numbers = *rc::gen::scale(share, rc::gen::container<std::vector<std::uint64_t>>(number));
    const std::vector<Step> steps = history(numbers, tally);
    for (auto step = steps.rbegin(); step != steps.rend(); ++step)
      RC_ASSERT(document_after(step->after, step->inverse) == project::write_project_line(step->before));
    for (const Step& step : steps)
      RC_ASSERT(document_after(step.before, step.edits) == project::write_project_line(step.after));
  }));
  return tally;
}

TEST(RandomProjectEdit, UndoGivesBackTheBytesAndRedoTheOthers) {
  const Tally tally = try_histories(0.15);
  EXPECT_GT(tally.carried_out, tally.refused / 2) << "most random edits are refused";
  EXPECT_GT(tally.refused, tally.carried_out / 20) << "hardly any random edit is refused";
}

TEST(LongRandomProjectEdit, UndoGivesBackTheBytesAndRedoTheOthersManyTimes) {
  EXPECT_GT(try_histories(0.4).carried_out, 3000);
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

/// What becomes of damaged edits: refused with their place, or carried out and undone to the same bytes.
void refuse_or_undo(const project::Project& project, const json::JsonValue& tree, Tally& tally) {
  const Result<std::vector<editing::ProjectEdit>> edits = editing::read_edits(tree, "/edits");
  if (!edits) {
    RC_ASSERT(edits.error().where.starts_with("/edits"));
    return;
  }
  const Result<editing::EditedProject> out = editing::apply_edits(project, *edits, square_files());
  ++(out ? tally.carried_out : tally.refused);
  if (!out) {
    RC_ASSERT(out.error().where.starts_with("/edits"));
    return;
  }
  RC_ASSERT(document_after(out->project, out->inverse) == project::write_project_line(project));
}

Tally try_damaged_edits() {
  const project::Project project = project::parse_project(test::kEditedDocument).value();
  // Mostly figures, so that a part of them still means something.
  const auto bytes = rc::gen::oneOf(rc::gen::inRange<std::uint8_t>(32, 127),
                                    rc::gen::map(rc::gen::elementOf(std::string("0123456789-.e")),
                                                 [](char c) { return static_cast<std::uint8_t>(c); }));
  Tally tally;
  EXPECT_TRUE(rc::check([&] {
    const std::vector<test::Stroke> strokes = *test::damage(bytes);
    for (const char* seed : kSeeds) {
      const std::string text = test::struck(seed, strokes);
      const Result<json::JsonValue> tree = json::parse_json(text);
      if (tree) refuse_or_undo(project, *tree, tally);
    }
  }));
  return tally;
}

TEST(RandomProjectEdit, DamagedEditsAreRefusedOrUndone) {
  const Tally tally = try_damaged_edits();
  EXPECT_GT(tally.carried_out, 5);
  EXPECT_GT(tally.refused, 20);
}

TEST(LongRandomProjectEdit, ManyDamagedEditsAreRefusedOrUndone) {
  EXPECT_GT(try_damaged_edits().carried_out, 100);
}

}  // namespace
}  // namespace toile
