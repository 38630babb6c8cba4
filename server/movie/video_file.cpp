#include "server/movie/video_file.h"

#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <thread>
#include <utility>
#include <vector>

#include "core/base/check.h"
#include "core/base/run_child.h"
#include "server/movie/ffmpeg.h"

namespace toile::movie {
namespace {

constexpr std::uint64_t kMemory = std::uint64_t{3} << 30;  // of address space; 4096² of H.264 take about one
constexpr double kStartUp = 30;                            // s
constexpr double kCpuOfFrame = 10;                         // s, far more than 4096² need
constexpr double kWallOfFrame = 120;  // s, drawing it included, on a machine that does much else

std::vector<std::string> codec_of(VideoFormat format) {
  if (format == VideoFormat::kAvi) return {"-c:v", "mjpeg", "-q:v", "3", "-pix_fmt", "yuvj420p", "-f", "avi"};
  return {"-vf",          "scale=out_color_matrix=bt709:out_range=tv",
          "-c:v",         "libx264",
          "-preset",      "medium",
          "-crf",         "20",
          "-pix_fmt",     "yuv420p",
          "-colorspace",  "bt709",
          "-color_range", "tv",
          "-movflags",    "+faststart",
          "-f",           "mp4"};
}

/// One thread and no dates: the bytes follow from the pictures.
std::vector<std::string> arguments_of(const std::filesystem::path& path, const VideoSettings& settings) {
  const std::string size = std::to_string(settings.width) + "x" + std::to_string(settings.height);
  std::vector<std::string> words{"-hide_banner",
                                 "-nostdin",
                                 "-loglevel",
                                 "error",
                                 "-protocol_whitelist",
                                 "file,pipe",
                                 "-f",
                                 "rawvideo",
                                 "-pixel_format",
                                 "rgb24",
                                 "-video_size",
                                 size,
                                 "-framerate",
                                 std::to_string(settings.fps),
                                 "-i",
                                 "pipe:0",
                                 "-an",
                                 "-map_metadata",
                                 "-1",
                                 "-threads",
                                 "1",
                                 "-filter_threads",
                                 "1",
                                 "-fflags",
                                 "+bitexact",
                                 "-flags:v",
                                 "+bitexact"};
  for (std::string& word : codec_of(settings.format)) words.push_back(std::move(word));
  words.insert(words.end(), {"-y", "file:" + std::filesystem::absolute(path).string()});
  return words;
}

}  // namespace

std::string word_of(VideoFormat format) { return format == VideoFormat::kAvi ? "avi" : "mp4"; }

/// ffmpeg reads one end of a pair of sockets, whose other end this thread writes to; run_child waits for it
/// on a thread of its own.
struct VideoFile::Child {
  int to_child = -1;
  std::atomic<bool> cancel{false};
  ChildOutcome outcome;
  std::thread waiting;
  std::size_t picture_bytes = 0;

  void close_input() {
    if (to_child >= 0) ::close(std::exchange(to_child, -1));
  }
  const ChildOutcome& wait() {
    close_input();
    if (waiting.joinable()) waiting.join();
    return outcome;
  }
  ~Child() {
    cancel = true;
    wait();
  }
};

VideoFile::VideoFile(std::unique_ptr<Child> child) : child_(std::move(child)) {}

VideoFile::~VideoFile() = default;

Result<std::unique_ptr<VideoFile>> VideoFile::open(const std::filesystem::path& path,
                                                   const VideoSettings& settings) {
  TOILE_CHECK(settings.width % 2 == 0 && settings.height % 2 == 0);
  const std::string program = TRY(ffmpeg_program());
  int ends[2] = {-1, -1};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) return ffmpeg_not_run(errno);
  auto child = std::make_unique<Child>();
  child->to_child = ends[0];
  child->picture_bytes = static_cast<std::size_t>(settings.width) * settings.height * 3;
  ChildLimits limits;
  limits.memory_bytes = kMemory;
  limits.cpu_s = kStartUp + kCpuOfFrame * settings.frames;
  limits.wall_s = kStartUp + kWallOfFrame * settings.frames;
  limits.file_bytes = settings.most_bytes;
  const ChildCommand command{program, arguments_of(path, settings), ends[1]};
  Child& c = *child;
  child->waiting = std::thread([&c, command, limits] {
    c.outcome = run_child(command, limits, &c.cancel);
    ::close(command.input);  // so that whoever still writes hears of the end
  });
  return std::unique_ptr<VideoFile>(new VideoFile(std::move(child)));
}

Status VideoFile::add(const render::Image& picture) {
  TOILE_CHECK(picture.rgb.size() == child_->picture_bytes);
  std::size_t sent = 0;
  while (sent < picture.rgb.size()) {
    const ssize_t now =
        ::send(child_->to_child, picture.rgb.data() + sent, picture.rgb.size() - sent, MSG_NOSIGNAL);
    if (now < 0 && errno == EINTR) continue;
    if (now < 0) {
      TRY(ffmpeg_status(child_->wait()));
      return Error{"movie.failed", "ffmpeg ended before the last picture", "", ErrorKind::kSystem};
    }
    sent += static_cast<std::size_t>(now);
  }
  return {};
}

Status VideoFile::finish() { return ffmpeg_status(child_->wait()); }

}  // namespace toile::movie
