#include "server/http/public_address.h"

#include <algorithm>
#include <cstdint>

namespace toile::http {
namespace {

namespace ip = boost::asio::ip;

struct Network4 {
  std::uint32_t first;
  int bits;
};

constexpr std::uint32_t four(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  return a << 24 | b << 16 | c << 8;
}

/// IANA IPv4 Special-Purpose Address Registry; multicast; the class E that is reserved.
constexpr Network4 kNotPublic[] = {
    {four(0, 0, 0), 8},      {four(10, 0, 0), 8},     {four(100, 64, 0), 10}, {four(127, 0, 0), 8},
    {four(169, 254, 0), 16}, {four(172, 16, 0), 12},  {four(192, 0, 0), 24},  {four(192, 0, 2), 24},
    {four(192, 88, 99), 24}, {four(192, 168, 0), 16}, {four(198, 18, 0), 15}, {four(198, 51, 100), 24},
    {four(203, 0, 113), 24}, {four(224, 0, 0), 4},    {four(240, 0, 0), 4},
};

bool is_public_v4(const ip::address_v4& address) {
  const std::uint32_t number = address.to_uint();
  return std::none_of(std::begin(kNotPublic), std::end(kNotPublic), [&](const Network4& network) {
    return (number ^ network.first) >> (32 - network.bits) == 0;
  });
}

/// Of 2000::/3, the global unicast addresses, but for what IANA's registry takes out of it: 2001::/23 (Teredo
/// and others), 2001:db8::/32 and 3fff::/20 (documentation), 2002::/16 (6to4).
bool is_public_v6(const ip::address_v6& address) {
  const auto bytes = address.to_bytes();
  const unsigned first = unsigned{bytes[0]} << 8 | bytes[1], second = unsigned{bytes[2]} << 8 | bytes[3];
  if ((first & 0xe000U) != 0x2000U || first == 0x2002U) return false;
  if (first == 0x2001U && (second < 0x0200U || second == 0x0db8U)) return false;
  return !(first == 0x3fffU && second < 0x1000U);
}

}  // namespace

bool is_public(const ip::address& address) {
  if (address.is_v4()) return is_public_v4(address.to_v4());
  const ip::address_v6 six = address.to_v6();
  if (six.is_v4_mapped()) return is_public_v4(ip::make_address_v4(ip::v4_mapped, six));
  return is_public_v6(six);
}

}  // namespace toile::http
