#include "server/render/png.h"

#include "core/base/write_file.h"
#include "core/image/write_png.h"

namespace toile::render {

Result<std::string> png_bytes(const Image& image) {
  Result<std::string> bytes = image::encode_png(image.width, image.height, 3, image.rgb);
  if (!bytes) return Error{"render.bad_image", bytes.error().message, "", ErrorKind::kInternal};
  return bytes;
}

Status write_png(const std::filesystem::path& path, const Image& image) {
  const std::string bytes = TRY(png_bytes(image));
  return write_file(path, bytes);
}

}  // namespace toile::render
