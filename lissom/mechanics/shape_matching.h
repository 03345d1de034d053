#pragma once
/// Rotation of a corotational joint: the nearest rotation to the cross-covariance of present and rest frames of its
/// edges [mathematics 2.3; Mueller et al. 2005; errata E9, E10].

#include <vector>

#include "lissom/mechanics/state.h"

namespace lissom {

/// N = sum w_t t tbar' + w_n n nbar' + w_b b bbar' over the connections of a joint.
Mat3 cross_covariance(const System& system, int joint, const std::vector<EdgeState>& edges);

/// Whether the nearest rotation to N is not determined: its second and signed third singular values cancel.
bool is_degenerate(const Mat3& covariance);

/// Signed polar factor of N. Where it is not determined, N is first pulled towards the previous rotation.
Mat3 matched_rotation(const System& system, int joint, const std::vector<EdgeState>& edges, const Mat3& previous);

}  // namespace lissom
