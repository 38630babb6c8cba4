#pragma once

#include <string>

namespace toile::app {

/// A hash of the program itself: any other build may drape in other bytes. Empty where it cannot be read.
std::string engine_of_this_program();

}  // namespace toile::app
