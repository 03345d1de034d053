#include "lissom/core/parallel.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

namespace lissom {

namespace {
constexpr int kYieldsBeforeSleep = 64;  // jobs often follow each other within microseconds
}

struct ThreadPool::Impl {
  std::vector<std::thread> workers;
  std::mutex mutex;
  std::condition_variable wake;
  std::condition_variable left;
  std::atomic<std::uint64_t> round{0};  ///< written under the mutex, watched without it
  bool stop = false;                    ///< guarded by the mutex, as are the next three
  const std::function<void(int)>* job = nullptr;
  int pieces = 0;
  int busy = 0;  ///< workers inside the current job
  std::atomic<int> next{0};

  void take_pieces(const std::function<void(int)>& piece, int count) {
    for (int i = next.fetch_add(1, std::memory_order_relaxed); i < count;
         i = next.fetch_add(1, std::memory_order_relaxed)) {
      piece(i);
    }
  }

  void work() {
    std::uint64_t seen = 0;
    for (;;) {
      for (int i = 0; i < kYieldsBeforeSleep && round.load(std::memory_order_relaxed) == seen; ++i) {
        std::this_thread::yield();
      }
      std::unique_lock lock(mutex);
      wake.wait(lock, [&] { return stop || round.load(std::memory_order_relaxed) != seen; });
      if (stop) return;
      seen = round.load(std::memory_order_relaxed);
      if (job == nullptr) continue;  // came too late: the others have done it all
      const std::function<void(int)>& piece = *job;
      const int count = pieces;
      ++busy;
      lock.unlock();
      take_pieces(piece, count);
      lock.lock();
      if (--busy == 0) left.notify_one();
    }
  }
};

ThreadPool::ThreadPool(int threads) : impl_(std::make_unique<Impl>()) {
  for (int i = 1; i < threads; ++i) impl_->workers.emplace_back([impl = impl_.get()] { impl->work(); });
}

ThreadPool::~ThreadPool() {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->stop = true;
    impl_->round.fetch_add(1, std::memory_order_relaxed);
  }
  impl_->wake.notify_all();
  for (std::thread& worker : impl_->workers) worker.join();
}

int ThreadPool::threads() const { return static_cast<int>(impl_->workers.size()) + 1; }

void ThreadPool::run(int pieces, const std::function<void(int)>& piece) {
  if (impl_->workers.empty() || pieces <= 1) {
    for (int i = 0; i < pieces; ++i) piece(i);
    return;
  }
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->job = &piece;
    impl_->pieces = pieces;
    impl_->next.store(0, std::memory_order_relaxed);
    impl_->round.fetch_add(1, std::memory_order_relaxed);
  }
  impl_->wake.notify_all();
  impl_->take_pieces(piece, pieces);
  std::unique_lock lock(impl_->mutex);
  impl_->job = nullptr;  // no worker joins from here on
  impl_->left.wait(lock, [&] { return impl_->busy == 0; });
}

}  // namespace lissom
