#pragma once
/// Quantities that documents can expect. docs/guide/quantities.md defines them; the list is in quantities.cpp.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lissom/session/study.h"

namespace lissom {

/// What a quantity is asked for: one pose (or several together) at one resolution.
struct Measurement {
  Study& study;
  const Expectation& expectation;
  const Selector& at;      ///< the place: `at` of the expectation, or `to` when two places are compared
  std::vector<int> poses;  ///< all poses of the entry; the one in question comes first
  double refine = 1;
  std::string where;  ///< of the entry in the document: "/expect/3"

  int pose() const { return poses.front(); }
};

/// Fields of an expectation that a quantity may read.
enum QuantityField : unsigned {
  kAt = 1,
  kTo = 2,
  kAxis = 4,
  kRod = 8,
  kFraction = 16,
  kMode = 32,
  kModeKind = 64,
  kMembrane = 128,
  kFabricTest = 256,
  kParameter = 512
};

enum class PoseUse {
  kEach,      ///< one value per pose
  kTogether,  ///< one value from all poses
  kNone,      ///< one value that no pose changes
};

using Evaluator = Result<double> (*)(const Measurement&);

struct QuantityInfo {
  std::string_view name;
  std::string_view unit;         ///< SI, of the evaluated number; empty: that of a parameter decides
  std::string_view description;  ///< one line
  unsigned reads = 0;            ///< sum of QuantityField
  unsigned needs = 0;            ///< of which have to be given
  Evaluator measure = nullptr;
  Evaluator rate = nullptr;  ///< of `name` + "_rate"; null: there is none
  PoseUse poses = PoseUse::kEach;
};

std::span<const QuantityInfo> quantities();

/// A quantity by its name in a document, `_rate` resolved.
struct NamedQuantity {
  const QuantityInfo* info = nullptr;
  Evaluator measure = nullptr;
};
Result<NamedQuantity> find_quantity(std::string_view name);

/// Refuses unknown names, fields that the quantity does not read, and fields that it needs and does not have.
Status check_expectation(const Expectation& expectation);

/// The numbers that an entry claims something about: one per value that it compares, after `combine`, before scaling.
Result<std::vector<double>> measure(Study& study, const Expectation& expectation, const std::string& where);

}  // namespace lissom
