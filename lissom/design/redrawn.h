#pragma once
/// A rod network with its nodes at other places of the drawing, without cutting curves anew: description and structure move
/// together [mathematics 6.1]. Normals of edges are kept fixed in space and made perpendicular, so that the derivatives of
/// rest_jacobian are the whole truth; rods whose normals come from joints or from transport get one direction per edge, the
/// normals that they have, which changes no rest number by more than rounding while nothing has moved.

#include "lissom/core/result.h"
#include "lissom/design/design.h"

namespace lissom {

/// Whether nodes can be moved at all: kUnsupported, with the reason, for plans, membranes, and rods whose natural shape is
/// described apart from the drawing.
Status check_redrawable(const Model& model, const Structure& structure);

/// Whether every edge has a normal of its own, so that derivatives by places are the whole truth.
bool has_own_normals(const Structure& structure);

/// `places`: m, three per node, in the order of the structure. Selectors that name places (boxes, points) go on to name the
/// same nodes. Takes a model that can be redrawn. kGeometry where an edge would lose its length, turn back or run along its
/// normal; kConflict where a pose would select other nodes.
Status redraw(Model& model, Structure& structure, const VecX& places);

}  // namespace lissom
