#pragma once
/// Long work beside the engine's thread, one job at a time: it reports how far it is, can be ended, and hands its result over
/// to the engine's thread.

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <thread>

#include "lissom/core/context.h"
#include "lissom/studio/inbox.h"
#include "lissom/studio/pages.h"

namespace lissom {

class Jobs {
 public:
  /// How a job ended, with what the engine's thread is to do about it (may be empty).
  struct End {
    enum class State { kDone, kCancelled, kFailed } state = State::kDone;
    std::string detail;  ///< a sentence
    Inbox::Task then;
  };
  /// Runs on the thread of the jobs, with a context of its own.
  using Work = std::function<End(const Context&)>;

  /// Events go to `pages`, results to `inbox`; both have to outlive the jobs.
  Jobs(const Pages& pages, Inbox& inbox, int threads);
  ~Jobs();
  Jobs(const Jobs&) = delete;
  Jobs& operator=(const Jobs&) = delete;

  /// Starts when the job at hand has ended; one that still waits is given up, and the one at hand is told to end.
  void start(std::string name, std::string unit, Work work);
  /// Ends the job of this name (empty: any) as soon as it can; whether there was one.
  bool cancel(const std::string& name);
  /// Ends the job at hand and waits for it; nothing is started any more.
  void close();
  /// Of the job at hand, or that waits; empty when there is none.
  std::string name() const;

 private:
  struct Job {
    std::string name, unit;
    Work work;
    std::atomic<bool> cancelled = false;
  };

  void run();
  void run(const std::shared_ptr<Job>& job);
  void tell(const Job& job, const char* state, const Progress& progress) const;

  const Pages& pages_;
  Inbox& inbox_;
  std::unique_ptr<ThreadPool> threads_;
  mutable std::mutex in_use_;
  std::condition_variable changed_;
  std::shared_ptr<Job> present_, waiting_;
  bool closing_ = false;
  std::thread thread_;  // last: it uses all of the above
};

}  // namespace lissom
