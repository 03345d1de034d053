// The WebSocket of the studio's server: who gets one, what passes through it, what happens to pages that are slow or hostile.

#include <gtest/gtest.h>
#include <random>

#include "tests/studio/raw_client.h"

namespace lissom {
namespace {

using testing::ask;
using testing::Frame;
using testing::frame_bytes;
using testing::RawClient;
using testing::soon;
using testing::TestServer;
using Kind = StudioMessage::Kind;
using Lane = StudioMessage::Lane;

/// What a page gets back for a text, "" when the connection is over.
std::string echo(RawClient& page, const std::string& text) {
  page.send(frame_bytes({.payload = text}));
  const std::optional<Frame> frame = page.receive_frame();
  return frame ? frame->payload : std::string();
}

/// The code of the frame that ends a connection; what comes before it is passed over. 0 when there is none.
int close_code(RawClient& page) {
  while (const std::optional<Frame> frame = page.receive_frame()) {
    if (frame->opcode != testing::kClose || frame->payload.size() < 2) continue;
    return static_cast<unsigned char>(frame->payload[0]) << 8 | static_cast<unsigned char>(frame->payload[1]);
  }
  return 0;
}

TEST(StudioLive, NeedsTheCookieAndAPageOfOurs) {
  TestServer test;
  const std::string cookie = test.let_in(), good = test.upgrade(cookie);
  const auto replaced = [&](const std::string& what, const std::string& by) {
    std::string request = good;
    return request.replace(request.find(what), what.size(), by);
  };
  const std::string ours = "http://" + testing::host_of(test.port());
  EXPECT_TRUE(ask(test.port(), test.upgrade("")).starts_with("HTTP/1.1 403"));
  EXPECT_TRUE(ask(test.port(), replaced(cookie, "Cookie: lissom=1\r\n")).starts_with("HTTP/1.1 403"));
  EXPECT_TRUE(ask(test.port(), replaced("Origin: " + ours + "\r\n", "")).starts_with("HTTP/1.1 403"));
  EXPECT_TRUE(ask(test.port(), replaced("Origin: " + ours, "Origin: http://evil.com")).starts_with("HTTP/1.1 403"));
  EXPECT_TRUE(ask(test.port(), replaced("Host: " + ours.substr(7), "Host: evil.com")).starts_with("HTTP/1.1 421"));
  EXPECT_TRUE(ask(test.port(), replaced("/live", "/")).starts_with("HTTP/1.1 404"));
  EXPECT_EQ(test.door.pages(), 0);
  RawClient page(test.port());
  page.send(good);
  const std::string header = page.receive_header();
  EXPECT_TRUE(header.starts_with("HTTP/1.1 101"));
  EXPECT_NE(header.find("s3pPLMBiTxaQ9kYGzzhZRbK+xOo="), std::string::npos);  // of the key in RFC 6455, 1.3
  EXPECT_EQ(header.find("permessage-deflate"), std::string::npos);
  EXPECT_EQ(echo(page, "{}"), "{}");
  EXPECT_EQ(test.door.pages(), 1);
}

TEST(StudioLive, CarriesMessagesOfAllSizesWhole) {
  TestServer test;
  const auto page = test.open_page(test.let_in());
  ASSERT_NE(page, nullptr);
  for (const size_t size : {0, 1, 125, 126, 65535, 65536, 1000000, 8 << 20}) {
    const std::string text(size, 'a');
    page->send(frame_bytes({.payload = text}));
    const std::optional<Frame> frame = page->receive_frame();
    ASSERT_TRUE(frame.has_value()) << size;
    EXPECT_EQ(frame->opcode, testing::kText);
    EXPECT_EQ(frame->payload, text);
  }
  page->send(frame_bytes({.payload = "pack 240000"}));
  const std::optional<Frame> pack = page->receive_frame();
  ASSERT_TRUE(pack.has_value());
  EXPECT_EQ(pack->opcode, testing::kBinary);
  EXPECT_EQ(pack->payload, std::string(240000, 'p'));
  // In pieces, with a ping in between.
  page->send(frame_bytes({.last = false, .payload = "ab"}) + frame_bytes({.opcode = testing::kPing, .payload = "?"}) +
             frame_bytes({.last = false, .opcode = testing::kContinuation, .payload = "cd"}) +
             frame_bytes({.opcode = testing::kContinuation, .payload = "ef"}));
  const std::optional<Frame> pong = page->receive_frame(), whole = page->receive_frame();
  ASSERT_TRUE(pong.has_value() && whole.has_value());
  EXPECT_EQ(pong->opcode, testing::kPong);
  EXPECT_EQ(whole->payload, "abcdef");
}

TEST(StudioLive, RefusesLongAndBinaryMessages) {
  TestServer test;
  const std::string cookie = test.let_in();
  const auto hundred_megabytes = test.open_page(cookie), pieces = test.open_page(cookie),
             binary = test.open_page(cookie);
  ASSERT_TRUE(hundred_megabytes && pieces && binary);
  hundred_megabytes->send(frame_bytes({}, 100000000));
  EXPECT_EQ(close_code(*hundred_megabytes), 1009);
  const std::string piece(size_t{3} << 20, 'x');
  pieces->send(frame_bytes({.last = false, .payload = piece}));
  for (int i = 0; i < 2; ++i)
    pieces->send(frame_bytes({.last = false, .opcode = testing::kContinuation, .payload = piece}));
  EXPECT_EQ(close_code(*pieces), 1009);
  binary->send(frame_bytes({.opcode = testing::kBinary, .payload = "x"}));
  EXPECT_EQ(close_code(*binary), 1003);
  EXPECT_TRUE(test.logs("too long or binary"));
  EXPECT_EQ(test.door.received(), 0);
  EXPECT_TRUE(soon([&] { return test.door.pages() == 0; }));
}

TEST(StudioLive, TellsAllPagesAndLetsThemGo) {
  TestServer test;
  const std::string cookie = test.let_in();
  auto a = test.open_page(cookie), b = test.open_page(cookie);
  ASSERT_TRUE(a && b && soon([&] { return test.door.pages() == 2; }));
  test.door.tell_all({std::make_shared<const std::string>("news")});
  EXPECT_EQ(a->receive_frame()->payload, "news");
  EXPECT_EQ(b->receive_frame()->payload, "news");
  a.reset();
  EXPECT_TRUE(soon([&] { return test.door.pages() == 1; }));
  b->send(frame_bytes({.opcode = testing::kClose, .payload = {"\x03\xe8", 2}}));
  EXPECT_EQ(close_code(*b), 1000);
  EXPECT_TRUE(soon([&] { return test.door.pages() == 0; }));
  EXPECT_EQ(echo(*test.open_page(cookie), "again"), "again");
}

TEST(StudioLive, ThereAreSoManyPagesAndNoMore) {
  StudioServerOptions options;
  options.pages = 3;
  TestServer test(options);
  const std::string cookie = test.let_in();
  std::vector<std::unique_ptr<RawClient>> pages;
  for (int i = 0; i < 3; ++i) pages.push_back(test.open_page(cookie));
  EXPECT_TRUE(ask(test.port(), test.upgrade(cookie)).starts_with("HTTP/1.1 503"));
  pages.pop_back();
  ASSERT_TRUE(soon([&] { return test.door.pages() == 2; }));
  EXPECT_NE(test.open_page(cookie), nullptr);
}

TEST(StudioLive, SlowPagesGetTheNewestShapeAndEverythingInOrder) {
  TestServer test;
  const auto page = test.open_page(test.let_in(), 4096);
  ASSERT_TRUE(page && soon([&] { return test.door.pages() == 1; }));
  // Far more than the system's buffers hold, while the page reads nothing.
  constexpr int kCount = 400;
  for (int i = 0; i < kCount; ++i) {
    const std::string number = std::to_string(i);
    test.door.tell_all(
        {std::make_shared<const std::string>(number + std::string(240000, ' ')), Kind::kPack, Lane::kShape});
    test.door.tell_all({std::make_shared<const std::string>("o" + number)});
  }
  int shapes = 0, ordered = 0, newest = -1;
  while (ordered < kCount || newest < kCount - 1) {
    const std::optional<Frame> frame = page->receive_frame();
    ASSERT_TRUE(frame.has_value());
    if (frame->opcode == testing::kText) {
      EXPECT_EQ(frame->payload, "o" + std::to_string(ordered++));
    } else {
      const int number = std::stoi(frame->payload);
      EXPECT_GT(number, newest);
      newest = number;
      ++shapes;
    }
  }
  EXPECT_EQ(newest, kCount - 1);
  EXPECT_LT(shapes, kCount / 2);
}

TEST(StudioLive, PagesThatFallFarBehindAreClosed) {
  StudioServerOptions options;
  options.waiting_bytes = 1 << 20;
  TestServer test(options);
  const std::string cookie = test.let_in();
  const auto stuck = test.open_page(cookie, 4096), lively = test.open_page(cookie);
  ASSERT_TRUE(stuck && lively && soon([&] { return test.door.pages() == 2; }));
  const auto megabyte = std::make_shared<const std::string>(size_t{1} << 20, 'x');
  for (int i = 0; i < 40; ++i) {
    test.door.tell_all({megabyte});
    ASSERT_TRUE(lively->receive_frame().has_value());
  }
  EXPECT_TRUE(test.logs("too slow"));
  EXPECT_TRUE(soon([&] { return test.door.pages() == 1; }));
  EXPECT_EQ(echo(*lively, "here"), "here");
}

TEST(StudioLive, PagesThatDoNotAnswerPingsAreClosed) {
  StudioServerOptions options;
  options.idle_time = std::chrono::milliseconds(200);
  TestServer test(options);
  const auto page = test.open_page(test.let_in());
  ASSERT_TRUE(page && soon([&] { return test.door.pages() == 1; }));
  EXPECT_EQ(page->receive_frame()->opcode, testing::kPing);
  EXPECT_TRUE(soon([&] { return test.door.pages() == 0; }));
  EXPECT_TRUE(test.logs("too slow"));
}

TEST(StudioLive, WhatBreaksOnePageLeavesTheOthers) {
  TestServer test;
  const std::string cookie = test.let_in();
  const auto broken = test.open_page(cookie), other = test.open_page(cookie);
  ASSERT_TRUE(broken && other && soon([&] { return test.door.pages() == 2; }));
  broken->send(frame_bytes({.payload = "throw"}));
  EXPECT_TRUE(test.logs("the door broke"));
  EXPECT_TRUE(soon([&] { return test.door.pages() == 1; }));
  EXPECT_EQ(echo(*other, "here"), "here");
}

TEST(StudioLive, EndsWithAllItsPages) {
  TestServer test;
  const std::string cookie = test.let_in();
  const auto good = test.open_page(cookie), stuck = test.open_page(cookie, 4096);
  ASSERT_TRUE(good && stuck && soon([&] { return test.door.pages() == 2; }));
  for (int i = 0; i < 20; ++i)
    test.door.tell_all({std::make_shared<const std::string>(size_t{1} << 20, 'x'), Kind::kPack, Lane::kPreview});
  RawClient idle(test.port());
  std::thread reader([&] { EXPECT_EQ(close_code(*good), 1001); });
  const auto start = std::chrono::steady_clock::now();
  test.server->stop();
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
  EXPECT_EQ(test.door.pages(), 0);
  test.door.tell_all({std::make_shared<const std::string>("late")});
  reader.join();
}

}  // namespace
}  // namespace lissom
