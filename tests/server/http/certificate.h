#pragma once

#include <filesystem>

namespace toile::test {

/// A certificate for localhost and 127.0.0.1, and its key, as PEM files: made anew, and vouching for itself.
/// It is written to where an earlier one may lie, as renewing programs do.
struct Certificate {
  std::filesystem::path certificate, key;
};
Certificate make_certificate(const std::filesystem::path& folder);

}  // namespace toile::test
