#include "core/image/read_picture.h"

#include <string>

#include "core/image/read_jpeg.h"
#include "core/image/read_png.h"

namespace toile::image {
namespace {

using namespace std::string_view_literals;

/// The name of a kind of picture that is often met and not read; empty when the bytes are none.
std::string_view other_format(std::string_view bytes) {
  if (bytes.starts_with("GIF8"sv)) return "GIF";
  if (bytes.starts_with("RIFF"sv) && bytes.substr(0, 12).ends_with("WEBP"sv)) return "WebP";
  if (bytes.starts_with("II*\0"sv) || bytes.starts_with("MM\0*"sv)) return "TIFF";
  if (bytes.starts_with("BM"sv)) return "BMP";
  if (bytes.substr(0, 8).ends_with("ftyp"sv)) return "HEIC or AVIF";
  if (bytes.starts_with("<svg"sv) || bytes.starts_with("<?xml"sv)) return "SVG";
  return "";
}

Error unknown_format(std::string_view bytes) {
  if (bytes.empty()) return {"image.format", "the file is empty", ""};
  const std::string other(other_format(bytes));
  return {"image.format",
          "a picture is a PNG or a JPEG file, and this is " + (other.empty() ? "neither" : other), ""};
}

}  // namespace

std::string_view media_type(PictureFormat format) {
  return format == PictureFormat::kPng ? "image/png" : "image/jpeg";
}

std::optional<PictureFormat> picture_format(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG\r\n\x1a\n"sv)) return PictureFormat::kPng;
  if (bytes.starts_with("\xff\xd8\xff"sv)) return PictureFormat::kJpeg;
  return std::nullopt;
}

Result<ReadPicture> read_picture(std::string_view bytes, const PictureLimits& limits) {
  const std::optional<PictureFormat> format = picture_format(bytes);
  if (!format) return unknown_format(bytes);
  // After the format: a large file of another kind is told as that, which helps more.
  if (bytes.size() > limits.bytes) {
    return Error{"image.too_large",
                 "the file has more than the " + std::to_string(limits.bytes >> 20) + " MiB that are allowed",
                 "", ErrorKind::kTooLarge};
  }
  return *format == PictureFormat::kPng ? read_png(bytes, limits) : read_jpeg(bytes, limits);
}

}  // namespace toile::image
