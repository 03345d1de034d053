#pragma once
/// Which rods stand for a rod of a plan that was edited. Rods here are the printed parts that a plan expands to, by the names
/// that documents use ("rim", or "rim-0" and "rim-1" where it is split).

#include <map>
#include <string>
#include <vector>

#include "lissom/model/plan.h"

namespace lissom {

/// A place on a rod by name.
struct PlaceOnRod {
  std::string rod;
  double fraction = 0;  ///< of its length
};

class RodHeirs {
 public:
  /// `rods`, `points`: NameChanges of the edit.
  RodHeirs(const Plan& before, const Plan& after, const std::map<std::string, std::string>& points,
           const std::map<std::string, std::vector<std::string>>& rods);

  /// Whether the plan had a rod of this name.
  bool known(const std::string& rod) const;
  /// The rods that run where it ran; empty when it is gone.
  std::vector<std::string> of(const std::string& rod) const;
  /// Where a place on it is now; an empty rod when it is gone.
  PlaceOnRod of(const PlaceOnRod& place) const;
  /// The same for rods of the plan by their own names, ghosts too.
  std::vector<std::string> of_plan_rod(const std::string& rod) const;

 private:
  struct Part {
    std::string name, plan_rod;
    std::vector<std::string> points;
    std::vector<Vec2> line;  ///< m, finely sampled
  };
  static std::vector<Part> parts_of(const Plan& plan);
  const Part* part(const std::string& rod) const;
  std::vector<const Part*> heirs(const Part& part) const;

  std::vector<Part> before_, after_;
  std::vector<std::string> rods_before_, rods_after_;
  std::map<std::string, std::vector<std::string>> rods_;
};

}  // namespace lissom
