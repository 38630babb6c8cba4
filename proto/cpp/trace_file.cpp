#include "proto/cpp/trace_file.h"

#include <bit>
#include <cerrno>
#include <cstring>
#include <optional>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>

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

template <typename Bits>
Bits take(std::istream& in) {
  Bits bits = 0;
  for (unsigned i = 0; i < sizeof(Bits); ++i)
    bits |= static_cast<Bits>(static_cast<Bits>(static_cast<unsigned char>(in.get())) << (8 * i));
  return bits;
}

Error bad_trace(const std::filesystem::path& path) {
  return {"trace.damaged", "this is no trace of a drape", path.string(), ErrorKind::kInput};
}

/// Nothing at the end of the file, or within a frame that was cut off.
std::optional<drape::Frame> take_frame(std::istream& in, std::size_t vertices) {
  drape::Frame frame;
  frame.step = static_cast<int>(take<std::uint32_t>(in));
  take<std::uint32_t>(in);
  frame.time = std::bit_cast<double>(take<std::uint64_t>(in));
  std::string bytes(12 * vertices, '\0');
  if (!in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) return std::nullopt;
  frame.positions.resize(vertices);
  std::istringstream numbers(std::move(bytes));
  for (Vec3& p : frame.positions)
    for (double* c : {&p.x, &p.y, &p.z}) *c = std::bit_cast<float>(take<std::uint32_t>(numbers));
  return frame;
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

Status read_trace(const std::filesystem::path& path, drape::FrameSink& sink) {
  std::ifstream in(path, std::ios::binary);
  std::error_code failure;
  const std::uintmax_t size = std::filesystem::file_size(path, failure);
  if (!in || failure) return Error{"trace.read", "cannot read the trace", path.string(), ErrorKind::kInput};
  std::string magic(kTraceMagic.size(), '\0');
  in.read(magic.data(), static_cast<std::streamsize>(magic.size()));
  if (magic != kTraceMagic) return bad_trace(path);
  if (take<std::uint32_t>(in) != kTraceVersion)
    return Error{"trace.version", "the trace is of another version of this program", path.string(),
                 ErrorKind::kInput};
  const std::uint32_t vertices = take<std::uint32_t>(in), triangles = take<std::uint32_t>(in);
  take<std::uint32_t>(in);
  if (vertices > size / 12 || triangles > size / 12) return bad_trace(path);
  sewing::GarmentMesh garment;
  garment.rest.resize(vertices);
  garment.triangles.resize(triangles);
  for (Tri& t : garment.triangles) {
    for (Index& v : t) {
      const std::uint32_t vertex = take<std::uint32_t>(in);
      if (vertex >= vertices) return bad_trace(path);
      v = static_cast<Index>(vertex);
    }
  }
  if (!in) return bad_trace(path);
  sink.begin(garment);
  while (const std::optional<drape::Frame> frame = take_frame(in, vertices)) sink.frame(*frame);
  return {};
}

}  // namespace toile::proto
