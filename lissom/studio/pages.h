#pragma once
/// The pages that look on, and what is sent to them. For use by any thread.

#include <map>
#include <memory>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "lissom/studio/door.h"

namespace lissom {

class Pages {
 public:
  int connect(StudioDoor::Send send);
  /// Nothing is sent to the page once this has returned.
  void disconnect(int page);

  /// JSON to one page, or to all of them.
  void tell(int page, const nlohmann::json& message) const;
  void tell_all(const nlohmann::json& message) const;
  /// A pack to one page, or to all of them.
  void show(int page, const std::shared_ptr<const std::string>& pack, StudioMessage::Lane lane) const;
  void show_all(const std::shared_ptr<const std::string>& pack, StudioMessage::Lane lane) const;

 private:
  void send(int page, const StudioMessage& message) const;
  void send_all(const StudioMessage& message) const;

  mutable std::mutex in_use_;
  std::map<int, StudioDoor::Send> pages_;
  int last_ = 0;
};

}  // namespace lissom
