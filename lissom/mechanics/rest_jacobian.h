#pragma once
/// Exact derivatives of all rest numbers by their inputs.

#include "lissom/mechanics/rest_numbers.h"
#include "lissom/mechanics/system.h"

namespace lissom {

/// All rest numbers from these inputs, by the formulas that are differentiated. Rest turns are relative to the frames of
/// `system`. Rods whose natural shape is described apart from the drawing keep the rest lengths and natural strains that
/// they have, whatever the places of their nodes.
VecX rest_numbers_of(const Model& model, const System& system, const VecX& inputs);

/// d rest numbers / d inputs, (RestNumbers::size x RestInputs::size), at the system's own inputs.
SparseMatrix rest_jacobian(const Model& model, const System& system);

/// sum over numbers k of y_k (Hessian of number k by the inputs) direction, at the system's own inputs: how
/// rest_jacobian' y changes along a direction of RestInputs::size. Entries of y beyond RestNumbers::size are passed over.
VecX rest_curvature(const Model& model, const System& system, const VecX& y, const VecX& direction);

}  // namespace lissom
