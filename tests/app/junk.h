#pragma once
// What tests of bad input make their files of.

#include <cstddef>
#include <string>

namespace toile {

inline constexpr std::size_t kFiftyMegabytes = 50'000'000;

/// `text` again and again, until there are at least so many bytes.
inline std::string repeated(const std::string& text, std::size_t bytes) {
  std::string out;
  out.reserve(bytes + text.size());
  while (out.size() < bytes) out += text;
  return out;
}

/// A hundred millimetre square named FRONT, one group a pair of lines.
inline std::string square_dxf(
    const std::string& vertices = "10\n0\n20\n0\n10\n100\n20\n0\n10\n100\n20\n100\n10\n0\n20\n100\n",
    const std::string& closed = "1") {
  return "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\nFRONT\n90\n4\n70\n" + closed + "\n" + vertices +
         "0\nTEXT\n8\nFRONT\n10\n50\n20\n50\n40\n5\n1\nFRONT\n0\nENDSEC\n0\nEOF\n";
}

}  // namespace toile
