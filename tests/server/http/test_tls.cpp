// The service under TLS: requests, the stream, and who is not let in.

#include <boost/asio/connect.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket/ssl.hpp>
#include <boost/beast/websocket/stream.hpp>

#include <chrono>
#include <ctime>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <thread>
#include <utility>

#include "server/accounts/secrets.h"
#include "server/http/client.h"
#include "tests/server/http/certificate.h"
#include "tests/server/http/served.h"

namespace toile::test {
namespace {

namespace asio = boost::asio;
namespace websocket = boost::beast::websocket;

class Tls : public Served {
 protected:
  void SetUp() override {
    keys = std::filesystem::path(testing::TempDir()) / ("toile_tls_" + std::to_string(getpid()));
    std::filesystem::create_directories(keys);
    made = make_certificate(keys);
    settings.tls_certificate = made.certificate;
    settings.tls_key = made.key;
    settings.header_within = std::chrono::milliseconds(1000);
    serve(settings, false, true);
    store::AccountRow anna;
    anna.name = "anna";
    anna.admin = true;  // who may look at metrics
    store::KeyRow key;
    key.owner = store->accounts()->add_account(anna)->id;
    key.scopes = store::Scopes::all();
    secret = accounts::new_secret();
    ASSERT_TRUE(store->accounts()->add_key(key, accounts::hash_of_secret(secret)));
  }
  void TearDown() override {
    Served::TearDown();
    std::filesystem::remove_all(keys);
  }

  std::string url(const std::string& host = "localhost") const {
    return "https://" + host + ":" + std::to_string(port);
  }
  http::HttpReply ask_secretly(http::HttpClient& client, const std::string& method, const std::string& target,
                               const std::string& body = "", const std::string& type = "") const {
    const Result<http::HttpReply> reply = client.ask({.method = method,
                                                      .target = target,
                                                      .body = body,
                                                      .content_type = type,
                                                      .headers = {{"Authorization", "Bearer " + secret}}},
                                                     std::chrono::seconds(30));
    EXPECT_TRUE(reply) << to_string(reply.error());
    return reply ? *reply : http::HttpReply{};
  }
  static std::string id_of(const http::HttpReply& reply) {
    return *json::parse_json(reply.body, {.depth = 64})->find("id")->text();
  }

