#pragma once
/// A small plan and what tests of edits ask of it.

#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "lissom/editing/edits_json.h"
#include "lissom/model/document.h"

namespace lissom::edit_samples {

using Json = nlohmann::json;

/// A frame of 60 mm, a rod across, and an arc from side to side, with things that refer to them.
inline constexpr const char* kDocument = R"({
  "lissom": 1,
  "plan": {
    "points": {"a": [0, 0], "b": [60, 0], "c": [60, 60], "d": [0, 60], "m": [30, 30], "k": [30, 52]},
    "rods": [
      {"name": "frame", "points": ["a", "b", "c", "d"], "curve": "straight", "closed": true},
      {"name": "across", "points": ["a", "m", "c"], "curve": "straight"},
      {"name": "bow", "points": ["d", "k", "c"], "curve": "arc"}
    ],
    "material": "PLA", "r_n": 0.2, "r_b": 0.4, "edge_length": 4,
    "fabric": {"material": "soft knit", "pre_stretch": 1.4}
  },
  "sets": {"middle": {"plan_point": "m"}, "line": {"rod": "across"}},
  "poses": [{
    "name": "released",
    "supports": [{"at": "middle", "hold": "pin"}],
    "forces": [{"at": {"plan_point": "b"}, "force": [0, 0, 0.001]}, {"at": {"rod": "across", "at": 0.25}, "force": [0, 0, 0.001]}]
  }]
})";

inline Model model() {
  Result<Model> read = read_document(kDocument);
  EXPECT_TRUE(read.ok()) << (read.ok() ? "" : read.error().text());
  return std::move(read).value();
}

inline EditOutcome done(const Model& from, const Json& edit) {
  Result<EditOutcome> outcome = apply_edit(from, edit);
  EXPECT_TRUE(outcome.ok()) << edit.dump() << ": " << (outcome.ok() ? "" : outcome.error().text());
  if (!outcome) return {from};
  EXPECT_TRUE(outcome.value().model.validate().ok());
  const Result<Model> again = read_document(write_document(outcome.value().model));
  EXPECT_TRUE(again.ok()) << (again.ok() ? "" : again.error().text());
  return std::move(outcome).value();
}

inline EditOutcome done(const Json& edit) { return done(model(), edit); }

inline Error refused(const Model& from, const Json& edit) {
  const std::string before = write_document(from);
  const Result<EditOutcome> outcome = apply_edit(from, edit);
  EXPECT_FALSE(outcome.ok()) << edit.dump();
  EXPECT_EQ(write_document(from), before);
  return outcome ? Error{} : outcome.error();
}

inline Error refused(const Json& edit) { return refused(model(), edit); }

inline const PlanPoint& point(const Model& in, const std::string& name) {
  for (const PlanPoint& one : in.plan->points) {
    if (one.name == name) return one;
  }
  ADD_FAILURE() << "no point " << name;
  return in.plan->points[0];
}

inline const PlanRod& rod(const Model& in, const std::string& name) {
  for (const PlanRod& one : in.plan->rods) {
    if (one.name == name) return one;
  }
  ADD_FAILURE() << "no rod " << name;
  return in.plan->rods[0];
}

inline std::vector<std::string> names(const Model& in, const PlanRod& of) {
  std::vector<std::string> list;
  for (const int i : of.points) list.push_back(in.plan->points[static_cast<std::size_t>(i)].name);
  return list;
}

using Names = std::vector<std::string>;

}  // namespace lissom::edit_samples
