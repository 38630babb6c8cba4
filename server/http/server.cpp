#include "server/http/server.h"

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>

#include <atomic>
#include <chrono>
#include <thread>
#include <utility>
#include <vector>

#include "server/http/connection_context.h"
#include "server/http/listener.h"
#include "server/http/static_files.h"
#include "server/http/tls_files.h"

namespace toile::http {

namespace asio = boost::asio;

/// Members are destroyed from below: connections before what they work with.
class HttpServer::Impl {
 public:
  Impl(store::Store& store, jobs::JobService& jobs, ws::Hub& hub, ServerSettings given, const Log& log)
      : settings_(std::move(given)),
        log_(log),
        page_(settings_.web),
        budget_(settings_.most_body_bytes),
        answers_(settings_.most_answer_bytes),
        pools_(settings_),
        gate_(settings_.gate),
        streams_{store, jobs, hub, pools_.store(), settings_.stream, may_go_on()},
        context_{log_,
                 request_ids_,
                 settings_,
                 router_,
                 metrics_,
                 pools_,
                 budget_,
                 answers_,
                 connections_,
                 streams_,
                 seats_,
                 site_of(settings_),
                 cookie_name(settings_.secure()),
                 nullptr,
                 gate_},
        io_(settings_.io_threads),
        listener_(io_, context_) {
    router_.add_page(
        [this](const store::RequestContext&, const HttpRequest& request) { return page_.get(request); });
  }

  Status start() {
    if (!settings_.tls_certificate.empty()) {
      tls_ = TRY(TlsFiles::open(settings_.tls_certificate, settings_.tls_key, metrics_.certificate));
      context_.tls = tls_.get();
    }
    TRY(listener_.open(settings_));
    if (tls_) look_at_certificate();
    listener_.start();
    for (int i = 0; i < settings_.io_threads; ++i) {
      threads_.emplace_back([this] { io_.run(); });
    }
    return {};
  }

  void drain() { ready_ = false; }
  void read_certificate_again() {
    if (tls_) tls_->read_again(log_);
  }

  void stop() {
    if (stopped_.exchange(true)) return;
    ready_ = false;
    listener_.close();
    connections_.stop_all();
    constexpr auto kPatience = std::chrono::seconds(3);
    const auto until = std::chrono::steady_clock::now() + kPatience;
    while (!threads_.empty() && connections_.count() > 0 && std::chrono::steady_clock::now() < until) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    work_.reset();
    io_.stop();
    for (std::thread& thread : threads_) thread.join();
    pools_.join();  // nobody waits for them any more, but they still look at their connections
    connections_.forget_all();
  }

  int port() const { return listener_.port(); }
  Router& router() { return router_; }
  const Metrics& metrics() const { return metrics_; }
  const std::atomic<bool>& ready() const { return ready_; }

 private:
  /// Every now and then, until the threads that would do it end.
  void look_at_certificate() {
    certificate_timer_.expires_after(settings_.tls_look_every);
    certificate_timer_.async_wait([this](const boost::system::error_code& failure) {
      if (failure) return;
      tls_->look(log_);
      look_at_certificate();
    });
  }
  static Site site_of(const ServerSettings& settings) {
    return {settings.gate != nullptr, settings.secure()};
  }
  /// Whether a viewer's key or link is still good.
  ws::MayGoOn may_go_on() {
    return [gate = gate_, links = settings_.links](const store::RequestContext& context) {
      if (context.link) return links != nullptr && links->is_still_good(context.key);
      return gate == nullptr || gate->is_still_good(context.key);
    };
  }

  const ServerSettings settings_;
  const Log log_;
  RequestIds request_ids_;
  std::atomic<bool> ready_{true}, stopped_{false};
  Metrics metrics_;
  StaticFiles page_;
  Router router_;
  BodyBudget budget_, answers_;
  Connections connections_;
  WorkPools pools_;
  accounts::Gate* const gate_;
  const ws::StreamServices streams_;
  FeedSeats seats_;
  std::unique_ptr<TlsFiles> tls_;
  ConnectionContext context_;  // as it is once connections are taken
  asio::io_context io_;
  asio::executor_work_guard<asio::io_context::executor_type> work_{io_.get_executor()};
  Listener listener_;
  asio::steady_timer certificate_timer_{io_};
  std::vector<std::thread> threads_;
};

HttpServer::HttpServer(store::Store& store, jobs::JobService& jobs, ws::Hub& hub, ServerSettings settings,
                       const Log& log)
    : impl_(std::make_unique<Impl>(store, jobs, hub, std::move(settings), log)) {}

HttpServer::~HttpServer() { stop(); }

Status HttpServer::start() { return impl_->start(); }
void HttpServer::drain() { impl_->drain(); }
void HttpServer::read_certificate_again() { impl_->read_certificate_again(); }
void HttpServer::stop() { impl_->stop(); }
int HttpServer::port() const { return impl_->port(); }
Router& HttpServer::router() { return impl_->router(); }
const Metrics& HttpServer::metrics() const { return impl_->metrics(); }
const std::atomic<bool>& HttpServer::ready() const { return impl_->ready(); }

}  // namespace toile::http
