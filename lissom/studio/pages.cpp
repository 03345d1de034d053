#include "lissom/studio/pages.h"

#include <nlohmann/json.hpp>
#include <utility>

namespace lissom {

namespace {

StudioMessage text_of(const nlohmann::json& message) {
  // Names from files may hold bytes that are no UTF-8; pages get a mark in their stead.
  const auto replace = nlohmann::json::error_handler_t::replace;
  return {std::make_shared<const std::string>(message.dump(-1, ' ', false, replace)), StudioMessage::Kind::kText,
          StudioMessage::Lane::kOrdered};
}

}  // namespace

int Pages::connect(StudioDoor::Send send) {
  const std::scoped_lock lock(in_use_);
  pages_.emplace(++last_, std::move(send));
  return last_;
}

void Pages::disconnect(int page) {
  const std::scoped_lock lock(in_use_);
  pages_.erase(page);
}

void Pages::tell(int page, const nlohmann::json& message) const { send(page, text_of(message)); }

void Pages::tell_all(const nlohmann::json& message) const { send_all(text_of(message)); }

void Pages::show(int page, const std::shared_ptr<const std::string>& pack, StudioMessage::Lane lane) const {
  send(page, {pack, StudioMessage::Kind::kPack, lane});
}

void Pages::show_all(const std::shared_ptr<const std::string>& pack, StudioMessage::Lane lane) const {
  send_all({pack, StudioMessage::Kind::kPack, lane});
}

void Pages::send(int page, const StudioMessage& message) const {
  const std::scoped_lock lock(in_use_);
  const auto found = pages_.find(page);
  if (found != pages_.end()) found->second(message);
}

void Pages::send_all(const StudioMessage& message) const {
  const std::scoped_lock lock(in_use_);
  for (const auto& [page, send] : pages_) send(message);
}

}  // namespace lissom
