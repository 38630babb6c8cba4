#pragma once
// Groups of binary DXF files.

#include <optional>
#include <string>
#include <string_view>

#include "core/pattern/dxf/byte_source.h"

namespace toile::dxf {

/// How a binary file writes its codes.
enum class DxfCodeWidth {
  kOneByte,  ///< R10 to R12: one byte, 255 before two
  kTwoBytes  ///< since R13
};

/// How the file that begins so writes its codes; nothing when it is no binary DXF file.
std::optional<DxfCodeWidth> binary_width(std::string_view beginning);

/// Takes the words that binary files begin with.
void pass_sentinel(DxfByteSource& bytes);

/// A group as a text file would hold it.
struct DxfBinaryGroup {
  enum class End {
    kNone,
    kAtOnce,  ///< there is no further group
    kWithin,  ///< the file ends within the group
    kNoCode,  ///< there is no such group code: what follows cannot be taken apart
  };
  End end = End::kNone;
  int code = 0;
  std::string value;  ///< numbers in as many digits as they need; empty for chunks of bytes
};
DxfBinaryGroup next_binary_group(DxfByteSource& bytes, DxfCodeWidth width);

}  // namespace toile::dxf
