#include "apps/studio/server/outbox.h"

#include <utility>

namespace lissom {

Outbox::Outbox(size_t limit, std::function<void()> wake) : limit_(limit), wake_(std::move(wake)) {}

void Outbox::put(const StudioMessage& message) {
  const std::lock_guard lock(mutex_);
  if (closed_ || overflowed_ || !message.bytes) return;
  Waiting waiting{next_number_++, message};
  if (message.lane == StudioMessage::Lane::kOrdered) {
    bytes_ += message.bytes->size();
    ordered_.push_back(std::move(waiting));
    if (bytes_ > limit_) {
      overflowed_ = true;
      ordered_.clear();
      shape_.reset();
      preview_.reset();
      wake_();
      return;
    }
  } else {
    (message.lane == StudioMessage::Lane::kShape ? shape_ : preview_) = std::move(waiting);
  }
  if (!awake_) {
    awake_ = true;
    wake_();
  }
}

std::optional<StudioMessage> Outbox::take() {
  const std::lock_guard lock(mutex_);
  std::optional<Waiting>* lane = nullptr;
  for (std::optional<Waiting>* other : {&shape_, &preview_}) {
    if (other->has_value() && (lane == nullptr || (*other)->number < (*lane)->number)) lane = other;
  }
  StudioMessage message;
  if (!ordered_.empty() && (lane == nullptr || ordered_.front().number < (*lane)->number)) {
    message = std::move(ordered_.front().message);
    ordered_.pop_front();
    bytes_ -= message.bytes->size();
  } else if (lane != nullptr) {
    message = std::move((*lane)->message);
    lane->reset();
  } else {
    awake_ = false;
    return std::nullopt;
  }
  return message;
}

bool Outbox::overflowed() const {
  const std::lock_guard lock(mutex_);
  return overflowed_;
}

void Outbox::close() {
  const std::lock_guard lock(mutex_);
  closed_ = true;
  ordered_.clear();
  shape_.reset();
  preview_.reset();
}

}  // namespace lissom
