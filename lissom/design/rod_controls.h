#pragma once
/// Values along the rods of a network by few numbers each: controls at the ends of rods, shared by all that meet there, and
/// none, one or two between [mathematics 6.1, thesis 5]. The same rule serves for radii, which live on edges, and for
/// displacements of the rest shape, which live on nodes. The spaces of the three stages are nested, so that a coarse design
/// goes on as a fine one without a change.

#include <span>
#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/model/structure.h"

namespace lissom {

/// By the number of controls of a rod.
enum class ControlStage {
  kEnds = 2,    ///< linear from end to end
  kMiddle = 3,  ///< one control in the middle: quadratic
  kThirds = 4,  ///< controls at the thirds: cubic pieces with continuous slope
};

class RodControls {
 public:
  /// kUnsupported, with the rod's name, where a rod is closed, has a single edge, or is met by another one between its ends.
  static Result<RodControls> make(const Structure& structure, ControlStage stage);

  struct Control {
    int node = -1;  ///< of the structure, for a control at the end of rods
    int rod = -1;   ///< else the rod that it belongs to
    double at = 0;  ///< and where on it, 0 to 1
  };
  /// Ends first, in the order in which rods come to them, then rod by rod.
  std::span<const Control> controls() const { return controls_; }
  int size() const { return static_cast<int>(controls_.size()); }
  int ends() const { return ends_; }
  ControlStage stage() const { return stage_; }
  /// "end at node 12", "rod \"rib\" at 1/3".
  std::string name(int control, const Structure& structure) const;
  /// m, where it is drawn; between nodes on the edge.
  Vec3 place(int control, const Structure& structure) const;

  /// Value at the middle of each edge, (edges x size). Values can leave the range of their controls by 12.5 % of its width.
  SparseMatrix edge_weights(const Structure& structure) const;
  /// Value at each node, (nodes x size); nodes that no rod has get none.
  SparseMatrix node_weights(const Structure& structure) const;

  /// Values of the controls of `finer`, a stage of the same structure, such that all values along rods stay as they are:
  /// (finer.size() x size).
  SparseMatrix prolongation(const RodControls& finer) const;

 private:
  /// Numbers of the controls of a rod, from its start to its end.
  std::vector<int> along(int rod) const;
  void add_value(int row, int rod, double u, std::vector<Eigen::Triplet<double>>& out) const;

  ControlStage stage_ = ControlStage::kEnds;
  int ends_ = 0;
  std::vector<Control> controls_;
  std::vector<std::array<int, 2>> rod_ends_;  // controls at start and end of each rod
};

}  // namespace lissom
