#pragma once
/// The border to the terminal: errors, progress, interrupts, threads.

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>
#include <string>

#include "lissom/core/context.h"
#include "lissom/core/result.h"

namespace lissom::cli {

/// Options that every computing command takes.
struct RunOptions {
  int threads = 0;        ///< 0: one per core
  bool progress = false;  ///< also when standard error is no terminal
};
void add_run_options(CLI::App& command, RunOptions& options);

/// From now on Ctrl-C, or a request to end, is noted once; the next one ends the program at once.
void catch_interrupts();
bool interrupted();

/// Threads, progress on standard error and Ctrl-C for one run. The first Ctrl-C asks the work to stop and keep what it
/// has; the second ends the program at once.
class Run {
 public:
  explicit Run(const RunOptions& options);
  ~Run();
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  const Context& context() const { return context_; }
  /// Wipes the line of progress, so that something else can be printed.
  void clear_line();

 private:
  void show(const Progress& progress);

  std::unique_ptr<ThreadPool> threads_;
  Context context_;
  bool terminal_ = false;  // standard error is one: a single line, written over
  size_t shown_ = 0;       // characters on it
  std::chrono::steady_clock::time_point next_;
};

/// Prints "lissom: FILE: where: message (hint)" on standard error; returns the exit code.
int report(const Error& error, const std::string& file = {});

void print(const std::string& text);

}  // namespace lissom::cli