  http::ServerSettings settings;
  std::filesystem::path keys;
  Certificate made;
  std::string secret;
};

TEST_F(Tls, AnswersWhoBelievesItsCertificate) {
  auto client = http::HttpClient::make(url(), made.certificate);
  ASSERT_TRUE(client);
  EXPECT_EQ(ask_secretly(*client, "GET", "/api/v1/jobs").status, 200);
  EXPECT_EQ(ask_secretly(*client, "GET", "/api/v1/jobs").status, 200) << "again on the same connection";
  auto by_number = http::HttpClient::make(url("127.0.0.1"), made.certificate);
  EXPECT_EQ(ask_secretly(*by_number, "GET", "/readyz").status, 200);
}

TEST_F(Tls, AClientTurnsFromACertificateThatNobodyVouchesFor) {
  auto client = http::HttpClient::make(url());
  ASSERT_TRUE(client);
  const auto reply = client->ask(http::HttpClient::Request());
  ASSERT_FALSE(reply);
  EXPECT_EQ(reply.error().code, "client.tls");
}

TEST_F(Tls, CarriesLargeBodiesBothWays) {
  auto client = http::HttpClient::make(url(), made.certificate);
  std::string large = kPost;
  while (large.size() < 3'000'000) large += "# a line that a mesh reader passes over\n";
  const http::HttpReply kept = ask_secretly(*client, "POST", "/api/v1/assets?kind=body&name=post.obj", large,
                                            "application/octet-stream");
  ASSERT_EQ(kept.status, 201) << kept.body;
  EXPECT_EQ(ask_secretly(*client, "GET", "/api/v1/assets/" + id_of(kept) + "/content").body, large);
  const http::HttpReply refused =
      ask_secretly(*client, "POST", "/api/v1/jobs", std::string(1 << 20, ' '), "application/json");
  EXPECT_EQ(refused.status, 413) << "told, though the body was still under way";
}

TEST_F(Tls, TheStreamIsUnderItAsWell) {
  auto client = http::HttpClient::make(url(), made.certificate);
  const std::string asset =
      id_of(ask_secretly(*client, "POST", "/api/v1/bodies?name=post.obj", kPost, "application/octet-stream"));
  const std::string project =
      id_of(ask_secretly(*client, "POST", "/api/v1/projects", napkin_request(asset), "application/json"));
  const std::string job = id_of(ask_secretly(*client, "POST", "/api/v1/jobs",
                                             "{\"project_id\": \"" + project + "\"}", "application/json"));
  asio::io_context io;
  asio::ssl::context trust(asio::ssl::context::tls_client);
  trust.load_verify_file(made.certificate);
  trust.set_verify_mode(asio::ssl::verify_peer);
  websocket::stream<asio::ssl::stream<asio::ip::tcp::socket>> viewer(io, trust);
  viewer.next_layer().next_layer().connect(
      {asio::ip::address_v4::loopback(), static_cast<asio::ip::port_type>(port)});
  viewer.next_layer().handshake(asio::ssl::stream_base::client);
  viewer.set_option(websocket::stream_base::decorator(
      [&](websocket::request_type& request) { request.set("Authorization", "Bearer " + secret); }));
  viewer.handshake("localhost", "/api/v1/jobs/" + job + "/stream");
  boost::beast::flat_buffer buffer;
  viewer.read(buffer);
  EXPECT_NE(boost::beast::buffers_to_string(buffer.data()).find(job), std::string::npos);
  ask_secretly(*client, "POST", "/api/v1/jobs/" + job + "/cancel");
  hub.ended(job, {});
  boost::system::error_code end;
  for (int i = 0; i < 20 && !end; ++i) {
    buffer.clear();
    viewer.read(buffer, end);
  }
  EXPECT_EQ(end, websocket::error::closed) << end.message();
  EXPECT_EQ(viewer.reason().code, websocket::close_code::normal);
}

TEST_F(Tls, WhoSpeaksPlainlyOrNotAtAllIsNotWaitedFor) {
  Wire plain(port);
  plain.send("GET /readyz HTTP/1.1\r\nHost: localhost\r\n\r\n");
  EXPECT_TRUE(plain.closed(5));
  Wire silent(port);
  EXPECT_TRUE(silent.closed(5)) << "a handshake that never comes";
  auto client = http::HttpClient::make(url(), made.certificate);
  EXPECT_EQ(ask_secretly(*client, "GET", "/readyz").status, 200);
}

TEST_F(Tls, AnOriginIsThatOfHttps) {
  auto client = http::HttpClient::make(url(), made.certificate);
  const auto asked = [&](const std::string& origin) {
    return client
        ->ask({.method = "POST",
               .target = "/api/v1/jobs",
               .body = "{}",
               .content_type = "application/json",
               .headers = {{"Authorization", "Bearer " + secret}, {"Origin", origin}}})
        ->status;
  };
  EXPECT_EQ(asked(url()), 422);
  EXPECT_EQ(asked("http://localhost:" + std::to_string(port)), 403);
  EXPECT_EQ(asked("https://elsewhere.example"), 403);
}

/// A server that looks often whether its certificate has been renewed.
class RenewedTls : public Tls {
 protected:
  void SetUp() override {
    settings.tls_look_every = std::chrono::milliseconds(20);
    Tls::SetUp();
  }
  /// A client that believes nothing but what lies there now.
  http::HttpClient believer(const std::filesystem::path& roots) const {
    return std::move(*http::HttpClient::make(url(), roots));
  }
  bool is_believed(const std::filesystem::path& roots) const {
    http::HttpClient::Request request;
    request.target = "/readyz";
    return believer(roots).ask(request, std::chrono::seconds(30)).ok();
  }
  /// A figure of /metrics; -1 where it is not there.
  double figure(const std::filesystem::path& roots, const std::string& name) const {
    http::HttpClient client = believer(roots);
    const std::string text = "\n" + ask_secretly(client, "GET", "/metrics").body;
    const std::size_t at = text.find("\n" + name + " ");
    return at == std::string::npos ? -1 : std::stod(text.substr(at + name.size() + 2));
  }
  double renewed(const std::filesystem::path& roots) const {
    return figure(roots, "toile_certificate_reads_total{end=\"taken\"}");
  }
  double refused(const std::filesystem::path& roots) const {
    return figure(roots, "toile_certificate_reads_total{end=\"refused\"}");
  }
  static bool becomes(const std::function<bool()>& holds) {
    for (int i = 0; i < 3000 && !holds(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return holds();
  }
  static std::string text_of(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  /// A copy for clients, since the server's own is written over.
  std::filesystem::path kept_copy(const std::filesystem::path& file, const std::string& name) const {
    std::filesystem::copy_file(file, keys / name, std::filesystem::copy_options::overwrite_existing);
    return keys / name;
  }
  Certificate other() const {
    std::filesystem::create_directories(keys / "other");
    return make_certificate(keys / "other");
  }
};

TEST_F(RenewedTls, IsTakenUpByNewConnectionsWhileOldOnesGoOn) {
  const std::filesystem::path before = kept_copy(made.certificate, "before.pem");
  http::HttpClient old = believer(before);
  ASSERT_EQ(ask_secretly(old, "GET", "/api/v1/jobs").status, 200);
  EXPECT_EQ(renewed(before), 0);
  const Certificate next = other();
  std::filesystem::rename(next.key, made.key);  // as certbot puts other files in the place of these
  std::filesystem::rename(next.certificate, made.certificate);
  const std::filesystem::path after = kept_copy(made.certificate, "after.pem");
  EXPECT_TRUE(becomes([&] { return is_believed(after); }));
  EXPECT_FALSE(is_believed(before));
  EXPECT_EQ(ask_secretly(old, "GET", "/api/v1/jobs").status, 200) << "on the connection that it had";
  EXPECT_EQ(renewed(after), 1);
  const double expires = figure(after, "toile_certificate_expires_seconds");
  EXPECT_NEAR(expires, static_cast<double>(std::time(nullptr) + 86400), 3600);
}

TEST_F(RenewedTls, ABrokenOrForeignPairKeepsTheOldOneUntilItIsWhole) {
  const std::filesystem::path before = kept_copy(made.certificate, "before.pem");
  const Certificate next = other();
  const auto put = [this](const std::string& bytes, const std::filesystem::path& to) {
    std::ofstream(keys / "put") << bytes;
    std::filesystem::rename(keys / "put", to);  // at once, so that what is refused can be counted
  };
  put("-----BEGIN CERTIFICATE-----\nMIIB", made.certificate);
  EXPECT_TRUE(becomes([&] { return refused(before) == 1; }));
  put(text_of(next.certificate), made.certificate);  // whole, but the key is that of the one before
  EXPECT_TRUE(becomes([&] { return refused(before) == 2; }));
  EXPECT_TRUE(is_believed(before));
  std::filesystem::remove(made.key);
  EXPECT_TRUE(becomes([&] { return refused(before) == 3; }));
  EXPECT_TRUE(is_believed(before));
  EXPECT_EQ(renewed(before), 0);
  put(text_of(next.key), made.key);
  EXPECT_TRUE(becomes([&] { return is_believed(next.certificate); }));
  EXPECT_EQ(renewed(next.certificate), 1);
  EXPECT_EQ(refused(next.certificate), 3) << "each was looked at once, not again and again";
}

class TlsFiles : public Served {};

TEST_F(TlsFiles, ThatCannotBeUsedAreNamed) {
  serve();  // for a store and all that belongs to it
  const Certificate good = make_certificate(folder);
  const std::filesystem::path nonsense = folder / "nonsense.pem";
  std::ofstream(nonsense) << "no certificate";
  const auto refused = [&](const std::filesystem::path& certificate, const std::filesystem::path& key) {
    http::ServerSettings settings;
    settings.port = 0;
    settings.tls_certificate = certificate;
    settings.tls_key = key;
    http::HttpServer other(*store, *jobs, hub, settings);
    const Status started = other.start();
    return started ? Error() : started.error();
  };
  EXPECT_EQ(refused(good.certificate, good.key).code, "");
  EXPECT_EQ(refused(nonsense, good.key).where, nonsense);
  EXPECT_EQ(refused(folder / "none.pem", good.key).code, "server.tls");
  EXPECT_EQ(refused(good.certificate, nonsense).where, nonsense);
  EXPECT_EQ(refused(good.certificate, "").code, "server.tls");
  std::filesystem::create_directories(folder / "other");
  const Certificate other = make_certificate(folder / "other");
  EXPECT_EQ(refused(good.certificate, other.key).where, other.key) << "the key of another";
}

}  // namespace
}  // namespace toile::test
