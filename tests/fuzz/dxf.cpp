// DXF files, down to panels.

#include "core/pattern/dxf/read.h"

#include "tests/core/pattern/dxf/binary_text.h"
#include "tests/core/pattern/dxf/dialects.h"
#include "tests/fuzz/fuzz.h"

namespace toile::fuzz {

std::vector<std::string> seeds() {
  return {dxf_text::graded_blocks(), dxf_text::free_lines(), dxf_text::nested_blocks(),
          dxf_text::as_binary(dxf_text::graded_blocks(), false),
          dxf_text::as_binary(dxf_text::free_lines(), true)};
}

void try_input(std::string_view bytes) {
  dxf::DxfSettings settings;
  settings.max_drawn_points = 20'000;
  const Result<dxf::DxfDrawing> drawing = dxf::read_dxf(bytes, settings);
  if (!drawing) return expect(drawing.error().code.starts_with("dxf."), "an error of a DXF file says so");
  const dxf::DxfReport& r = drawing->report;
  expect(r.entities == r.kept + r.converted + r.dropped, "the report accounts for every entity");
  expect(!drawing->pieces.empty(), "a drawing without a piece is an error");
  for (const dxf::DxfPiece& piece : drawing->pieces) {
    for (const Vec2 p : piece.outline) expect(is_finite(p), "outlines are finite");
    expect(dxf::panel_from_piece(piece).ok(), "a piece makes a panel");
  }
}

}  // namespace toile::fuzz
