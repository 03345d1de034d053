#include "lissom/core/parallel.h"

#include <atomic>
#include <chrono>
#include <gtest/gtest.h>
#include <thread>
#include <vector>

namespace lissom {
namespace {

class ThreadPoolTest : public testing::TestWithParam<int> {};

TEST_P(ThreadPoolTest, RunsEveryPieceExactlyOnceInManyRounds) {
  ThreadPool pool(GetParam());
  EXPECT_EQ(pool.threads(), GetParam());
  long long checked = 0;
  for (int round = 0; round < 2000; ++round) {
    const int pieces = round % 37;
    std::vector<std::atomic<int>> count(pieces);
    pool.run(pieces, [&](int i) { count[i].fetch_add(1); });
    for (const auto& c : count) {
      ASSERT_EQ(c.load(), 1) << "round " << round;
      ++checked;
    }
  }
  EXPECT_GT(checked, 30000);
}

TEST_P(ThreadPoolTest, WritesOfPiecesAreSeenByTheCaller) {
  ThreadPool pool(GetParam());
  std::vector<double> slot(1000);
  for (int round = 0; round < 200; ++round) {
    parallel_for(&pool, 1000, 7, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) slot[i] = i * 0.5 + round;
    });
    for (int i = 0; i < 1000; ++i) ASSERT_EQ(slot[i], i * 0.5 + round);
  }
}

TEST_P(ThreadPoolTest, WakesFromSleepAndIsDestroyedWhileAsleep) {
  for (int round = 0; round < 5; ++round) {
    ThreadPool pool(GetParam());
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    std::atomic<int> sum{0};
    pool.run(100, [&](int i) { sum += i; });
    EXPECT_EQ(sum.load(), 4950);
    std::this_thread::sleep_for(std::chrono::milliseconds(round));
  }
}

TEST_P(ThreadPoolTest, IsDestroyedWithoutEverWorking) {
  for (int round = 0; round < 50; ++round) ThreadPool pool(GetParam());
  SUCCEED();
}

INSTANTIATE_TEST_SUITE_P(Threads, ThreadPoolTest, testing::Values(1, 2, 8));

TEST(ParallelFor, CoversTheRangeInChunksWithoutOverlap) {
  ThreadPool pool(2);
  for (ThreadPool* p : {static_cast<ThreadPool*>(nullptr), &pool}) {
    for (int count : {0, 1, 6, 7, 8, 70, 71}) {
      std::vector<std::atomic<int>> hits(count);
      parallel_for(p, count, 7, [&](int begin, int end) {
        EXPECT_LT(begin, end);
        for (int i = begin; i < end; ++i) hits[i].fetch_add(1);
      });
      for (const auto& h : hits) EXPECT_EQ(h.load(), 1);
    }
  }
}

TEST(ParallelFor, UsesSeveralThreads) {
  ThreadPool pool(2);
  std::atomic<int> inside{0};
  std::atomic<bool> met{false};
  // Each of the two pieces waits for the other one: this ends only when two threads work at once.
  pool.run(2, [&](int) {
    inside.fetch_add(1);
    const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (inside.load() < 2 && std::chrono::steady_clock::now() < limit) std::this_thread::yield();
    if (inside.load() == 2) met = true;
  });
  EXPECT_TRUE(met.load());
}

}  // namespace
}  // namespace lissom
