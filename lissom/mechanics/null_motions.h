#pragma once
/// Motions that cost no energy: they make a Hessian singular without saying anything about the shape. Found from the
/// description, before any solve, and taken out by holding as few unknowns as needed.

#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/mechanics/potential.h"
#include "lissom/model/model.h"

namespace lissom {

/// What becomes of motions that cost no energy.
enum class NullMotions {
  kRemove,     ///< statics: one place is as good as another, so some unknowns are held
  kKeepRigid,  ///< motion with massless rolls: rigid motions have inertia, spins have not and are taken out
  kKeep,       ///< motion: everything has inertia and stays free
};

/// Holds further entries of `held` (in local axes) against
///  - the spin of rods with equal bending stiffnesses that are straight at rest and held in no frame,
///  - rolls without any spring (a single edge between ball joints),
///  - rigid motions of a connected part that no support prevents and on which the loads do no work.
/// An unsupported part that its loads would drive away is an error unless rigid motions are kept. `removed` gets one
/// sentence per motion, `free_parts` the parts (Structure::component) that lost all six rigid motions.
Status remove_null_motions(const Model& model, const System& system, const Pose& pose, const std::string& where,
                           const std::vector<LocalAxes>& local_axes, NullMotions choice, std::vector<bool>& held,
                           std::vector<std::string>& removed, std::vector<int>& free_parts);

}  // namespace lissom
