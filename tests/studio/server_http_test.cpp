// What the studio's server answers over HTTP: the page to browsers that were let in, refusals to everybody else.

#include <gtest/gtest.h>

#include "tests/studio/raw_client.h"

namespace lissom {
namespace {

using testing::ask;
using testing::get;
using testing::host_of;
using testing::RawClient;
using testing::TestServer;

const std::string kLast = "Connection: close\r\n";

bool has(const std::string& answer, const std::string& words) { return answer.find(words) != std::string::npos; }

std::string status(const std::string& answer) { return answer.substr(0, 12); }

TEST(StudioHttp, OneTokenLetsOneBrowserIn) {
  TestServer test;
  const std::string address = test.server->new_address();
  EXPECT_TRUE(address.starts_with("http://" + host_of(test.port()) + "/?token="));
  const std::string path = address.substr(address.find("/?"));
  // Looking at the address does not use it up.
  EXPECT_EQ(status(ask(test.port(), "HEAD" + get(test.port(), path, kLast).substr(3))), "HTTP/1.1 403");
  const std::string first = ask(test.port(), get(test.port(), path, kLast));
  EXPECT_EQ(status(first), "HTTP/1.1 303");
  EXPECT_TRUE(has(first, "\r\nLocation: /\r\n"));
  EXPECT_TRUE(has(first, "; Path=/; HttpOnly; SameSite=Strict\r\n"));
  EXPECT_EQ(status(ask(test.port(), get(test.port(), path, kLast))), "HTTP/1.1 403");
  // Another address for another browser; a browser that is in may use any address again.
  const std::string cookie = test.let_in();
  ASSERT_FALSE(cookie.empty());
  EXPECT_EQ(status(ask(test.port(), get(test.port(), path, cookie + kLast))), "HTTP/1.1 303");
  EXPECT_EQ(status(ask(test.port(), get(test.port(), "/", cookie + kLast))), "HTTP/1.1 200");
}

TEST(StudioHttp, PoliciesStandOnEveryAnswer) {
  TestServer test;
  const std::string cookie = test.let_in();
  for (const std::string& request :
       {get(test.port(), "/", cookie + kLast), get(test.port(), "/"), get(test.port(), "/absent", cookie + kLast)}) {
    const std::string answer = ask(test.port(), request);
    EXPECT_TRUE(
        has(answer, "Content-Security-Policy: default-src 'self'; img-src 'self' data: blob:; connect-src 'self'"));
    EXPECT_FALSE(has(answer, "unsafe"));
    for (const char* policy :
         {"X-Content-Type-Options: nosniff", "Referrer-Policy: no-referrer", "X-Frame-Options: DENY",
          "Cross-Origin-Opener-Policy: same-origin", "Cross-Origin-Resource-Policy: same-origin"}) {
      EXPECT_TRUE(has(answer, policy)) << policy;
    }
  }
}

TEST(StudioHttp, ServesFilesCompressedOrNotAndOnlyWhenTheyAreNew) {
  TestServer test;
  const std::string cookie = test.let_in();
  const std::string plain = ask(test.port(), get(test.port(), "/", cookie + kLast));
  EXPECT_TRUE(plain.ends_with("\r\n\r\nHello"));
  EXPECT_TRUE(has(plain, "Cache-Control: private, no-cache\r\n"));
  const std::string refused =
      ask(test.port(), get(test.port(), "/", cookie + kLast + "Accept-Encoding: gzip;q=0, br\r\n"));
  EXPECT_TRUE(refused.ends_with("\r\n\r\nHello"));
  const std::string packed =
      ask(test.port(), get(test.port(), "/assets/hello.js", cookie + kLast + "Accept-Encoding: br, gzip;q=0.5\r\n"));
  EXPECT_TRUE(has(packed, "Content-Encoding: gzip\r\n"));
  EXPECT_TRUE(has(packed, "Content-Length: 25\r\n"));
  EXPECT_TRUE(has(packed, "immutable"));
  EXPECT_TRUE(has(packed, "Content-Type: text/javascript; charset=utf-8\r\n"));
  const std::string known =
      ask(test.port(), get(test.port(), "/", cookie + kLast + "If-None-Match: \"x\", \"0123456789abcdef\"\r\n"));
  EXPECT_EQ(status(known), "HTTP/1.1 304");
  const std::string head = ask(test.port(), "HEAD" + get(test.port(), "/", cookie + kLast).substr(3));
  EXPECT_EQ(status(head), "HTTP/1.1 200");
  EXPECT_TRUE(has(head, "Content-Length: 5\r\n"));
  EXPECT_TRUE(head.ends_with("\r\n\r\n"));
}

TEST(StudioHttp, RefusesStrangersWithAPageThatSaysWhatToDo) {
  TestServer test;
  const std::string cookie = test.let_in();
  const std::string host = "Host: " + host_of(test.port()) + "\r\n";
  struct Case {
    std::string request, status, log;
  };
  const Case cases[] = {
      {get(test.port(), "/"), "403", "without token and cookie"},
      {get(test.port(), "/assets/hello.js"), "403", "without token and cookie"},
      {get(test.port(), "/?token=" + std::string(32, 'a')), "403", "wrong or used token"},
      {get(test.port(), "/?token="), "403", "wrong or used token"},
      {"GET / HTTP/1.1\r\nHost: evil.com\r\n" + cookie + "\r\n", "421", "another host"},
      {"GET / HTTP/1.1\r\n" + cookie + "\r\n", "421", "another host"},
      {"GET / HTTP/1.1\r\n" + host + "Host: evil.com\r\n" + cookie + "\r\n", "421", "another host"},
      {"GET http://evil.com/ HTTP/1.1\r\n" + host + cookie + "\r\n", "404", "path that is not there"},
      {get(test.port(), "/", cookie + "Origin: http://evil.com\r\n"), "403", "page from elsewhere"},
      {get(test.port(), "/", cookie + "Origin: null\r\n"), "403", "page from elsewhere"},
      {get(test.port(), "/../../etc/passwd", cookie), "404", "path that is not there"},
      {get(test.port(), "/..%2f..%2fetc/passwd", cookie), "404", "path that is not there"},
      {get(test.port(), "//etc/passwd", cookie), "404", "path that is not there"},
      {get(test.port(), "/assets", cookie), "404", "path that is not there"},
      {get(test.port(), "/live", cookie), "426", "/live without a WebSocket"},
      {"POST / HTTP/1.1\r\n" + host + cookie + "Content-Length: 5\r\n\r\nhello", "405", "method other than"},
      {"DELETE / HTTP/1.1\r\n" + host + cookie + "\r\n", "405", "method other than"},
      {"GET / HTTP/1.1\r\n" + host + cookie + "Content-Length: 5\r\n\r\nhello", "400", "not a request"},
      {"GET / HTTP/9.9\r\n" + host + "\r\n", "400", "not a request"},
      {"\x16\x03\x01\x02rubbish\r\n\r\n", "400", "not a request"},
      {get(test.port(), "/" + std::string(20000, 'x')), "431", "header that is too long"},
  };
  for (const Case& c : cases) {
    const std::string answer = ask(test.port(), c.request);
    EXPECT_EQ(status(answer), "HTTP/1.1 " + c.status) << c.request.substr(0, 200);
    EXPECT_TRUE(has(answer, "Connection: close\r\n"));
    EXPECT_TRUE(has(answer, "<h1>"));
    EXPECT_FALSE(has(answer, "Hello"));
    EXPECT_TRUE(test.logs(c.log)) << c.log;
  }
  // Nine kinds, each said once, however often it happens.
  for (int i = 0; i < 50; ++i) ask(test.port(), get(test.port(), "/absent", cookie));
  EXPECT_EQ(test.log().size(), 9u);
}

TEST(StudioHttp, KeepsConnectionsForMoreThanOneRequest) {
  TestServer test;
  const std::string cookie = test.let_in();
  RawClient client(test.port());
  for (int i = 0; i < 3; ++i) {
    client.send("HEAD" + get(test.port(), "/", cookie).substr(3));
    EXPECT_EQ(status(client.receive_header()), "HTTP/1.1 200");
  }
}

TEST(StudioHttp, RefusesAHundredMegabytesWithoutTakingThem) {
  TestServer test;
  const std::string cookie = test.let_in();
  RawClient client(test.port());
  client.send("POST / HTTP/1.1\r\nHost: " + host_of(test.port()) + "\r\n" + cookie +
              "Content-Length: 100000000\r\n\r\n");
  EXPECT_EQ(status(client.receive_header()), "HTTP/1.1 405");
  const std::string piece(1000000, 'x');
  int sent = 0;
  while (sent < 100 && client.send(piece)) ++sent;
  EXPECT_EQ(status(ask(test.port(), get(test.port(), "/", cookie + kLast))), "HTTP/1.1 200");
}

TEST(StudioHttp, ThousandConnectionsDoNotKeepOthersOut) {
  TestServer test;
  const std::string cookie = test.let_in();
  const std::unique_ptr<RawClient> page = test.open_page(cookie);
  ASSERT_NE(page, nullptr);
  std::vector<std::unique_ptr<RawClient>> crowd;
  for (int i = 0; i < 1000; ++i) crowd.push_back(std::make_unique<RawClient>(test.port()));
  EXPECT_EQ(status(ask(test.port(), get(test.port(), "/", cookie + kLast))), "HTTP/1.1 200");
  page->send(testing::frame_bytes({.payload = "still here"}));
  const std::optional<testing::Frame> echo = page->receive_frame();
  ASSERT_TRUE(echo.has_value());
  EXPECT_EQ(echo->payload, "still here");
  EXPECT_TRUE(test.logs("too many connections"));
  EXPECT_LE(test.log().size(), 2u);
}

TEST(StudioHttp, ForgetsThoseWhoAskTooSlowly) {
  StudioServerOptions options;
  options.request_time = std::chrono::milliseconds(100);
  TestServer test(options);
  RawClient client(test.port());
  client.send("GET / HTTP/1.1\r\nHo");
  EXPECT_EQ(client.receive_all(), "");
  EXPECT_TRUE(test.logs("too slow"));
}

TEST(StudioHttp, PortsThatAreTakenAreAnErrorWithAWayOut) {
  TestServer test;
  testing::FakeDoor door;
  StudioServerOptions options;
  options.port = test.port();
  const Result<std::unique_ptr<StudioServer>> second = StudioServer::start(door, testing::test_page(), options);
  ASSERT_FALSE(second.ok());
  EXPECT_EQ(second.error().where, "--port");
  EXPECT_FALSE(second.error().hint.empty());
}

}  // namespace
}  // namespace lissom
