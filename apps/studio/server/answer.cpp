#include "apps/studio/server/answer.h"

#include <string>
#include <string_view>

namespace lissom {

namespace {

namespace http = boost::beast::http;

std::string_view view(boost::beast::string_view text) { return {text.data(), text.size()}; }
boost::beast::string_view beast_view(std::string_view text) { return {text.data(), text.size()}; }

std::string_view header(const EmptyRequest& request, http::field name) { return view(request[name]); }

/// The value of "token" in "/?token=VALUE"; nothing of other targets.
std::optional<std::string_view> token_of(std::string_view target) {
  constexpr std::string_view kStart = "/?token=";
  if (!target.starts_with(kStart)) return std::nullopt;
  target.remove_prefix(kStart.size());
  return target.substr(0, target.find('&'));
}

/// Headers of every answer: nothing from elsewhere may be loaded, nothing of ours is shown or read elsewhere.
void add_policies(Answer& answer, std::string_view host) {
  // Not every browser counts a WebSocket of the same server as 'self'.
  const std::string live = host.empty() ? std::string() : " ws://" + std::string(host);
  answer.set("Content-Security-Policy",
             "default-src 'self'; img-src 'self' data: blob:; connect-src 'self'" + live +
                 "; object-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'");
  answer.set("X-Content-Type-Options", "nosniff");
  answer.set("X-Frame-Options", "DENY");
  answer.set("Referrer-Policy", "no-referrer");
  answer.set("Cross-Origin-Opener-Policy", "same-origin");
  answer.set("Cross-Origin-Embedder-Policy", "require-corp");
  answer.set("Cross-Origin-Resource-Policy", "same-origin");
  answer.set("Permissions-Policy", "camera=(), geolocation=(), microphone=()");
}

/// Whether the header Accept-Encoding lets gzip in. A weight of 0 forbids it (RFC 9110, 12.5.3).
bool accepts_gzip(std::string_view accepted) {
  while (!accepted.empty()) {
    const size_t end = std::min(accepted.find(','), accepted.size());
    std::string_view coding = accepted.substr(0, end);
    accepted.remove_prefix(std::min(end + 1, accepted.size()));
    while (coding.starts_with(' ')) coding.remove_prefix(1);
    const std::string_view name = coding.substr(0, coding.find_first_of("; "));
    if (name != "gzip" && name != "*") continue;
    const size_t weight = coding.find("q=");
    return weight == std::string_view::npos || coding.find_first_of("123456789", weight) != std::string_view::npos;
  }
  return false;
}

Answer file_answer(const PageFile& file, const EmptyRequest& request) {
  Answer answer(http::status::ok, request.version());
  const std::string tag = "\"" + std::string(file.tag) + "\"";
  answer.set(http::field::etag, tag);
  answer.set(http::field::vary, "Accept-Encoding");
  answer.set(http::field::cache_control,
             never_changes(file) ? "private, max-age=31536000, immutable" : "private, no-cache");
  if (header(request, http::field::if_none_match).find(tag) != std::string_view::npos) {
    answer.result(http::status::not_modified);
    return answer;
  }
  answer.set(http::field::content_type, beast_view(file.type));
  if (accepts_gzip(header(request, http::field::accept_encoding))) {
    answer.set(http::field::content_encoding, "gzip");
    answer.body().assign(reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size());
  } else {
    answer.body() = decompress(file);
  }
  return answer;
}

/// Sends a browser that was let in to the page, whose address does not tell how.
Answer welcome(const Gate& gate, const EmptyRequest& request, bool new_browser) {
  Answer answer(http::status::see_other, request.version());
  answer.set(http::field::location, "/");
  answer.set(http::field::cache_control, "no-store");
  if (new_browser) answer.set(http::field::set_cookie, gate.session_cookie());
  return answer;
}

Answer page_answer(ServerCore& core, const EmptyRequest& request, std::optional<Refusal>& refused) {
  const bool known = has_session(core.gate, request);
  if (const auto token = token_of(view(request.target()))) {
    // HEAD only looks: programs that preview addresses must not use them up.
    const bool good = known || (request.method() == http::verb::get && core.gate.use_token(*token));
    if (good) return welcome(core.gate, request, !known);
    refused = Refusal::kToken;
  } else if (!known) {
    refused = Refusal::kSession;
  } else if (request.target() == "/live") {
    refused = Refusal::kUpgrade;
  } else if (const PageFile* file = find_file(core.page, view(request.target()))) {
    return file_answer(*file, request);
  } else {
    refused = Refusal::kPath;
  }
  return {};
}

}  // namespace

std::optional<Refusal> check_request(const Gate& gate, const EmptyRequest& request) {
  const std::string_view host = header(request, http::field::host);
  if (request.count(http::field::host) != 1 || !gate.host_is_ours(host)) return Refusal::kHost;
  const bool has_origin = request.count(http::field::origin) > 0;
  if (has_origin && !gate.origin_is_ours(header(request, http::field::origin), host)) return Refusal::kOrigin;
  if (request.method() != http::verb::get && request.method() != http::verb::head) return Refusal::kMethod;
  return std::nullopt;
}

bool has_session(const Gate& gate, const EmptyRequest& request) {
  return gate.session_is_ours(header(request, http::field::cookie));
}

Answer answer_request(ServerCore& core, const EmptyRequest& request) {
  std::optional<Refusal> refused;
  Answer answer = page_answer(core, request, refused);
  if (refused) {
    core.refusals.add(*refused);
    answer = answer_refusal(*refused, request.version());
  }
  add_policies(answer, header(request, http::field::host));
  // The length of what GET would send.
  answer.prepare_payload();
  if (request.method() == http::verb::head) {
    const std::string length(view(answer[http::field::content_length]));
    answer.body().clear();
    if (!length.empty()) answer.set(http::field::content_length, length);
  }
  answer.keep_alive(!refused && request.keep_alive());
  return answer;
}

Answer answer_refusal(Refusal refusal, unsigned version) {
  Answer answer(static_cast<http::status>(refusal_info(refusal).status), version);
  answer.set(http::field::content_type, "text/html; charset=utf-8");
  answer.set(http::field::cache_control, "no-store");
  if (refusal == Refusal::kMethod) answer.set(http::field::allow, "GET, HEAD");
  if (refusal == Refusal::kUpgrade) answer.set(http::field::upgrade, "websocket");
  add_policies(answer, {});
  answer.body() = refusal_page(refusal);
  answer.prepare_payload();
  answer.keep_alive(false);
  return answer;
}

}  // namespace lissom
