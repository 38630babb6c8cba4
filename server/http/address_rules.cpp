#include "server/http/address_rules.h"

#include <arpa/inet.h>

#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>

#include "core/base/names.h"

namespace toile::http {

namespace ip = boost::asio::ip;

Result<ip::address> listening_address(const ServerSettings& settings) {
  boost::system::error_code failure;
  const std::string& given = settings.address;
  const ip::address address = ip::make_address(given == "localhost" ? "127.0.0.1" : given, failure);
  if (failure)
    return Error{"server.address", in_quotes(given) + " is no address, as 127.0.0.1 and ::1 are", ""};
  if (address.is_loopback() || settings.container) return address;
  if (settings.gate && settings.secure()) return address;
  const std::string missing =
      !settings.gate
          ? "there are no accounts, so that everybody would get at everything (toile account add NAME)"
          : "it would speak to others without TLS (--tls-certificate and --tls-key, or "
            "--behind-proxy where a proxy speaks it)";
  return Error{"server.address",
               in_quotes(given) + " is no address of the loopback, and " + missing +
                   "; for this machine only it is 127.0.0.1 or ::1",
               ""};
}

bool is_host_of_container(const ip::address& remote, const ip::address& local,
                          const std::optional<ip::address>& gateway) {
  const auto plain = [](const ip::address& address) -> ip::address {
    if (!address.is_v6() || !address.to_v6().is_v4_mapped()) return address;
    return ip::make_address_v4(ip::v4_mapped, address.to_v6());
  };
  const ip::address from = plain(remote);
  return from.is_loopback() || from == plain(local) || (gateway && from == *gateway);
}

std::optional<ip::address> default_gateway() {
  std::ifstream routes("/proc/net/route");  // device, destination, gateway, … in hex, as the network has them
  std::string line;
  while (std::getline(routes, line)) {
    std::istringstream columns(line);
    std::string device, destination;
    std::uint32_t gateway = 0;
    if (!(columns >> device >> destination >> std::hex >> gateway)) continue;  // the heading
    if (destination == "00000000" && gateway != 0) return ip::address_v4(ntohl(gateway));
  }
  return std::nullopt;
}

}  // namespace toile::http
