#pragma once
// Which addresses are of the internet. Pure.

#include <boost/asio/ip/address.hpp>

namespace toile::http {

/// False for the loopback, private and link-local networks, carrier-grade NAT, documentation, multicast and
/// all else that IANA's special-purpose registries (RFC 6890) keep from being reached over the internet, and
/// for IPv6 addresses that stand for an IPv4 one elsewhere (6to4, Teredo, NAT64).
bool is_public(const boost::asio::ip::address& address);

}  // namespace toile::http
