#include "lissom/core/eigen_solver.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "lissom/core/assert.h"

namespace lissom {

namespace {

constexpr int kGuardVectors = 4;      ///< width of the block beyond the wanted pairs
constexpr int kBlocksPerCycle = 8;    ///< blocks added before a restart
constexpr int kMaxBlocks = 400;       ///< in all
constexpr double kDependent = 1e-12;  ///< what is left of a vector, relative, that counts as nothing

class Iteration {
 public:
  Iteration(const LinearSolver& factor, double shift, std::span<const double> metric, int count)
      : factor_(factor),
        shift_(shift),
        metric_(Eigen::Map<const VecX>(metric.data(), static_cast<Eigen::Index>(metric.size()))),
        count_(count) {
    const auto massive = static_cast<int>((metric_.array() > 0).count());
    count_ = std::min(count_, massive);
    block_ = std::min(count_ + kGuardVectors, massive);
    const Eigen::Index capacity = std::min<Eigen::Index>(massive, block_ * (kBlocksPerCycle + 1)) + block_;
    basis_.resize(metric_.size(), capacity);
    projection_ = MatX::Zero(capacity, capacity);
  }

  EigenPairs run(double tolerance) {
    EigenPairs result;
    if (count_ > 0) {
      start();
      for (int step = 0; step < kMaxBlocks && !result.converged; ++step) {
        extend();
        result.converged = converged(tolerance);
        if (!result.converged && used_ + 2 * fresh_ > basis_.cols()) restart();
      }
      finish(result);
    } else {
      result.vectors.resize(metric_.size(), 0);
      result.converged = true;
    }
    result.solves = solves_;
    return result;
  }

 private:
  /// image = (K + shift M)^-1 M x. Range vectors have a positive M-norm, whatever the massless unknowns do.
  void apply(const MatX& x, MatX& image) {
    image.noalias() = metric_.asDiagonal() * x;
    factor_.solve_many(image, image);
    solves_ += static_cast<int>(x.cols());
  }

  /// Takes from `x` what lies in the first `columns` basis vectors; returns the coefficients taken.
  MatX remove_basis(MatX& x, Eigen::Index columns) {
    const auto basis = basis_.leftCols(columns);
    MatX taken = MatX::Zero(columns, x.cols());
    for (int pass = 0; pass < 2; ++pass) {
      weighted_.noalias() = metric_.asDiagonal() * x;
      const MatX part = basis.transpose() * weighted_;
      x.noalias() -= basis * part;
      taken += part;
    }
    return taken;
  }

  /// M-orthonormalises the columns of x, which are free of the first `columns` basis vectors, and stores them as the
  /// next block, without those that depend on the others. `scale` holds their M-norms before anything was removed.
  /// Fills `coupling_` such that x = block * coupling.
  void store_block(MatX& x, const VecX& scale, Eigen::Index columns) {
    coupling_ = MatX::Zero(x.cols(), x.cols());
    fresh_ = 0;
    for (Eigen::Index j = 0; j < x.cols(); ++j) {
      VecX v = x.col(j);
      for (int pass = 0; pass < 2; ++pass) {
        for (Eigen::Index i = 0; i < fresh_; ++i) {
          const auto other = basis_.col(columns + i);
          const double c = other.dot(metric_.cwiseProduct(v));
          coupling_(i, j) += c;
          v -= c * other;
        }
      }
      const double norm = m_norm(v);
      if (!(norm > kDependent * scale[j])) continue;
      coupling_(fresh_, j) = norm;
      v /= norm;
      const auto before = basis_.leftCols(columns + fresh_);  // cleans a short vector of what rounding left in it
      v -= before * (before.transpose() * metric_.cwiseProduct(v)).eval();
      basis_.col(columns + fresh_) = v / m_norm(v);
      ++fresh_;
    }
    coupling_.conservativeResize(fresh_, Eigen::NoChange);
  }

  double m_norm(const VecX& v) const { return std::sqrt(v.dot(metric_.cwiseProduct(v))); }

  VecX m_norms(const MatX& x) const { return (metric_.asDiagonal() * x.cwiseAbs2()).colwise().sum().cwiseSqrt(); }

  void start() {
    MatX x(metric_.size(), block_);
    std::uint64_t state = 0x9E3779B97F4A7C15ULL;  // xorshift64*, the same everywhere
    for (double& v : x.reshaped()) {
      state ^= state >> 12;
      state ^= state << 25;
      state ^= state >> 27;
      v = static_cast<double>((state * 0x2545F4914F6CDD1DULL) >> 11) * 0x1p-52 - 1;
    }
    apply(x, image_);
    store_block(image_, m_norms(image_), 0);
    used_ = 0;
  }

