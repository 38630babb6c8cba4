#include "server/ws/session.h"

#include <boost/asio/buffer.hpp>
#include <boost/asio/experimental/awaitable_operators.hpp>
#include <boost/asio/post.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>

#include <algorithm>
#include <utility>

#include "server/ws/job_message.h"
#include "server/ws/on_pool.h"
#include "server/ws/tuple.h"

namespace toile::ws {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;

constexpr std::size_t kMostMessageBytes = 4096;  // of what a viewer says
/// What the kernel keeps for a slow viewer. More would only let it see older frames.
constexpr int kSendBufferBytes = 128 << 10;

}  // namespace

StreamSession::StreamSession(Line line, const StreamServices& services, const store::RequestContext& context,
                             std::string job_id)
    : services_(services),
      context_(context.for_job(job_id)),
      job_id_(std::move(job_id)),
      socket_(std::move(line)),
      wake_(socket_.get_executor()),
      tick_(socket_.get_executor()) {}

asio::awaitable<void> StreamSession::run(Handshake handshake) {
  using namespace asio::experimental::awaitable_operators;
  const auto self = shared_from_this();
  prepare();
  const auto [failure] = co_await socket_.async_accept(handshake, kTuple);
  if (failure) co_return;
  last_sign_ = last_ping_ = last_check_ = Clock::now();
  subscription_ = services_.hub.subscribe(job_id_, this);  // before the row is read: nothing falls between
  asio::awaitable<void> all = read_all() && write_all() && watch();
  co_await std::move(all);
  co_await let_go();
  subscription_.reset();
}

void StreamSession::prepare() {
  beast::get_lowest_layer(socket_).expires_never();
  boost::system::error_code ignored;
  auto& tcp = beast::get_lowest_layer(socket_).socket();
  tcp.set_option(asio::ip::tcp::no_delay(true), ignored);
  tcp.set_option(asio::socket_base::send_buffer_size(kSendBufferBytes), ignored);
  socket_.set_option(websocket::stream_base::timeout{services_.settings.close_within,
                                                     websocket::stream_base::none(), false});
  socket_.auto_fragment(false);
  socket_.read_message_max(kMostMessageBytes);
  socket_.control_callback([this](websocket::frame_type, beast::string_view) { last_sign_ = Clock::now(); });
}

StreamSession::Found StreamSession::find() const {
  Found found{services_.store.job(context_, job_id_), services_.jobs.progress(context_, job_id_)};
  if (context_.link && found.job) found.job = store::shown_by(*context_.link, std::move(*found.job));
  return found;
}

asio::awaitable<void> StreamSession::write_all() {
  if (co_await greet()) {
    while (!gone_ && !closing_) {
      const bool went_on = co_await write_next();
      if (!went_on) break;
    }
  }
  if (closing_ && !gone_) co_await socket_.async_close(reason_, kTuple);
  drop();
}

asio::awaitable<bool> StreamSession::greet() {
  const Found found = co_await on_pool(services_.pool, [this] { return find(); });
  if (!found.job || !found.progress) {
    context_.log.warn("stream ended: the job cannot be read",
                      found.job ? found.progress.error() : found.job.error());
    ask_to_close(websocket::close_code::internal_error, "the job cannot be read");
    co_return false;
  }
  row_is_final_ = store::is_final(found.job->state);
  const std::string hello = job_message(*found.job, *found.progress);
  co_return co_await write(hello, true);
}

asio::awaitable<bool> StreamSession::write_next() {
  if (!reply_.empty()) {
    const std::string reply = std::exchange(reply_, "");
    co_return co_await write(reply, true);
  }
  const ChannelView view = subscription_.look();
  const std::optional<FeedMessage> message = feed_.next(view);
  if (message && message->kind == FeedMessage::Kind::kProgress) {
    const std::string text = progress_message(view.progress);
    co_return co_await write(text, true);
  }
  if (message) co_return co_await write(*message->bytes, false);
  if (feed_.finished(view) || (row_is_final_ && !view.topology)) co_return co_await write_ended(view);
  co_await sleep();
  co_return true;
}

asio::awaitable<bool> StreamSession::write(std::string_view bytes, bool text) {
  socket_.text(text);
  writing_ = true;
  write_began_ = Clock::now();
  const auto [failure, size] = co_await socket_.async_write(asio::buffer(bytes.data(), bytes.size()), kTuple);
  writing_ = false;
  co_return !failure;
}

asio::awaitable<bool> StreamSession::write_ended(const ChannelView& view) {
  const Found found = co_await on_pool(services_.pool, [this] { return find(); });
  ask_to_close(websocket::close_code::normal, "the drape has ended");
  if (!found.job || !(view.ended || found.progress)) co_return true;
  const std::string last = ended_message(*found.job, view.ended ? view.progress : *found.progress);
  co_return co_await write(last, true);
}

asio::awaitable<void> StreamSession::sleep() {
  if (!roused_) {
    wake_.expires_at(Clock::time_point::max());
    co_await wake_.async_wait(kTuple);
  }
  roused_ = false;
}

asio::awaitable<void> StreamSession::read_all() {
  beast::flat_buffer buffer;
  for (;;) {
    const auto [failure, size] = co_await socket_.async_read(buffer, kTuple);
    if (failure) break;
    last_sign_ = Clock::now();
    std::string text = beast::buffers_to_string(buffer.data());
    buffer.clear();
    if (closing_) continue;  // only to meet the other side's close
    if (socket_.got_binary()) {
      ask_to_close(websocket::close_code::unknown_data, "only text is understood here");
    } else {
      co_await obey(std::move(text));
    }
  }
  drop();
}

