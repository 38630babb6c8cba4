#pragma once
// The certificate that a server shows, read again when its files have changed. Internal to http.

#include <sys/types.h>

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "core/base/log.h"
#include "core/base/result.h"
#include "server/http/metrics.h"
#include "server/http/tls.h"

namespace toile::http {

/// Certificates are renewed while the server runs, by programs that put other files in the place of these or
/// write them anew, one after the other. New connections get what was read last and belongs together; what is
/// open goes on with what it began with. Thread-safe.
class TlsFiles {
 public:
  /// Of two PEM files, by path; `figures` are kept up and outlive it. Error: server.tls, as server_tls.
  static Result<std::unique_ptr<TlsFiles>> open(const std::string& certificate, const std::string& key,
                                                CertificateFigures& figures);

  /// For one connection's beginning. OpenSSL counts who uses it, so a connection may outlive what is given
  /// back.
  std::shared_ptr<boost::asio::ssl::context> now() const;

  /// Reads them again and logs what came of it. A pair that cannot be used, or of which one does not belong
  /// to the other, changes nothing.
  void read_again(const Log& log);
  /// The same where either is another file than was read last, or has been written to since. What was refused
  /// is looked at again when it changes again.
  void look(const Log& log);

 private:
  /// What tells a file that was written to or replaced from the one before.
  struct Mark {
    dev_t device = 0;
    ino_t inode = 0;
    off_t size = -1;  ///< -1: there is none
    std::int64_t modified_ns = 0;
    friend bool operator==(const Mark&, const Mark&) = default;
  };
  using Marks = std::array<Mark, 2>;
  TlsFiles(std::string certificate, std::string key, CertificateFigures& figures)
      : certificate_(std::move(certificate)), key_(std::move(key)), figures_(figures) {}
  static Mark mark_of(const std::string& path);
  Marks marks() const { return {mark_of(certificate_), mark_of(key_)}; }
  Status read();

  const std::string certificate_, key_;
  CertificateFigures& figures_;
  mutable std::mutex mutex_;
  std::shared_ptr<boost::asio::ssl::context> now_;
  Marks read_;  ///< as they were before they were read last
};

}  // namespace toile::http
