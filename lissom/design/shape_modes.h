#pragma once
/// What can move next: the singular vectors of the scaled sensitivity under hard constraints [mathematics 7].

#include <vector>

#include "lissom/design/hard_constraints.h"
#include "lissom/design/shape_response.h"

namespace lissom {

struct ShapeMode {
  double strength = 0;  ///< singular value over the largest one
  VecX parameters;      ///< change of p / scale, (m), that moves the node that moves most by 1 m, to first order
  VecX shape;           ///< change of all unknowns that goes with it, (unknowns)
  /// Shares of the kinds of parameters in the (normalised) right singular vector; they sum up to 1.
  double radii = 0, positions = 0, pre_stretch = 0;
};

/// The first `count` modes, strongest first; fewer where the constraints leave fewer. Parameters are normalised so that radii,
/// places and pre-stretch have columns of equal mean norm before they are projected. The largest component of the shape is
/// positive.
std::vector<ShapeMode> shape_modes(const ShapeResponse& response, const HardConstraints& constraints, int count);

/// Every so many nodes of a structure, at most `most` of them: enough to measure smooth shapes by.
std::vector<int> spread_nodes(const System& system, int most);

}  // namespace lissom
