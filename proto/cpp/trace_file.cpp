#include "proto/cpp/trace_file.h"

#include <bit>
#include <cerrno>
#include <cstring>
#include <string>

#include "core/base/check.h"

namespace toile::proto {
namespace {

/// Appends the value's bytes, least significant first, on any machine.
template <typename Bits>
void append(std::string& out, Bits bits) {
  for (unsigned i = 0; i < sizeof(Bits); ++i) out += static_cast<char>(bits >> (8 * i) & 0xff);
}

void append(std::string& out, double value) { append(out, std::bit_cast<std::uint64_t>(value)); }

void append(std::string& out, Vec3 p) {
  for (const double coordinate : {p.x, p.y, p.z}) {
    append(out, std::bit_cast<std::uint32_t>(static_cast<float>(coordinate)));
  }
}

}  // namespace

TraceWriter::TraceWriter(const std::filesystem::path& path, int every) : path_(path), every_(every) {
  out_.open(path_, std::ios::binary | std::ios::trunc);
}

Result<std::unique_ptr<TraceWriter>> TraceWriter::open(const std::filesystem::path& path, int every) {
  TOILE_CHECK(every >= 1);
  std::unique_ptr<TraceWriter> writer(new TraceWriter(path, every));
  if (!writer->out_) return Error{"export.write", std::strerror(errno), path.string(), ErrorKind::kInternal};
  return writer;
}

void TraceWriter::begin(const sewing::GarmentMesh& garment) {
  std::string header(kTraceMagic);
  append(header, kTraceVersion);
  append(header, static_cast<std::uint32_t>(garment.rest.size()));
  append(header, static_cast<std::uint32_t>(garment.triangles.size()));
  append(header, static_cast<std::uint32_t>(every_));
  for (const Tri& triangle : garment.triangles) {
    for (const Index corner : triangle) append(header, static_cast<std::uint32_t>(corner));
  }
  out_.write(header.data(), static_cast<std::streamsize>(header.size()));
}

void TraceWriter::frame(const drape::Frame& frame) {
  has_skipped_ = seen_++ % every_ != 0;
  if (has_skipped_) {
    skipped_ = frame;
  } else {
    write(frame);
  }
}

void TraceWriter::write(const drape::Frame& frame) {
  std::string bytes;
  bytes.reserve(16 + 12 * frame.positions.size());
  append(bytes, static_cast<std::uint32_t>(frame.step));
  append(bytes, std::uint32_t{0});
  append(bytes, frame.time);
  for (const Vec3 p : frame.positions) append(bytes, p);
  out_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

Status TraceWriter::finish() {
  if (has_skipped_) write(skipped_);
  has_skipped_ = false;
  out_.close();
  if (!out_) return Error{"export.write", "cannot write the trace", path_.string(), ErrorKind::kInternal};
  return {};
}

}  // namespace toile::proto
