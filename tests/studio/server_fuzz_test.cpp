// 100,000 frames that no browser sends, and requests that are bent in every way: the server refuses them and goes on.

#include <gtest/gtest.h>
#include <random>

#include "tests/studio/raw_client.h"

namespace lissom {
namespace {

using testing::ask;
using testing::Frame;
using testing::frame_bytes;
using testing::get;
using testing::RawClient;
using testing::TestServer;

class Bytes {
 public:
  explicit Bytes(unsigned seed) : random_(seed) {}
  int below(int end) { return static_cast<int>(random_() % static_cast<unsigned>(end)); }
  std::string some(int most) {
    std::string bytes(static_cast<size_t>(below(most + 1)), '\0');
    for (char& byte : bytes) byte = static_cast<char>(random_());
    return bytes;
  }

 private:
  std::mt19937 random_;
};

/// A frame that is right, or wrong in one of many ways.
std::string odd_frame(Bytes& bytes) {
  switch (bytes.below(12)) {
    case 0:
      return bytes.some(40);  // noise
    case 1:
      return frame_bytes({.payload = bytes.some(20)}, std::nullopt, false);  // without a mask
    case 2:
      return frame_bytes({.opcode = 3 + bytes.below(5)});  // codes that mean nothing
    case 3:
      return frame_bytes({.opcode = testing::kPing, .payload = std::string(126, 'p')});  // a control frame too long
    case 4:
      return frame_bytes({.last = false, .opcode = testing::kPing});  // or in pieces
    case 5:
      return frame_bytes({.opcode = testing::kContinuation, .payload = "x"});  // goes on with nothing
    case 6:
      return frame_bytes({.payload = "\xff\xfe" + bytes.some(8)});  // not UTF-8
    case 7:
      return frame_bytes({}, (uint64_t{1} << 62) + static_cast<uint64_t>(bytes.below(99)));  // longer than everything
    case 8:
      return frame_bytes({.opcode = testing::kClose, .payload = bytes.some(3)});  // odd ends
    case 9: {                                                                     // bits that are reserved
      std::string frame = frame_bytes({.payload = "x"});
      frame[0] = static_cast<char>(frame[0] | (0x10 << bytes.below(3)));
      return frame;
    }
    case 10: {  // one bit turned
      std::string frame = frame_bytes(
          {.last = bytes.below(2) == 0, .payload = std::string(static_cast<size_t>(bytes.below(200)), 'a')});
      frame[static_cast<size_t>(bytes.below(static_cast<int>(frame.size())))] ^= static_cast<char>(1 << bytes.below(8));
      return frame;
    }
    default:
      return frame_bytes({.payload = "good"});
  }
}

TEST(StudioFuzz, HundredThousandFrames) {
  TestServer test;
  const std::string cookie = test.let_in();
  const auto witness = test.open_page(cookie);
  ASSERT_NE(witness, nullptr);
  Bytes bytes(7);
  int frames = 0, connections = 0;
  while (frames < 100000) {
    const auto page = test.open_page(cookie);
    ASSERT_NE(page, nullptr) << "after " << frames;
    ++connections;
    // Most frames end a connection; what was sent behind them has to be harmless too.
    std::string burst;
    const int count = 1 + bytes.below(8);
    for (int i = 0; i < count; ++i) burst += odd_frame(bytes);
    frames += count;
    page->send(burst);
    page->end_sending();
    page->receive_all();
    if (connections % 50 == 0) {
      witness->send(frame_bytes({.payload = "?"}));
      const std::optional<Frame> answer = witness->receive_frame();
      ASSERT_TRUE(answer && answer->payload == "?") << "after " << frames;
    }
  }
  EXPECT_TRUE(test.logs("broken frame"));
  EXPECT_LE(test.log().size(), 20u);
  EXPECT_TRUE(testing::soon([&] { return test.door.pages() == 1; }));
  ::testing::Test::RecordProperty("connections", connections);
}

TEST(StudioFuzz, BentRequests) {
  TestServer test;
  const std::string cookie = test.let_in();
  const std::string good[] = {get(test.port(), "/", cookie), get(test.port(), "/assets/hello.js"),
                              test.upgrade(cookie)};
  Bytes bytes(11);
  for (int i = 0; i < 3000; ++i) {
    std::string request = good[bytes.below(3)];
    for (int turns = 1 + bytes.below(4); turns > 0; --turns) {
      const auto place = static_cast<size_t>(bytes.below(static_cast<int>(request.size())));
      switch (bytes.below(3)) {
        case 0:
          request[place] = static_cast<char>(bytes.below(256));
          break;
        case 1:
          request.erase(place, static_cast<size_t>(1 + bytes.below(20)));
          break;
        default:
          request.insert(place, bytes.some(30));
      }
      if (request.empty()) request = "\n";
    }
    RawClient client(test.port());
    client.send(request);
    client.end_sending();
    client.receive_all();
  }
  EXPECT_TRUE(ask(test.port(), get(test.port(), "/", cookie + "Connection: close\r\n")).ends_with("Hello"));
  EXPECT_LE(test.log().size(), 30u);
}

}  // namespace
}  // namespace lissom
