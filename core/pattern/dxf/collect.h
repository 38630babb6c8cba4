#pragma once
// Entities of a DXF file, one after the other, into the file's content.

#include <cstddef>
#include <optional>
#include <string>

#include "core/pattern/dxf/draft.h"
#include "core/pattern/dxf/entities.h"

namespace toile::dxf {

/// Gathers finished drafts. An error ends the reading; a fault of one entity is told of in the log.
class DxfCollector {
 public:
  DxfCollector(DxfFile& file, const DxfSettings& settings) : file_(file), settings_(settings) {}

  /// Takes the draft in. Error: dxf.too_large.
  std::optional<Error> store(DxfDraft& draft);
  /// What begins now is no part of a POLYLINE; `line` is where.
  void end_polyline(int line);
  /// Leaves out an entity that the end of the file cuts off.
  void cut_off(const DxfDraft& draft);
  /// Leaves out the POLYLINE that awaits its SEQEND at the end of the file. Whether there was one.
  bool cut_polyline();
  void end_block() { in_block_ = false; }
  bool in_block() const { return in_block_; }
  /// One more vertex, knot or entity. Error: dxf.too_large.
  std::optional<Error> count_vertex(int line);
  std::optional<Error> count_entity(int line);

 private:
  DxfBlock& target() { return in_block_ ? file_.blocks.back() : file_.entities; }
  std::size_t add(const DxfDraft& draft);
  void drop(const DxfDraft& draft, const std::string& reason);
  void fail(const DxfDraft& draft, const Error& error);
  std::optional<Error> missing(const DxfDraft& draft) const;
  DxfCurve curve_of(const DxfDraft& draft);

  void begin_block(const DxfDraft& draft);
  void begin_polyline(const DxfDraft& draft);
  void add_vertex(const DxfDraft& draft);
  void end_sequence(const DxfDraft& draft);
  void add_lwpolyline(DxfDraft& draft);
  void add_line(const DxfDraft& draft);
  void add_arc(const DxfDraft& draft);
  void add_ellipse(const DxfDraft& draft);
  void add_spline(DxfDraft& draft);
  void add_point(const DxfDraft& draft);
  void add_text(const DxfDraft& draft);
  void add_insert(const DxfDraft& draft);

  DxfFile& file_;
  const DxfSettings& settings_;
  bool in_block_ = false;
  std::optional<DxfCurve> polyline_;
  std::optional<Error> polyline_fault_;
  bool polyline_is_mesh_ = false, polyline_has_layer_ = false, attributes_follow_ = false;
  std::size_t entities_ = 0, vertices_ = 0;
};

}  // namespace toile::dxf
