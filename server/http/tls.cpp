#include "server/http/tls.h"

#include <boost/asio/ssl/context.hpp>

#include <utility>

namespace toile::http {
namespace {

namespace ssl = boost::asio::ssl;

TlsContext modern() {
  TlsContext context(new ssl::context(ssl::context::tls));
  context->set_options(ssl::context::default_workarounds | ssl::context::no_sslv2 | ssl::context::no_sslv3 |
                       ssl::context::no_tlsv1 | ssl::context::no_tlsv1_1 | ssl::context::no_compression |
                       ssl::context::single_dh_use);
  return context;
}

Error unusable(const std::string& what, const boost::system::error_code& failure, const std::string& path) {
  return {"server.tls", what + " cannot be used: " + failure.message(), path};
}

}  // namespace

void DropTls::operator()(ssl::context* context) const { delete context; }

Result<TlsContext> server_tls(const std::string& certificate, const std::string& key) {
  TlsContext context = modern();
  boost::system::error_code failure;
  // Nobody is asked for a pass phrase, least of all while it serves.
  context->set_password_callback([](std::size_t, ssl::context::password_purpose) { return std::string(); },
                                 failure);
  context->use_certificate_chain_file(certificate, failure);
  if (failure) return unusable("the certificate (a PEM file)", failure, certificate);
  context->use_private_key_file(key, ssl::context::pem, failure);
  if (failure)
    return unusable("the private key (a PEM file without a pass phrase, of this certificate)", failure, key);
  return context;
}

Result<TlsContext> client_tls(const std::string& roots) {
  TlsContext context = modern();
  boost::system::error_code failure;
  if (roots.empty()) {
    context->set_default_verify_paths(failure);
  } else {
    context->load_verify_file(roots, failure);
  }
  if (failure) {
    return Error{"client.tls", "the certificates to believe cannot be read: " + failure.message(), roots};
  }
  context->set_verify_mode(ssl::verify_peer);
  return context;
}

}  // namespace toile::http
