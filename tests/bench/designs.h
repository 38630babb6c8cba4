#pragma once
// What the benches of garments are run on: the random GarmentCode designs of DATA/garmentcode/random, other
// specifications of GarmentCode, and projects.

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/drape/drape_input.h"

namespace toile::bench {

/// The files of the designs with even numbers, which are for tuning, or with odd ones, for scores. Sorted.
std::vector<std::filesystem::path> designs_of(const std::filesystem::path& data, bool even);

/// What an argument names: "even", "odd", a number or name of a design ("1004", "random_1004"), or a file.
std::vector<std::filesystem::path> garments_named(const std::filesystem::path& data,
                                                  const std::string& argument);

/// "random_1004" of .../random_1004_specification.json, "skirt" of .../skirt/project.json.
std::string name_of_garment(const std::filesystem::path& file);

/// A specification on the body of an OBJ file in metres; a project has bodies of its own. Errors: those of
/// create and resolve.
Result<drape::DrapeInput> garment_input(const std::filesystem::path& file, const std::filesystem::path& body);

}  // namespace toile::bench
