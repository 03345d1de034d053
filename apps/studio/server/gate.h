#pragma once
/// Who may talk to the studio's server: only browsers of whoever started it. Any page in any browser of this machine, and any
/// program of any user, can reach a port on the loopback; docs/decisions/0018-studio-server.md says how they are told apart.

#include <deque>
#include <mutex>
#include <string>
#include <string_view>

namespace lissom {

/// 128 bits from the system's source of randomness, as 32 hexadecimal digits.
std::string random_secret();

/// Whether two secrets are equal; the time it takes says nothing about where they differ.
bool same_secret(std::string_view a, std::string_view b);

/// Host, origin, token and session of requests. May be used from several threads.
class Gate {
 public:
  /// `session`: the secret that browsers show once they are let in.
  Gate(unsigned short port, std::string session);

  /// A token that lets one browser in. Of those that nobody has used the newest 16 are good.
  std::string new_token();
  /// Whether a token is good; from then on it is not.
  bool use_token(std::string_view token);

  /// Of the header Host: an address of this server. Keeps out pages of others whose name is made to lead here.
  bool host_is_ours(std::string_view host) const;
  /// Of the header Origin: a page of the server at `host`.
  bool origin_is_ours(std::string_view origin, std::string_view host) const;
  /// Of the header Cookie.
  bool session_is_ours(std::string_view cookies) const;
  /// Value of the header Set-Cookie for a browser that is let in.
  std::string session_cookie() const;

 private:
  std::string port_, cookie_name_, session_;
  std::mutex mutex_;
  std::deque<std::string> tokens_;
};

}  // namespace lissom