asio::awaitable<void> StreamSession::obey(std::string text) {
  const Result<Control> control = parse_control(text);
  if (!control) {
    ask_to_close(websocket::close_code::policy_error, control.error().code);
    co_return;
  }
  if (!context_.scopes.has(store::Scope::kSubmit)) {
    refuse({"auth.scope", "this wants a key of scope submit", ""});
    co_return;
  }
  if (control->kind == Control::Kind::kTouch) co_return co_await touch(*control);
  const Control::Kind wish = control->kind;
  const Result<store::JobRow> done =
      co_await on_pool(services_.pool, [this, wish]() -> Result<store::JobRow> {
        if (wish == Control::Kind::kPause) return services_.jobs.pause(context_, job_id_);
        if (wish == Control::Kind::kResume) return services_.jobs.resume(context_, job_id_);
        if (wish == Control::Kind::kStep) return services_.jobs.step(context_, job_id_);
        return services_.jobs.cancel(context_, job_id_);
      });
  if (!done) refuse(done.error());
}

/// What the cloth refuses is told later, by the worker.
asio::awaitable<void> StreamSession::touch(Control wish) {
  using drape::TouchKind;
  const TouchKind kind = wish.touch.touch.kind;
  if (kind == TouchKind::kLetGo) co_return co_await let_go();
  if (!pace_.may(Clock::now())) {
    refuse({"live.too_fast", "a hand may be told of 60 times a second; this one was passed over", "",
            ErrorKind::kTooMany});
    co_return;
  }
  if (kind == TouchKind::kPull) {
    if (hand_ == 0) hand_ = services_.hub.new_hand();
    wish.touch.touch.id = hand_;
    holds_ = true;
  }
  wish.touch.refused = [self = weak_from_this()](const Error& error) {
    const auto session = self.lock();
    if (!session) return;
    asio::post(session->socket_.get_executor(), [session, error] { session->refuse(error); });
  };
  const Status done = co_await on_pool(services_.pool, [this, &wish] {
    return services_.jobs.touch(context_, job_id_, std::move(wish.touch));
  });
  if (!done) refuse(done.error());
}

/// A drape that has ended meanwhile has no hands on it.
asio::awaitable<void> StreamSession::let_go() {
  if (!std::exchange(holds_, false)) co_return;
  jobs::LiveTouch open;
  open.touch.kind = drape::TouchKind::kLetGo;
  open.touch.id = hand_;
  const Status done = co_await on_pool(
      services_.pool, [this, &open] { return services_.jobs.touch(context_, job_id_, std::move(open)); });
  if (!done) context_.log.debug("nothing to let go of", {{"code", done.error().code}});
}

void StreamSession::refuse(const Error& error) {
  reply_ = error_message(error);
  rouse();
}

asio::awaitable<void> StreamSession::watch() {
  const auto pause =
      std::min<Clock::duration>(std::min(services_.settings.ping_every, services_.settings.check_every) / 4,
                                std::chrono::milliseconds(500));
  while (!gone_) {
    tick_.expires_after(pause);
    co_await tick_.async_wait(kTuple);
    if (gone_) break;
    const Clock::time_point now = Clock::now();
    if (overdue(now)) {
      drop();
    } else if (now - last_ping_ >= services_.settings.ping_every && !pinging_ && !closing_) {
      ping();
    }
    if (services_.may_go_on && now - last_check_ >= services_.settings.check_every) co_await check_key();
  }
}

/// Who is not known any more sees no more.
asio::awaitable<void> StreamSession::check_key() {
  last_check_ = Clock::now();
  const auto look = [this] { return services_.may_go_on(context_); };
  const bool good = co_await on_pool(services_.pool, look);
  if (!good) ask_to_close(websocket::close_code::policy_error, context_.link ? "links.over" : "auth.token");
}

bool StreamSession::overdue(Clock::time_point now) const {
  const StreamSettings& settings = services_.settings;
  return (writing_ && now - write_began_ > settings.write_within) ||
         now - last_sign_ > settings.pong_within || (closing_ && now - close_began_ > settings.close_within);
}

/// Not awaited: behind a write that hangs a ping hangs as well, and watch() must go on to end both.
void StreamSession::ping() {
  pinging_ = true;
  last_ping_ = Clock::now();
  socket_.async_ping({}, [self = shared_from_this()](boost::system::error_code) { self->pinging_ = false; });
}

void StreamSession::ask_to_close(websocket::close_code code, std::string_view words) {
  if (closing_) return;
  constexpr std::size_t kMostReasonBytes = 123;  // RFC 6455, 5.5
  reason_ = Reason(code, beast::string_view(words.data(), std::min(words.size(), kMostReasonBytes)));
  closing_ = true;
  close_began_ = Clock::now();
  rouse();
}

void StreamSession::wake() {
  if (wake_posted_.exchange(true)) return;  // one post at a time, however fast frames come
  auto self = weak_from_this().lock();
  if (!self) return;
  // Moved: were this the last holder, the session would unsubscribe here, under the lock that its caller has.
  asio::post(socket_.get_executor(), [self = std::move(self)] {
    self->wake_posted_ = false;
    self->rouse();
  });
}

void StreamSession::stop() {
  asio::post(socket_.get_executor(), [self = shared_from_this()] {
    self->ask_to_close(websocket::close_code::going_away, "the server is stopping");
  });
}

void StreamSession::rouse() {
  roused_ = true;
  wake_.cancel();
}

void StreamSession::drop() {
  gone_ = true;
  boost::system::error_code ignored;
  beast::get_lowest_layer(socket_).socket().close(ignored);
  tick_.cancel();
  rouse();
}

}  // namespace toile::ws
