#pragma once
/// The other stable shapes of the design at hand. Used by the engine's thread alone.

#include <nlohmann/json.hpp>
#include <vector>

#include "lissom/equilibrium/branches.h"
#include "lissom/studio/shape_packs.h"

namespace lissom {

class Desk;

class BranchShapes {
 public:
  explicit BranchShapes(Desk& desk) : desk_(desk) {}

  /// The design is another one now: shapes found before are none of it.
  void forget();
  void greet(int page) const;

  /// Starts the job `branches`.
  Status find();
  /// The structure flips to one of them.
  Status take(int branch);

 private:
  void show(std::vector<Branch> branches, int revision);
  nlohmann::json event() const;
  Pack pack() const;

  Desk& desk_;
  std::vector<Branch> branches_;
};

}  // namespace lissom
