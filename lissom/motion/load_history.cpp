#include "lissom/motion/load_history.h"

#include <algorithm>
#include <limits>

namespace lissom {

Result<LoadHistory> LoadHistory::make(std::span<const Vec2> points, const std::string& where) {
  for (size_t i = 0; i < points.size(); ++i) {
    const std::string place = where + "/" + std::to_string(i);
    if (!points[i].allFinite()) {
      return Error{ErrorCode::kRange, place, "the time or the load factor is not a finite number", "give two numbers"};
    }
    if (i > 0 && !(points[i].x() > points[i - 1].x())) {
      return Error{ErrorCode::kRange, place, "the times of the load factor have to ascend", "sort the points by time"};
    }
  }
  LoadHistory history;
  history.points_.assign(points.begin(), points.end());
  return history;
}

double LoadHistory::at(double time) const {
  if (points_.empty()) return 1;
  if (time <= points_.front().x()) return points_.front().y();
  if (time >= points_.back().x()) return points_.back().y();
  const auto next =
      std::upper_bound(points_.begin(), points_.end(), time, [](double t, const Vec2& point) { return t < point.x(); });
  const Vec2 &a = *(next - 1), &b = *next;
  return a.y() + (b.y() - a.y()) * ((time - a.x()) / (b.x() - a.x()));
}

double LoadHistory::next_kink(double time) const {
  for (const Vec2& point : points_) {
    if (point.x() > time) return point.x();
  }
  return std::numeric_limits<double>::infinity();
}

bool LoadHistory::constant() const {
  return std::all_of(points_.begin(), points_.end(), [&](const Vec2& p) { return p.y() == points_.front().y(); });
}

}  // namespace lissom
