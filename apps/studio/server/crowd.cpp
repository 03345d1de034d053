#include "apps/studio/server/crowd.h"

#include <utility>
#include <vector>

namespace lissom {

Crowd::Crowd(int places, int pages) : places_(places), most_pages_(pages) {}

uint64_t Crowd::enter(std::function<void()> leave) {
  if (size() >= places_) {
    auto out = members_.end();
    for (auto i = members_.begin(); i != members_.end(); ++i) {
      if (i->second.rank == Rank::kPage) continue;
      if (out == members_.end() || i->second.rank < out->second.rank) out = i;
    }
    if (out == members_.end()) return 0;
    const std::function<void()> go = std::move(out->second.leave);
    members_.erase(out);
    go();
  }
  members_[++last_].leave = std::move(leave);
  return last_;
}

void Crowd::retarget(uint64_t who, std::function<void()> leave) {
  const auto found = members_.find(who);
  if (found != members_.end()) found->second.leave = std::move(leave);
}

bool Crowd::promote(uint64_t who, Rank rank) {
  const auto found = members_.find(who);
  if (found == members_.end()) return false;
  if (rank == Rank::kPage && found->second.rank != Rank::kPage) {
    if (pages_ >= most_pages_) return false;
    ++pages_;
  }
  found->second.rank = rank;
  return true;
}

void Crowd::exit(uint64_t who) {
  const auto found = members_.find(who);
  if (found == members_.end()) return;
  if (found->second.rank == Rank::kPage) --pages_;
  members_.erase(found);
}

void Crowd::disperse() {
  std::vector<std::function<void()>> all;
  for (auto& [who, member] : members_) all.push_back(member.leave);
  for (const std::function<void()>& leave : all) leave();
}

}  // namespace lissom
