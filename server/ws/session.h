#pragma once
// One viewer of one job: a WebSocket with at most one write in flight. Internal to ws and http.

#include <boost/asio/awaitable.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/websocket/stream.hpp>

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "server/jobs/service.h"
#include "server/store/store.h"
#include "server/ws/control.h"
#include "server/ws/feed.h"
#include "server/ws/hand_pace.h"
#include "server/ws/hub.h"
#include "server/ws/line.h"
#include "server/ws/stream_settings.h"

namespace toile::ws {

/// Whether somebody may go on looking; nothing: everybody may. It may block.
using MayGoOn = std::function<bool(const store::RequestContext&)>;

/// What streams work with; outlives them all.
struct StreamServices {
  store::Store& store;
  jobs::JobService& jobs;
  Hub& hub;
  boost::asio::thread_pool& pool;  ///< for what may block
  StreamSettings settings;
  MayGoOn may_go_on;
};

/// All members run on the socket's strand, but for wake() and stop().
class StreamSession final : public ChannelListener, public std::enable_shared_from_this<StreamSession> {
 public:
  using Handshake = boost::beast::http::request<boost::beast::http::string_body>;

  StreamSession(Line line, const StreamServices& services, const store::RequestContext& context,
                std::string job_id);

  /// Answers the handshake and serves the viewer until either side ends it. `job` exists.
  boost::asio::awaitable<void> run(Handshake handshake);

  /// There is something new. From any thread; returns at once.
  void wake() override;
  /// The server goes: closes with 1001. From any thread.
  void stop();

 private:
  using Clock = std::chrono::steady_clock;
  using Socket = boost::beast::websocket::stream<Line>;

  using Reason = boost::beast::websocket::close_reason;
  /// The job as this viewer may see it, and what it is doing.
  struct Found {
    Result<store::JobRow> job;
    Result<jobs::JobProgress> progress;
  };

  void prepare();
  boost::asio::awaitable<void> write_all();
  boost::asio::awaitable<bool> greet();
  boost::asio::awaitable<bool> write_next();
  boost::asio::awaitable<bool> write(std::string_view bytes, bool text);
  boost::asio::awaitable<bool> write_ended(const ChannelView& view);
  boost::asio::awaitable<void> sleep();
  boost::asio::awaitable<void> read_all();
  boost::asio::awaitable<void> obey(std::string text);
  boost::asio::awaitable<void> touch(Control wish);
  boost::asio::awaitable<void> let_go();
  void refuse(const Error& error);
  boost::asio::awaitable<void> watch();
  boost::asio::awaitable<void> check_key();
  Found find() const;
  void ask_to_close(boost::beast::websocket::close_code code, std::string_view words);
  void ping();
  bool overdue(Clock::time_point now) const;
  void rouse();  ///< lets the writer look again
  void drop();   ///< closes the connection without a word

  const StreamServices& services_;
  store::RequestContext context_;  ///< of the request that became this stream
  std::string job_id_;
  Socket socket_;
  boost::asio::steady_timer wake_;  ///< the writer sleeps on it
  boost::asio::steady_timer tick_;  ///< watch() sleeps on it
  std::atomic<bool> wake_posted_{false};
  bool roused_ = false;

  Subscription subscription_;
  Feed feed_;
  HandPace pace_;
  int hand_ = 0;               ///< number of this viewer's hand; 0 before its first touch
  bool holds_ = false;         ///< it may hold the cloth
  std::string reply_;          ///< newest refusal of a command, to be sent; empty: none
  bool row_is_final_ = false;  ///< the job had ended before this viewer came

  bool gone_ = false;  ///< the connection is of no more use
  bool closing_ = false;
  Reason reason_;
  bool writing_ = false, pinging_ = false;
  Clock::time_point last_sign_, last_ping_, last_check_, write_began_, close_began_;
};

}  // namespace toile::ws
