#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "lissom/core/assert.h"
#include "lissom/design/design_spaces.h"

namespace lissom {

namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

SparseMatrix matrix(int rows, int columns, const Triplets& entries) {
  SparseMatrix m(rows, columns);
  m.setFromTriplets(entries.begin(), entries.end());
  return m;
}

const Parameter& parameter(const DesignSpace& space, int i) { return space.parameters()[static_cast<std::size_t>(i)]; }

/// Without bounds and scale, which follow from those of the space.
Parameter open(Parameter like, std::string name) {
  like.name = std::move(name);
  like.lower = like.upper = like.scale = 0;
  return like;
}

Status check_number(const DesignSpace& space, int i) {
  if (i >= 0 && i < space.size()) return {};
  return Error{ErrorCode::kUnknown, "/parameters", fmt::format("there is no parameter number {}", i),
               fmt::format("there are {}, numbered from 0", space.size())};
}

/// How a component of a parameter goes over into its mirror image at a plane across `axis`.
double mirror_sign(const Parameter& p, int axis) {
  switch (p.kind) {
    case ParameterKind::kPosition:
    case ParameterKind::kDisplacement:
    case ParameterKind::kForce:
    case ParameterKind::kPinTarget:
    case ParameterKind::kMove:
      return p.axis == axis ? -1 : 1;
    case ParameterKind::kMoment:
      return p.axis == axis ? 1 : -1;
    default:
      return 1;
  }
}

/// A coordinate, not a difference of coordinates.
bool is_place(const Parameter& p) { return p.kind == ParameterKind::kPosition || p.kind == ParameterKind::kPinTarget; }

bool is_vector(const Parameter& p) {
  return p.axis >= 0 && p.kind != ParameterKind::kRadius && p.kind != ParameterKind::kPreStretch &&
         p.kind != ParameterKind::kSheetStiffness;
}

/// The parameter at the mirror image of number i; -1 where there is none.
int image_of(const DesignSpace& space, int i, const Vec3& normal, double offset, double tolerance) {
  const Parameter& own = parameter(space, i);
  const Vec3 image = *own.at - 2 * (normal.dot(*own.at) - offset) * normal;
  for (int j = 0; j < space.size(); ++j) {
    const Parameter& other = parameter(space, j);
    if (other.kind != own.kind || other.axis != own.axis || !other.at) continue;
    if ((*other.at - image).norm() <= tolerance) return j;
  }
  return -1;
}

}  // namespace

Result<MappedSpace> common_factor(SpacePtr space, const std::string& name) {
  const VecX start = space->start();
  Triplets entries;
  for (int i = 0; i < start.size(); ++i) entries.emplace_back(i, 0, start[i]);
  Parameter factor = open({}, name);
  factor.kind = ParameterKind::kFactor;
  return MappedSpace::make(std::move(space), VecX::Zero(start.size()),
                           matrix(static_cast<int>(start.size()), 1, entries), {factor});
}

Result<MappedSpace> chosen_parameters(SpacePtr space, const std::vector<int>& numbers) {
  VecX origin = space->start();
  Triplets entries;
  std::vector<Parameter> parameters;
  std::vector<bool> taken(static_cast<std::size_t>(space->size()), false);
  for (const int i : numbers) {
    if (Status s = check_number(*space, i); !s) return s.error();
    if (taken[static_cast<std::size_t>(i)]) {
      return Error{ErrorCode::kConflict, "/parameters",
                   fmt::format("\"{}\" is chosen twice", parameter(*space, i).name), "name it once"};
    }
    taken[static_cast<std::size_t>(i)] = true;
    entries.emplace_back(i, static_cast<int>(parameters.size()), 1);
    parameters.push_back(parameter(*space, i));
    origin[i] = 0;
  }
  const int rows = space->size(), columns = static_cast<int>(parameters.size());
  return MappedSpace::make(std::move(space), std::move(origin), matrix(rows, columns, entries), std::move(parameters));
}

