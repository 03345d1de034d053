// What the design of a document becomes, and how its shapes answer to its parameters.

#include <fmt/format.h>
#include <memory>

#include "lissom/core/nearest_name.h"
#include "lissom/design/brief_space.h"
#include "lissom/design/sensitivity.h"
#include "lissom/session/design_run.h"
#include "lissom/session/quantity_families.h"

namespace lissom {

namespace {

/// Designs are made at the resolution of the document.
Status check_measurement(const Measurement& m) {
  if (m.refine != 1) {
    return Error{ErrorCode::kUnsupported, m.where + "/edges", "designs are made with the edges that the document has",
                 "leave this out"};
  }
  if (m.study.model().design) return {};
  return Error{ErrorCode::kConflict, "/design", "the document does not say what may change",
               "describe it under \"design\""};
}

Result<int> parameter_number(const Measurement& m, std::span<const Parameter> parameters) {
  const std::string& name = m.expectation.parameter;
  if (name.empty() && parameters.size() == 1) return 0;
  std::vector<std::string> names;
  for (const Parameter& parameter : parameters) names.push_back(parameter.name);
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == name) return static_cast<int>(i);
  }
  std::string hint = suggestion(name, names);
  if (hint.empty()) hint = "the first one is \"" + names.front() + "\"";
  return Error{ErrorCode::kUnknown, m.where + "/parameter",
               name.empty() ? fmt::format("the design has {} parameters", names.size())
                            : fmt::format("the design has no parameter \"{}\"", name),
               std::move(hint)};
}

}  // namespace

Result<double> designed_parameter(const Measurement& m) {
  if (const Status s = check_measurement(m); !s) return s.error();
  Result<std::unique_ptr<DesignRun>> made = DesignRun::start(m.study.model(), m.study.context());
  if (!made) return made.error();
  DesignRun& run = *made.value();
  const Result<int> number = parameter_number(m, run.problem().space().parameters());
  if (!number) return number.error();
  while (run.step()) {
  }
  if (*run.verdict() != DesignVerdict::kConverged && *run.verdict() != DesignVerdict::kGoodEnough) {
    return Error{ErrorCode::kConflict, "/design", "the design was not found: " + run.message(),
                 "look at it with `lissom optimize`"};
  }
  return run.problem().p()[number.value()];
}

Result<double> design_sensitivity(const Measurement& m) {
  if (const Status s = check_measurement(m); !s) return s.error();
  const Model& model = m.study.model();
  const Result<BriefSpace> made = make_brief_space(*model.design, model);
  if (!made) return made.error();
  const DesignSpace& space = *made.value().space;
  const Result<int> number = parameter_number(m, space.parameters());
  if (!number) return number.error();
  const VecX p = space.start();
  const Result<Design> design = space.at(p);
  if (!design) return design.error();
  const Result<int> node = selected_node(m, design.value().system);
  if (!node) return node.error();
  SolveOptions options = m.study.options();
  options.modes = 0;
  Result<std::unique_ptr<PoseFollower>> follower =
      PoseFollower::make(design.value(), m.pose(), options, m.study.context());
  if (!follower) return follower.error();
  PoseFollower& pose = *follower.value();
  if (const PoseEnd end = pose.release(design.value()); end.outcome != Outcome::kSettled) {
    return Error{ErrorCode::kConflict, fmt::format("/poses/{}", m.pose()), "there is no shape at rest: " + end.reason,
                 "look at the pose with `lissom solve`"};
  }
  pose.stand_at_point(design.value());
  const DesignJacobian jacobian = space.jacobian(design.value(), p);
  const Result<Sensitivity> sensitivity =
      Sensitivity::make(design.value().model, m.pose(), pose.problem(), pose.state(), pose.factor(), jacobian);
  if (!sensitivity) return sensitivity.error();
  const VecX moves = sensitivity.value().forward(VecX::Unit(space.size(), number.value()));
  return m.expectation.axis->dot(moves.segment<3>(3 * node.value()));
}

}  // namespace lissom
