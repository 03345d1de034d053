#pragma once
/// A motion in time: where it starts, what acts, for how long, with which damping.

#include <optional>
#include <string>
#include <vector>

#include "lissom/core/types.h"
#include "lissom/model/selector.h"

namespace lissom {

struct MotionCase {
  std::string name;
  std::string start_pose;   ///< equilibrium to start from; empty: the drawn shape at rest
  std::string pose;         ///< supports and loads during the motion
  double duration = 0;      ///< s
  double step = 0;          ///< s, first (and largest, when adaptive) time step
  double record_every = 0;  ///< s; 0: every step
  bool adaptive = true;
  double error_tolerance = 1e-3;  ///< local error per step relative to the size of the structure
  double rho_infinity = 1;  ///< spectral radius at infinite frequency of generalised-alpha; 1: no numerical damping
  double mass_damping = 0;  ///< 1/s, Rayleigh
  double stiffness_damping = 0;   ///< s, Rayleigh
  bool roll_inertia = true;       ///< false: roll angles follow quasi-statically
  std::vector<Vec2> load_factor;  ///< (time s, factor), piecewise linear; empty: 1 throughout
  struct Kick {
    Selector at;
    Vec3 velocity = Vec3::Zero();  ///< m/s at the start
  };
  std::vector<Kick> kicks;
};

}  // namespace lissom
