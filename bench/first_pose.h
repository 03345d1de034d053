#pragma once
/// A model made ready for benches of its first pose.

#include <cstdio>
#include <memory>
#include <string>
#include <utility>

#include "lissom/equilibrium/static_problem.h"

namespace lissom {

struct FirstPose {
  std::unique_ptr<System> system;  ///< null, with the reason on standard error, when there is something wrong
  std::unique_ptr<StaticProblem> problem;
};

inline FirstPose first_pose(const std::string& name, const Model& model) {
  Result<System> system = make_system(model);
  if (!system) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), system.error().text().c_str());
    return {};
  }
  auto owned = std::make_unique<System>(std::move(system).value());
  Result<StaticProblem> problem = make_static_problem(model, *owned, model.poses[0], "/poses/0");
  if (!problem) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), problem.error().text().c_str());
    return {};
  }
  return {std::move(owned), std::make_unique<StaticProblem>(std::move(problem).value())};
}

}  // namespace lissom
