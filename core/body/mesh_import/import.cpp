#include "core/body/mesh_import/import.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <semaphore>
#include <system_error>
#include <utility>

#include "core/base/text.h"
#include "core/body/mesh_import/confine.h"
#include "core/body/mesh_import/message.h"

namespace toile::mesh_import {
namespace {

constexpr int kAtOnce = 3;  // readers, of one importer
constexpr std::uint64_t kMemory = std::uint64_t{3} << 30;
constexpr double kCpuSeconds = 30;
constexpr double kWallSeconds = 90;
/// Of the largest mesh that load_mesh gives, and what is filled into it.
constexpr std::size_t kMostOutput = (3 * sizeof(Vec3) + 2 * sizeof(Tri)) * kMostMeshTriangles;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kCanLimitMemory = false;  // a sanitizer reserves terabytes for its shadow
#else
constexpr bool kCanLimitMemory = true;
#endif

#ifdef NDEBUG
constexpr bool kIsQuick = kCanLimitMemory;
#else
constexpr bool kIsQuick = false;  // a build for finding faults takes many times as long
#endif

Result<RepairedMesh> mended(Result<geometry::TriangleMesh> mesh) {
  geometry::TriangleMesh read = TRY(std::move(mesh));
  return repair_mesh(std::move(read));
}

/// The settings as arguments, and back.
std::vector<std::string> words_of(const MeshSettings& settings) {
  return {number_text(settings.unit_in_m), settings.z_up ? "z" : "y"};
}

MeshSettings settings_of(const std::string& unit, const std::string& up) {
  return {number_in<double>(unit).value_or(-1), up == "z", true};  // -1 m is refused
}

/// Closed when this goes.
struct Descriptor {
  int fd = -1;
  ~Descriptor() {
    if (fd >= 0) ::close(fd);
  }
};

Error reader_error(const std::string& name, const std::string& reason) {
  return {"mesh.reader", "The mesh reader could not be started: " + reason + ".", name, ErrorKind::kSystem};
}

std::string reason_of(int number) { return std::generic_category().message(number); }

bool write_whole(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(fd, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

Result<std::string> read_whole(int fd, const std::string& name) {
  constexpr std::size_t kChunk = std::size_t{1} << 20;
  std::string bytes;
  struct stat about {};
  if (::fstat(fd, &about) == 0 && about.st_size > 0 &&
      static_cast<std::uint64_t>(about.st_size) <= kMostMeshBytes) {
    bytes.reserve(static_cast<std::size_t>(about.st_size) + kChunk);
  }
  while (bytes.size() <= kMostMeshBytes) {
    const std::size_t had = bytes.size();
    bytes.resize(had + kChunk);
    const ssize_t got = ::read(fd, bytes.data() + had, kChunk);
    bytes.resize(had + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return Error{"mesh.not_found", "The file cannot be read: " + reason_of(errno) + ".", name};
    if (got == 0) break;
  }
  return bytes;
}

/// 0 where the system does not say.
std::uint64_t size_of(int fd) {
  struct stat about {};
  return ::fstat(fd, &about) == 0 ? static_cast<std::uint64_t>(about.st_size) : 0;
}

/// `text` with one name in place of another.
std::string renamed(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

Result<RepairedMesh> read_as_told(const std::vector<std::string>& arguments) {
  if (arguments.size() != 4 || (arguments[0] != "bytes" && arguments[0] != "file")) {
    return Error{"mesh.reader", "The mesh reader was called in a way that it does not know.", "",
                 ErrorKind::kSystem};
  }
  const MeshSettings settings = settings_of(arguments[2], arguments[3]);
  if (arguments[0] == "file") return mended(load_mesh(arguments[1], settings));
  confine();
  const std::string bytes = TRY(read_whole(0, arguments[1]));
  return mended(load_mesh_bytes(arguments[1], bytes, settings));
}

}  // namespace

struct MeshImporter::Reader {
  std::string program;
  ChildLimits limits;
  using Places = std::counting_semaphore<kAtOnce>;
  mutable Places free{kAtOnce};
  mutable std::atomic<std::int64_t> started{0}, crashed{0}, refused{0};

  void count(ChildOutcome::End end) const {
    using End = ChildOutcome::End;
    if (end != End::kNotStarted) ++started;
    if (end == End::kKilledBySignal) ++crashed;
    if (end == End::kTookTooLong || end == End::kWroteTooMuch) ++refused;
  }

  struct Release {
    Places& places;
    ~Release() { places.release(); }
  };

  /// Waits for a place among the readers. Error: mesh.cancelled.
  Status take_place(const std::string& name, const std::atomic<bool>* cancel) const {
    while (!free.try_acquire_for(std::chrono::milliseconds(50))) {
      if (cancel != nullptr && cancel->load(std::memory_order_relaxed)) return cancelled(name);
    }
    return {};
  }

  static Error cancelled(const std::string& name) {
    return {"mesh.cancelled", "Nobody waits for the mesh any more, or reading it took too long.", name,
            ErrorKind::kCancelled};
  }

  Result<RepairedMesh> run(const char* how, const std::string& name, int input, const MeshSettings& settings,
                           const std::atomic<bool>* cancel = nullptr) const {
    const ChildLimits own = input < 0 ? limits : limits_for(limits, size_of(input));
    ChildCommand command{program, {kMeshImportVerb, how, name}, input};
    for (std::string& word : words_of(settings)) command.arguments.push_back(std::move(word));
    TRY(take_place(name, cancel));
    const Release release{free};
    const ChildOutcome outcome = run_child(command, own, cancel);
    count(outcome.end);
    return answer_of(outcome, own, name);
  }

  static Result<RepairedMesh> answer_of(const ChildOutcome& outcome, const ChildLimits& own,
                                        const std::string& name) {
    using End = ChildOutcome::End;
    switch (outcome.end) {
      case End::kExited:
        break;
      case End::kNotStarted:
        return reader_error(name, reason_of(outcome.code));
      case End::kTookTooLong:
        return Error{
            "mesh.too_long",
            "Reading the file took more than " + fixed_text(own.cpu_s, 1) +
                " s and was broken off. It is damaged or far too large; export it anew, as OBJ, STL or "
                "GLB, with fewer triangles.",
            name};
      case End::kCancelled:
        return cancelled(name);
      case End::kWroteTooMuch:
        return Error{"mesh.too_large", "The mesh has too many triangles; export it with fewer.", name,
                     ErrorKind::kTooLarge};
      case End::kKilledBySignal:
        return Error{
            "mesh.crashed",
            "The file brought the mesh reader down (signal " + std::to_string(outcome.code) +
                "); nothing else is harmed. It is damaged, or of a kind that the reader cannot take; "
                "export it anew, as OBJ, STL or GLB.",
            name};
    }
    Result<RepairedMesh> mesh = parse_mesh_message(outcome.output);
    if (mesh || !mesh.error().where.empty()) return mesh;
    return placed_at(mesh.error(), name);
  }
};

/// Meshes in order are read and mended at 10 MB a second and more, in a tenth of the memory.
ChildLimits limits_for(const ChildLimits& most, std::uint64_t bytes) {
  constexpr double kStartSeconds = 0.6, kBytesPerSecond = 500e3;
  constexpr std::uint64_t kStartMemory = std::uint64_t{512} << 20, kMemoryPerByte = 200;
  ChildLimits own = most;
  if (!kIsQuick) return own;
  own.cpu_s = std::min(most.cpu_s, kStartSeconds + static_cast<double>(bytes) / kBytesPerSecond);
  if (most.memory_bytes > 0)
    own.memory_bytes = std::min(most.memory_bytes, kStartMemory + kMemoryPerByte * bytes);
  return own;
}

ReaderEnds MeshImporter::ends() const {
  if (!reader_) return {};
  return {reader_->started.load(), reader_->crashed.load(), reader_->refused.load()};
}

ChildLimits mesh_import_limits() {
  return {kCanLimitMemory ? kMemory : 0, kCpuSeconds, kWallSeconds, kMostOutput};
}

MeshImporter::MeshImporter() = default;

MeshImporter::MeshImporter(std::string program, const ChildLimits& limits)
    : reader_(new Reader{std::move(program), limits}) {}

Result<RepairedMesh> MeshImporter::file(const std::filesystem::path& path,
                                        const MeshSettings& settings) const {
  if (!reader_) return mended(load_mesh(path, settings));
  std::error_code error;
  const std::filesystem::path whole = std::filesystem::absolute(path, error);  // the reader works elsewhere
  Result<RepairedMesh> mesh = reader_->run("file", whole.string(), -1, settings);
  if (mesh) return mesh;
  const Error& e = mesh.error();
  return Error{e.code, renamed(e.message, whole.string(), path.string()),
               renamed(e.where, whole.string(), path.string()), e.kind};
}

Result<RepairedMesh> MeshImporter::bytes(const std::string& name, std::string_view bytes,
                                         const MeshSettings& settings,
                                         const std::atomic<bool>* cancel) const {
  if (!reader_) return mended(load_mesh_bytes(name, bytes, settings));
  const Descriptor memory{::memfd_create("mesh", MFD_CLOEXEC)};
  if (memory.fd < 0) return reader_error(name, reason_of(errno));
  if (!write_whole(memory.fd, bytes) || ::lseek(memory.fd, 0, SEEK_SET) != 0) {
    return reader_error(name, reason_of(errno));
  }
  return reader_->run("bytes", name, memory.fd, settings, cancel);
}

Result<RepairedMesh> MeshImporter::stored(const std::filesystem::path& path, const std::string& name,
                                          const MeshSettings& settings,
                                          const std::atomic<bool>* cancel) const {
  const Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC)};
  if (file.fd < 0) {
    return Error{"mesh.not_found", "The file cannot be opened: " + reason_of(errno) + ".", name};
  }
  if (reader_) return reader_->run("bytes", name, file.fd, settings, cancel);
  const std::string read = TRY(read_whole(file.fd, name));
  return mended(load_mesh_bytes(name, read, settings));
}

int run_mesh_import(const std::vector<std::string>& arguments) {
  const std::string message = mesh_message(read_as_told(arguments));
  if (!write_whole(1, message)) return 1;
  std::_Exit(0);  // the mesh's memory goes with the process, which is faster than piece by piece
}

}  // namespace toile::mesh_import
