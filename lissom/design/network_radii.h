#pragma once
/// The radii of a rod network as design parameters: both half-extents of the sections at the controls of its rods
/// [mathematics 6.1]. What a flexible rod mesh is tuned by.

#include <memory>
#include <span>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/design/linear_space.h"
#include "lissom/design/parameter.h"
#include "lissom/design/rod_controls.h"
#include "lissom/mechanics/system.h"

namespace lissom {

class NetworkRadii {
 public:
  /// `range`: bounds of the radii, m, 0 < lower < upper. Between controls radii may leave it by an eighth of its width, which
  /// has to leave something of the rod: kRange where it does not. kUnsupported for plans, for sections other than ellipses and
  /// rectangles, and for what RodControls does not take.
  static Result<NetworkRadii> make(const Model& model, const Structure& structure, ControlStage stage,
                                   const Vec2& range);

  int size() const { return static_cast<int>(parameters_.size()); }
  /// r_n at every control, then r_b.
  std::span<const Parameter> parameters() const { return parameters_; }
  const RodControls& controls() const { return controls_; }

  /// p of a network with the same radii everywhere.
  VecX constant(double r_n, double r_b) const;
  /// Half-extents of every edge, (edges x 2), n and b.
  MatX edge_extents(const VecX& p) const;

  /// The model with parameters p; everything else stays. kRange, with the parameter's name, outside of the bounds or where p
  /// is not finite.
  Result<Model> model_at(const Model& model, const VecX& p) const;

  /// d rest inputs / d p, (RestInputs::size x size()): constant.
  SparseMatrix rest_inputs(const Structure& structure) const;

  /// p of `finer`, the same radii.
  VecX prolonged(const VecX& p, const NetworkRadii& finer) const;

 private:
  explicit NetworkRadii(RodControls controls) : controls_(std::move(controls)) {}

  RodControls controls_;
  SparseMatrix weights_;  // (edges x controls)
  std::vector<std::vector<int>> rod_edges_;
  std::vector<Parameter> parameters_;
};

/// The same as a design space. Its start is the nearest that the controls can come to the present radii (least squares over
/// the edges, within the range): the design there is the base itself where radii are constant or were made by such a space.
Result<LinearSpace> radii_space(std::shared_ptr<const Design> base, ControlStage stage, const Vec2& range);

}  // namespace lissom
