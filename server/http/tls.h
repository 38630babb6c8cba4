#pragma once
// What TLS is spoken with: versions, certificates, and whom a client believes.

#include <memory>
#include <string>

#include "core/base/result.h"

namespace boost::asio::ssl {
class context;
}

namespace toile::http {

struct DropTls {
  void operator()(boost::asio::ssl::context* context) const;
};
using TlsContext = std::unique_ptr<boost::asio::ssl::context, DropTls>;

/// Of a server: TLS 1.2 and 1.3 with the certificate (and those between it and its root) and the private key
/// of two PEM files. Error: server.tls with the file as its place.
Result<TlsContext> server_tls(const std::string& certificate, const std::string& key);

/// Of a client that believes the roots of the PEM file, or, where none is named, those of this machine
/// (SSL_CERT_FILE can name others). Error: client.tls.
Result<TlsContext> client_tls(const std::string& roots);

}  // namespace toile::http
