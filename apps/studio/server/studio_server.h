#pragma once
/// The studio's server: the page over HTTP, the engine over a WebSocket, for browsers of this machine and of whoever started it.
/// docs/studio/protocol.md is what page and engine say; docs/decisions/0018-studio-server.md is why it is built like this.

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include "apps/studio/server/page.h"
#include "lissom/core/result.h"
#include "lissom/studio/door.h"

namespace lissom {

struct StudioServerOptions {
  unsigned short port = 0;  ///< of 127.0.0.1; 0: any that is free
  /// The secret that browsers remember once they are let in, for the port that was taken; absent: a new one.
  std::function<std::string(unsigned short)> session;
  std::function<void(const std::string&)> log;  ///< one line, from the server's thread

  int connections = 64;                     ///< at once
  int pages = 48;                           ///< of them WebSockets
  size_t message_bytes = size_t{8} << 20;   ///< of one message of a page
  size_t waiting_bytes = size_t{64} << 20;  ///< that may wait for a slow page before it is closed
  size_t header_bytes = size_t{16} << 10;
  std::chrono::milliseconds request_time{10000};  ///< for the header of a request, and for taking an answer
  std::chrono::milliseconds idle_time{30000};  ///< of a connection without requests; a page that does not answer a ping
};

/// Serves from its own thread until it is destroyed.
class StudioServer {
 public:
  /// `door` and `page` have to outlive it. Errors: the port is taken or not allowed.
  static Result<std::unique_ptr<StudioServer>> start(StudioDoor& door, Page page, StudioServerOptions options);
  ~StudioServer();
  StudioServer(const StudioServer&) = delete;
  StudioServer& operator=(const StudioServer&) = delete;

  unsigned short port() const;
  /// An address that lets one browser in, once: "http://127.0.0.1:PORT/?token=...". A browser that is in needs none. From any
  /// thread.
  std::string new_address();
  /// Closes all connections and disconnects all pages from the door. Returns when that is done, after a second at most.
  void stop();

 private:
  struct Impl;
  explicit StudioServer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace lissom
