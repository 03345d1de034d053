#include "apps/studio/server/studio_server.h"

#include <utility>
// After <utility>, which Boost 1.74 forgets under C++20.
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <exception>
#include <thread>

#include "apps/studio/server/server_core.h"

namespace lissom {

namespace {

namespace net = boost::asio;
using boost::system::error_code;
using net::ip::tcp;

constexpr std::chrono::milliseconds kAcceptPause{100};  // when the system has no more sockets for us
constexpr std::chrono::milliseconds kEndCheck{10};
constexpr int kEndChecks = 120;  // longer than connections take to say goodbye

Error cannot_listen(unsigned short port, const error_code& error) {
  return {ErrorCode::kConflict, "--port", "port " + std::to_string(port) + " cannot be had: " + error.message(),
          "choose another one, or 0 for any that is free"};
}

}  // namespace

struct StudioServer::Impl {
  Status listen(unsigned short port);
  void accept();
  void on_accept(const error_code& error, tcp::socket socket);
  void run();
  void begin_to_end();
  void wait_for_end(int checks);

  std::unique_ptr<ServerCore> core;  // before the context: connections end with it
  net::io_context context{1};
  tcp::acceptor acceptor{context};
  net::steady_timer timer{context};  // of the next attempt to accept, then of the end
  unsigned short port = 0;
  std::thread thread;
};

Status StudioServer::Impl::listen(unsigned short wanted) {
  const tcp::endpoint here(net::ip::address_v4::loopback(), wanted);
  error_code error;
  acceptor.open(here.protocol(), error);
  if (!error) acceptor.set_option(net::socket_base::reuse_address(true), error);
  if (!error) acceptor.bind(here, error);
  if (!error) acceptor.listen(net::socket_base::max_listen_connections, error);
  if (!error) port = acceptor.local_endpoint(error).port();
  if (error) return cannot_listen(wanted, error);
  return {};
}

void StudioServer::Impl::accept() {
  acceptor.async_accept([this](error_code error, tcp::socket socket) { on_accept(error, std::move(socket)); });
}

void StudioServer::Impl::on_accept(const error_code& error, tcp::socket socket) {
  if (core->stopping) return;
  if (error) {
    timer.expires_after(kAcceptPause);
    timer.async_wait([this](error_code) {
      if (!core->stopping) accept();
    });
    return;
  }
  accept();
  error_code ignored;
  socket.set_option(tcp::no_delay(true), ignored);
  start_connection(*core, std::move(socket));
}

void StudioServer::Impl::run() {
  while (true) {
    try {
      context.run();
      return;
    } catch (const std::exception& exception) {
      if (core->options.log) core->options.log(std::string("a connection ended badly: ") + exception.what());
    }
  }
}

void StudioServer::Impl::begin_to_end() {
  core->stopping = true;
  acceptor.close();
  core->crowd.disperse();
  wait_for_end(kEndChecks);
}

/// Ends the thread when all connections have ended, or after so many checks.
void StudioServer::Impl::wait_for_end(int checks) {
  if (core->crowd.size() == 0 || checks == 0) return context.stop();
  timer.expires_after(kEndCheck);
  timer.async_wait([this, checks](error_code) { wait_for_end(checks - 1); });
}

StudioServer::StudioServer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

Result<std::unique_ptr<StudioServer>> StudioServer::start(StudioDoor& door, Page page, StudioServerOptions options) {
  LISSOM_ASSERT(find_file(page, "/") != nullptr);
  auto impl = std::make_unique<Impl>();
  if (Status s = impl->listen(options.port); !s) return s.error();
  impl->core = std::make_unique<ServerCore>(door, page, std::move(options), impl->port);
  impl->accept();
  Impl* running = impl.get();
  impl->thread = std::thread([running] { running->run(); });
  return std::unique_ptr<StudioServer>(new StudioServer(std::move(impl)));
}

StudioServer::~StudioServer() { stop(); }

unsigned short StudioServer::port() const { return impl_->port; }

std::string StudioServer::new_address() {
  return "http://127.0.0.1:" + std::to_string(impl_->port) + "/?token=" + impl_->core->gate.new_token();
}

void StudioServer::stop() {
  if (!impl_->thread.joinable()) return;
  net::post(impl_->context, [impl = impl_.get()] { impl->begin_to_end(); });
  impl_->thread.join();
  for (const int page : impl_->core->pages) impl_->core->door.disconnect(page);
  impl_->core->pages.clear();
  impl_->core->refusals.flush();
}

}  // namespace lissom
