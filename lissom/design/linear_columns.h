#pragma once
/// Collects the parameters of a linear space one by one.

#include <memory>
#include <utility>
#include <vector>

#include "lissom/design/linear_space.h"

namespace lissom {

class LinearColumns {
 public:
  /// A parameter on its own scale, a tenth of its range, with this value at the start. Entries are added to its column.
  void add(Parameter parameter, double start) {
    parameter.scale = 0.1 * (parameter.upper - parameter.lower);
    parameters_.push_back(std::move(parameter));
    start_.push_back(start);
  }
  /// In the column of the last parameter.
  void input(int row, double value) { inputs_.emplace_back(row, last(), value); }
  void load(int pose, int row, double value) { loads_.push_back({pose, {row, last(), value}}); }
  void move(int pose, int row, double value) { moves_.push_back({pose, {row, last(), value}}); }

  /// Values are Z p: every number that has a row is the sum of its parameters.
  Result<LinearSpace> space(std::shared_ptr<const Design> base) && {
    if (parameters_.empty()) {
      return Error{ErrorCode::kRange, "/parameters", "there are no parameters", "choose something that may change"};
    }
    const DesignValues values = values_of(*base);
    LinearRows rows;
    rows.inputs = matrix(values.inputs.size(), inputs_);
    for (std::size_t k = 0; k < values.poses.size() && !(loads_.empty() && moves_.empty()); ++k) {
      rows.poses.push_back({matrix(values.poses[k].loads.size(), of_pose(loads_, k)),
                            matrix(values.poses[k].moves.size(), of_pose(moves_, k))});
    }
    VecX start = Eigen::Map<const VecX>(start_.data(), static_cast<Eigen::Index>(start_.size()));
    return LinearSpace::make(std::move(base), std::move(parameters_), std::move(start), std::move(rows),
                             LinearSpace::Offset::kZero);
  }

 private:
  using Triplets = std::vector<Eigen::Triplet<double>>;
  using OfPose = std::vector<std::pair<int, Eigen::Triplet<double>>>;

  int last() const { return static_cast<int>(parameters_.size()) - 1; }
  static Triplets of_pose(const OfPose& all, std::size_t pose) {
    Triplets own;
    for (const auto& [number, entry] : all) {
      if (static_cast<std::size_t>(number) == pose) own.push_back(entry);
    }
    return own;
  }
  /// Without columns where there is nothing.
  SparseMatrix matrix(Eigen::Index rows, const Triplets& entries) const {
    if (entries.empty()) return {};
    SparseMatrix m(rows, static_cast<Eigen::Index>(parameters_.size()));
    m.setFromTriplets(entries.begin(), entries.end());
    return m;
  }

  std::vector<Parameter> parameters_;
  std::vector<double> start_;
  Triplets inputs_;
  OfPose loads_, moves_;
};

}  // namespace lissom
