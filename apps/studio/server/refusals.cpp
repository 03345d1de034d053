#include "apps/studio/server/refusals.h"

#include <fmt/format.h>
#include <utility>

namespace lissom {

namespace {

constexpr std::chrono::seconds kPause{10};

constexpr RefusalInfo kInfo[] = {
    {421, "a request for another host", "This is not the studio's address",
     "The studio answers at 127.0.0.1 and localhost, with its own port, only. Open the address that "
     "<code>lissom studio</code> printed."},
    {403, "a request of a page from elsewhere", "This page may not talk to the studio",
     "Only pages that the studio has served itself may. Open the address that <code>lissom studio</code> printed."},
    {403, "a wrong or used token", "This address has been used, or never was one",
     "Each address that the studio prints lets one browser in, once. Press Enter in the terminal in which "
     "<code>lissom studio</code> runs, or start it again, and open the address that it prints then."},
    {403, "a request without token and cookie", "The studio does not know this browser",
     "Open the address that <code>lissom studio</code> printed; its last part, the token, lets a browser in. If a link "
     "on another page brought you here and this browser was in before, <a href=\"/\">go on</a>."},
    {404, "a path that is not there", "There is no such page", "The studio has one page: <a href=\"/\">here</a>."},
    {405, "a method other than GET and HEAD", "The studio's pages can only be read", "Use GET or HEAD."},
    {426, "/live without a WebSocket", "This is where the page talks to the engine", "Use a WebSocket."},
    {400, "something that is not a request", "This is not a request that the studio understands",
     "Use HTTP/1.1 without a body."},
    {431, "a header that is too long", "This request is too long", "Delete the cookies of 127.0.0.1 and try again."},
    {0, "a connection that was too slow", "", ""},
    {503, "too many connections", "Too many pages are open", "Close some of them and try again."},
    {0, "a message that is too long or binary", "", ""},
    {0, "a broken frame", "", ""},
};
static_assert(std::size(kInfo) == kRefusals);

}  // namespace

const RefusalInfo& refusal_info(Refusal refusal) { return kInfo[static_cast<size_t>(refusal)]; }

std::string refusal_page(Refusal refusal) {
  const RefusalInfo& info = refusal_info(refusal);
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<title>{0}</title>\n<h1>{0}</h1>\n<p>{1}</p>\n",
      info.title, info.remedy);
}

RefusalLog::RefusalLog(std::function<void(const std::string&)> log) : log_(std::move(log)) {}

void RefusalLog::add(Refusal refusal, Clock::time_point now) {
  const auto index = static_cast<size_t>(refusal);
  Kind& kind = kinds_[index];
  ++kind.count;
  if (kind.logged > 0 && now - kind.last < kPause) return;
  kind.last = now;
  write(index);
}

void RefusalLog::flush() {
  for (size_t i = 0; i < kinds_.size(); ++i) {
    if (kinds_[i].count > kinds_[i].logged) write(i);
  }
}

void RefusalLog::write(size_t index) {
  Kind& kind = kinds_[index];
  const int more = kind.count - kind.logged;
  kind.logged = kind.count;
  if (!log_) return;
  const std::string text = "refused: " + std::string(kInfo[index].log);
  log_(more == 1 ? text : fmt::format("{} ({} times, {} in all)", text, more, kind.count));
}

}  // namespace lissom
