#pragma once
// What a fuzz target gives, and what it may ask of its input. A target is one file that defines seeds() and
// try_input(); CMakeLists.txt names it.

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

namespace toile::fuzz {

/// Inputs to begin with, small and of every kind that the parser tells apart: the fuzzer finds its way from
/// them by itself.
std::vector<std::string> seeds();

/// Reads the bytes as the program would read a stranger's. It must come back, and every promise about what is
/// read must hold; whether the input is refused does not matter.
void try_input(std::string_view bytes);

/// A promise that does not hold is a finding.
inline void expect(bool holds, const char* promise) {
  if (holds) return;
  std::fprintf(stderr, "not so: %s\n", promise);
  std::abort();
}

}  // namespace toile::fuzz
