#pragma once
// Where a server may listen, and whom it takes connections from. Pure, but for what asks the system.

#include <boost/asio/ip/address.hpp>

#include <optional>

#include "core/base/result.h"
#include "server/http/server_settings.h"

namespace toile::http {

/// The address to listen on. Any but one of the loopback wants accounts, and TLS or a proxy that speaks it:
/// what is said would else be for everybody on the way, and what is kept for everybody who comes. Error:
/// server.address, with the way out.
Result<boost::asio::ip::address> listening_address(const ServerSettings& settings);

/// Whether `remote` is the machine around a container whose port is published on its loopback: the gateway
/// of the container's network, or the container itself (which a user's own container engine forwards as).
/// Others in its network are not.
bool is_host_of_container(const boost::asio::ip::address& remote, const boost::asio::ip::address& local,
                          const std::optional<boost::asio::ip::address>& gateway);

/// The default route's gateway (IPv4), as Linux tells it; nothing when there is none.
std::optional<boost::asio::ip::address> default_gateway();

}  // namespace toile::http
