#include "apps/studio/server/live_socket.h"

#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/websocket.hpp>
#include <memory>
#include <optional>
#include <string>

#include "apps/studio/server/outbox.h"

namespace lissom {

namespace {

namespace net = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;
using boost::system::error_code;

constexpr std::chrono::seconds kFarewell{1};  // for the handshake that ends a connection

class LiveSocket : public std::enable_shared_from_this<LiveSocket> {
 public:
  LiveSocket(ServerCore& core, beast::tcp_stream stream, uint64_t member)
      : core_(core),
        member_(member),
        executor_(stream.get_executor()),
        timer_(executor_),
        socket_(std::in_place, std::move(stream)),
        arrived_(core.options.message_bytes) {}
  ~LiveSocket() { sign_off(); }
  LiveSocket(const LiveSocket&) = delete;
  LiveSocket& operator=(const LiveSocket&) = delete;

  void start(const EmptyRequest& request);

 private:
  void set_up();
  void on_open(error_code error);
  void read();
  void on_read(error_code error);
  void write();
  void watch(bool was_open);
  void say_goodbye(websocket::close_code code, const char* reason);
  void end();
  void sign_off();
  void refuse_read(error_code error);

  ServerCore& core_;
  const uint64_t member_;
  const net::any_io_executor executor_;
  net::steady_timer timer_;
  std::optional<websocket::stream<beast::tcp_stream, false>> socket_;  // false: without compression; gone after the end
  beast::flat_buffer arrived_;
  std::shared_ptr<Outbox> outbox_;
  StudioMessage leaving_;  // what is being written
  int page_ = 0;
  bool open_ = false, closing_ = false, ended_ = false;
};

void LiveSocket::set_up() {
  beast::get_lowest_layer(*socket_).expires_never();  // the WebSocket has timers of its own
  websocket::stream_base::timeout times{};
  times.handshake_timeout = core_.options.request_time;
  times.idle_timeout = core_.options.idle_time;
  times.keep_alive_pings = true;
  socket_->set_option(times);
  socket_->read_message_max(core_.options.message_bytes);
  socket_->auto_fragment(false);
}

void LiveSocket::start(const EmptyRequest& request) {
  set_up();
  const std::weak_ptr<LiveSocket> weak = weak_from_this();
  core_.crowd.retarget(member_, [weak] {
    if (const auto alive = weak.lock()) alive->say_goodbye(websocket::close_code::going_away, "the studio ends");
  });
  outbox_ = std::make_shared<Outbox>(core_.options.waiting_bytes, [weak, executor = executor_] {
    net::post(executor, [weak] {
      if (const auto alive = weak.lock()) alive->write();
    });
  });
  socket_->async_accept(request, [self = shared_from_this()](error_code error) { self->on_open(error); });
}

void LiveSocket::on_open(error_code error) {
  if (error || core_.stopping) return end();
  open_ = true;
  page_ = core_.door.connect([box = outbox_](const StudioMessage& message) { box->put(message); });
  core_.pages.insert(page_);
  watch(true);
  read();
}

/// Once the WebSocket is closed the page has to end the connection too. Not every one does. Holds nothing: a page whose other
/// handlers are gone, by an exception, goes too.
void LiveSocket::watch(bool was_open) {
  timer_.expires_after(kFarewell);
  timer_.async_wait([weak = weak_from_this(), was_open](error_code error) {
    const auto self = weak.lock();
    if (error || !self || self->closing_) return;
    const bool open = self->socket_->is_open();
    if (!open && !was_open) return self->end();
    self->watch(open);
  });
}

void LiveSocket::read() {
  socket_->async_read(arrived_, [self = shared_from_this()](error_code error, size_t) { self->on_read(error); });
}

void LiveSocket::on_read(error_code error) {
  if (ended_) return;
  if (error) {
    refuse_read(error);
    return end();
  }
  if (closing_) return;  // what closes it reads from now on
  if (socket_->got_binary()) {
    core_.refusals.add(Refusal::kMessage);
    return say_goodbye(websocket::close_code::unknown_data, "messages of a page are text");
  }
  core_.door.receive(page_, beast::buffers_to_string(arrived_.data()));
  arrived_.consume(arrived_.size());
  // A picture was large; what comes next is not.
  constexpr size_t kKept = 64 << 10;
  if (arrived_.capacity() > kKept) arrived_.shrink_to_fit();
  read();
}

void LiveSocket::refuse_read(error_code error) {
  if (error == websocket::error::message_too_big || error == websocket::error::buffer_overflow) {
    core_.refusals.add(Refusal::kMessage);
  } else if (error == beast::error::timeout) {
    core_.refusals.add(Refusal::kSlow);
  } else if (error.category() == make_error_code(websocket::error::closed).category() &&
             error != websocket::error::closed) {
    core_.refusals.add(Refusal::kFrame);
  }
}

void LiveSocket::write() {
  if (!open_ || closing_) return;
  if (outbox_->overflowed()) {
    core_.refusals.add(Refusal::kSlow);
    return say_goodbye(websocket::close_code::try_again_later, "the page reads too slowly");
  }
  if (leaving_.bytes) return;  // goes on when it has left
  std::optional<StudioMessage> next = outbox_->take();
  if (!next) return;
  leaving_ = std::move(*next);
  socket_->binary(leaving_.kind == StudioMessage::Kind::kPack);
  socket_->async_write(net::buffer(*leaving_.bytes), [self = shared_from_this()](error_code error, size_t) {
    self->leaving_ = {};
    if (error) return self->end();
    self->write();
  });
}

/// Ends the connection in an orderly way, or by force when the page does not play along.
void LiveSocket::say_goodbye(websocket::close_code code, const char* reason) {
  if (closing_) return;
  closing_ = true;
  const auto self = shared_from_this();
  if (!open_) return end();
  timer_.expires_after(kFarewell);
  timer_.async_wait([self](error_code error) {
    if (!error) self->end();
  });
  socket_->async_close(websocket::close_reason(code, reason), [self](error_code) { self->end(); });
}

/// The connection is over. May be called more than once.
void LiveSocket::end() {
  if (std::exchange(ended_, true)) return;
  closing_ = true;
  sign_off();
  timer_.cancel();
  beast::get_lowest_layer(*socket_).close();
  // In Beast 1.74 reading can wait for closing and closing for reading when a broken frame arrives between them. They wait
  // inside of the stream and hold this object, so the stream has to go.
  net::post(executor_, [self = shared_from_this()] { self->socket_.reset(); });
}

/// Nobody counts on this page any more. Also where a connection ends by an exception.
void LiveSocket::sign_off() {
  if (outbox_) outbox_->close();
  core_.crowd.exit(member_);
  if (std::exchange(open_, false) && core_.pages.erase(page_) > 0) core_.door.disconnect(page_);
}

}  // namespace

void start_live_socket(ServerCore& core, beast::tcp_stream stream, const EmptyRequest& request, uint64_t member) {
  std::make_shared<LiveSocket>(core, std::move(stream), member)->start(request);
}

}  // namespace lissom
