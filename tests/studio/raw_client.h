#pragma once
/// A client of the studio's server that sends whatever bytes it is told to, and a door without an engine.

#include <arpa/inet.h>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <netinet/tcp.h>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

#include "apps/studio/server/studio_server.h"

namespace lissom::testing {

/// Answers every message by itself; "pack N" by a pack of N bytes, "throw" by an exception. Counts pages.
class FakeDoor : public StudioDoor {
 public:
  int connect(Send send) override {
    const std::lock_guard lock(mutex_);
    pages_[++last_] = std::move(send);
    return last_;
  }
  void receive(int page, std::string text) override {
    const std::lock_guard lock(mutex_);
    ++received_;
    if (text == "throw") throw std::runtime_error("the door broke");
    StudioMessage answer;
    if (text.starts_with("pack ")) {
      answer.kind = StudioMessage::Kind::kPack;
      answer.bytes = std::make_shared<const std::string>(std::stoul(text.substr(5)), 'p');
    } else {
      answer.bytes = std::make_shared<const std::string>(std::move(text));
    }
    pages_.at(page)(answer);
  }
  void disconnect(int page) override {
    const std::lock_guard lock(mutex_);
    pages_.erase(page);
  }
  void tell_all(const StudioMessage& message) {
    const std::lock_guard lock(mutex_);
    for (auto& [page, send] : pages_) send(message);
  }
  int pages() const {
    const std::lock_guard lock(mutex_);
    return static_cast<int>(pages_.size());
  }
  int received() const {
    const std::lock_guard lock(mutex_);
    return received_;
  }

