#include "server/documents/documents.h"

#include <cstddef>
#include <utility>

#include "server/documents/starts.h"

namespace toile {
namespace {

constexpr std::size_t kBodyBytes = std::size_t{256} << 20;  // some hundred mannequins, or a few scans
constexpr std::size_t kMannequins = 32;                     // of 4,000 triangles each: a few megabytes
constexpr std::size_t kFigures = 32;                        // some hundred kilobytes each
constexpr std::size_t kStartBytes = std::size_t{64} << 20;

}  // namespace

Documents::Documents(Store& store, MeshImporter importer)
    : store_(store),
      bodies_(kBodyBytes, std::move(importer)),
      mannequins_(kMannequins),
      figures_(kFigures),
      starts_(kStartBytes) {}

Documents::~Documents() = default;

}  // namespace toile
