#include "lissom/equilibrium/frame_relaxation.h"

#include <utility>

namespace lissom {

FrameRelaxer::FrameRelaxer(NewtonWorkspace& workspace) : workspace_(workspace) {
  const DofLayout& layout = workspace.system().layout;
  kept_.assign(layout.size(), -1);
  for (int i = 3 * layout.nodes(); i < layout.size(); ++i) {
    if (workspace.problem().supports.kept()[i] >= 0) kept_[i] = unknowns_++;
  }
  factor_.emplace(workspace.problem().potential.pattern(), kept_);
  b_.resize(unknowns_);
}

void FrameRelaxer::relax(State& state, int steps) {
  if (unknowns_ == 0) return;
  const Potential& potential = workspace_.problem().potential;
  for (int k = 0; k < steps; ++k) {
    potential.hessian(state, gradient_, hessian_, buffers_, workspace_.context().threads);
    if (!factor_->factorize(hessian_).positive_definite) return;
    for (int i = 0; i < static_cast<int>(kept_.size()); ++i) {
      if (kept_[i] >= 0) b_[kept_[i]] = -gradient_[i];
    }
    factor_->solve(b_, b_);
    const double largest = b_.cwiseAbs().maxCoeff();
    if (!(largest < 1e6)) return;
    if (largest > 0.5) b_ *= 0.5 / largest;
    increment_ = VecX::Zero(static_cast<int>(kept_.size()));
    for (int i = 0; i < static_cast<int>(kept_.size()); ++i) {
      if (kept_[i] >= 0) increment_[i] = b_[kept_[i]];
    }
    potential.to_global(increment_);
    if (!advance(workspace_.system(), state, increment_, moved_, workspace_.context().threads)) return;
    std::swap(state, moved_);
    if (largest < 1e-8) return;
  }
}

}  // namespace lissom
