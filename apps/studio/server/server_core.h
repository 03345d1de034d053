#pragma once
/// What the connections of one server share. Used from the server's thread only.

#include <utility>
// After <utility>, which Boost 1.74 forgets under C++20.
#include <boost/asio/ip/tcp.hpp>
#include <set>

#include "apps/studio/server/crowd.h"
#include "apps/studio/server/gate.h"
#include "apps/studio/server/refusals.h"
#include "apps/studio/server/studio_server.h"

namespace lissom {

struct ServerCore {
  ServerCore(StudioDoor& the_door, Page the_page, StudioServerOptions given, unsigned short port)
      : door(the_door),
        page(the_page),
        options(std::move(given)),
        gate(port, options.session ? options.session(port) : random_secret()),
        refusals(options.log),
        crowd(options.connections, options.pages) {}

  StudioDoor& door;
  Page page;
  StudioServerOptions options;
  Gate gate;
  RefusalLog refusals;
  Crowd crowd;
  std::set<int> pages;  ///< as the door numbers them
  bool stopping = false;
};

/// Reads and answers the requests of a connection, until it ends or becomes a WebSocket.
void start_connection(ServerCore& core, boost::asio::ip::tcp::socket socket);

}  // namespace lissom
