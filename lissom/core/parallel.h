#pragma once
/// Threads behind one small interface. Work is cut at fixed places that do not depend on the number of threads, and
/// every piece writes to slots of its own, so results are the same bytes for any thread count.

#include <functional>
#include <memory>

namespace lissom {

/// A fixed set of worker threads that wait between jobs. Not reentrant: a job must not start another on its own pool,
/// and only one thread at a time may call `run`. Pieces must not throw.
class ThreadPool {
 public:
  /// `threads` counts the calling thread; 1 (or less) starts none.
  explicit ThreadPool(int threads);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  int threads() const;

  /// Calls `piece(i)` once for each i in [0, pieces), in any order, on any thread; returns when all are done.
  void run(int pieces, const std::function<void(int)>& piece);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Calls body(begin, end) over [0, count) cut in chunks of `grain`. Runs inline without a pool or for a single chunk.
template <class Body>
void parallel_for(ThreadPool* pool, int count, int grain, const Body& body) {
  if (count <= 0) return;
  const int pieces = (count - 1) / grain + 1;
  if (pool == nullptr || pool->threads() == 1 || pieces == 1) {
    body(0, count);
    return;
  }
  const auto chunk = [&](int i) { body(i * grain, i + 1 == pieces ? count : (i + 1) * grain); };
  pool->run(pieces, std::cref(chunk));  // a reference fits into std::function without allocation
}

}  // namespace lissom
