#pragma once
/// How many connections there may be at once, and which one goes when there are more.

#include <cstdint>
#include <functional>
#include <map>

namespace lissom {

/// Connections by what they have shown. When all places are taken, a newcomer takes the place of the oldest stranger, then of
/// the oldest guest; pages are never sent away. So nobody who only connects keeps others out for long.
class Crowd {
 public:
  enum class Rank {
    kStranger,  ///< has shown nothing yet
    kGuest,     ///< has shown a session
    kPage,      ///< a WebSocket
  };

  Crowd(int places, int pages);

  /// A number for a newcomer, 0 when there is no place. `leave` is called, at once, when somebody has to go.
  uint64_t enter(std::function<void()> leave);
  /// Who is asked to leave in another way from now on.
  void retarget(uint64_t who, std::function<void()> leave);
  /// False when there are too many pages.
  bool promote(uint64_t who, Rank rank);
  void exit(uint64_t who);
  /// Asks everyone to leave.
  void disperse();
  int size() const { return static_cast<int>(members_.size()); }

 private:
  struct Member {
    Rank rank = Rank::kStranger;
    std::function<void()> leave;
  };

  const int places_, most_pages_;
  std::map<uint64_t, Member> members_;  // oldest first
  uint64_t last_ = 0;
  int pages_ = 0;
};

}  // namespace lissom
