// Project documents.

#include "core/project/project.h"

#include <fstream>
#include <iterator>

#include "tests/core/project/documents.h"
#include "tests/fuzz/fuzz.h"

namespace toile::fuzz {

std::vector<std::string> seeds() {
  std::ifstream sample(std::string(TOILE_SOURCE_DIR) + "/samples/skirt/project.json", std::ios::binary);
  return {kFullDocument, {std::istreambuf_iterator<char>(sample), {}}};
}

void try_input(std::string_view bytes) {
  const Result<project::Project> read = project::parse_project(bytes);
  if (!read) return;
  const std::string text = project::write_project(*read);
  const Result<project::Project> again = project::parse_project(text);
  expect(again.ok(), "what is written is read again");
  expect(project::write_project(*again) == text, "and written alike");
}

}  // namespace toile::fuzz
