#include "server/documents/documents.h"

#include <cstddef>
#include <utility>

#include "server/documents/read_cloth.h"
#include "server/documents/starts.h"

namespace toile::documents {
namespace {

constexpr std::size_t kBodyBytes = std::size_t{256} << 20;  // some hundred mannequins, or a few scans
constexpr std::size_t kMannequins = 32;                     // of 4,000 triangles each: a few megabytes
constexpr std::size_t kFigures = 32;                        // some hundred kilobytes each
constexpr std::size_t kStartBytes = std::size_t{64} << 20;
constexpr std::size_t kClothBytes = std::size_t{64} << 20;  // some hundred garments

}  // namespace

Documents::Documents(store::Store& store, mesh_import::MeshImporter importer)
    : store_(store),
      bodies_(kBodyBytes, std::move(importer)),
      mannequins_(kMannequins),
      figures_(kFigures),
      starts_(kStartBytes),
      cloths_(kClothBytes) {}

Documents::~Documents() = default;

}  // namespace toile::documents
