#include <utility>
// After <utility>, which Boost 1.74 forgets under C++20.
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <limits>
#include <memory>
#include <optional>

#include "apps/studio/server/answer.h"
#include "apps/studio/server/live_socket.h"
#include "apps/studio/server/server_core.h"

namespace lissom {

namespace {

namespace beast = boost::beast;
namespace http = beast::http;
using boost::asio::ip::tcp;
using boost::system::error_code;

constexpr std::chrono::seconds kDrainTime{1};

/// One connection while it speaks HTTP: request, answer, request, ..., until it ends or becomes a WebSocket.
class Connection : public std::enable_shared_from_this<Connection> {
 public:
  Connection(ServerCore& core, tcp::socket socket)
      : core_(core), stream_(std::move(socket)), arrived_(core.options.header_bytes) {}
  ~Connection() { core_.crowd.exit(member_); }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  void start() {
    const std::weak_ptr<Connection> weak = weak_from_this();
    member_ = core_.crowd.enter([weak] {
      if (const auto alive = weak.lock()) alive->leave();
    });
    if (member_ != 0) return read(core_.options.request_time);
    core_.refusals.add(Refusal::kConnections);
    error_code ignored;
    answer_ = answer_refusal(Refusal::kConnections, 11);
    http::write(stream_, answer_, ignored);  // fits into the buffer of a new socket, so it does not wait
  }

 private:
  void read(std::chrono::milliseconds time);
  void on_read(error_code error);
  void handle(const EmptyRequest& request);
  void send(Answer answer);
  void send_refusal(Refusal refusal);
  void leave();
  void end();
  void drain();

  ServerCore& core_;
  beast::tcp_stream stream_;
  beast::flat_buffer arrived_;
  std::optional<http::request_parser<http::empty_body>> parser_;
  Answer answer_;
  uint64_t member_ = 0;
  bool asked_ = false;  // has sent a request before
};

void Connection::read(std::chrono::milliseconds time) {
  parser_.emplace();
  parser_->header_limit(static_cast<std::uint32_t>(core_.options.header_bytes));
  parser_->body_limit(std::numeric_limits<uint64_t>::max());  // a body of any length is refused where it begins
  stream_.expires_after(time);
  http::async_read_header(stream_, arrived_, *parser_,
                          [self = shared_from_this()](error_code error, size_t) { self->on_read(error); });
}

void Connection::on_read(error_code error) {
  if (!error) return handle(parser_->get());
  const bool silent = error == http::error::end_of_stream || (error == beast::error::timeout && asked_);
  if (error == http::error::header_limit || error == http::error::buffer_overflow)
    return send_refusal(Refusal::kHeader);
  if (error == beast::error::timeout && !silent) core_.refusals.add(Refusal::kSlow);
  if (!silent && error.category() == http::make_error_code(http::error::bad_version).category()) {
    return send_refusal(Refusal::kRequest);
  }
  end();
}

void Connection::handle(const EmptyRequest& request) {
  asked_ = true;
  if (const std::optional<Refusal> refused = check_request(core_.gate, request)) return send_refusal(*refused);
  if (!parser_->is_done()) return send_refusal(Refusal::kRequest);  // a body follows
  const bool known = has_session(core_.gate, request);
  if (known) core_.crowd.promote(member_, Crowd::Rank::kGuest);
  if (!beast::websocket::is_upgrade(request)) return send(answer_request(core_, request));
  if (request.target() != "/live") return send_refusal(Refusal::kPath);
  if (request.count(http::field::origin) != 1) return send_refusal(Refusal::kOrigin);
  if (!known) return send_refusal(Refusal::kSession);
  if (!core_.crowd.promote(member_, Crowd::Rank::kPage)) return send_refusal(Refusal::kConnections);
  start_live_socket(core_, std::move(stream_), request, std::exchange(member_, 0));
}

void Connection::send_refusal(Refusal refusal) {
  core_.refusals.add(refusal);
  send(answer_refusal(refusal, 11));
}

void Connection::send(Answer answer) {
  answer_ = std::move(answer);
  stream_.expires_after(core_.options.request_time);
  http::async_write(stream_, answer_, [self = shared_from_this()](error_code error, size_t) {
    if (error == beast::error::timeout) self->core_.refusals.add(Refusal::kSlow);
    if (error || !self->answer_.keep_alive() || self->core_.stopping) return self->end();
    self->read(self->core_.options.idle_time);
  });
}

/// Somebody else needs the place, or the server ends.
void Connection::leave() {
  if (!core_.stopping) core_.refusals.add(Refusal::kConnections);
  stream_.close();
}

void Connection::end() {
  error_code ignored;
  stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
  stream_.expires_after(kDrainTime);
  drain();
}

/// Reads what is still on its way: a socket that is closed before that takes the answer along.
void Connection::drain() {
  arrived_.clear();
  stream_.async_read_some(arrived_.prepare(arrived_.max_size()), [self = shared_from_this()](error_code error, size_t) {
    if (!error && !self->core_.stopping) return self->drain();
    self->stream_.close();
    self->core_.crowd.exit(self->member_);
  });
}

}  // namespace

void start_connection(ServerCore& core, tcp::socket socket) {
  std::make_shared<Connection>(core, std::move(socket))->start();
}

}  // namespace lissom
