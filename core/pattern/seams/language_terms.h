#pragma once
// The trade's words for pieces of a garment in other languages than English. From general dictionaries and
// the habits of drafting programs.

#include <span>
#include <string_view>

namespace toile::seams {

/// A table for each language, or for some together: "theirs=english;", small letters without accents. Of
/// terms that more than one table has, the first counts.
std::span<const std::string_view> language_tables();

}  // namespace toile::seams
