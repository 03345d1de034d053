#pragma once
/// What long work needs from its caller: threads, cancellation, progress and log. Passed down explicitly; no globals.

#include <atomic>
#include <functional>
#include <string>
#include <string_view>

#include "lissom/core/parallel.h"

namespace lissom {

/// One report of long work. `fraction` is in [0, 1], or negative when unknown.
struct Progress {
  std::string_view task;    ///< what is being done: "solve", "path", ...
  double fraction = -1;     ///< how far
  int iteration = 0;        ///< count within the task
  double residual = 0;      ///< N, largest unbalanced force; 0 when it does not apply
  std::string_view detail;  ///< one short sentence
};

/// Services for one running job. Copyable view: the caller owns what it points to.
struct Context {
  ThreadPool* threads = nullptr;                  ///< null: run on the calling thread
  const std::atomic<bool>* cancel = nullptr;      ///< set to true by the caller to stop at the next safe point
  std::function<void(const Progress&)> progress;  ///< called often; must be cheap
  std::function<void(std::string_view)> log;      ///< one line, no newline

  bool cancelled() const { return cancel != nullptr && cancel->load(std::memory_order_relaxed); }
  void report(const Progress& p) const {
    if (progress) progress(p);
  }
};

}  // namespace lissom
