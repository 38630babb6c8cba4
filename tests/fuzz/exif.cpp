// The EXIF segment of a JPEG.

#include "core/image/exif.h"

#include "tests/fuzz/fuzz.h"

namespace toile::fuzz {

std::vector<std::string> seeds() {
  // "Exif", byte order, 42, the first directory at 8; in it one tag: 0x112, a short, once, 6.
  const std::string big("Exif\0\0MM\0\x2a\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x06\0\0\0\0\0\0", 32);
  const std::string little("Exif\0\0II\x2a\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0\x06\0\0\0\0\0\0\0", 32);
  return {big, little};
}

void try_input(std::string_view bytes) {
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  const int orientation = image::exif_orientation({data, bytes.size()});
  expect(orientation >= 1 && orientation <= 8, "an orientation is 1 to 8");
}

}  // namespace toile::fuzz
