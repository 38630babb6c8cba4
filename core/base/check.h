#pragma once
// A broken invariant is a bug of ours, never of the input: it stops the program with its place.

#include <cstdio>
#include <cstdlib>

/// Aborts with file and line when `condition` does not hold, in every build.
#define TOILE_CHECK(condition)                                                               \
  do {                                                                                       \
    if (!(condition)) {                                                                      \
      std::fprintf(stderr, "%s:%d: broken invariant: %s\n", __FILE__, __LINE__, #condition); \
      std::abort();                                                                          \
    }                                                                                        \
  } while (false)