  /// Adds the block found last to the space: op(basis) = basis * projection + next block * coupling * (last rows).
  void extend() {
    const MatX block = basis_.middleCols(used_, fresh_);
    last_ = fresh_;
    apply(block, image_);
    const VecX scale = m_norms(image_);
    const Eigen::Index columns = used_ + fresh_;
    const MatX taken = remove_basis(image_, columns);
    projection_.block(0, used_, columns, fresh_) = taken;
    projection_.block(used_, 0, fresh_, columns) = taken.transpose();
    const MatX corner = projection_.block(used_, used_, fresh_, fresh_);
    projection_.block(used_, used_, fresh_, fresh_) = 0.5 * (corner + corner.transpose());
    used_ = columns;
    store_block(image_, scale, used_);

    const Eigen::SelfAdjointEigenSolver<MatX> ritz(projection_.topLeftCorner(used_, used_));
    ritz_values_ = ritz.eigenvalues().reverse();  // largest first: lowest mu first
    ritz_vectors_ = ritz.eigenvectors().rowwise().reverse();
  }

  bool converged(double tolerance) const {
    if (used_ < count_) return false;
    if (fresh_ == 0) return true;  // the space is closed
    const MatX outside = coupling_ * ritz_vectors_.bottomLeftCorner(last_, count_);
    const double floor = 4 * std::numeric_limits<double>::epsilon() * ritz_values_[0];
    for (int i = 0; i < count_; ++i) {
      if (!(outside.col(i).norm() <= std::max(tolerance * ritz_values_[i], floor))) return false;
    }
    return true;
  }

  /// Shrinks the space to its best vectors and keeps the block to come.
  void restart() {
    const Eigen::Index keep = std::min<Eigen::Index>(2 * block_, used_ - last_);
    const MatX next = basis_.middleCols(used_, fresh_);
    const MatX best = basis_.leftCols(used_) * ritz_vectors_.leftCols(keep);
    basis_.leftCols(keep) = best;
    basis_.middleCols(keep, fresh_) = next;
    projection_.setZero();
    projection_.topLeftCorner(keep, keep).diagonal() = ritz_values_.head(keep);
    used_ = keep;
  }

  /// Rayleigh-Ritz for (K + shift M, M) on U = op(Y), Y the best Ritz vectors: as (K + shift M) U = M Y, it costs no
  /// product with K. It frees the vectors of massless and stiff parts, and errors of the values become those of the
  /// vectors squared.
  void finish(EigenPairs& result) {
    const Eigen::Index width = std::min<Eigen::Index>(block_, used_);
    MatX y = basis_.leftCols(used_) * ritz_vectors_.leftCols(width);
    apply(y, image_);
    for (Eigen::Index i = 0; i < width; ++i) {
      const double size = m_norm(image_.col(i));
      image_.col(i) /= size;
      y.col(i) /= size;
    }
    weighted_.noalias() = metric_.asDiagonal() * image_;
    MatX stiffness = y.transpose() * weighted_;
    stiffness = 0.5 * (stiffness + stiffness.transpose()).eval();
    const MatX mass = image_.transpose() * weighted_;
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatX> ritz(stiffness, mass);
    const Eigen::Index found = std::min<Eigen::Index>(count_, width);
    result.values = ritz.eigenvalues().head(found).array() - shift_;
    result.vectors.noalias() = image_ * ritz.eigenvectors().leftCols(found);
    result.converged = result.converged && found == count_ && ritz.info() == Eigen::Success &&
                       result.values.allFinite() && result.vectors.allFinite();
  }

  const LinearSolver& factor_;
  double shift_;
  VecX metric_;
  int count_;
  Eigen::Index block_ = 0;
  MatX basis_;  ///< (unknowns x capacity), M-orthonormal; the first used_ span the space, then the next block
  Eigen::Index used_ = 0;
  Eigen::Index fresh_ = 0;  ///< columns of the next block
  Eigen::Index last_ = 0;   ///< columns of the block added last
  MatX projection_;         ///< basis' M op(basis)
  MatX coupling_;           ///< (fresh x last)
  VecX ritz_values_;
  MatX ritz_vectors_;
  MatX image_;
  MatX weighted_;
  int solves_ = 0;
};

}  // namespace

EigenPairs lowest_eigenpairs(const LinearSolver& factor, double shift, std::span<const double> metric, int count,
                             double tolerance) {
  LISSOM_ASSERT(metric.size() == static_cast<std::size_t>(factor.unknowns()));
  return Iteration(factor, shift, metric, std::max(count, 0)).run(tolerance);
}

}  // namespace lissom
