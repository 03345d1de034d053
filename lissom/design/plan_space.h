#pragma once
/// The design parameters of a plan: radii and places of its control points and the pre-stretch of its fabric, or any of
/// them, with names, bounds and scales [mathematics 6.2].

#include <span>
#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/design/parameter.h"
#include "lissom/design/plan_mesh.h"

namespace lissom {

enum class Choice { kFixed, kFree };
enum class PreStretchChoice {
  kFixed,
  kCommon,   ///< one factor for both axes: the parameter is the pre-stretch along axis 1
  kPerAxis,  ///< both on their own
};

struct PlanSpaceOptions {
  Choice radii = Choice::kFree, positions = Choice::kFree;
  PreStretchChoice pre_stretch = PreStretchChoice::kCommon;
  std::vector<std::string> points;   ///< control points that take part; empty: all
  Vec2 radius_range{0.1e-3, 10e-3};  ///< m
  double reach = 0.25;               ///< how far points may move along x and y, times the size of the plan
  Vec2 pre_stretch_range{1.01, 2.5};
};

class PlanSpace {
 public:
  /// Bounds are widened to what the plan has. Errors name points that do not exist and ranges that are empty.
  static Result<PlanSpace> make(const Model& model, const PlanSpaceOptions& options = {});

  int size() const { return static_cast<int>(slots_.size()); }
  std::span<const Parameter> parameters() const { return parameters_; }

  /// p of a plan, SI.
  VecX values(const Plan& plan) const;

  /// The model with parameters p; everything else stays. kRange, with the parameter's name, outside of the bounds or where
  /// p is not finite.
  Result<Model> model_at(const Model& model, const VecX& p) const;

  /// d rest inputs / d p, (RestInputs::size x size()), of the plan of `model` on `mesh`, discretised to `system`.
  SparseMatrix rest_inputs(const Model& model, const PlanMesh& mesh, const System& system) const;

  /// d/de [ (d inputs / d p)' y ] along p + e v, y over RestInputs: what arcs contribute. Radii are linear in pieces, and
  /// pre-stretches are inputs themselves.
  VecX curvature(const Model& model, const PlanMesh& mesh, const System& system, const VecX& y, const VecX& v) const;

 private:
  /// What a parameter is in the plan.
  struct Slot {
    ParameterKind kind;
    int point;  ///< -1 for the pre-stretch
    int axis;   ///< radii: n, b; positions: x, y; pre-stretch: along axis 1, 2, both: 2
  };

  std::vector<Slot> slots_;
  std::vector<Parameter> parameters_;
};

}  // namespace lissom
