#include "lissom/studio/jobs.h"

#include <chrono>
#include <nlohmann/json.hpp>
#include <utility>

namespace lissom {

namespace {

constexpr std::chrono::milliseconds kBetweenReports{60};

}  // namespace

Jobs::Jobs(const Pages& pages, Inbox& inbox, int threads)
    : pages_(pages), inbox_(inbox), threads_(std::make_unique<ThreadPool>(threads)), thread_([this] { run(); }) {}

Jobs::~Jobs() { close(); }

void Jobs::close() {
  {
    const std::scoped_lock lock(in_use_);
    closing_ = true;
    waiting_.reset();
    if (present_) present_->cancelled = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void Jobs::start(std::string name, std::string unit, Work work) {
  const auto job = std::make_shared<Job>();
  job->name = std::move(name);
  job->unit = std::move(unit);
  job->work = std::move(work);
  const std::scoped_lock lock(in_use_);
  if (closing_) return;
  if (present_) present_->cancelled = true;
  if (waiting_) tell(*waiting_, "cancelled", {.task = {}, .detail = "another job came first"});
  waiting_ = job;
  changed_.notify_all();
}

bool Jobs::cancel(const std::string& name) {
  const std::scoped_lock lock(in_use_);
  const auto meant = [&](const std::shared_ptr<Job>& job) { return job && (name.empty() || job->name == name); };
  bool any = false;
  if (meant(present_)) any = !present_->cancelled.exchange(true);
  if (meant(waiting_)) {
    tell(*waiting_, "cancelled", {.task = {}, .detail = "it had not begun"});
    waiting_.reset();
    any = true;
  }
  return any;
}

std::string Jobs::name() const {
  const std::scoped_lock lock(in_use_);
  if (present_ && !present_->cancelled) return present_->name;
  return waiting_ ? waiting_->name : std::string();
}

void Jobs::run() {
  for (;;) {
    {
      std::unique_lock lock(in_use_);
      changed_.wait(lock, [this] { return closing_ || waiting_; });
      if (closing_) return;
      present_ = std::exchange(waiting_, nullptr);
    }
    run(present_);
    const std::scoped_lock lock(in_use_);
    present_.reset();
  }
}

void Jobs::run(const std::shared_ptr<Job>& job) {
  auto last = std::chrono::steady_clock::now();
  Context context;
  context.threads = threads_.get();
  context.cancel = &job->cancelled;
  context.progress = [&](const Progress& progress) {
    const auto now = std::chrono::steady_clock::now();
    if (now - last < kBetweenReports) return;
    last = now;
    tell(*job, "running", progress);
  };
  tell(*job, "running", {});
  End end = job->work(context);
  const char* state = end.state == End::State::kDone        ? "done"
                      : end.state == End::State::kCancelled ? "cancelled"
                                                            : "failed";
  // The end is told after what came of it.
  inbox_.hand_over([this, job, state, end = std::move(end)] {
    if (end.then) end.then();
    tell(*job, state, {.task = {}, .fraction = 1, .detail = end.detail});
  });
}

void Jobs::tell(const Job& job, const char* state, const Progress& progress) const {
  pages_.tell_all({{"event", "job"},
                   {"job", job.name},
                   {"state", state},
                   {"fraction", progress.fraction},
                   {"iteration", progress.iteration},
                   {"value", progress.residual},
                   {"unit", job.unit},
                   {"detail", progress.detail}});
}

}  // namespace lissom
