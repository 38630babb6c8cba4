#include "server/http/tls_files.h"

#include <openssl/ssl.h>
#include <sys/stat.h>

#include <boost/asio/ssl/context.hpp>

#include <ctime>
#include <utility>

namespace toile::http {
namespace {

/// Until when the context's certificate is good, Unix time; 0 where it does not say.
std::int64_t expiry_of(boost::asio::ssl::context& context) {
  const X509* const shown = SSL_CTX_get0_certificate(context.native_handle());
  std::tm end{};
  if (shown == nullptr || ASN1_TIME_to_tm(X509_get0_notAfter(shown), &end) != 1) return 0;
  return static_cast<std::int64_t>(::timegm(&end));
}

}  // namespace

Result<std::unique_ptr<TlsFiles>> TlsFiles::open(const std::string& certificate, const std::string& key,
                                                 CertificateFigures& figures) {
  std::unique_ptr<TlsFiles> files(new TlsFiles(certificate, key, figures));
  TRY(files->read());
  return files;
}

TlsFiles::Mark TlsFiles::mark_of(const std::string& path) {
  struct stat found {};
  if (::stat(path.c_str(), &found) != 0) return {};
  constexpr std::int64_t kSecond = 1'000'000'000;
  return {found.st_dev, found.st_ino, found.st_size,
          kSecond * static_cast<std::int64_t>(found.st_mtim.tv_sec) + found.st_mtim.tv_nsec};
}

std::shared_ptr<boost::asio::ssl::context> TlsFiles::now() const {
  const std::lock_guard lock(mutex_);
  return now_;
}

/// The marks are taken first: what is written while it is read is read once more.
Status TlsFiles::read() {
  const Marks before = marks();
  Result<TlsContext> context = server_tls(certificate_, key_);
  const std::lock_guard lock(mutex_);
  read_ = before;
  if (!context) return context.error();
  figures_.expires_s = expiry_of(**context);
  now_ = std::move(*context);
  return {};
}

void TlsFiles::read_again(const Log& log) {
  const Status taken = read();
  if (!taken) {
    ++figures_.refused;
    log.warn("certificate not taken; connections get the one of before", taken.error());
    return;
  }
  ++figures_.renewed;
  log.info("certificate read anew",
           {{"file", certificate_}, {"expires_s", std::to_string(figures_.expires_s)}});
}

void TlsFiles::look(const Log& log) {
  {
    const std::lock_guard lock(mutex_);
    if (marks() == read_) return;
  }
  read_again(log);
}

}  // namespace toile::http
