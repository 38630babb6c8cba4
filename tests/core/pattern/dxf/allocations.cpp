#include "tests/core/pattern/dxf/allocations.h"

#include <cstdlib>
#include <new>

namespace {

thread_local std::size_t taken = 0;

}  // namespace

// This program's own, in place of the library's.
void* operator new(std::size_t size) {
  ++taken;
  if (void* place = std::malloc(size)) return place;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++taken;
  return std::malloc(size);
}
void operator delete(void* place) noexcept { std::free(place); }
void operator delete(void* place, std::size_t) noexcept { std::free(place); }

namespace toile::test {

std::size_t allocations() { return taken; }

}  // namespace toile::test
