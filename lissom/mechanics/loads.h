#pragma once
/// Dead loads and penalties on single nodes and joints. Loads are linear in the unknowns: no Hessian of their own.

#include "lissom/mechanics/stencil_term.h"
#include "lissom/mechanics/strain.h"

namespace lissom {

/// Factor by which a load acts in a state.
inline double load_scale(Scaling scaling, const State& state) {
  return scaling == Scaling::kConstant ? 1.0 : state.load_factor;
}

/// -rest[0] scale (rest[1..3] . (x - drawn)): a load per mass or length on the part of a structure that a node carries.
template <class T>
T tributary_work(std::span<const T, 3> x, std::span<const T, 4> rest, double scale, const Vec3& drawn) {
  T work(0);
  for (int i = 0; i < 3; ++i) work += (x[i] - T(drawn[i])) * (rest[1 + i] * scale);
  return -(rest[0] * work);
}

/// V = -m g . (x - X) [mathematics 1.4].
struct NodeGravity {
  static constexpr std::string_view kName = "gravity";
  static constexpr std::string_view kCitation = "mathematics 1.4";
  static constexpr int kDofs = 3;  // x (m)
  static constexpr int kRest = 4;  // mass m (kg), acceleration g (m/s^2)
  static constexpr bool kHasHessian = false;
  struct Stencil {
    std::array<int, kDofs> dofs;
    std::array<double, kRest> rest;
    Vec3 drawn;
  };
  struct Frozen {
    double scale;
    Vec3 drawn;
  };
  Frozen frozen(const State& state, const Stencil& s) const { return {load_scale(scaling, state), s.drawn}; }
  template <class T>
  static T value(std::span<const T, kDofs> x, std::span<const T, kRest> rest, const Frozen& f) {
    return tributary_work<T>(x, rest, f.scale, f.drawn);
  }
  std::vector<Stencil> stencils;
  Scaling scaling = Scaling::kProportional;
};

/// V = -l w . (x - X): load per length on the tributary rest length of a node.
struct NodeLineLoad {
  static constexpr std::string_view kName = "line_load";
  static constexpr std::string_view kCitation = "lumped consistent with the node masses of mathematics 1.4";
  static constexpr int kDofs = 3;  // x (m)
  static constexpr int kRest = 4;  // tributary length l (m), load w (N/m)
  static constexpr bool kHasHessian = false;
  struct Stencil {
    std::array<int, kDofs> dofs;
    std::array<double, kRest> rest;
    Vec3 drawn;
    Scaling scaling;
  };
  struct Frozen {
    double scale;
    Vec3 drawn;
  };
  Frozen frozen(const State& state, const Stencil& s) const { return {load_scale(s.scaling, state), s.drawn}; }
  template <class T>
  static T value(std::span<const T, kDofs> x, std::span<const T, kRest> rest, const Frozen& f) {
    return tributary_work<T>(x, rest, f.scale, f.drawn);
  }
  std::vector<Stencil> stencils;
};

/// V = -f . (x - X).
struct NodeForce {
  static constexpr std::string_view kName = "point_force";
  static constexpr std::string_view kCitation = "dead load";
  static constexpr int kDofs = 3;  // x (m)
  static constexpr int kRest = 3;  // force f (N)
  static constexpr bool kHasHessian = false;
  struct Stencil {
    std::array<int, kDofs> dofs;
    std::array<double, kRest> rest;
    Vec3 drawn;
    Scaling scaling;
  };
  struct Frozen {
    double scale;
    Vec3 drawn;
  };
  Frozen frozen(const State& state, const Stencil& s) const { return {load_scale(s.scaling, state), s.drawn}; }
  template <class T>
  static T value(std::span<const T, kDofs> x, std::span<const T, kRest> rest, const Frozen& f) {
    T work(0);
    for (int i = 0; i < 3; ++i) work += (x[i] - f.drawn[i]) * rest[i];
    return work * (-f.scale);
  }
  std::vector<Stencil> stencils;
};

/// V = -m . (turn so far + r): a moment about axes fixed in space. Such a moment has no potential over finite rotations
/// in space; within a step it is the one whose gradient is exact and whose Hessian is the symmetric part (zero), so
/// equilibria are exact and paths are followed, while stability is that of the symmetric part.
struct JointMoment {
  static constexpr std::string_view kName = "point_moment";
  static constexpr std::string_view kCitation = "docs/energies/loads.md";
  static constexpr int kDofs = 3;  // r (rad)
  static constexpr int kRest = 3;  // moment m (N m)
  static constexpr bool kHasHessian = false;
  struct Stencil {
    std::array<int, kDofs> dofs;
    std::array<double, kRest> rest;
    int joint;
    Scaling scaling;
  };
  struct Frozen {
    double scale;
    Vec3 turn;
  };
  Frozen frozen(const State& state, const Stencil& s) const {
    return {load_scale(s.scaling, state), state.joint_turn[s.joint]};
  }
  template <class T>
  static T value(std::span<const T, kDofs> x, std::span<const T, kRest> rest, const Frozen& f) {
    T work(0);
    for (int i = 0; i < 3; ++i) work += (x[i] + f.turn[i]) * rest[i];
    return work * (-f.scale);
  }
  std::vector<Stencil> stencils;
};

/// Penalty V = 1/2 k |x - b|^2 [mathematics 4, 5.4].
struct NodeSoftPin {
  static constexpr std::string_view kName = "soft_pin";
  static constexpr std::string_view kCitation = "mathematics 4";
  static constexpr int kDofs = 3;  // x (m)
  static constexpr int kRest = 4;  // stiffness k (N/m), target b (m)
  static constexpr bool kHasHessian = true;
  struct Stencil {
    std::array<int, kDofs> dofs;
    std::array<double, kRest> rest;
  };
  struct Frozen {};
  Frozen frozen(const State&, const Stencil&) const { return {}; }
  template <class T>
  static T value(std::span<const T, kDofs> x, std::span<const T, kRest> rest, const Frozen&) {
    T distance2(0);
    for (int i = 0; i < 3; ++i) distance2 += (x[i] - rest[1 + i]) * (x[i] - rest[1 + i]);
    return T(0.5) * rest[0] * distance2;
  }
  std::vector<Stencil> stencils;
};

}  // namespace lissom
