#pragma once
// What the codes of groups say of their values, and codes that a fault of the file has changed.

#include <string_view>

namespace toile::dxf {

/// The kind of value that a group code announces (DXF reference, "Group code value types"); it decides how
/// many bytes the value takes in binary files.
enum class DxfValueKind {
  kText,
  kReal,     ///< eight bytes
  kBoolean,  ///< one
  kShort,    ///< two
  kInteger,  ///< four
  kLong,     ///< eight
  kChunk,    ///< bytes, told as figures in text files
  kUnknown   ///< no group code
};

DxfValueKind value_kind_of(int code);

/// Whether a text file may hold this value behind this code.
bool is_plausible(int code, std::string_view value);

/// Whether `found` is `expected` but for one character that has changed or is lost.
bool is_one_off(int found, int expected);

/// Whether the value is the name of a section's or a block's border, or of an entity that is read.
bool is_record_name(std::string_view value);

/// Whether a section of this name may hold a DXF file's content.
bool is_section_name(std::string_view value);

}  // namespace toile::dxf
