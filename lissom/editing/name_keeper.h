#pragma once
/// Names of points, rods and sets in what selects them, after an edit of a plan.

#include <map>
#include <set>
#include <string>
#include <vector>

#include "lissom/editing/edits_json.h"
#include "lissom/editing/rod_heirs.h"

namespace lissom {

/// What became of a selection.
enum class Kept {
  kWhole,  ///< it selects what it did
  kPart,   ///< some of it is gone
  kNone,
};

class NameKeeper {
 public:
  /// `after`: what the edit has made of the model; both outlive the keeper.
  NameKeeper(const Plan& before, const Model& after, const NameChanges& names);

  const RodHeirs& heirs() const { return heirs_; }
  /// The name that a point has now, or that no point had; empty when it is gone.
  std::string point(const std::string& name) const;
  bool has_set(const std::string& name) const { return sets_.contains(name); }
  void lose_set(const std::string& name) { sets_.erase(name); }

  /// Rewrites the names in a selector. Once for each selector: names may mean something else before and after.
  Kept keep(Selector& selector) const;
  /// The same for names of sets alone.
  Kept keep_sets(Selector& selector) const;
  /// Lists of names; those that are gone are left out.
  std::vector<std::string> keep_rods(const std::vector<std::string>& rods) const;
  std::vector<std::string> keep_points(const std::vector<std::string>& points) const;

 private:
  Kept keep_rod(Selector& selector) const;
  template <class Keep>
  static Kept keep_union(Selector& selector, const Keep& keep);

  const NameChanges& names_;
  RodHeirs heirs_;
  std::set<std::string> points_before_, points_, sets_;
};

}  // namespace lissom
