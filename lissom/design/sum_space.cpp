#include <fmt/format.h>
#include <map>
#include <utility>

#include "lissom/core/assert.h"
#include "lissom/design/design_spaces.h"

namespace lissom {

namespace {

/// Appends a block of columns at `first` of m columns.
void place_columns(const SparseMatrix& block, int first, int m, SparseMatrix& whole) {
  if (block.cols() == 0) return;
  SparseMatrix wide(block.rows(), m);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(block.nonZeros()));
  for (int c = 0; c < block.outerSize(); ++c) {
    for (SparseMatrix::InnerIterator it(block, c); it; ++it) {
      entries.emplace_back(static_cast<int>(it.row()), first + c, it.value());
    }
  }
  wide.setFromTriplets(entries.begin(), entries.end());
  if (whole.cols() == 0) {
    whole = std::move(wide);
  } else {
    whole += wide;
  }
}

/// Which parameter claims which number, over all spaces so far.
class Claims {
 public:
  explicit Claims(const std::vector<Parameter>& parameters) : parameters_(parameters) {}

  Status take(const SparseMatrix& matrix, int first, int part, int kind) {
    for (int c = 0; c < matrix.outerSize(); ++c) {
      for (SparseMatrix::InnerIterator it(matrix, c); it; ++it) {
        if (it.value() == 0) continue;
        const auto [claim, fresh] = claims_.try_emplace({kind, static_cast<int>(it.row())}, Claim{part, first + c});
        if (fresh || claim->second.part == part) continue;
        return Error{ErrorCode::kConflict, "/parameters",
                     fmt::format("\"{}\" and \"{}\" change the same number of the design",
                                 parameters_[static_cast<std::size_t>(claim->second.parameter)].name,
                                 parameters_[static_cast<std::size_t>(first + c)].name),
                     "leave one of them out"};
      }
    }
    return {};
  }

 private:
  struct Claim {
    int part, parameter;
  };
  const std::vector<Parameter>& parameters_;
  std::map<std::pair<int, int>, Claim> claims_;
};

}  // namespace

Result<SumSpace> SumSpace::make(std::vector<SpacePtr> parts) {
  if (parts.empty()) {
    return Error{ErrorCode::kRange, "/parameters", "there are no parameters", "choose something that may change"};
  }
  SumSpace out;
  out.parts_ = std::move(parts);
  for (const SpacePtr& part : out.parts_) {
    out.first_.push_back(static_cast<int>(out.parameters_.size()));
    out.parameters_.insert(out.parameters_.end(), part->parameters().begin(), part->parameters().end());
  }
  const Result<Design> design = out.at(out.start());
  if (!design) return design.error();
  Claims claims(out.parameters_);
  for (std::size_t k = 0; k < out.parts_.size(); ++k) {
    const DesignJacobian own = out.parts_[k]->jacobian(design.value(), out.parts_[k]->start());
    const int part = static_cast<int>(k), first = out.first_[k];
    int kind = 0;
    if (Status s = claims.take(own.inputs, first, part, kind++); !s) return s.error();
    if (Status s = claims.take(own.numbers, first, part, kind++); !s) return s.error();
    for (const PoseJacobian& pose : own.poses) {
      if (Status s = claims.take(pose.loads, first, part, kind++); !s) return s.error();
      if (Status s = claims.take(pose.held, first, part, kind++); !s) return s.error();
    }
  }
  return out;
}

VecX SumSpace::start() const {
  VecX p(size());
  for (std::size_t k = 0; k < parts_.size(); ++k) p.segment(first_[k], parts_[k]->size()) = parts_[k]->start();
  return p;
}

Result<Design> SumSpace::at(const VecX& p) const {
  LISSOM_ASSERT(p.size() == size());
  Result<Design> design = parts_[0]->at(part(0, p));
  for (std::size_t k = 1; k < parts_.size() && design; ++k) {
    design = parts_[k]->applied(std::move(design).value(), part(k, p));
  }
  return design;
}

Result<Design> SumSpace::applied(Design design, const VecX& p) const {
  LISSOM_ASSERT(p.size() == size());
  Result<Design> result(std::move(design));
  for (std::size_t k = 0; k < parts_.size() && result; ++k) {
    result = parts_[k]->applied(std::move(result).value(), part(k, p));
  }
  return result;
}

DesignJacobian SumSpace::jacobian(const Design& design, const VecX& p) const {
  DesignJacobian all;
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    const DesignJacobian own = parts_[k]->jacobian(design, part(k, p));
    place_columns(own.inputs, first_[k], size(), all.inputs);
    place_columns(own.numbers, first_[k], size(), all.numbers);
    if (all.poses.size() < own.poses.size()) all.poses.resize(own.poses.size());
    for (std::size_t i = 0; i < own.poses.size(); ++i) {
      place_columns(own.poses[i].loads, first_[k], size(), all.poses[i].loads);
      place_columns(own.poses[i].held, first_[k], size(), all.poses[i].held);
    }
  }
  return all;
}

VecX SumSpace::curvature(const Design& design, const VecX& p, const VecX& y, const VecX& v) const {
  VecX result(size());
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    result.segment(first_[k], parts_[k]->size()) = parts_[k]->curvature(design, part(k, p), y, part(k, v));
  }
  return result;
}

}  // namespace lissom