Result<MappedSpace> tied_parameters(SpacePtr space, const std::vector<std::vector<int>>& groups) {
  std::vector<int> group_of(static_cast<std::size_t>(space->size()), -1);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    for (const int i : groups[g]) {
      if (Status s = check_number(*space, i); !s) return s.error();
      int& own = group_of[static_cast<std::size_t>(i)];
      if (own >= 0 || parameter(*space, i).kind != parameter(*space, groups[g][0]).kind) {
        return Error{ErrorCode::kConflict, "/parameters",
                     fmt::format("\"{}\" is {}", parameter(*space, i).name,
                                 own >= 0 ? "in two groups" : "of another kind than its group"),
                     "put parameters of one kind into one group"};
      }
      own = static_cast<int>(g);
    }
  }
  Triplets entries;
  std::vector<Parameter> parameters;
  std::vector<int> column_of(groups.size(), -1);
  for (int i = 0; i < space->size(); ++i) {
    const int group = group_of[static_cast<std::size_t>(i)];
    int column = group < 0 ? -1 : column_of[static_cast<std::size_t>(group)];
    if (column < 0) {
      column = static_cast<int>(parameters.size());
      const Parameter& own = parameter(*space, i);
      const std::size_t members = group < 0 ? 1 : groups[static_cast<std::size_t>(group)].size();
      parameters.push_back(members < 2 ? own : open(own, fmt::format("{} and {} more", own.name, members - 1)));
      if (group >= 0) column_of[static_cast<std::size_t>(group)] = column;
    }
    entries.emplace_back(i, column, 1);
  }
  const int rows = space->size(), columns = static_cast<int>(parameters.size());
  return MappedSpace::make(std::move(space), VecX::Zero(rows), matrix(rows, columns, entries), std::move(parameters));
}

Result<MappedSpace> mirrored(SpacePtr space, const Vec3& normal, double offset, double tolerance) {
  if (!(normal.norm() > 0) || !normal.allFinite() || !std::isfinite(offset) || !(tolerance >= 0)) {
    return Error{ErrorCode::kRange, "/parameters", "the mirror plane has no direction or no finite place",
                 "give a normal, an offset and a tolerance"};
  }
  const Vec3 n = normal.normalized();
  const double d = offset / normal.norm();
  int axis = -1;
  for (int i = 0; i < 3; ++i) {
    if (std::abs(n[i]) > 1 - 1e-12) axis = i;
  }
  Triplets entries;
  VecX origin = VecX::Zero(space->size());
  std::vector<Parameter> parameters;
  std::vector<bool> done(static_cast<std::size_t>(space->size()), false);
  for (int i = 0; i < space->size(); ++i) {
    if (done[static_cast<std::size_t>(i)]) continue;
    const Parameter& own = parameter(*space, i);
    const int column = static_cast<int>(parameters.size());
    if (!own.at) {
      entries.emplace_back(i, column, 1);
      parameters.push_back(own);
      continue;
    }
    if (axis < 0 && is_vector(own)) {
      return Error{ErrorCode::kUnsupported, "/parameters",
                   fmt::format("\"{}\" has no mirror image of its own at an oblique plane", own.name),
                   "turn the drawing such that the plane is across x, y or z"};
    }
    const int j = image_of(*space, i, n, d, tolerance);
    if (j < 0) {
      return Error{ErrorCode::kGeometry, "/parameters", fmt::format("\"{}\" has no mirror image", own.name),
                   "raise the tolerance, move the plane, or make the drawing symmetric"};
    }
    const double sign = mirror_sign(own, axis);
    done[static_cast<std::size_t>(i)] = done[static_cast<std::size_t>(j)] = true;
    if (sign < 0 && is_place(own)) origin[j] = (i == j ? 1 : 2) * d * n[axis];
    if (i == j && sign < 0) continue;  // stays in the plane
    entries.emplace_back(i, column, 1);
    if (i == j) {
      parameters.push_back(own);
      continue;
    }
    entries.emplace_back(j, column, sign);
    parameters.push_back(open(own, own.name + " and its mirror image"));
  }
  const int rows = space->size(), columns = static_cast<int>(parameters.size());
  return MappedSpace::make(std::move(space), std::move(origin), matrix(rows, columns, entries), std::move(parameters));
}

Result<MappedSpace> spectral_space(SpacePtr space, const MatX& z, const VecX& scales, const VecX& reach,
                                   const std::string& name) {
  LISSOM_ASSERT(z.rows() == space->size() && scales.size() == z.cols() && reach.size() == z.cols());
  std::vector<Parameter> parameters;
  for (int j = 0; j < z.cols(); ++j) {
    if (!(reach[j] > 0) || !(scales[j] > 0) || !z.col(j).allFinite()) {
      return Error{ErrorCode::kRange, "/parameters", fmt::format("direction {} of {} has no scale or reach", j, name),
                   "give positive numbers and finite directions"};
    }
    parameters.push_back({ParameterKind::kFactor, fmt::format("{} {}", name, j), -reach[j], reach[j], scales[j]});
  }
  VecX origin = space->start();
  return MappedSpace::make(std::move(space), std::move(origin), z.sparseView(), std::move(parameters));
}

}  // namespace lissom
