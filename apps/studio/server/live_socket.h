#pragma once
/// The WebSocket of one page: its messages to the door, the door's messages to it.

#include <utility>
// After <utility>, which Boost 1.74 forgets under C++20.
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/message.hpp>

#include "apps/studio/server/server_core.h"

namespace lissom {

using EmptyRequest = boost::beast::http::request<boost::beast::http::empty_body>;

/// Takes over a connection that is number `member` of the crowd, after its request for a WebSocket has been checked.
void start_live_socket(ServerCore& core, boost::beast::tcp_stream stream, const EmptyRequest& request, uint64_t member);

}  // namespace lissom
