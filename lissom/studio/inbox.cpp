#include "lissom/studio/inbox.h"

#include <algorithm>
#include <string>
#include <utility>

namespace lissom {

namespace {

constexpr int kMostRequests = 2000;
constexpr std::size_t kMostBytes = std::size_t{64} << 20;

/// What makes two requests of a page versions of one; empty: each counts.
std::string moving(const nlohmann::json& body) {
  const auto verb = body.find("do");
  if (verb == body.end() || !verb->is_string()) return {};
  std::string name = verb->get<std::string>();
  if (name == "handle_move") return name;
  if (name != "drag") return {};
  const auto drag = body.find("drag");
  return drag != body.end() && drag->is_number_integer() ? name + std::to_string(drag->get<long long>())
                                                         : std::string();
}

}  // namespace

Inbox::Taken Inbox::ask(Asked asked, std::vector<Asked>& skipped) {
  const std::scoped_lock lock(in_use_);
  if (closed_) return Taken::kClosed;
  if (const std::string kind = moving(asked.body); !kind.empty()) {
    // Only those at the end: an older one before anything else of the page keeps its place.
    for (auto item = items_.rbegin(); item != items_.rend(); ++item) {
      Asked* before = std::get_if<Asked>(&*item);
      if (before == nullptr || before->page != asked.page) continue;
      if (moving(before->body) != kind) break;
      bytes_ += asked.bytes - before->bytes;
      std::swap(*before, asked);
      skipped.push_back(std::move(asked));
      return Taken::kYes;
    }
  }
  if (requests_ >= kMostRequests || bytes_ + asked.bytes > kMostBytes) return Taken::kFull;
  ++requests_;
  bytes_ += asked.bytes;
  items_.emplace_back(std::move(asked));
  arrived_.notify_one();
  return Taken::kYes;
}

void Inbox::hand_over(Task task) {
  const std::scoped_lock lock(in_use_);
  if (closed_) return;
  items_.emplace_back(std::move(task));
  arrived_.notify_one();
}

std::optional<Inbox::Item> Inbox::next(std::chrono::milliseconds patience) {
  std::unique_lock lock(in_use_);
  arrived_.wait_for(lock, patience, [this] { return closed_ || !items_.empty(); });
  if (closed_ || items_.empty()) return std::nullopt;
  Item item = std::move(items_.front());
  items_.pop_front();
  if (const Asked* asked = std::get_if<Asked>(&item)) {
    --requests_;
    bytes_ -= asked->bytes;
  }
  return item;
}

bool Inbox::any(const std::function<bool(const Asked&)>& passes) const {
  const std::scoped_lock lock(in_use_);
  return std::any_of(items_.begin(), items_.end(), [&](const Item& item) {
    const Asked* asked = std::get_if<Asked>(&item);
    return asked != nullptr && passes(*asked);
  });
}

void Inbox::close() {
  const std::scoped_lock lock(in_use_);
  closed_ = true;
  items_.clear();
  arrived_.notify_all();
}

bool Inbox::closed() const {
  const std::scoped_lock lock(in_use_);
  return closed_;
}

}  // namespace lissom