 private:
  mutable std::mutex mutex_;
  std::map<int, Send> pages_;
  int last_ = 0, received_ = 0;
};

/// Waits until something holds, at most five seconds.
inline bool soon(const std::function<bool()>& holds) {
  for (int i = 0; i < 1000; ++i) {
    if (holds()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

enum Opcode { kContinuation = 0, kText = 1, kBinary = 2, kClose = 8, kPing = 9, kPong = 10 };

struct Frame {
  bool last = true;
  int opcode = kText;
  std::string payload{};
};

/// The bytes of a frame of a client (RFC 6455, 5.2). `claimed`: the length that its header names, if not that of the payload.
inline std::string frame_bytes(const Frame& frame, std::optional<uint64_t> claimed = std::nullopt, bool masked = true) {
  const uint64_t length = claimed.value_or(frame.payload.size());
  std::string bytes;
  bytes += static_cast<char>((frame.last ? 0x80 : 0) | frame.opcode);
  const char mask_bit = static_cast<char>(masked ? 0x80 : 0);
  const int extra = length < 126 ? 0 : length < 65536 ? 2 : 8;
  bytes += static_cast<char>(mask_bit | (extra == 0 ? static_cast<char>(length) : extra == 2 ? 126 : 127));
  for (int i = extra - 1; i >= 0; --i) bytes += static_cast<char>(length >> (8 * i));
  const char key[] = {0x11, 0x22, 0x33, 0x44};
  if (masked) bytes.append(key, 4);
  for (size_t i = 0; i < frame.payload.size(); ++i) {
    bytes += masked ? static_cast<char>(frame.payload[i] ^ key[i % 4]) : frame.payload[i];
  }
  return bytes;
}

class RawClient {
 public:
  explicit RawClient(unsigned short port, int receive_buffer = 0) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    const timeval patience{5, 0};
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    ::setsockopt(socket_, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
    const int on = 1;
    ::setsockopt(socket_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    if (receive_buffer > 0) ::setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &receive_buffer, sizeof receive_buffer);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    connected_ = ::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  }
  ~RawClient() { ::close(socket_); }
  RawClient(const RawClient&) = delete;
  RawClient& operator=(const RawClient&) = delete;

  bool connected() const { return connected_; }

  /// False when the other side has gone.
  bool send(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t count = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (count <= 0) return false;
      bytes.remove_prefix(static_cast<size_t>(count));
    }
    return true;
  }
  /// Nothing more will be sent; what is on its way arrives.
  void end_sending() const { ::shutdown(socket_, SHUT_WR); }
  /// Takes what has arrived, waiting for some; false at the end of the connection or after five seconds.
  bool receive() {
    char piece[65536];
    const ssize_t count = ::recv(socket_, piece, sizeof piece, 0);
    if (count > 0) arrived_.append(piece, static_cast<size_t>(count));
    return count > 0;
  }
  /// Everything until the other side ends.
  std::string receive_all() {
    while (receive()) {
    }
    return std::exchange(arrived_, {});
  }
  /// The header of an answer, up to and with its empty line; what follows stays.
  std::string receive_header() {
    size_t end = 0;
    while ((end = arrived_.find("\r\n\r\n")) == std::string::npos) {
      if (!receive()) return {};
    }
    std::string header = arrived_.substr(0, end + 4);
    arrived_.erase(0, end + 4);
    return header;
  }
  /// The next frame of the server, which never masks and never splits.
  std::optional<Frame> receive_frame() {
    const auto wait_for = [this](size_t count) {
      while (arrived_.size() < count) {
        if (!receive()) return false;
      }
      return true;
    };
    if (!wait_for(2)) return std::nullopt;
    const auto byte = [this](size_t i) { return static_cast<unsigned char>(arrived_[i]); };
    Frame frame{(byte(0) & 0x80) != 0, byte(0) & 0x0f, {}};
    size_t length = byte(1) & 0x7f, start = 2;
    const size_t extra = length == 126 ? 2 : length == 127 ? 8 : 0;
    if (!wait_for(2 + extra)) return std::nullopt;
    if (extra > 0) length = 0;
    for (size_t i = 0; i < extra; ++i) length = length << 8 | byte(start++);
    if (!wait_for(start + length)) return std::nullopt;
    frame.payload = arrived_.substr(start, length);
    arrived_.erase(0, start + length);
    return frame;
  }

 private:
  int socket_;
  bool connected_ = false;
  std::string arrived_;
};

inline std::string host_of(unsigned short port) { return "127.0.0.1:" + std::to_string(port); }

/// "GET PATH HTTP/1.1" with the right Host and with further headers, each ended by "\r\n".
inline std::string get(unsigned short port, const std::string& path, const std::string& headers = {}) {
  return "GET " + path + " HTTP/1.1\r\nHost: " + host_of(port) + "\r\n" + headers + "\r\n";
}

/// What the server answers to a request, as text; the connection is closed by `Connection: close` in it or by the server.
inline std::string ask(unsigned short port, const std::string& request) {
  RawClient client(port);
  client.send(request);
  return client.receive_all();
}

/// A server with a fake door and a page of two files, and what it has logged.
class TestServer {
 public:
  explicit TestServer(StudioServerOptions options = {});

  unsigned short port() const { return server->port(); }
  /// "Cookie: ...\r\n" of a browser that has used a token.
  std::string let_in() {
    const std::string address = server->new_address();
    const std::string answer = ask(port(), get(port(), address.substr(address.find("/?")), "Connection: close\r\n"));
    const size_t start = answer.find("Set-Cookie: ");
    if (start == std::string::npos) return {};
    return "Cookie: " + answer.substr(start + 12, answer.find(';', start) - start - 12) + "\r\n";
  }
  /// The request for a WebSocket.
  std::string upgrade(const std::string& cookie) const {
    return get(port(), "/live",
               "Origin: http://" + host_of(port()) + "\r\n" + cookie +
                   "Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
                   "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n");
  }
  /// A page that has been let in, nullptr when that did not work.
  std::unique_ptr<RawClient> open_page(const std::string& cookie, int receive_buffer = 0) const {
    auto client = std::make_unique<RawClient>(port(), receive_buffer);
    client->send(upgrade(cookie));
    if (!client->receive_header().starts_with("HTTP/1.1 101 ")) return nullptr;
    return client;
  }
  std::vector<std::string> log() {
    const std::lock_guard lock(mutex_);
    return log_;
  }
  /// Whether something with these words has been logged, or is before long.
  bool logs(const std::string& words) {
    return soon([&] {
      for (const std::string& line : log()) {
        if (line.find(words) != std::string::npos) return true;
      }
      return false;
    });
  }

  FakeDoor door;

 private:
  std::mutex mutex_;
  std::vector<std::string> log_;

 public:
  std::unique_ptr<StudioServer> server;  // ends first, because it logs until then
};

/// "Hello", compressed by gzip, as /index.html, and the same as /assets/hello.js.
inline Page test_page() {
  static constexpr unsigned char kHello[] = {0x1f, 0x8b, 8,    0,    0,    0,    0,    0,    2,    3, 0xf3, 0x48, 0xcd,
                                             0xc9, 0xc9, 0x07, 0x00, 0x82, 0x89, 0xd1, 0xf7, 0x05, 0, 0,    0};
  static constexpr PageFile kFiles[] = {
      {"/index.html", "text/html; charset=utf-8", "0123456789abcdef", kHello},
      {"/assets/hello.js", "text/javascript; charset=utf-8", "fedcba9876543210", kHello}};
  return kFiles;
}

inline TestServer::TestServer(StudioServerOptions options) {
  options.log = [this](const std::string& line) {
    const std::lock_guard lock(mutex_);
    log_.push_back(line);
  };
  Result<std::unique_ptr<StudioServer>> started = StudioServer::start(door, test_page(), std::move(options));
  if (started) server = std::move(started).value();
}

}  // namespace lissom::testing
