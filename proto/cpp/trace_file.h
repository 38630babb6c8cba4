#pragma once
// Keeps frames of a drape in a file, and reads them back. The byte layout is proto/trace.md's.

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string_view>

#include "core/base/result.h"
#include "core/drape/frame_sink.h"

namespace toile::proto {

inline constexpr std::string_view kTraceMagic = "TOILETRC";
inline constexpr std::uint32_t kTraceVersion = 1;

/// Writes every n-th frame that it is given as it comes, and the last one at finish.
class TraceWriter final : public drape::FrameSink {
 public:
  /// Makes the file. REQUIRES every >= 1. Error: export.write.
  static Result<std::unique_ptr<TraceWriter>> open(const std::filesystem::path& path, int every);

  void begin(const sewing::GarmentMesh& garment) override;
  void frame(const drape::Frame& frame) override;

  /// Writes the last frame if it was passed over. Error: export.write with the path, for whatever went wrong
  /// since open.
  Status finish();

 private:
  TraceWriter(const std::filesystem::path& path, int every);
  void write(const drape::Frame& frame);

  std::filesystem::path path_;
  std::ofstream out_;
  int every_;
  int seen_ = 0;
  drape::Frame skipped_;  ///< the newest frame, when it was passed over
  bool has_skipped_ = false;
};

/// Gives `sink` the frames of a trace, one after the other; the garment has triangles, and as many vertices,
/// but nothing else. Errors: trace.read, trace.damaged (no trace, or its
/// header cannot be), trace.version.
Status read_trace(const std::filesystem::path& path, drape::FrameSink& sink);

}  // namespace toile::proto
