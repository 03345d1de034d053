// The parts of the studio's server that need no network: who is let in, what waits, what is logged.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "apps/studio/server/crowd.h"
#include "apps/studio/server/gate.h"
#include "apps/studio/server/kept_session.h"
#include "apps/studio/server/outbox.h"
#include "apps/studio/server/page.h"
#include "apps/studio/server/refusals.h"
#include "tests/studio/raw_client.h"

namespace lissom {
namespace {

using Lane = StudioMessage::Lane;

TEST(Gate, KnowsItsOwnHostsOnly) {
  const Gate gate(8080, "s");
  for (const char* host : {"127.0.0.1:8080", "localhost:8080", "LocalHost:8080", "[::1]:8080"}) {
    EXPECT_TRUE(gate.host_is_ours(host)) << host;
    EXPECT_TRUE(gate.origin_is_ours(std::string("http://") + host, host)) << host;
  }
  for (const char* host :
       {"", ":8080", "127.0.0.1", "127.0.0.1:80", "127.0.0.1:18080", "evil.com:8080", "127.0.0.1.evil.com:8080",
        "evil.com?127.0.0.1:8080", "127.0.0.2:8080", "localhost.:8080", "127.0.0.1:8080 ", "user@localhost:8080"}) {
    EXPECT_FALSE(gate.host_is_ours(host)) << host;
  }
  for (const char* origin :
       {"", "null", "http://evil.com", "https://127.0.0.1:8080", "http://127.0.0.1:8081", "http://localhost:8080",
        "http://127.0.0.1:8080/", "http://127.0.0.1:8080.evil.com", "file://"}) {
    EXPECT_FALSE(gate.origin_is_ours(origin, "127.0.0.1:8080")) << origin;
  }
}

TEST(Gate, TokensOpenOnceAndTheOldestAreForgotten) {
  Gate gate(8080, "s");
  const std::string first = gate.new_token();
  EXPECT_EQ(first.size(), 32u);
  EXPECT_FALSE(gate.use_token(""));
  EXPECT_FALSE(gate.use_token(first.substr(1)));
  EXPECT_FALSE(gate.use_token(std::string(32, '0')));
  EXPECT_TRUE(gate.use_token(first));
  EXPECT_FALSE(gate.use_token(first));
  const std::string old = gate.new_token(), next = gate.new_token();
  for (int i = 0; i < 15; ++i) EXPECT_NE(gate.new_token(), next);
  EXPECT_FALSE(gate.use_token(old));
  EXPECT_TRUE(gate.use_token(next));
}

TEST(Gate, FindsItsCookieAmongOthers) {
  const Gate gate(8080, "0123");
  EXPECT_EQ(gate.session_cookie(), "lissom_8080=0123; Path=/; HttpOnly; SameSite=Strict");
  for (const char* cookies :
       {"lissom_8080=0123", "a=b; lissom_8080=0123", "lissom_8080=0123; c=d", "lissom_8080=9; lissom_8080=0123"}) {
    EXPECT_TRUE(gate.session_is_ours(cookies)) << cookies;
  }
  for (const char* cookies : {"", ";", "lissom_8080", "lissom_8080=", "lissom_8080=012", "lissom_8080=01234",
                              "lissom_8081=0123", "xlissom_8080=0123", "0123", "a=lissom_8080=0123"}) {
    EXPECT_FALSE(gate.session_is_ours(cookies)) << cookies;
  }
}

TEST(Page, OpensNamesAndNothingElse) {
  const Page page = testing::test_page();
  ASSERT_NE(find_file(page, "/"), nullptr);
  EXPECT_EQ(find_file(page, "/")->path, "/index.html");
  EXPECT_EQ(find_file(page, "/assets/hello.js?x=/../y")->path, "/assets/hello.js");
  for (const char* path :
       {"", "index.html", "//index.html", "/assets", "/assets/", "/assets/../index.html", "/./index.html",
        "/%69ndex.html", "/../../etc/passwd", "/index.html/", "/INDEX.HTML", "http://x/index.html"}) {
    EXPECT_EQ(find_file(page, path), nullptr) << path;
  }
  EXPECT_EQ(decompress(page[0]), "Hello");
  PageFile damaged = page[0];
  damaged.bytes = damaged.bytes.first(15);
  EXPECT_EQ(decompress(damaged), "");
}

TEST(RefusalLog, SaysEachKindOnceAndThenHowOften) {
  std::vector<std::string> lines;
  RefusalLog log([&](const std::string& line) { lines.push_back(line); });
  const RefusalLog::Clock::time_point start{};
  for (int i = 0; i < 1000; ++i) log.add(Refusal::kHost, start + std::chrono::milliseconds(i));
  log.add(Refusal::kPath, start);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0], "refused: a request for another host");
  log.add(Refusal::kHost, start + std::chrono::seconds(11));
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[2], "refused: a request for another host (1000 times, 1001 in all)");
  log.add(Refusal::kHost, start + std::chrono::seconds(12));
  log.flush();
  log.flush();
  EXPECT_EQ(lines.size(), 4u);
  EXPECT_EQ(log.count(Refusal::kHost), 1002);
}

