#pragma once
/// Turns the supports of a pose into held unknowns. Used by Supports::make only.

#include <string>
#include <vector>

#include "lissom/mechanics/supports.h"

namespace lissom {

class SupportsBuilder {
 public:
  SupportsBuilder(const Model& model, const System& system, const Pose& pose, std::string where);
  Result<Supports> build(NullMotions null_motions);

 private:
  Status apply(const Support& support, const std::vector<int>& nodes, const std::string& where);
  Status hold_free(const Support& support, int node, const Vec3& move, const std::string& where);
  Status hold_edge(const Support& support, int node, const Vec3& move, const std::string& where);
  Status hold_symmetry(const Support& support, int node, const std::string& where);
  void hold_position(int node, const Vec3& move);
  Status hold_directions(int first_dof, const std::vector<Vec3>& directions, const std::string& where);
  Result<int> frame_at(int node, const std::string& where) const;  ///< joint with a rotation of its own
  void hold_rolls_within(const std::vector<int>& nodes);

  const Model& model_;
  const System& system_;
  const Pose& pose_;
  std::string where_;
  Supports supports_;
};

}  // namespace lissom
