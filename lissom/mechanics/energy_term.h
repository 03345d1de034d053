#pragma once
/// One phenomenon on one stencil, seen by the assembler: how many stencils there are, which unknowns they touch, and their
/// energies and derivatives. Concrete energies are plain structs (rod_stretch.h, ...) wrapped by `StencilTerm`.

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "lissom/core/types.h"
#include "lissom/mechanics/rest_link.h"
#include "lissom/mechanics/state.h"

namespace lissom {

class Tape;
struct HyperDual;

/// Everything about one stencil by automatic differentiation of its value: the reference for hand-written derivatives
/// and the source of the mixed block.
struct StencilDerivatives {
  double energy = 0;   ///< J
  VecX gradient;       ///< dofs
  MatX hessian;        ///< dofs x dofs
  MatX mixed;          ///< dofs x rests: derivative of the gradient by the rest quantities
  VecX rest_gradient;  ///< rests: derivative of the energy by the rest quantities
};

/// Where third derivatives of one stencil's energy go along: lambda moves the unknowns alone (dofs), dq moves the unknowns
/// (dofs) together with dn, which moves the rest quantities (rests).
struct StencilDirections {
  const double *lambda, *dq, *dn;
};

/// Stencils are processed in groups of kLanes; entry e of stencil s of a block array with n entries per stencil sits at
/// s * n + e. Places beyond the last stencil, up to whole groups, hold copies and are not used.
class EnergyTerm {
 public:
  virtual ~EnergyTerm() = default;

  virtual std::string_view name() const = 0;
  virtual std::string_view citation() const = 0;
  virtual int stencils() const = 0;
  virtual int dofs() const = 0;                      ///< per stencil
  virtual int rests() const = 0;                     ///< rest quantities per stencil
  virtual bool has_hessian() const = 0;              ///< false: linear in the unknowns, or to be taken for it
  virtual std::span<const int> indices() const = 0;  ///< (stencils x dofs) global unknowns

  int groups() const { return (stencils() + kLanes - 1) / kLanes; }
  int hessian_entries() const { return dofs() * (dofs() + 1) / 2; }

  /// Energy of every stencil of the groups [begin, end).
  virtual void energies(const State& state, int begin, int end, double* energy) const = 0;
  /// Gradient blocks (dofs entries) and, unless null, lower triangles of the Hessian blocks (row by row).
  virtual void derivatives(const State& state, int begin, int end, double* gradient, double* hessian) const = 0;
  /// Derivatives of one stencil's value as a function of unknowns anchored at `state`, evaluated at state + dq.
  virtual StencilDerivatives automatic(const State& state, const VecX& dq, int stencil) const = 0;
  /// Derivative of one stencil's gradient by its rest quantities at the anchor, (dofs x rests) by columns.
  virtual void mixed(const State& state, int stencil, double* block) const = 0;
  /// Third derivatives of one stencil's energy, anchored at `state`, along lambda, along (dq, dn), and by each unknown (dofs)
  /// and rest quantity (rests). `tape` is storage for intermediate numbers.
  virtual void third(const State& state, int stencil, const StencilDirections& along, Tape& tape, double* by_q,
                     double* by_rest) const = 0;
  /// Derivatives of one stencil's energy, anchored at `state`, by each unknown (dofs) and rest quantity (rests): `a`, and
  /// their changes along (dq, dn), dofs and rests numbers: `d2`.
  virtual void second(const State& state, int stencil, const double* dq, const double* dn, Tape& tape, HyperDual* by_q,
                      HyperDual* by_rest) const = 0;
  /// What the rest quantities hang on.
  virtual const RestLinks& links() const = 0;
  /// Rest quantities of one stencil, and a copy of the term with others (for checks of the mixed block).
  virtual VecX rest(int stencil) const = 0;
  virtual void set_rest(int stencil, const VecX& rest) = 0;
  /// The term over those stencils alone that have one of the marked unknowns; without links, and on request without its Hessian.
  virtual std::unique_ptr<EnergyTerm> touching(const std::vector<bool>& unknown, bool with_hessian) const = 0;
};

}  // namespace lissom
