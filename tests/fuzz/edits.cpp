// Lists of edits.

#include "core/project/editing/edits.h"
#include "core/json/tree.h"
#include "tests/core/project/editing/every_edit.h"
#include "tests/fuzz/fuzz.h"

namespace toile::fuzz {

std::vector<std::string> seeds() { return {kEveryEdit, "[]", R"([{"edit": "split_edge", "piece": "a"}])"}; }

void try_input(std::string_view bytes) {
  const Result<json::JsonValue> list = json::parse_json(bytes);
  if (!list) return;
  const auto edits = editing::read_edits(*list, "/edits");
  if (!edits) return;
  const std::string text = json::write_json_line(editing::edits_json(*edits));
  const auto again = editing::read_edits(json::parse_json(text).value(), "/edits");
  expect(again.ok(), "what is written is read again");
  expect(json::write_json_line(editing::edits_json(*again)) == text, "and written alike");
}

}  // namespace toile::fuzz
