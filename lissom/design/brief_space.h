#pragma once
/// What a document lets a design change, as a design space [mathematics 6].

#include <array>
#include <memory>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/design/design_space.h"
#include "lissom/model/brief.h"

namespace lissom {

struct BriefSpace {
  std::shared_ptr<const Design> base;  ///< as the document has it
  std::shared_ptr<const DesignSpace> space;
  /// Pairs of parameters of the same kind and direction whose controls follow each other along a rod.
  std::vector<std::array<int, 2>> neighbours;
};

/// `model` is valid with this brief as its design. Errors name the entry, "/design/parameters/2": a start outside of its
/// bounds, numbers that two entries claim, structures that a kind of parameter does not take.
Result<BriefSpace> make_brief_space(const Brief& brief, const Model& model);

/// Number of a pose by the name in a brief; empty: the only one.
int brief_pose(const Model& model, const std::string& name);

}  // namespace lissom
