#pragma once
/// Selectors of a model whose nodes move: those that name places are made to name the places where their nodes have gone, and
/// all are checked to select what they did.

#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/model/structure.h"

namespace lissom {

class KeptSelectors {
 public:
  /// Notes what the poses and joints of the model select.
  KeptSelectors(const Model& model, const Structure& structure);

  /// Boxes and points of `model`, the same one but for places, become the points of the nodes that they selected. kConflict
  /// where something else would be selected all the same.
  Status rename(Model& model, const Structure& moved) const;

 private:
  std::vector<std::vector<int>> places_;    // by box or point, in the order of a walk over all selectors
  std::vector<std::vector<int>> selected_;  // by selector of a pose or joint
};

}  // namespace lissom
