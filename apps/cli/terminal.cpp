#include "apps/cli/terminal.h"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <fmt/format.h>
#include <thread>

#include "apps/cli/command.h"

#if defined(_WIN32)
#include <io.h>
#else
#include <unistd.h>
#endif

namespace lissom::cli {

namespace {

/// Set by Ctrl-C. Signals leave no other way than a variable of the program.
std::atomic<bool> interrupt_seen{false};
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void on_interrupt(int signal) {
  interrupt_seen.store(true, std::memory_order_relaxed);
  std::signal(signal, SIG_DFL);  // the next one ends the program
}

bool standard_error_is_terminal() {
#if defined(_WIN32)
  return _isatty(2) != 0;
#else
  return isatty(2) != 0;
#endif
}

}  // namespace

const char* exit_codes_text() {
  return "Exit codes: 0 stable, or all passed; 1 a check failed; 2 wrong arguments; 3 something is wrong in a "
         "document;\n"
         "4 a file cannot be read or written; 10 critical; 11 unstable; 12 out of iterations; 13 stalled; 14 runs "
         "away;\n"
         "15 stopped by you; 16 the start shape has no finite energy. Of several poses: the first code that is not 0.";
}

void add_run_options(CLI::App& command, RunOptions& options) {
  command
      .add_option("--threads", options.threads, "Threads to compute with; results do not depend on it [one per core]")
      ->check(CLI::Range(1, 1024));
  command.add_flag("--progress", options.progress, "Show progress on standard error even when that is no terminal");
}

void catch_interrupts() {
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
}

bool interrupted() { return interrupt_seen.load(std::memory_order_relaxed); }

Run::Run(const RunOptions& options) : terminal_(standard_error_is_terminal()) {
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  threads_ = std::make_unique<ThreadPool>(options.threads > 0 ? options.threads : cores);
  context_.threads = threads_.get();
  context_.cancel = &interrupt_seen;
  if (options.progress || terminal_) context_.progress = [this](const Progress& p) { show(p); };
  catch_interrupts();
}

Run::~Run() { clear_line(); }

void Run::show(const Progress& p) {
  const auto now = std::chrono::steady_clock::now();
  if (now < next_) return;
  next_ = now + std::chrono::milliseconds(100);
  std::string line(p.task);
  if (p.fraction >= 0) line += fmt::format(", {:.0f} %", 100 * p.fraction);
  if (p.iteration > 0) line += fmt::format(", number {}", p.iteration);
  if (p.residual > 0) line += fmt::format(", unbalanced force {:.2e} N", p.residual);
  if (!p.detail.empty()) line += ", " + std::string(p.detail);
  if (terminal_) {
    const size_t length = line.size();
    if (length < shown_) line.append(shown_ - length, ' ');
    std::fprintf(stderr, "\r%s", line.c_str());
    shown_ = length;
  } else {
    std::fprintf(stderr, "%s\n", line.c_str());
  }
  std::fflush(stderr);
}

void Run::clear_line() {
  if (shown_ == 0) return;
  std::fprintf(stderr, "\r%*s\r", static_cast<int>(shown_), "");
  std::fflush(stderr);
  shown_ = 0;
}

int report(const Error& error, const std::string& file) {
  const std::string text = error.text();
  const bool named = file.empty() || text.starts_with(file + ":");
  std::fprintf(stderr, "lissom: %s%s\n", named ? "" : (file + ": ").c_str(), text.c_str());
  return error.code == ErrorCode::kFile ? kFileTrouble : kBadInput;
}

void print(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stdout); }

}  // namespace lissom::cli
