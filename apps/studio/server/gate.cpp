#include "apps/studio/server/gate.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <sys/random.h>
#include <utility>

#include "lissom/core/assert.h"

namespace lissom {

namespace {

constexpr size_t kTokens = 16;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool same_text(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) { return lower(x) == lower(y); });
}

}  // namespace

std::string random_secret() {
  std::array<unsigned char, 16> bytes{};
  const int status = getentropy(bytes.data(), bytes.size());
  LISSOM_ASSERT(status == 0);  // fails only for too many bytes or on systems that have no such call
  std::string text;
  for (const unsigned char byte : bytes) text += fmt::format("{:02x}", byte);
  return text;
}

bool same_secret(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned difference = 0;
  for (size_t i = 0; i < a.size(); ++i) difference |= static_cast<unsigned char>(a[i] ^ b[i]);
  return difference == 0;
}

Gate::Gate(unsigned short port, std::string session)
    : port_(std::to_string(port)), cookie_name_("lissom_" + port_), session_(std::move(session)) {}

std::string Gate::new_token() {
  const std::lock_guard lock(mutex_);
  if (tokens_.size() == kTokens) tokens_.pop_front();
  return tokens_.emplace_back(random_secret());
}

bool Gate::use_token(std::string_view token) {
  const std::lock_guard lock(mutex_);
  const auto found =
      std::find_if(tokens_.begin(), tokens_.end(), [&](const std::string& t) { return same_secret(t, token); });
  if (found == tokens_.end()) return false;
  tokens_.erase(found);
  return true;
}

bool Gate::host_is_ours(std::string_view host) const {
  const std::string end = ":" + port_;
  if (!host.ends_with(end)) return false;
  const std::string_view name = host.substr(0, host.size() - end.size());
  return name == "127.0.0.1" || name == "[::1]" || same_text(name, "localhost");
}

bool Gate::origin_is_ours(std::string_view origin, std::string_view host) const {
  return host_is_ours(host) && same_text(origin, "http://" + std::string(host));
}

bool Gate::session_is_ours(std::string_view cookies) const {
  while (!cookies.empty()) {
    const size_t end = std::min(cookies.find(';'), cookies.size());
    std::string_view cookie = cookies.substr(0, end);
    cookies.remove_prefix(std::min(end + 1, cookies.size()));
    while (cookie.starts_with(' ')) cookie.remove_prefix(1);
    const size_t equals = cookie.find('=');
    if (equals == std::string_view::npos || cookie.substr(0, equals) != cookie_name_) continue;
    if (same_secret(cookie.substr(equals + 1), session_)) return true;
  }
  return false;
}

std::string Gate::session_cookie() const {
  return cookie_name_ + "=" + session_ + "; Path=/; HttpOnly; SameSite=Strict";
}

}  // namespace lissom
