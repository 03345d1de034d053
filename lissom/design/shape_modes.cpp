#include "lissom/design/shape_modes.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace lissom {

namespace {

constexpr int kMostNodes = 1200;
constexpr double kNoStrength = 1e-6;  // of the strongest mode
constexpr int kKinds = 3;

int kind_of(const Parameter& parameter) {
  return parameter.kind == ParameterKind::kRadius ? 0 : parameter.kind == ParameterKind::kPosition ? 1 : 2;
}

/// One over the mean column norm of each kind, per parameter.
VecX normalisation(std::span<const Parameter> parameters, const MatX& rows) {
  std::array<double, kKinds> sum{}, count{};
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto kind = static_cast<std::size_t>(kind_of(parameters[i]));
    sum[kind] += rows.col(static_cast<Eigen::Index>(i)).norm();
    ++count[kind];
  }
  VecX scale(rows.cols());
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto kind = static_cast<std::size_t>(kind_of(parameters[i]));
    scale[static_cast<Eigen::Index>(i)] = sum[kind] > 0 ? count[kind] / sum[kind] : 0;
  }
  return scale;
}

}  // namespace

std::vector<int> spread_nodes(const System& system, int most) {
  const int nodes = system.layout.nodes(), stride = (nodes + most - 1) / most;
  std::vector<int> chosen;
  for (int i = 0; i < nodes; i += stride) chosen.push_back(i);
  return chosen;
}

std::vector<ShapeMode> shape_modes(const ShapeResponse& response, const HardConstraints& constraints, int count) {
  const System& system = response.system();
  const MatX& s = response.matrix();
  const std::vector<int> nodes = spread_nodes(system, kMostNodes);
  MatX rows(3 * static_cast<Eigen::Index>(nodes.size()), s.cols());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    rows.middleRows<3>(3 * static_cast<Eigen::Index>(i)) = s.middleRows<3>(3 * nodes[i]);
  }
  const VecX d = normalisation(response.parameters(), rows);
  rows.array().rowwise() *= d.transpose().array();
  MatX k = constraint_response(constraints, response.start().state.q, s);
  k.array().rowwise() *= d.transpose().array();
  const ConstraintProjection projection(k);
  MatX gram = MatX::Zero(s.cols(), s.cols());
  gram.selfadjointView<Eigen::Lower>().rankUpdate(rows.transpose());
  gram = MatX(gram.selfadjointView<Eigen::Lower>());
  projection.apply(gram);
  gram.transposeInPlace();
  projection.apply(gram);
  const Eigen::SelfAdjointEigenSolver<MatX> eigen(gram);
  const VecX& values = eigen.eigenvalues();
  std::vector<ShapeMode> modes;
  const double strongest = std::sqrt(std::max(values[values.size() - 1], 0.0));
  for (Eigen::Index i = values.size() - 1; i >= 0 && static_cast<int>(modes.size()) < count; --i) {
    const double value = std::sqrt(std::max(values[i], 0.0));
    if (!(value > kNoStrength * strongest)) break;
    ShapeMode mode;
    mode.strength = value / strongest;
    const VecX v = projection.of(eigen.eigenvectors().col(i));
    mode.parameters = d.cwiseProduct(v);
    mode.shape = s * mode.parameters;
    const auto places = mode.shape.head(3 * system.layout.nodes());
    Eigen::Index largest = 0;
    const double component = places.cwiseAbs().maxCoeff(&largest);
    double reach = 0;
    for (int node = 0; node < system.layout.nodes(); ++node)
      reach = std::max(reach, places.segment<3>(3 * node).norm());
    if (!(component > 0)) break;
    const double scale = (places[largest] < 0 ? -1 : 1) / reach;
    mode.parameters *= scale;
    mode.shape *= scale;
    for (Eigen::Index j = 0; j < v.size(); ++j) {
      const int kind = kind_of(response.parameters()[static_cast<std::size_t>(j)]);
      (kind == 0 ? mode.radii : kind == 1 ? mode.positions : mode.pre_stretch) += v[j] * v[j] / v.squaredNorm();
    }
    modes.push_back(std::move(mode));
  }
  return modes;
}

}  // namespace lissom
