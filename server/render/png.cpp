#include "server/render/png.h"

#include "core/base/write_file.h"
#include "core/image/write_png.h"

namespace toile::render {
namespace {

std::vector<std::uint8_t> with_opacity(const Image& image) {
  std::vector<std::uint8_t> pixels;
  pixels.reserve(4 * image.opacity.size());
  for (std::size_t i = 0; i < image.opacity.size(); ++i) {
    for (std::size_t channel = 0; channel < 3; ++channel) pixels.push_back(image.rgb[3 * i + channel]);
    pixels.push_back(image.opacity[i]);
  }
  return pixels;
}

}  // namespace

Result<std::string> png_bytes(const Image& image) {
  const bool opaque = image.opacity.empty();
  if (!opaque && image.opacity.size() * 3 != image.rgb.size())
    return Error{"render.bad_image", "the opacity does not fit the picture", "", ErrorKind::kInternal};
  const int channels = opaque ? 3 : 4;
  const std::vector<std::uint8_t> mixed = opaque ? std::vector<std::uint8_t>{} : with_opacity(image);
  Result<std::string> bytes = image::encode_png(image.width, image.height, channels,
                                                opaque ? image.rgb : mixed, image::PngMatches::kRuns);
  if (!bytes) return Error{"render.bad_image", bytes.error().message, "", ErrorKind::kInternal};
  return bytes;
}

Status write_png(const std::filesystem::path& path, const Image& image) {
  const std::string bytes = TRY(png_bytes(image));
  return write_file(path, bytes);
}

}  // namespace toile::render
