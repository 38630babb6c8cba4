#include "core/base/hash.h"

#include <xxhash.h>

#include <cstdio>
#include <memory>

#include "core/base/check.h"

namespace toile {
namespace {

std::string hex_of(XXH128_hash_t h) {
  char text[33];
  std::snprintf(text, sizeof text, "%016llx%016llx", static_cast<unsigned long long>(h.high64),
                static_cast<unsigned long long>(h.low64));
  return text;
}

}  // namespace

std::string hash_of(std::span<const Vec3> positions) {
  const std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state(XXH3_createState(), &XXH3_freeState);
  TOILE_CHECK(state != nullptr);
  XXH3_128bits_reset(state.get());
  for (const Vec3& p : positions) {
    const double bytes[3] = {p.x + 0.0, p.y + 0.0, p.z + 0.0};  // -0.0 + 0.0 is 0.0
    XXH3_128bits_update(state.get(), bytes, sizeof bytes);
  }
  return hex_of(XXH3_128bits_digest(state.get()));
}

std::string hash_of(std::string_view bytes) { return hex_of(XXH3_128bits(bytes.data(), bytes.size())); }

}  // namespace toile
