#include "core/base/hash.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <cstdio>

namespace toile {

std::string hash_of(std::span<const Vec3> positions) {
  XXH3_state_t state;
  XXH3_128bits_reset(&state);
  for (const Vec3& p : positions) {
    const double bytes[3] = {p.x + 0.0, p.y + 0.0, p.z + 0.0};  // -0.0 + 0.0 is 0.0
    XXH3_128bits_update(&state, bytes, sizeof bytes);
  }
  const XXH128_hash_t h = XXH3_128bits_digest(&state);
  char text[33];
  std::snprintf(text, sizeof text, "%016llx%016llx", static_cast<unsigned long long>(h.high64),
                static_cast<unsigned long long>(h.low64));
  return text;
}

}  // namespace toile
