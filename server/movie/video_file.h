#pragma once
// Pictures, one after the other, as a video file: the one door to ffmpeg, which runs as a child without a
// shell, on a leash of memory, time and bytes.

#include <atomic>
#include <filesystem>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "server/render/still.h"

namespace toile::movie {

enum class VideoFormat {
  kMp4,  ///< H.264, 4:2:0, with its index in front, for browsers
  kAvi,  ///< Motion JPEG: every frame a picture of its own, for programs that cut and read everything
};
/// "mp4", "avi".
std::string word_of(VideoFormat format);

struct VideoSettings {
  VideoFormat format = VideoFormat::kMp4;
  int width = 720, height = 900;  ///< pixels, even
  int fps = 25;
  int frames = 0;  ///< as many will come at most; bounds the child's time
  std::uint64_t most_bytes = std::uint64_t{256} << 20;  ///< of the file
};

/// A video file under way. Equal frames give equal bytes with the same ffmpeg. Belongs to one thread.
class VideoFile {
 public:
  /// Begins the file, which must not be there, or be empty. Errors: movie.no_ffmpeg when ffmpeg is not
  /// installed, movie.failed.
  static Result<std::unique_ptr<VideoFile>> open(const std::filesystem::path& path,
                                                 const VideoSettings& settings);
  /// Without finish() ffmpeg is killed; what it has written stays.
  ~VideoFile();

  /// Waits until ffmpeg has taken the picture. REQUIRES the settings' size. Errors: those of finish().
  Status add(const render::Image& picture);
  /// Ends the file. Errors: movie.too_large, movie.too_long, movie.failed.
  Status finish();

 private:
  struct Child;
  explicit VideoFile(std::unique_ptr<Child> child);
  std::unique_ptr<Child> child_;
};

}  // namespace toile::movie
