#pragma once
/// What the server answers to a request, apart from how it is sent.

#include <utility>
// After <utility>, which Boost 1.74 forgets under C++20.
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>
#include <optional>

#include "apps/studio/server/live_socket.h"
#include "apps/studio/server/server_core.h"

namespace lissom {

using Answer = boost::beast::http::response<boost::beast::http::string_body>;

/// What is wrong with a request, if anything: its host, origin, method. Nothing is looked at before this.
std::optional<Refusal> check_request(const Gate& gate, const EmptyRequest& request);

/// Whether a request comes from a browser that was let in.
bool has_session(const Gate& gate, const EmptyRequest& request);

/// Of a request that check_request() lets pass and that does not want a WebSocket: a file of the page, a cookie for a token, or
/// a refusal, which is also logged.
Answer answer_request(ServerCore& core, const EmptyRequest& request);

/// A refusal as a page; the connection ends after it.
Answer answer_refusal(Refusal refusal, unsigned version);

}  // namespace lissom