StudioMessage message(Lane lane, const std::string& text) {
  return {std::make_shared<const std::string>(text), StudioMessage::Kind::kText, lane};
}

std::string take_all(Outbox& box) {
  std::string all;
  while (const std::optional<StudioMessage> next = box.take()) all += *next->bytes + " ";
  return all;
}

TEST(Outbox, KeepsOrderAndDropsWhatIsOld) {
  int woken = 0;
  Outbox box(100, [&] { ++woken; });
  box.put(message(Lane::kShape, "s1"));
  box.put(message(Lane::kOrdered, "a"));
  box.put(message(Lane::kPreview, "p1"));
  box.put(message(Lane::kShape, "s2"));
  box.put(message(Lane::kOrdered, "b"));
  box.put(message(Lane::kPreview, "p2"));
  EXPECT_EQ(woken, 1);
  EXPECT_EQ(take_all(box), "a s2 b p2 ");
  box.put(message(Lane::kShape, "s3"));
  EXPECT_EQ(woken, 2);
  EXPECT_EQ(take_all(box), "s3 ");
}

TEST(Outbox, OverflowsByWhatWaitsInOrderOnly) {
  int woken = 0;
  Outbox box(100, [&] { ++woken; });
  for (int i = 0; i < 50; ++i) box.put(message(Lane::kShape, std::string(90, 's')));
  for (int i = 0; i < 10; ++i) box.put(message(Lane::kOrdered, "0123456789"));
  EXPECT_FALSE(box.overflowed());
  box.put(message(Lane::kOrdered, "x"));
  EXPECT_TRUE(box.overflowed());
  EXPECT_EQ(woken, 2);
  EXPECT_EQ(take_all(box), "");
  Outbox closed(100, [] { FAIL(); });
  closed.close();
  closed.put(message(Lane::kOrdered, "x"));
  EXPECT_EQ(take_all(closed), "");
}

TEST(Crowd, SendsAwayStrangersThenGuestsNeverPages) {
  std::string gone;
  Crowd crowd(3, 2);
  const auto come = [&](char name) { return crowd.enter([&gone, name] { gone += name; }); };
  const uint64_t a = come('a'), b = come('b');
  come('c');
  EXPECT_TRUE(crowd.promote(a, Crowd::Rank::kGuest));
  EXPECT_TRUE(crowd.promote(b, Crowd::Rank::kPage));
  const uint64_t d = come('d');
  EXPECT_EQ(gone, "c");
  EXPECT_TRUE(crowd.promote(d, Crowd::Rank::kPage));
  const uint64_t e = come('e');
  EXPECT_EQ(gone, "ca");
  EXPECT_FALSE(crowd.promote(e, Crowd::Rank::kPage));
  come('f');
  EXPECT_EQ(gone, "cae");
  EXPECT_EQ(crowd.size(), 3);
  crowd.exit(b);
  crowd.exit(b);
  EXPECT_TRUE(crowd.promote(come('g'), Crowd::Rank::kPage));
  gone.clear();
  crowd.disperse();
  EXPECT_EQ(gone, "dfg");
  Crowd full(1, 1);
  EXPECT_TRUE(full.promote(full.enter([] { FAIL(); }), Crowd::Rank::kPage));
  EXPECT_EQ(full.enter([] {}), 0u);
}

TEST(KeptSession, ComesBackUnlessOthersCouldReadIt) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / ("lissom-" + random_secret()) / "lissom";
  const std::string secret = kept_session(folder, 80), other = kept_session(folder, 81);
  EXPECT_EQ(secret.size(), 32u);
  EXPECT_NE(secret, other);
  EXPECT_EQ(kept_session(folder, 80), secret);
  const fs::path file = folder / "studio-80.session";
  struct stat info {};
  ASSERT_EQ(::stat(file.c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 0777, 0600u);
  fs::permissions(file, fs::perms::others_read, fs::perm_options::add);
  const std::string renewed = kept_session(folder, 80);
  EXPECT_NE(renewed, secret);
  EXPECT_EQ(kept_session(folder, 80), renewed);
  fs::remove(file);
  fs::create_symlink(folder / "studio-81.session", file);
  EXPECT_NE(kept_session(folder, 80), other);
  forget_session(folder, 81);
  EXPECT_NE(kept_session(folder, 81), other);
  fs::permissions(folder, fs::perms::others_all, fs::perm_options::add);
  EXPECT_NE(kept_session(folder, 80), kept_session(folder, 80));
  fs::remove_all(folder.parent_path());
}

}  // namespace
}  // namespace lissom
