#pragma once
// Samples end in the same bytes on every machine, by every compiler, until somebody changes the engine on
// purpose. Their hashes are written down in tests/data/golden_hashes.txt.

#include <string>

namespace toile::test {

/// Fails unless `hash` is what is written down for `sample`. With TOILE_WRITE_GOLDEN=1 in the environment it
/// is written down instead.
void expect_golden(const std::string& sample, const std::string& hash);

}  // namespace toile::test
