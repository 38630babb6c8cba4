#include "server/movie/draw_svg.h"

#include <string>

#include "server/movie/ffmpeg.h"

namespace toile::movie {

Status draw_svg(const std::filesystem::path& svg, const std::filesystem::path& png, int width) {
  const std::string program = TRY(ffmpeg_program());
  const auto file = [](const std::filesystem::path& path) {
    return "file:" + std::filesystem::absolute(path).string();
  };
  ChildLimits limits;
  limits.memory_bytes = std::uint64_t{3} << 30;
  limits.file_bytes = std::uint64_t{64} << 20;
  const ChildCommand command{program,
                             {"-hide_banner",
                              "-nostdin",
                              "-loglevel",
                              "error",
                              "-protocol_whitelist",
                              "file",
                              "-f",
                              "svg_pipe",
                              "-width",
                              std::to_string(width),
                              "-i",
                              file(svg),
                              "-map_metadata",
                              "-1",
                              "-frames:v",
                              "1",
                              "-update",
                              "1",
                              "-y",
                              file(png)},
                             -1};
  return ffmpeg_status(run_child(command, limits));
}

}  // namespace toile::movie
